"""Responses of a grid: curves over time, and quantities over the levels of one dimension."""

import math

import matplotlib.pyplot as plt

from common import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, WIDTH, known, readable, with_unit

LEVEL_COLOURS = [BLUE, BLACK, RED]  # lowest, nominal, highest
SETTING_COLOURS = [BLUE, ORANGE, GREEN, PINK]
RUN_COLOURS = [BLUE, ORANGE, GREEN]
MOST_SETTINGS = 4  # what a figure has room for; report.json holds all
MOST_PATHS = 6  # columns of paths, likewise
UNEVEN = 5  # levels whose distances differ by more than this factor stand side by side, each with its name
CHANNELS = ["cage_stress", "cage_velocity", "cage_speed", "ring_velocity", "ring_displacement", "ring_acceleration",
            "roller_spin"]


def level_text(response, level):
    unit = "" if response["unit"] == "-" else f" {response['unit']}"
    return f"{response['levels'][level]:+g}{unit}" if response["levels"][level] else "nominal"


def level_label(response):
    return with_unit(f"deviation of the {response['name']}", response["unit"])


def short_level(level):
    return f"{level:+g}" if level else "0"


def is_uneven(levels):
    steps = [b - a for a, b in zip(levels, levels[1:])]
    return len(steps) > 1 and max(steps) > UNEVEN * min(steps)


def name_levels(axis, levels):
    """Ticks for levels that stand side by side."""
    many = len(levels) > MOST_PATHS
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


def channel_figure(name):
    def draw(report):
        response = report["response"]
        if not response or not response["history"]:
            return None
        history = response["history"]
        channel = next((entry for entry in history["channels"] if entry["channel"] == name), None)
        if channel is None:
            return None
        rows = len(settings_of(response))
        figure, axes = plt.subplot_mosaic(
            [[f"time{row}"] * 3 + ["mean" if row < rows / 2 else "fluctuation"] * 2 for row in range(rows)]
            if rows > 1 else [["time0"] * 3 + ["mean"] * 2, ["time0"] * 3 + ["fluctuation"] * 2],
            figsize=(WIDTH, 1.9 * max(rows, 2)))
        for row in range(rows):
            axis = axes[f"time{row}"]
            for place, level in enumerate(history["shown_levels"]):
                curves = channel["curves"][row][place]
                if curves is None:
                    continue
                colour = LEVEL_COLOURS[place % 3] if len(history["shown_levels"]) == 3 else RUN_COLOURS[place % 3]
                axis.fill_between(history["time_ms"], [known(v) for v in curves["low"]], [known(v) for v in curves["high"]],
                                  color=colour, alpha=0.10, linewidth=0)
                axis.plot(history["time_ms"], [known(v) for v in curves["run"]], color=colour, linewidth=0.8,
                          label=level_text(response, level))
            axis.set_ylabel(with_unit(readable(name), channel["unit"]))
            axis.set_title(setting_letter(response, row), fontsize=8.5)
            axis.ticklabel_format(axis="y", useOffset=False)
            axis.margins(x=0)
            if row == 0:
                axis.legend(ncols=3, loc="lower right", bbox_to_anchor=(1, 1), borderaxespad=0.1, handlelength=1, columnspacing=1)
        axes[f"time{rows - 1}"].set_xlabel("time in the measuring window [ms]")
        band(axes["mean"], response, channel["mean"], "mean over time", channel["unit"])
        band(axes["fluctuation"], response, channel["fluctuation"], "standard deviation over time", channel["unit"])
        axes["fluctuation"].set_xlabel(with_unit("deviation", response["unit"]))
        if len(response["settings"]) > 1:
            axes["mean"].legend(loc="best", ncols=2)
        settings_note(figure, response)
        return figure
    return draw


def extent(orbit, direction):
    """Range of all paths along y or z."""
    values = [v for setting in orbit["cells"] for level in setting for run in level for v in map(known, run[direction])
              if not math.isnan(v)]
    return max(values) - min(values) or 1.0 if values else 1.0


def orbit_figure(body):
    def draw(report):
        response = report["response"]
        if not response or not response["history"]:
            return None
        orbit = next((entry for entry in response["history"]["orbits"] if entry["body"] == body), None)
        if orbit is None:
            return None
        rows, count = len(settings_of(response)), len(response["levels"])
        columns = min(count, MOST_PATHS)
        shown = [round(column * (count - 1) / max(columns - 1, 1)) for column in range(columns)]
        panel = (WIDTH - 0.6) / columns * min(max(extent(orbit, "z") / extent(orbit, "y"), 0.3), 1.5)
        figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 0.8 + (panel + 0.1) * rows), squeeze=False,
                                    sharex=True, sharey=True)
        for row in range(rows):
            for column in range(columns):
                axis = axes[row][column]
                for run, colour in reversed(list(zip(orbit["cells"][row][shown[column]], RUN_COLOURS))):
                    axis.plot([known(v) for v in run["y"]], [known(v) for v in run["z"]], color=colour, linewidth=0.35)
                axis.set_aspect("equal", adjustable="box")
                axis.tick_params(labelsize=6.5)
                axis.locator_params(nbins=4)
                if row == 0:
                    axis.set_title(level_text(response, shown[column]), fontsize=8.5)
                if row == rows - 1:
                    axis.set_xlabel(f"y [{orbit['unit']}]", fontsize=7.5)
            axes[row][0].set_ylabel(f"{setting_letter(response, row)} z [{orbit['unit']}]".strip(), fontsize=7.5)
        settings_note(figure, response)
        return figure
    return draw


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
    return {**{f"response_{name}": channel_figure(name) for name in CHANNELS},
            "orbit_cage": orbit_figure("cage"), "orbit_ring": orbit_figure("ring"),
            "slip_bars": slip_bars, "response_quantities": response_quantities}
