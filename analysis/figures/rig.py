"""Slip of the cage as a rig has measured it, beside the model's."""

import math

import matplotlib.pyplot as plt

from common import BLUE, RED, SKY, WIDTH, known
from engine import legend_below

MOST_PANELS = 12
AXES = {"radial_N": ("radial load [N]", "{:g} N"), "speed_rpm": ("inner ring [r/min]", "{:g} r/min")}


def draw_panel(axis, rows, over):
    rows = sorted(rows, key=lambda row: row[over])
    place = [row[over] for row in rows]

    def bars(lower, upper, **style):
        shown = [(x, 100 * known(row[lower]), 100 * known(row[upper])) for x, row in zip(place, rows) if row[lower] is not None]
        if shown:
            axis.vlines(*zip(*shown), **style)

    bars("lower", "upper", color=SKY, linewidth=5, alpha=0.6, label="interval over assumptions")
    bars("starts_lower", "starts_upper", color=BLUE, linewidth=2, label="interval over starts")
    axis.plot(place, [100 * known(row["slip"]) for row in rows], "_", color=BLUE, markersize=9, markeredgewidth=1.6, label="predicted")
    axis.plot(place, [100 * row["measured_slip"] for row in rows], "o", color=RED, markersize=4, markerfacecolor="white",
              label="measured")
    axis.margins(x=0.12)


def rig(data):
    """One panel a speed over load, or a load over speed, whichever makes fewer."""
    rows = data["rows"]
    fixed, over = sorted(AXES, key=lambda key: (len({row[key] for row in rows}), key == "radial_N"))
    panels = sorted({row[fixed] for row in rows})
    shown = panels[:MOST_PANELS]
    columns = min(3, len(shown))
    lines = math.ceil(len(shown) / columns)
    height = 1.0 + 2.1 * lines
    figure, axes = plt.subplots(lines, columns, figsize=(WIDTH, height), squeeze=False)
    for axis in axes.flat[len(shown):]:
        axis.remove()
    for axis, value in zip(axes.flat, shown):
        draw_panel(axis, [row for row in rows if row[fixed] == value], over)
        axis.set_title(AXES[fixed][1].format(value), fontsize=9)
        axis.set_xlabel(AXES[over][0])
    for line in axes:
        line[0].set_ylabel("slip of the cage [%]")
    handles, labels = axes.flat[0].get_legend_handles_labels()
    legend_below(figure, handles, labels, 0.35 / height)
    more = f"; the first {len(shown)} of {len(panels)}" if len(panels) > len(shown) else ""
    figure.suptitle(f"{data['scene']} beside {data['file']}{more}", fontsize=10)
    return figure
