"""The stress field of a flexible cage, its surfaces laid flat."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import PowerNorm
from matplotlib.patches import Circle, Wedge
from matplotlib.tri import Triangulation

from common import BLACK, RED, WIDTH
from pocket import CAGE


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


def draw_place(axis, peak, strength):
    """The cage along its axis, to no scale but its own, pocket 0 on top, with the place of the largest stress."""
    at, count = peak["full"], peak["pockets"]
    radii = peak["surfaces"][2]["up_mm"]
    inner, outer = min(radii), max(radii)
    share = 0.5 * pocket_share(peak)
    for pocket in range(count):
        middle = 90 + 360 * (pocket + 0.5) / count
        axis.add_patch(Wedge((0, 0), outer, middle - 360 / count * (0.5 - share), middle + 360 / count * (0.5 - share),
                             width=outer - inner, facecolor=CAGE, edgecolor=BLACK, linewidth=0.6))
    for radius in (inner, outer):
        axis.add_patch(Circle((0, 0), radius, fill=False, edgecolor=BLACK, linewidth=0.6))
    for pocket in range(count):
        angle = np.radians(90 + 360 * pocket / count)
        axis.text(0.5 * (inner + outer) * np.cos(angle), 0.5 * (inner + outer) * np.sin(angle), str(pocket), ha="center", va="center",
                  fontsize=6, weight="bold" if pocket == peak["pocket"] else "normal")
    angle = np.radians(90 + at["angle_deg"])
    place = at["radius_mm"] * np.cos(angle), at["radius_mm"] * np.sin(angle)
    words = f"{at['stress_MPa']:.3g} MPa\nat x = {at['axial_mm']:.2f} mm"
    if strength:
        words += f"\nfatigue strength\n{strength['fatigue_MPa']:.3g} MPa"
    axis.annotate(words, xy=place, xytext=(0, 0), ha="center", va="center", fontsize=7.5, color=RED,
                  arrowprops={"arrowstyle": "-|>", "color": RED, "linewidth": 1})
    axis.set_xlim(-1.05 * outer, 1.05 * outer)
    axis.set_ylim(-1.05 * outer, 1.05 * outer)
    axis.set_aspect("equal")
    axis.axis("off")


def pocket_share(peak):
    """The part of the circumference that pockets take, from the mesh of the outside: where it has no cells in the middle."""
    outside = peak["surfaces"][0]
    across, up = np.array(outside["across"]), np.array(outside["up_mm"])
    middle = np.array([np.mean(across[cell]) for cell in outside["cells"] if np.min(up[cell]) <= 0 <= np.max(up[cell])])
    if len(middle) == 0:
        return 0.6
    step = 360 / peak["pockets"]
    offsets = np.abs((middle + step / 2) % step - step / 2)  # from the middle of the nearest pocket
    return float(np.clip(2 * np.min(offsets) / step, 0.2, 0.95))


def cage_stress(report):
    cage = report["cage"]
    if cage is None or cage["peak"] is None:
        return None
    peak = cage["peak"]
    at = peak["full"]
    outer, inner, walls = peak["surfaces"]
    figure, panels = plt.subplot_mosaic([["place", "outer"], ["place", "inner"], ["walls", "walls"]], figsize=(WIDTH, 5.2),
                                        height_ratios=[1, 1, 0.85], width_ratios=[0.62, 1])
    draw_place(panels["place"], peak, (report.get("bearing") or {}).get("strength"))
    axes = [panels["outer"], panels["inner"], panels["walls"]]
    for axis, surface in zip(axes, (outer, inner)):
        colours = draw_surface(axis, surface, at["stress_MPa"])
        step = 360 / peak["pockets"]
        for pocket in range(peak["pockets"]):
            axis.text(pocket * step, 0, str(pocket), ha="center", va="center", fontsize=6.5,
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
