"""Share of bad cages over the width of each tolerance: jams by geometry, limits by their bounds."""

import matplotlib.pyplot as plt

from common import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY, WIDTH, readable
from engine import legend_below

COLOURS = (BLUE, ORANGE, GREEN, PINK, SKY, RED)
DASHES = ("-", "--", "-.", (0, (1, 1)))  # told apart in grey, too
LEAST, MOST = 0.1, 1e6  # ppm


def ppm(shares):
    return [max(1e6 * share, LEAST) for share in shares]


def draw_limit(axis, row, place, dimension, colour, dashes):
    """A line with its band where the bound is extrapolated, else what the runs at their width say."""
    label, width = readable(row["quantity"]) + row["name"].removeprefix(row["quantity"]), dimension["width_mm"]
    if not row["upper_at"]:
        stated = row["upper"] is not None
        axis.plot([width, width], ppm([row["lower"] if stated else 0, row["exact_upper"]]), color=colour,
                  linewidth=3 if stated else 1, linestyle="-" if stated else ":", label=label + (" (counted)" if stated else " (not stated)"))
        axis.plot(width, 1e6 * row["exact_upper"], "v", color=colour, markersize=5)
        return
    upper = ppm(row["upper_at"][place])
    axis.fill_between(dimension["widths_mm"], LEAST, upper, color=colour, alpha=0.1, linewidth=0)
    axis.plot(dimension["widths_mm"], upper, color=colour, linestyle=dashes, label=label + " (extrapolated)")
    axis.plot(width, 1e6 * row["upper"], "v", color=colour, markersize=5)
    axis.plot(width, max(1e6 * row["if_normal"], LEAST), "x", color=colour, markersize=5)


def rare(data):
    """One panel for each tolerance; the others as they are."""
    dimensions = data.get("dimensions", [])
    if not dimensions:
        return None
    rows = [row for row in data["rows"] if "quantity" in row]
    figure, axes = plt.subplots(1, len(dimensions), figsize=(WIDTH, 4), sharey=True, squeeze=False)
    for d, (axis, dimension) in enumerate(zip(axes[0], dimensions)):
        axis.plot(dimension["jams"]["widths_mm"], ppm(dimension["jams"]["share"]), color=BLACK, label="does not fit, exact")
        for place, row in enumerate(rows):
            draw_limit(axis, row, d, dimension, COLOURS[place % len(COLOURS)], DASHES[place % len(DASHES)])
        for mark in (63, 1):
            axis.axhline(mark, color=GREY, linestyle="--", linewidth=0.8)
            axis.annotate(f"{mark} ppm", (1, mark), xycoords=("axes fraction", "data"), xytext=(-2, 2), textcoords="offset points",
                          ha="right", fontsize=7, color=GREY)
        axis.axvline(dimension["width_mm"], color=GREY, linestyle=":", linewidth=0.8)
        axis.plot([], [], "x", color=GREY, markersize=5, label="at the width studied, if normal")
        axis.set_yscale("log")
        axis.locator_params(axis="x", nbins=5)
        axis.set_ylim(LEAST, MOST)
        axis.set_xlim(dimension["widths_mm"][0], dimension["widths_mm"][-1])
        axis.set_xlabel(f"{readable(dimension['key'].split('.')[-1])}, full width [mm]")
    axes[0][0].set_ylabel("bad cages [ppm]")
    entries = {label: handle for axis in axes[0] for handle, label in zip(*axis.get_legend_handles_labels())}
    columns = 2 if max(map(len, entries)) < 45 else 1  # that fit into the figure's width
    height = 2.6 + 0.17 * -(-len(entries) // columns)
    figure.set_size_inches(WIDTH, height)
    legend_below(figure, list(entries.values()), list(entries), (height - 2.3) / height, columns)
    return figure


def of_report(report):
    return rare(report["rare"]) if report.get("rare") else None
