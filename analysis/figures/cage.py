"""The stress field of a flexible cage, its surfaces laid flat."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import PowerNorm
from matplotlib.tri import Triangulation

from common import BLACK, WIDTH


def draw_surface(axis, surface, largest):
    """Colours between the nodes of a surface; returns what a colour bar needs."""
    cells = np.array(surface["cells"])
    triangles = np.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
    mesh = Triangulation(surface["across"], surface["up_mm"], triangles)
    axis.grid(False)
    axis.set_facecolor("0.93")  # pockets
    return axis.tripcolor(mesh, np.array(surface["stress_MPa"]), shading="gouraud", cmap="viridis", rasterized=True,
                          norm=PowerNorm(0.5, vmin=0, vmax=largest))  # much of a cage is stressed little


def mark_peak(axis, across, up):
    axis.plot(across, up, "o", markersize=11, markerfacecolor="none", markeredgecolor="white", markeredgewidth=2.6, clip_on=False)
    axis.plot(across, up, "o", markersize=11, markerfacecolor="none", markeredgecolor=BLACK, markeredgewidth=1.1, clip_on=False)


def cage_stress(report):
    cage = report["cage"]
    if cage is None or cage["peak"] is None:
        return None
    peak = cage["peak"]
    at = peak["full"]
    outer, inner, walls = peak["surfaces"]
    figure, axes = plt.subplots(3, 1, figsize=(WIDTH, 5.4), height_ratios=[1, 1, 0.8])
    for axis, surface in zip(axes, (outer, inner)):
        colours = draw_surface(axis, surface, at["stress_MPa"])
        step = 360 / peak["pockets"]
        for pocket in range(peak["pockets"]):
            axis.text(pocket * step, 0, str(pocket), ha="center", va="center", fontsize=7.5,
                      weight="bold" if pocket == peak["pocket"] else "normal")
        axis.set_xlim(min(surface["across"]), max(surface["across"]))
        axis.set_xlabel("angle [deg]")
        axis.set_ylabel("x [mm]")
        axis.set_title(surface["name"])
    radii = [np.min(walls["up_mm"]), np.max(walls["up_mm"])]
    middle = sum(radii) / 2
    mark_peak(axes[0] if at["radius_mm"] > middle else axes[1], at["angle_deg"], at["axial_mm"])
    draw_surface(axes[2], walls, at["stress_MPa"])
    highest = int(np.argmax(walls["stress_MPa"]))
    if walls["stress_MPa"][highest] > 0.999 * at["stress_MPa"]:
        mark_peak(axes[2], walls["across"][highest], walls["up_mm"][highest])
    axes[2].set_xlabel("way along the walls [mm]: trailing face, end x > 0, leading face, end x < 0")
    axes[2].set_ylabel("radius [mm]")
    axes[2].set_title(f"walls of pocket {peak['pocket']}")
    axes[2].set_xlim(0, max(walls["across"]))
    axes[2].set_ylim(*radii)
    for corner in walls["corners_mm"]:
        axes[2].axvline(corner, color="white", linewidth=1.2)
    figure.colorbar(colours, ax=axes, label="von Mises stress [MPa]", shrink=0.7, aspect=30)
    return figure
