"""The bearing of a study with its pocket and clearances, to scale."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, FancyArrowPatch, Rectangle, Wedge

import pocket
from common import BLACK, BLUE, GREY, RED, WIDTH
from pocket import CAGE, ROLLER, STEEL

EDGE = {"edgecolor": BLACK, "linewidth": 0.6}


def ring(axis, inner, outer, colour):
    axis.add_patch(Wedge((0, 0), outer, 0, 360, width=outer - inner, facecolor=colour, **EDGE))


def draw_cage(axis, section):
    """Bars between the rollers, seen along the axis."""
    cage, count = section["cage"], section["rollers"]
    gap = np.degrees(cage["pocket_width_mm"] / section["pitch_radius_mm"]) / 2
    for number in range(count):
        middle = 90 + 360 * number / count
        axis.add_patch(Wedge((0, 0), cage["outer_mm"] / 2, middle + gap, middle + 360 / count - gap,
                             width=(cage["outer_mm"] - cage["inner_mm"]) / 2, facecolor=CAGE, **EDGE))


def draw_front(axis, section):
    """Along the axis: rings, rollers, cage, load and sense of rotation."""
    outside = section["outside_mm"] / 2
    ring(axis, section["outer_raceway_mm"] / 2, outside, STEEL)
    ring(axis, section["bore_mm"] / 2, section["inner_raceway_mm"] / 2, STEEL)
    draw_cage(axis, section)
    for number in range(section["rollers"]):
        angle = np.radians(90 + 360 * number / section["rollers"])
        axis.add_patch(Circle((section["pitch_radius_mm"] * np.cos(angle), section["pitch_radius_mm"] * np.sin(angle)),
                              section["roller_diameter_mm"] / 2, facecolor=ROLLER, edgecolor=BLUE, linewidth=0.7, zorder=3))
    bore = section["bore_mm"] / 2
    direction = np.radians(section["load_direction_deg"] - 90)
    tip = np.array([np.cos(direction), np.sin(direction)]) * 0.85 * bore
    axis.add_patch(FancyArrowPatch(-0.75 * tip, tip, arrowstyle="-|>", mutation_scale=11, color=RED, linewidth=1.8, zorder=5))
    words = f"{section['radial_load_N']:.6g} N"
    if section["inner_speed_rpm"] or section["outer_speed_rpm"]:
        turns = "inner_speed_rpm" if section["inner_speed_rpm"] else "outer_speed_rpm"
        radius = 0.5 * (bore + section["inner_raceway_mm"] / 2) if turns == "inner_speed_rpm" else 1.06 * outside
        words += f", {section[turns]:.6g} r/min"
        sense = 1 if section[turns] > 0 else -1
        ends = np.radians([20, 75]) if sense > 0 else np.radians([75, 20])
        points = [radius * np.array([np.cos(a), np.sin(a)]) for a in ends]
        axis.add_patch(FancyArrowPatch(*points, connectionstyle=f"arc3,rad={0.24 * sense}", arrowstyle="-|>", mutation_scale=9,
                                       color=BLACK, linewidth=1.1, zorder=6))
    axis.set_xlim(-1.12 * outside, 1.12 * outside)
    axis.set_ylim(-1.12 * outside, 1.12 * outside)
    axis.set_title(words, loc="center", fontsize=8.5)


def box(axis, left, right, low, high, colour, **style):
    axis.add_patch(Rectangle((left, low), right - left, high - low, facecolor=colour, **{**EDGE, **style}))


def draw_side(axis, section):
    """The upper half in a plane through the axis."""
    half, length = section["width_mm"] / 2, section["roller_length_mm"] / 2
    pitch, roller = section["pitch_radius_mm"], section["roller_diameter_mm"] / 2
    box(axis, -half, half, section["outer_raceway_mm"] / 2, section["outside_mm"] / 2, STEEL)
    box(axis, -half, half, section["bore_mm"] / 2, section["inner_raceway_mm"] / 2, STEEL)
    for sides, land, race in ((section["outer_flanges"], section["outer_land_mm"], section["outer_raceway_mm"]),
                              (section["inner_flanges"], section["inner_land_mm"], section["inner_raceway_mm"])):
        low, high = sorted((land / 2, race / 2))
        if sides in ("both", "left"):
            box(axis, -half, -1.01 * length, low, high, STEEL)
        if sides in ("both", "right"):
            box(axis, 1.01 * length, half, low, high, STEEL)
    cage = section["cage"]
    for side in (-1, 1):
        ends = sorted((side * cage["width_mm"] / 2, side * cage["pocket_length_mm"] / 2))
        box(axis, *ends, cage["inner_mm"] / 2, cage["outer_mm"] / 2, CAGE)
    box(axis, -length, length, pitch - roller, pitch + roller, ROLLER, edgecolor=BLUE)
    axis.axhline(0, color=GREY, linestyle="-.", linewidth=0.8)
    axis.set_xlim(-1.15 * half, 1.15 * half)
    axis.set_ylim(-0.1 * section["outside_mm"] / 2, 1.06 * section["outside_mm"] / 2)
    axis.set_title(f"bore {section['bore_mm']:.6g}, outside {section['outside_mm']:.6g},\nwidth {section['width_mm']:.6g} mm", loc="center",
                   fontsize=8.5)


def draw_key(axis, drawing, axes):
    """Letters at the clearances of the pocket, and what they are."""
    section, outside = drawing["section"], drawing["outside"]
    scale = {"section": section["roller_radius_mm"], "outside": outside["roller_length_mm"] / 2}
    shown = [each for each in drawing["clearances"] if each["value_mm"] is not None]
    axis.set_xlim(0, 1)
    axis.set_ylim(2 * len(shown), -0.8)
    for number, clearance in enumerate(shown):
        mark = "abcdefghij"[number]
        offset = [part * scale[clearance["view"]] for part in pocket.LETTER[clearance["key"]]]
        pocket.letter(axes[clearance["view"]], mark, (clearance["across"], clearance["up"]), offset)
        axis.text(0.02, 2 * number, mark, color=RED, weight="bold", ha="center", va="center", fontsize=8)
        axis.text(0.08, 2 * number, f"{clearance['value_mm']:.3f} mm", va="center", fontsize=8)
        words, line, lines = clearance["name"].split(), "", []
        for word in words:
            if len(line) + len(word) > 34 and len(lines) < 1:
                lines.append(line)
                line = ""
            line = f"{line} {word}".strip()
        axis.text(0.36, 2 * number, "\n".join(lines + [line]), va="center", fontsize=6.8, linespacing=1.05)


def bearing(report):
    facts = report.get("bearing")
    if not facts or "section" not in facts:
        return None
    section, drawing = facts["section"], facts["drawing"]
    figure, axes = plt.subplot_mosaic([["front", "side", "key"], ["section", "outside", "outside"]], figsize=(WIDTH, 3.75),
                                      width_ratios=[1.25, 0.62, 1.3], height_ratios=[1, 0.95])
    pocket.draw_section(axes["section"], drawing["section"])
    pocket.draw_outside(axes["outside"], drawing["outside"], sizes=False)
    draw_key(axes["key"], drawing, axes)
    axes["section"].set_title("pocket along the axis", fontsize=8.5, loc="center")
    view = drawing["outside"]
    for name in ("section", "outside"):
        axes[name].set_title("", loc="left")
    axes["outside"].set_title(f"pocket {view['pocket_width_mm']:.6g} × {view['pocket_length_mm']:.6g} mm, from outside, unrolled",
                              fontsize=8.5, loc="center")
    draw_front(axes["front"], section)
    draw_side(axes["side"], section)
    for axis in axes.values():
        axis.grid(False)
        axis.axis("off")
    for name in set(axes) - {"key"}:
        axes[name].set_aspect("equal")
    return figure
