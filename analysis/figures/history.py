"""Yield and limited quantities over studies that are run again and again."""

import math

import matplotlib.pyplot as plt

from common import BLUE, GREY, RED, SKY, WIDTH, known, readable, with_unit

MOST_PANELS = 12


def mark_changes(axis, rows):
    for place, row in enumerate(rows, 1):
        if row["changed"] or row["not_comparable"]:
            axis.axvline(place - 0.5, color=GREY, linestyle=":", linewidth=1.2)
    axis.set_xlim(0.5, len(rows) + 0.5)
    axis.xaxis.get_major_locator().set_params(integer=True)
    axis.set_xlabel("study, as numbered below")


def bars(axis, rows, lower, upper, **style):
    shown = [(place, low, high) for place, low, high in zip(range(1, len(rows) + 1), lower, upper) if math.isfinite(low + high)]
    if shown:
        axis.vlines(*zip(*shown), **style)


def draw_yield(axis, rows):
    low, value, high = ([100 * known(row[name]) for row in rows] for name in ("yield_lower", "yield", "yield_upper"))
    bars(axis, rows, low, high, color=BLUE, linewidth=2)
    axis.plot(range(1, len(rows) + 1), value, "o", color=BLUE, markersize=4)
    axis.set_ylabel("yield [%]")
    mark_changes(axis, rows)


def draw_quantity(axis, rows, name):
    entries = [row["quantities"].get(name, {}) for row in rows]

    def column(key):
        return [known(entry.get(key)) for entry in entries]

    bars(axis, rows, column("quantile_0.05"), column("quantile_0.95"), color=SKY, linewidth=5, alpha=0.6)
    bars(axis, rows, column("mean_lower"), column("mean_upper"), color=BLUE, linewidth=2)
    axis.plot(range(1, len(rows) + 1), column("mean"), "_", color=BLUE, markersize=8)
    for side in ("minimum", "maximum"):
        if not math.isnan(known(entries[-1][side])):
            axis.axhline(entries[-1][side], color=RED, linestyle="--", linewidth=1.2)
    axis.set_ylabel(with_unit(readable(name), entries[-1]["unit"]), fontsize=8)
    mark_changes(axis, rows)


def history(data):
    """One panel for the yield, one for each quantity that the last study limits."""
    rows = data["rows"]
    names = list(rows[-1]["quantities"])[:MOST_PANELS - 1]
    lines = math.ceil((len(names) + 1) / 2)
    figure, axes = plt.subplots(lines, 2, figsize=(WIDTH, 0.3 + 2.0 * lines), squeeze=False)
    draw_yield(axes.flat[0], rows)
    for axis, name in zip(axes.flat[1:], names):
        draw_quantity(axis, rows, name)
    for axis in axes.flat[len(names) + 1:]:
        axis.remove()
    return figure
