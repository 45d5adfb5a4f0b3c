"""One pocket of a cage with its roller and its clearances, to scale."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, Rectangle

from common import BLACK, BLUE, GREY, RED, WIDTH

STEEL, CAGE, ROLLER = "#D9D9D9", "#F3D9A4", "#DCEBF5"
# Where the letter of a clearance stands, beside the place that it points to, in parts of the roller's radius or half length.
LETTER = {"tangential": (-0.55, 0.0), "radial_outer": (-0.65, 0.1), "radial_inner": (-0.65, -0.3),
          "ring_outer": (0.45, 0.25), "ring_inner": (0.6, -0.2), "axial": (0.0, -0.3), "flange": (0.0, 0.3)}


def letter(axis, text, at, offset):
    axis.annotate(text, xy=at, xytext=(at[0] + offset[0], at[1] + offset[1]), ha="center", va="center", fontsize=9, weight="bold",
                  color=RED, bbox={"boxstyle": "circle,pad=0.2", "facecolor": "white", "edgecolor": RED, "linewidth": 0.9},
                  arrowprops={"arrowstyle": "-|>", "color": RED, "linewidth": 0.9, "shrinkB": 0, "mutation_scale": 7}, zorder=9)


def circle_of(radius, half_angle):
    angle = np.linspace(-half_angle, half_angle, 101)
    return radius * np.sin(angle), radius * np.cos(angle)


def draw_section(axis, section):
    """The radial plane: rings, bars, roller and its pitch circle."""
    pitch, roller, half = section["pitch_radius_mm"], section["roller_radius_mm"], section["half_angle_rad"]
    low, high = pitch - 1.45 * roller, pitch + 1.45 * roller
    wide = 1.1 * half
    for radius, end in ((section["outer_land_radius_mm"], high), (section["inner_land_radius_mm"], low)):
        across, up = circle_of(radius, wide)
        axis.fill_between(across, up, end, color=STEEL, linewidth=0)
        axis.plot(across, up, color=BLACK, linewidth=0.9)
    for bar in section["bars"]:
        axis.fill(bar["across"], bar["up"], facecolor=CAGE, edgecolor=BLACK, linewidth=0.9)
    axis.add_patch(Circle((0, pitch), roller, facecolor=ROLLER, edgecolor=BLUE, linewidth=0.9, zorder=3))
    axis.plot(*circle_of(pitch, wide), color=GREY, linewidth=0.7, linestyle="-.", zorder=4)
    axis.text(0, pitch + 0.75 * roller, "roller", ha="center", va="center", fontsize=7.5, zorder=5)
    axis.text(0, high - 0.04 * roller, "outer ring", ha="center", va="top", fontsize=7.5)
    axis.text(0, low + 0.04 * roller, "inner ring", ha="center", va="bottom", fontsize=7.5)
    for side, bar in zip((-1, 1), section["bars"]):
        axis.text(side * 0.93 * half * pitch, pitch, "bar", ha="center", va="center", fontsize=7.5, rotation=90)
    edge = section["outer_land_radius_mm"] * np.sin(wide)
    axis.set_xlim(-edge, edge + 0.35 * roller)
    axis.set_ylim(low, high)
    axis.set_title("along the axis")
    axis.set_xlabel("tangential [mm]")
    axis.set_ylabel("radius [mm]")


def draw_outside(axis, view, sizes=True):
    """The cage from outside, unrolled at the pitch radius; with its sizes written in."""
    half, width = view["half_sector_mm"], view["cage_width_mm"]
    axis.add_patch(Rectangle((-1.05 * half, -width / 2), 2.1 * half, width, facecolor=CAGE, edgecolor=BLACK, linewidth=0.9))
    axis.fill(view["opening"]["across"], view["opening"]["up"], facecolor="white", edgecolor=BLACK, linewidth=0.9)
    roller, length = view["roller_diameter_mm"], view["roller_length_mm"]
    axis.add_patch(Rectangle((-roller / 2, -length / 2), roller, length, facecolor=ROLLER, edgecolor=BLUE, linewidth=0.9))
    for end in (-1, 1):
        at = end * view["flange_distance_mm"] / 2
        axis.plot([-roller / 2, roller / 2], [at, at], color=GREY, linewidth=0.8, linestyle="--")
    ends = np.array([-view["pocket_length_mm"] / 2, view["pocket_length_mm"] / 2])
    for key, style in (("lip_outer_mm", "-"), ("lip_inner_mm", ":")):
        if view[key] is not None:
            for side in (-1, 1):
                axis.plot(side * view[key] / 2 + view["lean_rad"] * ends, ends, color=BLACK, linewidth=0.9, linestyle=style)
    axis.text(0, 0, "roller", ha="center", va="center", fontsize=7.5)
    size = {"ha": "center", "va": "center", "fontsize": 7.5}
    side = (width + view["pocket_length_mm"]) / 4
    if sizes:
        axis.text(0, side, f"pocket {view['pocket_width_mm']:.3f} × {view['pocket_length_mm']:.3f} mm", **size)
        axis.text(0, -side, f"roller {roller:.3f} × {length:.3f} mm", **size)
    axis.set_xlim(-1.15 * half, 1.15 * half)
    axis.set_ylim(-0.55 * width, 0.55 * width)
    axis.set_title("from outside, unrolled")
    axis.set_xlabel("tangential [mm]")
    axis.set_ylabel("x [mm]")


def pocket(report):
    drawing = report["drawing"]
    section, outside = drawing["section"], drawing["outside"]
    figure, axes = plt.subplot_mosaic([["section", "outside"], ["key", "key"]], figsize=(WIDTH, 5.6), height_ratios=[3.4, 1.5],
                                       width_ratios=[1.2, 1])
    for name in ("section", "outside"):
        axes[name].grid(False)
        axes[name].set_aspect("equal")
    draw_section(axes["section"], section)
    draw_outside(axes["outside"], outside)
    scale = {"section": section["roller_radius_mm"], "outside": outside["roller_length_mm"] / 2}
    shown = [each for each in drawing["clearances"] if each["value_mm"] is not None]
    key = axes["key"]
    key.axis("off")
    key.set_xlim(0, 1)
    key.set_ylim(len(shown) + 1.6, -0.5)
    for number, clearance in enumerate(shown):
        mark = "abcdefghij"[number]
        offset = [part * scale[clearance["view"]] for part in LETTER[clearance["key"]]]
        letter(axes[clearance["view"]], mark, (clearance["across"], clearance["up"]), offset)
        key.text(0.03, number, mark, color=RED, weight="bold", ha="center", va="center")
        key.text(0.07, number, clearance["name"], va="center")
        key.text(0.98, number, f"{clearance['value_mm']:.4f} mm", ha="right", va="center")
    key.text(0, len(shown) + 0.9, "Roller in the middle of its pocket, cage in the middle of the bearing. To scale; right view at the pitch radius,\n"
             "dash-dotted in the left one. Dashed across the roller: flanges of the ring. Lips: outside solid, at the bore dotted.",
             va="center", fontsize=7.5, in_layout=False)
    figure.suptitle(f"Pocket {drawing['pocket']} of {drawing['scene']}", x=0.02, ha="left", fontsize=11, weight="bold")
    return figure
