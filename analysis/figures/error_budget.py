"""What the means may be off by: errors of the model's settings beside the statistical error."""

import math

import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter

from common import BLUE, GREEN, GREY, ORANGE, PINK, RED, WIDTH, known, readable
from engine import legend_below

COLOURS = {"integrator": BLUE, "modes": RED, "slices": GREEN, "mesh": PINK, "window": ORANGE}
MARKERS = {"integrator": "o", "modes": "s", "slices": "D", "mesh": "^", "window": "v"}
MOST_ROWS = 8


def shown_quantities(report):
    """The limited quantities, without any the first of all; only those whose errors have a scale."""
    scaled = [entry for entry in report["error_budget"]["quantities"]
              if known(entry["sources"][0]["error"]["value"]) > 0]
    return ([entry for entry in scaled if entry["limited"]] or scaled)[:MOST_ROWS]


def settings_of(entry):
    return [source for source in entry["sources"] if source["source"] in COLOURS and source["error"]["value"] is not None]


def draw_row(axis, row, entry):
    sources = {source["source"]: source for source in entry["sources"]}
    scale = known(sources["statistical"]["error"]["value"])
    noise = known(sources["noise"]["error"]["value"]) / scale
    axis.fill_between([-1, 1], row - 0.42, row + 0.42, color=GREY, alpha=0.3, linewidth=0, label="statistical, 1 SE")
    if math.isfinite(noise):
        axis.fill_between([-noise, noise], row + 0.36, row + 0.42, color=GREY, alpha=0.9, linewidth=0, label="noise")
    for source in settings_of(entry):
        name = source["source"]
        place = row + 0.14 * (list(COLOURS).index(name) - 2)
        ends = [known(source["error"][key]) / scale for key in ("lower", "upper")]
        axis.plot(ends, [place, place], color=COLOURS[name], linewidth=1.3)
        axis.plot(known(source["error"]["value"]) / scale, place, MARKERS[name], color=COLOURS[name], markersize=4.5,
                  markerfacecolor=COLOURS[name] if source["state"] == "resolved" else "white")
        axis.plot([], [], MARKERS[name] + "-", color=COLOURS[name], linewidth=1.3, markersize=4.5, label=name)


def error_budget(report):
    """One row a quantity: each setting's error as run - refined, in standard errors, on a scale linear within one."""
    entries = shown_quantities(report)
    if not any(settings_of(entry) for entry in entries):
        return None
    height = 1.25 + 0.62 * len(entries)
    figure, axis = plt.subplots(figsize=(WIDTH, height))
    for row, entry in enumerate(entries):
        draw_row(axis, row, entry)
    axis.axvline(0, color=GREY, linewidth=0.8)
    axis.set_xscale("symlog", linthresh=1, linscale=0.6)
    low, high = axis.get_xlim()
    axis.set_xlim(min(1.3 * low, -1.5), max(1.3 * high, 1.5))
    reach = max(abs(x) for x in axis.get_xlim())
    ticks = [0.0] + [side * 10.0**power for power in range(6) for side in (-1, 1) if 10.0**power <= reach]
    axis.set_xticks(sorted(ticks))
    axis.xaxis.set_major_formatter(FuncFormatter(lambda x, _: f"{x:+g}" if x else "0"))
    axis.minorticks_off()
    axis.set_yticks(range(len(entries)), [readable(entry["quantity"]) for entry in entries])
    axis.set_ylim(len(entries) - 0.5, -0.5)
    axis.tick_params(axis="y", length=0)
    axis.grid(False, axis="y")
    axis.set_xlabel("error of the mean [standard errors], positive: the mean is too large")
    named = {}
    for handle, label in zip(*axis.get_legend_handles_labels()):
        named.setdefault(label, handle)
    legend_below(figure, list(named.values()), list(named), 0.5 / height)
    return figure
