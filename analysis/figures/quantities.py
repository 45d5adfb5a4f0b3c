"""Histograms, convergence and run health."""

import matplotlib.pyplot as plt

from common import BLUE, GREEN, GREY, RED, WIDTH, draw_limits, known, quantity_of, readable, with_unit


def bars(axis, histogram, color=BLUE):
    edges, counts = histogram["edges"], histogram["counts"]
    if counts:
        axis.bar(edges[:-1], counts, width=[b - a for a, b in zip(edges, edges[1:])], align="edge",
                 color=color, edgecolor="white", linewidth=0.4)


def limited_quantities(report):
    """Histograms of the quantities with limits."""
    limits = [entry for entry in report["limits"]["each"] if quantity_of(report, entry["quantity"])]
    if not limits:
        return None
    columns = min(2, len(limits))
    rows = -(-len(limits) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 2.4 * rows), squeeze=False)
    for axis in axes.flat[len(limits):]:
        axis.set_visible(False)
    for axis, limit in zip(axes.flat, limits):
        entry = quantity_of(report, limit["quantity"])
        bars(axis, entry["histogram"])
        draw_limits(axis, limit)
        axis.set_xlabel(with_unit(readable(limit["quantity"]), entry["unit"]))
        axis.set_ylabel("runs")
        axis.legend(loc="upper right")
    return figure


def other_quantities(report):
    """Small histograms of all other quantities that vary."""
    limited = {entry["quantity"] for entry in report["limits"]["each"]}
    entries = [entry for entry in report["quantities"]
               if entry["quantity"] not in limited and len(entry["histogram"]["counts"]) > 1]
    if not entries:
        return None
    columns = 4
    rows = -(-len(entries) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 1.45 * rows + 0.1), squeeze=False)
    for axis in axes.flat[len(entries):]:
        axis.set_visible(False)
    for axis, entry in zip(axes.flat, entries):
        bars(axis, entry["histogram"], GREY)
        axis.set_title(readable(entry["quantity"]).replace(" ", "\n", 1) if len(readable(entry["quantity"])) > 20
                       else readable(entry["quantity"]), fontsize=7.5)
        axis.set_xlabel("ratio [-]" if entry["unit"] == "-" else f"[{entry['unit']}]", fontsize=7)
        axis.tick_params(labelsize=6.5)
        axis.set_yticks([])
        axis.grid(False)
        axis.locator_params(axis="x", nbins=3)
        axis.ticklabel_format(axis="x", useOffset=False)
    return figure


def convergence(report):
    """Joint yield and the 95 % quantiles of the limited quantities after 1/2^k of the runs."""
    looks = report["convergence"]["looks"]
    if len(looks) < 2:
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
    wanted = ["steps", "energy_residual", "static_consistency_error", "wall_s"]
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
