"""Histograms, convergence and run health."""

import matplotlib.pyplot as plt

from common import BLUE, GREEN, GREY, RED, WIDTH, draw_limits, known, quantity_of, readable, with_unit


def bars(axis, histogram, color=BLUE):
    edges, counts = histogram["edges"], histogram["counts"]
    if counts:
        axis.bar(edges[:-1], counts, width=[b - a for a, b in zip(edges, edges[1:])], align="edge",
                 color=color, edgecolor="white", linewidth=0.4)


def reach(histogram):
    """Ends of the drawn scale: the data, and half their spread on either side."""
    low, high = histogram["edges"][0], histogram["edges"][-1]
    return low - 0.5 * (high - low), high + 0.5 * (high - low)


def far_limits(limit, histogram):
    """The bounds that lie beyond the scale, in words."""
    low, high = reach(histogram)
    return [f"limit {limit[key]:g} far {'above' if limit[key] > high else 'below'}"
            for key in ("minimum", "maximum") if limit[key] is not None and not low <= limit[key] <= high]


def limited_quantities(report):
    """Histograms of the quantities with limits, on the scale of the data."""
    limits = [(entry, quantity_of(report, entry["quantity"])) for entry in report["limits"]["each"]]
    limits = [(limit, entry) for limit, entry in limits if entry and entry["histogram"]["counts"]]
    if not limits:
        return None
    roles = {entry["quantity"]: entry["role"] for entry in report["margins"]["each"]}
    columns = min(3 if len(limits) > 4 else 2, len(limits))
    rows = -(-len(limits) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 1.75 * rows), squeeze=False)
    for axis in axes.flat[len(limits):]:
        axis.set_visible(False)
    for axis, (limit, entry) in zip(axes.flat, limits):
        bars(axis, entry["histogram"])
        far = far_limits(limit, entry["histogram"])
        drawn = {key: limit[key] if limit[key] is not None and reach(entry["histogram"])[0] <= limit[key] <= reach(entry["histogram"])[1]
                 else None for key in ("minimum", "maximum")}
        draw_limits(axis, drawn)
        words = far + ([roles[limit["quantity"]]] if far and roles.get(limit["quantity"]) == "met by enough runs" else [])
        axis.set_title("\n".join(words), fontsize=7.5, color=RED)
        axis.set_xlabel(two_lines(with_unit(readable(limit["quantity"]), entry["unit"]), width=24), fontsize=8)
        axis.set_ylabel("runs", fontsize=8)
        axis.locator_params(axis="x", nbins=5)
        if any(value is not None for value in drawn.values()):
            axis.legend(loc="upper right", fontsize=7)
    return figure


PANELS = 20  # of a figure; two of them fill a page


def varying(report):
    """Quantities without limits that vary and are no bookkeeping."""
    limited = {entry["quantity"] for entry in report["limits"]["each"]}
    return [entry for entry in report["quantities"]
            if entry["quantity"] not in limited and "@" not in entry["quantity"] and len(entry["histogram"]["counts"]) > 1 and not entry["constant"] and not entry["bookkeeping"]]


def other_quantities(page):
    """Small histograms of all other quantities that vary, a figure for each page."""
    def draw(report):
        entries = varying(report)[PANELS * page:PANELS * (page + 1)]
        if not entries:
            return None
        columns = 5
        rows = -(-len(entries) // columns)
        figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 1.16 * rows + 0.1), squeeze=False)
        for axis in axes.flat[len(entries):]:
            axis.set_visible(False)
        for axis, entry in zip(axes.flat, entries):
            bars(axis, entry["histogram"], GREY)
            axis.set_title(two_lines(readable(entry["quantity"])), fontsize=6.5)
            axis.set_xlabel("[-]" if entry["unit"] == "-" else f"[{entry['unit']}]", fontsize=6, labelpad=1)
            axis.tick_params(labelsize=6, pad=1)
            axis.set_yticks([])
            axis.grid(False)
            axis.locator_params(axis="x", nbins=3)
            axis.ticklabel_format(axis="x", useOffset=False)
        return figure
    return draw


def two_lines(name, width=20):
    """Broken at the space nearest to the middle."""
    spaces = [place for place, letter in enumerate(name) if letter == " "]
    if len(name) <= width or not spaces:
        return name
    middle = min(spaces, key=lambda place: abs(place - len(name) / 2))
    return f"{name[:middle]}\n{name[middle + 1:]}"


FEWEST_LOOKS = 4  # fewer show no trend


def convergence(report):
    """Joint yield and the 95 % quantiles of the limited quantities after 1/2^k of the runs."""
    looks = report["convergence"]["looks"]
    if len(looks) < FEWEST_LOOKS:
        return None
    names = list(looks[-1]["quantile_95"])
    yields = report["limits"]["each"] and report["limits"]["joint"]["if_unknown_fail"] is not None
    panels = (["joint yield"] if yields else []) + names
    if not panels:
        return None
    columns = min(2, len(panels))
    rows = -(-len(panels) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 2.2 * rows), squeeze=False)
    for axis in axes.flat[len(panels):]:
        axis.set_visible(False)
    runs = [look["runs"] for look in looks]
    for axis, name in zip(axes.flat, panels):
        if name == "joint yield":
            value = [100 * known(look["yield"]["if_unknown_fail"]) for look in looks]
            lower = [100 * known(look["yield"]["lower_bound"]) for look in looks]
            upper = [100 * known(look["yield"]["upper_bound"]) for look in looks]
            axis.set_ylabel("yield [%]")
            axis.set_title("joint yield")
        else:
            entries = [look["quantile_95"][name] for look in looks]
            value, lower, upper = ([known(entry[key]) for entry in entries] for key in ("value", "lower", "upper"))
            entry = quantity_of(report, name)
            axis.set_ylabel(with_unit("95 % quantile", entry["unit"]))
            axis.set_title(readable(name))
        axis.fill_between(runs, lower, upper, color=BLUE, alpha=0.15, linewidth=0)
        axis.plot(runs, value, "o-", color=BLUE)
        axis.set_xscale("log", base=2)
        axis.set_xticks(runs, [f"{count}" for count in runs])
        axis.minorticks_off()
        axis.set_xlabel("runs used")
    return figure


def health(report):
    """Steps, energy residual and static consistency error of all runs."""
    wanted = ["steps", "energy_residual", "static_consistency_error"]
    entries = [entry for name in wanted for entry in report["health"] if entry["field"] == name
               and len(entry["histogram"]["counts"]) > 1]
    if not entries:
        return None
    columns = min(2, len(entries))
    rows = -(-len(entries) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 1.7 * rows), squeeze=False)
    for axis in axes.flat[len(entries):]:
        axis.set_visible(False)
    for axis, entry in zip(axes.flat, entries):
        bars(axis, entry["histogram"], GREEN)
        axis.set_xlabel(with_unit(readable(entry["field"]), entry["unit"]))
        axis.locator_params(axis="x", nbins=3)
        axis.ticklabel_format(axis="x", scilimits=(-4, 6))
        axis.set_ylabel("runs")
    return figure
