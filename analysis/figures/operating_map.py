"""Widest tolerance over two keys of an operating point, and what decides there."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.patches import Patch

from common import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY, WIDTH, readable, with_unit
from engine import legend_below

COLOURS, HATCHES = [ORANGE, BLUE, GREEN, PINK, SKY, RED], ["", "//", "..", "xx", "\\\\", "++"]
NOTHING, UNRESOLVED, FAILED = "nothing within the candidates", "not resolved", "no answer"
NAMES = {"load.radial_N": "radial load [N]", "speed.inner_rpm": "speed of the inner ring [r/min]"}
MOST_PALE = 0.8  # share of white in the colour of the widest candidate


def edges_of(values, logarithmic):
    """Edges of cells about the values: half way to the next one, and the outermost values themselves."""
    scale = np.log(values) if logarithmic else np.asarray(values, float)
    edges = np.concatenate([scale[:1], (scale[1:] + scale[:-1]) / 2, scale[-1:]])
    return np.exp(edges) if logarithmic else edges


def middle(edges, place, logarithmic):
    low, high = edges[place], edges[place + 1]
    return (low * high) ** 0.5 if logarithmic else (low + high) / 2


def pale(colour, share):
    return tuple(1 - (1 - part) * (1 - share) for part in to_rgb(colour))


def short(name):
    """"driving slip" of driving_slip_ratio."""
    return readable(name).removesuffix(" ratio").removesuffix(" utilisation").removeprefix("cage ").removeprefix("operating ")


def standing(answer):
    """What decides a cell, as the legend has it."""
    return FAILED if answer["problem"] else UNRESOLVED if not answer["resolved"] else answer["decides"] or NOTHING


def draw_grades(axis, rows, up, across):
    """Lines between cells of different grades."""
    ends_up, ends_across = edges_of(up["values"], up["logarithmic"]), edges_of(across["values"], across["logarithmic"])
    grades = [[None if answer["problem"] else answer["grade"] for answer in row] for row in rows]
    for row, line in enumerate(grades):
        for column, grade in enumerate(line):
            x, y = (ends_across[column], ends_across[column + 1]), (ends_up[row], ends_up[row + 1])
            if column + 1 < len(line) and line[column + 1] != grade:
                axis.plot((x[1], x[1]), y, color=BLACK, linewidth=1.3, zorder=3)
            if row + 1 < len(grades) and grades[row + 1][column] != grade:
                axis.plot(x, (y[1], y[1]), color=BLACK, linewidth=1.3, zorder=3)


def draw_lines(axis, data):
    labelled = None
    for line in data["lines"]:
        up, across = zip(*line["points"])
        (left, right), (low, high) = axis.get_xlim(), axis.get_ylim()
        if not any(left <= x <= right and low <= y <= high for x, y in zip(across, up)):
            continue
        speed_factor = line["name"].startswith("n d_m")
        style = dict(color=GREY, linestyle=":", linewidth=1) if speed_factor else dict(
            color=BLACK, linestyle="--" if line["name"] == "minimum load" else "-.", linewidth=1.6, label=f"maker's {line['name']}")
        axis.plot(across, up, zorder=4, **style)
        if speed_factor:
            name = f"n$\\cdot$d$_m$ {float(line['name'].split()[-1]):,.0f}".replace(",", "\N{THIN SPACE}")
            upright = across[0] == across[-1]
            place = axis.transAxes.inverted().transform(axis.transData.transform((across[-1], up[-1])))
            if labelled is not None and max(abs(place - labelled)) < 0.14:
                continue
            labelled = place
            axis.annotate(name, (across[-1], up[-1]), xytext=(0, 2) if upright else (2, 0), textcoords="offset points", fontsize=6,
                          ha="center" if upright else "left", va="bottom" if upright else "center", color="#555555", annotation_clip=True)


def draw_points(axis, data, up, across):
    for number, point in enumerate(data["points"]):
        y, x = point["at"]
        if not (across["values"][0] <= x <= across["values"][-1] and up["values"][0] <= y <= up["values"][-1]):
            continue
        axis.plot(x, y, "*", markersize=11, markerfacecolor="white", markeredgecolor=BLACK, zorder=6, clip_on=False,
                  label="the study's own points" if number == 0 else None)
        words = min(up["values"], key=lambda value: abs(np.log(value / y) if up["logarithmic"] else value - y))  # of its cell
        axis.annotate(point["name"], (x, y), xytext=(0, 6 if y > words else -13), textcoords="offset points", fontsize=7, zorder=7,
                      ha="center", bbox=dict(facecolor="white", alpha=0.7, linewidth=0, pad=0.6))


def draw_cells(axis, dimension, rows, up, across, causes):
    ends_up, ends_across = edges_of(up["values"], up["logarithmic"]), edges_of(across["values"], across["logarithmic"])
    last = max(dimension["candidates"] - 1, 1)
    for row, line in enumerate(rows):
        for column, answer in enumerate(line):
            name = standing(answer)
            colour = COLOURS[causes.index(name) % len(COLOURS)] if name in causes else BLACK if name == FAILED else GREY
            share = MOST_PALE * max(answer["candidate"], 0) / last if name in causes else MOST_PALE if name == NOTHING else 0.92
            hatch = HATCHES[causes.index(name) % len(HATCHES)] if name in causes else "" if name == NOTHING else "/" if name == FAILED else "-"
            corner, far = (ends_across[column], ends_up[row]), (ends_across[column + 1], ends_up[row + 1])
            axis.add_patch(plt.Rectangle(corner, far[0] - corner[0], far[1] - corner[1], facecolor=pale(colour, share),
                                         edgecolor="white", linewidth=0.8, zorder=1))
            axis.add_patch(plt.Rectangle(corner, far[0] - corner[0], far[1] - corner[1], facecolor="none", edgecolor=pale(colour, 0.45),
                                         hatch=hatch, linewidth=0, zorder=1))
            words = answer["grade"]
            if answer["problem"]:
                words = "no\nanswer"
            elif not answer["resolved"]:
                words = f"{answer['lower_grade']} to {answer['upper_grade']}" + (f"\n{short(answer['decides'])}?" if answer["decides"] else "")
            elif answer["decides"]:
                words += "\n" + short(answer["decides"]) + ("?" if len(answer["may_decide"]) > 1 else "")
            axis.text(middle(ends_across, column, across["logarithmic"]), middle(ends_up, row, up["logarithmic"]), words, ha="center",
                      va="center", fontsize=6.5, zorder=5, linespacing=1.1, bbox=dict(facecolor="white", alpha=0.65, linewidth=0, pad=0.8))


def label_of(axis):
    section, key = axis["key"].split(".", 1)
    return NAMES.get(axis["key"]) or with_unit(f"{section}, {readable(key)}", axis["unit"])


def operating_map(data):
    """One panel for each dimension: colour by what decides, pale where the tolerance is wide, hatched to be read in grey."""
    up, across = data["axes"]
    columns = len(across["values"])
    causes = sorted({row["decides"] for row in data["rows"] if row["decides"] and row["resolved"]}, key=lambda name: (name != "jams", name))
    count = len(data["dimensions"])
    height = 0.8 + 4.3 * count  # the legend and a panel each
    figure, axes = plt.subplots(count, 1, figsize=(WIDTH, height), squeeze=False)
    shown = {standing(row) for row in data["rows"]}
    for axis, dimension in zip(axes[:, 0], data["dimensions"]):
        rows = [row for row in data["rows"] if row["tolerance"] == dimension["key"]]
        rows = [rows[start:start + columns] for start in range(0, len(rows), columns)]
        axis.set_xscale("log" if across["logarithmic"] else "linear")
        axis.set_yscale("log" if up["logarithmic"] else "linear")
        axis.set_xlim(across["values"][0], across["values"][-1])
        axis.set_ylim(up["values"][0], up["values"][-1])
        draw_cells(axis, dimension, rows, up, across, causes)
        draw_grades(axis, rows, up, across)
        draw_lines(axis, data)
        draw_points(axis, data, up, across)
        for direction, ticks in ((axis.xaxis, across), (axis.yaxis, up)):
            direction.set_ticks(ticks["values"], [f"{float(f'{value:.3g}'):g}" for value in ticks["values"]])
            direction.set_ticks([], minor=True)
        axis.set_xlabel(label_of(across))
        axis.set_ylabel(label_of(up))
        axis.set_title(f"widest tolerance of the {readable(dimension['key'].split('.')[-1])}", pad=14, fontsize=9)
        axis.grid(False)
    patches = [Patch(facecolor=pale(COLOURS[place % len(COLOURS)], 0.35), edgecolor="white", hatch=HATCHES[place % len(HATCHES)],
                     label=f"{short(name)} decide{'s' if name != 'jams' else ''}") for place, name in enumerate(causes)]
    patches += [Patch(facecolor=pale(colour, share), edgecolor=pale(colour, 0.45), hatch=hatch, label=name) for name, colour, share, hatch in (
        (NOTHING, GREY, MOST_PALE, ""), (UNRESOLVED, GREY, 0.92, "-"), (FAILED, BLACK, 0.92, "/")) if name in shown]
    handles, labels = axes[0][0].get_legend_handles_labels()
    legend_below(figure, patches + handles, [patch.get_label() for patch in patches] + labels, 0.8 / height, 3)
    return figure
