"""Responses of a grid: quantities over the levels of one dimension."""

import math

import matplotlib.pyplot as plt

from common import BLUE, GREEN, GREY, ORANGE, PINK, WIDTH, known, readable, with_unit

SETTING_COLOURS = [BLUE, ORANGE, GREEN, PINK]
MOST_NAMES = 6  # levels whose names fit side by side
MOST_SETTINGS = 4  # what a figure has room for; report.json holds all
UNEVEN = 5  # levels whose distances differ by more than this factor stand side by side, each with its name


def level_label(response):
    return with_unit(f"deviation of the {response['name']}", response["unit"])


def short_level(level):
    return f"{level:+g}" if level else "0"


def is_uneven(levels):
    steps = [b - a for a, b in zip(levels, levels[1:])]
    return len(steps) > 1 and max(steps) > UNEVEN * min(steps)


def name_levels(axis, levels):
    """Ticks for levels that stand side by side."""
    many = len(levels) > MOST_NAMES
    axis.set_xticks(range(len(levels)), [short_level(level) for level in levels], rotation=90 if many else 0,
                    fontsize=7 if many else None)


def settings_of(response):
    return response["settings"][:MOST_SETTINGS]


def setting_letter(response, index):
    return f"({'abcd'[index]})" if len(response["settings"]) > 1 else ""


def settings_note(figure, response):
    """Names the settings below the figure, where there are several."""
    if len(response["settings"]) > 1:
        words = "\n".join(f"{setting_letter(response, s)} {text}" for s, text in enumerate(settings_of(response)))
        figure.supxlabel(words, x=0.01, ha="left", fontsize=7.5)


def band(axis, response, cells, title, unit):
    """Median and 5 to 95 % of the runs over the level, one colour for each setting."""
    uneven = is_uneven(response["levels"])
    levels = list(range(len(response["levels"]))) if uneven else response["levels"]
    for setting, _ in enumerate(settings_of(response)):
        low, middle, high = ([known(cell[key]) for cell in cells[setting]] for key in ("low", "median", "high"))
        colour = SETTING_COLOURS[setting]
        axis.fill_between(levels, low, high, color=colour, alpha=0.15, linewidth=0)
        axis.plot(levels, middle, "o-", color=colour, markersize=3.5, label=setting_letter(response, setting) or None)
    axis.set_title(title, fontsize=8.5)
    axis.set_ylabel(f"[{unit}]" if unit not in ("", "-") else "[-]")
    axis.ticklabel_format(axis="y", useOffset=False)
    axis.locator_params(axis="y", nbins=5)
    if uneven:
        name_levels(axis, response["levels"])


def slip_bars(report):
    response = report["response"]
    entries = [entry for entry in response["quantities"] if entry["quantity"].startswith("roller_slip_ratio")] if response else []
    if not entries:
        return None
    figure, axes = plt.subplots(1, len(entries), figsize=(WIDTH, 2.7), squeeze=False)
    settings = settings_of(response)
    for axis, entry in zip(axes[0], entries):
        for setting, _ in enumerate(settings):
            cells = entry["cells"][setting]
            middle = [100 * known(cell["median"]) for cell in cells]
            error = [[m - 100 * known(cell["low"]) for m, cell in zip(middle, cells)],
                     [100 * known(cell["high"]) - m for m, cell in zip(middle, cells)]]
            width = 0.8 / len(settings)
            axis.bar([level + (setting - (len(settings) - 1) / 2) * width for level in range(len(cells))], middle, width,
                     yerr=error, color=SETTING_COLOURS[setting], ecolor=GREY, capsize=2, label=setting_letter(response, setting) or None)
        name_levels(axis, response["levels"])
        axis.set_xlabel(level_label(response))
        axis.set_ylabel("slip [%]")
        axis.set_title(readable(entry["quantity"]))
        axis.grid(False, axis="x")
        axis.margins(y=0.18)
    if len(settings) > 1:
        axes[0][0].legend(loc="upper right", ncols=len(settings))
    settings_note(figure, response)
    return figure


def response_quantities(report):
    response = report["response"]
    certain = {"rises", "falls", "not monotone"}
    entries = [entry for entry in response["quantities"] if certain & set(entry["course"])] if response else []
    if response and not entries:
        entries = response["quantities"]
    if not entries:
        return None
    columns = min(3, len(entries))
    rows = math.ceil(len(entries) / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 1.75 * rows + 0.4), squeeze=False)
    for axis in axes.flat[len(entries):]:
        axis.set_visible(False)
    for axis, entry in zip(axes.flat, entries):
        band(axis, response, entry["cells"], readable(entry["quantity"]), entry["unit"])
        axis.tick_params(labelsize=7)
        axis.set_xlabel(with_unit("deviation", response["unit"]))
    if len(response["settings"]) > 1:
        axes[0][0].legend(loc="best")
    settings_note(figure, response)
    return figure


def figures():
    """Every figure of this file by name."""
    return {"slip_bars": slip_bars, "response_quantities": response_quantities}
