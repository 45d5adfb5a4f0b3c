"""Which tolerance moves which limited quantity, and where its limit is reached or a jam comes first."""

import matplotlib.pyplot as plt

from common import BLUE, GREY, ORANGE, RED, WIDTH, known, readable
from engine import legend_below

PARTS = {"lot": (BLUE, -0.15), "pocket": (ORANGE, 0.15)}


def draw_shifts(axis, limit, places):
    """Shifts by 0.01 mm and noise of the start, as shares of the distance to the limit."""
    bound = limit["max"] if "max" in limit else limit["min"]
    share = 100 / (abs(bound - known(limit["level"])) or 1)
    noise = share * known(limit["start_noise"])
    axis.axvspan(-noise, noise, color=GREY, alpha=0.2, linewidth=0, label="noise of start")
    for part, (colour, offset) in PARTS.items():
        shown = [shift for shift in limit.get("shifts", []) if shift["part"] == part]
        if not shown:
            continue
        height = [places[shift["key"]] + offset for shift in shown]
        axis.errorbar([share * known(shift["shift"]) for shift in shown], height,
                      xerr=[2 * share * known(shift["error"]) for shift in shown], fmt="none", color=colour, linewidth=1.3,
                      label=f"{part} ±2 std errors")
        for shift, y in zip(shown, height):
            axis.plot(share * known(shift["shift"]), y, "o", color=colour, markersize=5,
                      markerfacecolor=colour if shift["resolved"] else "white")
    axis.axvline(0, color=GREY, linewidth=0.8)


def draw_reach(axis, limit, places, screened):
    for reach in limit["reach"]:
        y, most = places[reach["key"]], reach["searched_mm"]
        axis.plot(screened[reach["key"]], y + 0.25, "|", color=GREY, markersize=9, markeredgewidth=2, label="screened")
        if reach["jam_mm"] is not None:
            axis.plot([reach["jam_mm"], most], [y, y], color=RED, linewidth=6, alpha=0.25, solid_capstyle="butt", label="jams")
        if reach["lower_mm"] is not None:
            axis.plot([reach["lower_mm"], most if reach["upper_mm"] is None else reach["upper_mm"]], [y, y], color=BLUE,
                      linewidth=1.4, label="limit reached")
        if reach["width_mm"] is not None:
            axis.plot(reach["width_mm"], y, "D", color=BLUE, markersize=5)
    axis.set_xlim(0, 1.03 * max(reach["searched_mm"] for reach in limit["reach"]))


def screen(data):
    """One line of two panels for each limit."""
    limits = data["limits"]
    if not limits:
        return None
    keys = [dimension["key"] for dimension in data["dimensions"]]
    places = {key: place for place, key in enumerate(keys)}
    screened = {dimension["key"]: dimension["screened_width_mm"] for dimension in data["dimensions"]}
    height = 1.2 + (0.75 + 0.4 * len(keys)) * len(limits)
    figure, axes = plt.subplots(len(limits), 2, figsize=(WIDTH, height), squeeze=False, sharey=True)
    for (left, right), limit in zip(axes, limits):
        draw_shifts(left, limit, places)
        draw_reach(right, limit, places, screened)
        left.set_yticks(range(len(keys)), [readable(key.split(".")[-1]) for key in keys])
        left.set_ylim(len(keys) - 0.5, -0.5)
        left.set_title(readable(limit["quantity"]), fontsize=9, loc="left")
        for axis in (left, right):
            axis.grid(False, axis="y")
    axes[-1][0].set_xlabel("shift by 0.01 mm, % of the distance to the limit")
    axes[-1][1].set_xlabel("tolerance width [mm]")
    entries = {}
    for axis in axes.flat:
        for handle, label in zip(*axis.get_legend_handles_labels()):
            entries.setdefault(label, handle)
    legend_below(figure, list(entries.values()), list(entries), 0.5 / height)
    jams = "jams alone can decide" if data["jams_alone"] else f"{data['runs']} runs"
    figure.suptitle(f"{data['study']}: {jams}", fontsize=10)
    return figure
