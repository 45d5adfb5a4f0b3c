"""Yield against tolerance."""

import math

import matplotlib.pyplot as plt
import numpy as np

from common import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, WIDTH, known, quantity_of, readable
from engine import legend_below


def confirmed_tolerances(report):
    """Tolerances of the attempt that confirmed, by key: full width, attempt, as on a drawing."""
    attempts = (report["confirmation"] or {"attempts": []})["attempts"]
    return {tolerance["key"]: (tolerance["tolerance_width_mm"], attempt, tolerance["drawing"].split(" (")[0]) for attempt in attempts if attempt["passed"] and not attempt["judged_again"]
            for tolerance in attempt["tolerances"]}


def side_by_side(widths):
    """Places of tolerances on an axis: those of the same width side by side."""
    places = []
    for width in widths:
        places.append(1.12 * places[-1] if places and places[-1] >= 0.999 * width else width)
    return places


def limit_curves(report):
    """One panel for each side of a limit: yield of each candidate over the value that the limit might have."""
    curves = [curve for curve in report.get("limit_curves", []) if len(curve["values"]) > 1]
    if not curves:
        return None
    chosen = (report["tolerance"] or {}).get("chosen_candidate")
    rows = -(-len(curves) // 2)
    figure, axes = plt.subplots(rows, 2, figsize=(WIDTH, 2.6 * rows), sharey=True, squeeze=False)
    for axis in axes.flat[len(curves):]:
        axis.set_visible(False)
    for axis, curve in zip(axes.flat, curves):
        alone = len(curve["candidates"]) == 1
        for number, candidate in enumerate(curve["candidates"]):
            marked = alone or number == chosen
            if candidate["shown"] or marked:
                axis.plot(curve["values"], [100 * known(value) for value in candidate["if_unknown_fail"]], color=BLUE if marked else GREY,
                          linewidth=1.8 if marked else 0.6, zorder=3 if marked else 2,
                          label=("all runs" if alone else "candidate of the verdict") if marked else "other candidates")
            if marked:
                axis.plot(curve["values"], [100 * known(value) for value in candidate["lower_bound"]], ":", color=BLUE, label="its lower bound")
        axis.locator_params(axis="x", nbins=5)
        axis.axvline(curve["bound"], color=GREEN, linewidth=1.2, label="limit")
        axis.axhline(100 * report["verdict"]["target_yield"], color=RED, linestyle="--", linewidth=1.2, label="target")
        axis.set_xlabel(f"{readable(curve['quantity'])}, at {'most' if curve['side'] == 'max' else 'least'}"
                        + (f" [{curve['unit']}]" if curve["unit"] not in ("", "-") else ""), fontsize=8.5)
    for row in axes:
        row[0].set_ylabel("yield [%]")
    handles = {label: handle for axis in axes.flat[:len(curves)] for handle, label in zip(*axis.get_legend_handles_labels())}
    legend_below(figure, list(handles.values()), list(handles), 0.28 / (2.6 * rows))
    return figure


MOST_LIMITS = 8  # lines that can be told apart
LIMIT_STYLES = [(colour, style) for style in ("-", "--") for colour in (BLUE, ORANGE, GREEN, PINK)]


def share_of_limit(limit, value):
    """How much of the room up to the limit is used: 1 is on the limit; None where shares have no meaning."""
    shares = []
    if (limit["max"] or 0) > 0:
        shares.append(known(value) / limit["max"])
    if (limit["min"] or 0) > 0 and known(value) > 0:
        shares.append(limit["min"] / known(value))
    return max(shares, default=None)


def width_curves(report):
    """One panel for each dimension: limited quantities as shares of their limits over the width of the tolerance."""
    dimensions = report["tolerance"].get("width_curves", []) if report["tolerance"] else []
    dimensions = [d for d in dimensions if len(d["tolerance_widths_mm"]) > 1 and any(any(limit["bands"]) for limit in d["limits"])]
    if not dimensions:
        return None

    def largest(limit):
        return max((share_of_limit(limit, band[end]) or 0 for band in limit["bands"] if band for end in ("low", "high")), default=0)

    nearest = sorted(range(len(dimensions[0]["limits"])), key=lambda l: -largest(dimensions[0]["limits"][l]))[:MOST_LIMITS]
    confirmed, jams = confirmed_tolerances(report), {jam["key"]: jam for jam in report["tolerance"]["jams"]}
    figure, axes = plt.subplots(1, len(dimensions), figsize=(WIDTH, 2.7), sharey=True, squeeze=False)
    for axis, dimension in zip(axes[0], dimensions):
        widths = side_by_side([1e3 * width for width in dimension["tolerance_widths_mm"]])
        edges = [0] + [(a + b) / 2 for a, b in zip(widths, widths[1:])] + [1.5 * widths[-1] - 0.5 * widths[-2]]
        for i, (left, right) in enumerate(zip(edges, edges[1:])):
            if i % 2:
                axis.axvspan(left, right, color=GREY, alpha=0.08, linewidth=0)
        for place, l in enumerate(nearest):
            limit, (colour, style) = dimension["limits"][l], LIMIT_STYLES[place]
            drawn = [(width, *(100 * share_of_limit(limit, band[key]) for key in ("low", "median", "high")))
                     for width, band in zip(widths, limit["bands"]) if band and share_of_limit(limit, band["median"]) is not None]
            if not drawn:
                continue
            x, low, middle, high = zip(*drawn)
            axis.fill_between(x, low, high, color=colour, alpha=0.15, linewidth=0)
            axis.plot(x, middle, style, color=colour, marker="o", markersize=3, label=readable(limit["quantity"]))
            noise = quantity_of(report, limit["quantity"])["noise"]["standard_deviation"]
            if noise is not None and (limit["max"] or 0) > 0:
                axis.errorbar(x[0] * 0.5, middle[0], yerr=100 * noise / limit["max"], color=colour, capsize=2)
        axis.axhline(100, color=RED, linestyle="--", linewidth=1.2, label="limit")
        jam = jams.get(dimension["key"])
        if jam and jam["limit_mm"] is not None and 1e3 * jam["limit_mm"] < edges[-1]:
            axis.axvspan(1e3 * jam["limit_mm"], edges[-1], facecolor="none", edgecolor=BLACK, alpha=0.5, hatch="//", linewidth=0,
                         label="jams alone miss the target")
        if dimension["key"] in confirmed:
            width, words = 1e3 * confirmed[dimension["key"]][0], confirmed[dimension["key"]][2]
            axis.axvline(width, color=BLACK, linewidth=1.5, label="confirmed")
            axis.annotate(words, (width, 1), xycoords=("data", "axes fraction"), xytext=(-3, -30),
                          textcoords="offset points", ha="right", va="top", fontsize=8.5)
        axis.set_xlim(0, edges[-1])
        axis.set_ylim(0, None)
        axis.set_xticks(widths, [grade.removeprefix("IT").replace("/", "\n") or f"{width:.0f}" for width, grade in zip(widths, dimension["grades"])])
        axis.set_xlabel(f"{dimension['name']}: " + ("tolerance at its width" if all(dimension["grades"]) else "full width [µm]"),
                        fontsize=8.5)
    axes[0][0].set_ylabel("share of the limit [%]")
    handles = {label: handle for axis in axes[0] for handle, label in zip(*axis.get_legend_handles_labels())}
    columns = 3 if any("@" in label for label in handles) else 5
    legend = 0.1 + 0.17 * math.ceil(len(handles) / columns)
    figure.set_size_inches(WIDTH, 2.3 + legend)
    legend_below(figure, list(handles.values()), list(handles), legend / (2.3 + legend), columns)
    return figure


def yield_curves(report):
    """One panel for each dimension: yield with its bounds over the width of the tolerance."""
    dimensions = report["tolerance"].get("dimensions", []) if report["tolerance"] else []
    dimensions = [dimension for dimension in dimensions if sum(level["shown"] for level in dimension["levels"]) > 1]
    if not dimensions:
        return None
    confirmed = confirmed_tolerances(report)
    columns = min(len(dimensions), 3)
    rows = -(-len(dimensions) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 2.9 * rows), sharey=True, squeeze=False)
    for axis in axes.flat[len(dimensions):]:
        axis.set_visible(False)
    for axis, dimension in zip(axes.flat, dimensions):
        levels = [level for level in dimension["levels"] if level["shown"]]
        tolerances = side_by_side([1e3 * level["tolerance_width_mm"] for level in levels])
        low = [100 * known(level["yield"]["if_unknown_fail"]) for level in levels]
        high = [100 * known(level["yield"]["if_unknown_pass"]) for level in levels]
        lower = [100 * known(level["yield"]["lower_bound"]) for level in levels]
        upper = [100 * known(level["yield"]["upper_bound"]) for level in levels]
        axis.fill_between(tolerances, lower, upper, color=BLUE, alpha=0.15, linewidth=0, label="between the bounds")
        apart = any(abs(a - b) > 0.05 for a, b in zip(low, high))
        axis.plot(tolerances, low, "o-", color=BLUE, label="estimate, runs without result fail" if apart else "estimate")
        if apart:
            axis.plot(tolerances, high, "s:", color=BLUE, markerfacecolor="white", label="runs without result pass")
        axis.axhline(100 * report["verdict"]["target_yield"], color=RED, linestyle="--", linewidth=1.2, label="target")
        if dimension["key"] in confirmed:
            tolerance, attempt, _ = confirmed[dimension["key"]]
            bound, value = 100 * attempt["yield"]["lower_bound"], 100 * attempt["yield"]["if_unknown_fail"]
            axis.plot([1e3 * tolerance] * 2, [bound, value], color=GREEN, linewidth=2.5, label="confirmed, bound to estimate", zorder=4)
            axis.plot(1e3 * tolerance, bound, "_", color=GREEN, markersize=9, zorder=4)
        axis.set_xlabel(f"{dimension['name']}, full width [µm]", fontsize=8.5)
        if tolerances[-1] > 4 * tolerances[0]:
            axis.set_xscale("log")
            axis.minorticks_off()
        axis.set_xticks(tolerances)
        axis.set_xticklabels([f"{1e3 * level['tolerance_width_mm']:.0f}\n{level['grade']}\n({level['yield']['effective_runs']:.0f})"
                              for level in levels], fontsize=7 if len(levels) > 4 or columns > 2 else 8.5)
        axis.margins(x=0.08)
    for row in axes:
        row[0].set_ylabel("yield [%]")
    handles = {label: handle for axis in axes.flat[:len(dimensions)] for handle, label in zip(*axis.get_legend_handles_labels())}
    legend_below(figure, list(handles.values()), list(handles), 0.28 / (2.9 * rows))
    return figure


def yield_map(report):
    """Lower yield bound for two dimensions together."""
    tolerance = report["tolerance"]
    if not tolerance or len(tolerance["dimensions"]) != 2:
        return None
    if len({round(c["yield"]["if_unknown_fail"], 4) for c in tolerance["candidates"] if c["shown"]}) < 2:
        return None  # nothing to see
    first, second = tolerance["dimensions"]
    rows, columns = ([(level["tolerance_width_mm"], level["grade"]) for level in dimension["levels"]] for dimension in (first, second))
    places = lambda candidate: list(zip(candidate["tolerance_widths_mm"], candidate["grades"]))
    bound = np.full((len(rows), len(columns)), np.nan)
    text = {}
    for candidate in tolerance["candidates"]:
        place = rows.index(places(candidate)[0]), columns.index(places(candidate)[1])
        if not candidate["shown"]:
            text[place] = f"too few\n({candidate['yield']['effective_runs']:.0f} runs)"
            continue
        bound[place] = 100 * candidate["yield"]["lower_bound"]
        text[place] = (f"{100 * candidate['yield']['if_unknown_fail']:.1f} %\n"
                       f"≥ {bound[place]:.1f} %\n({candidate['yield']['effective_runs']:.0f} runs)")
    target = 100 * report["verdict"]["target_yield"]
    figure, axis = plt.subplots(figsize=(WIDTH, 0.9 + 0.62 * len(rows)))
    reach = max(100 - target, 1.0)  # the colours end at 100 % and as far below the target
    image = axis.imshow(bound, cmap="PuOr", vmin=target - reach, vmax=target + reach, aspect="auto", origin="lower")
    chosen = tolerance["chosen_candidate"]
    for place, words in text.items():
        strong = abs(np.nan_to_num(bound[place], nan=target) - target) > 0.5 * reach
        axis.text(place[1], place[0], words, ha="center", va="center", fontsize=8 if len(columns) < 6 else 6.5,
                  color="white" if strong else "black")
    if chosen is not None:
        tolerances = places(tolerance["candidates"][chosen])
        axis.add_patch(plt.Rectangle((columns.index(tolerances[1]) - 0.48, rows.index(tolerances[0]) - 0.46), 0.96, 0.92,
                                     fill=False, edgecolor="black", linewidth=2))
    label = lambda levels, between: [f"{1e3 * level['tolerance_width_mm']:.0f} µm{between}{level['grade']}" for level in levels]
    axis.set_xticks(range(len(columns)), label(second["levels"], "\n"))
    axis.set_yticks(range(len(rows)), label(first["levels"], "  "))
    axis.set_xlabel(f"tolerance of {second['name']}")
    axis.set_ylabel(f"tolerance of {first['name']}")
    axis.grid(False)
    bar = figure.colorbar(image, ax=axis, pad=0.02)
    bar.set_label("lower bound of the yield [%]")
    bar.ax.axhline(target, color="black", linewidth=1.5)
    return figure


def jam_curves(report):
    """One panel for each dimension: share of cages that jam over the width of its tolerance."""
    jams = report["tolerance"].get("jams", []) if report["tolerance"] else []
    jams = [jam for jam in jams if max(jam["share"]) > 1e-7]
    if not jams:
        return None
    tolerances = {tolerance["key"]: tolerance["tolerance_width_mm"] for tolerance in report["tolerance"]["tolerances"]}
    figure, axes = plt.subplots(1, len(jams), figsize=(WIDTH, 2.9), sharey=True, squeeze=False)
    for axis, jam in zip(axes[0], jams):
        shown = [(1e3 * tolerance, 100 * share) for tolerance, share in zip(jam["tolerance_width_mm"], jam["share"]) if share > 1e-7]
        axis.plot(*zip(*shown), "o-", color=BLUE, markersize=3)
        axis.axhline(100 * (1 - report["verdict"]["target_yield"]), color=RED, linestyle="--", linewidth=1.2)
        if jam["key"] in tolerances:
            axis.axvline(1e3 * tolerances[jam["key"]], color=GREY, linestyle=":", linewidth=1.5)
        axis.set_xlim(0, 1.02e3 * jam["tolerance_width_mm"][-1])
        axis.set_yscale("log")
        axis.set_ylim(bottom=5e-5)  # 1 ppm and below
        axis.tick_params(axis="y", labelsize=9)  # exponents are smaller
        axis.set_xlabel(f"tolerance of {jam['name']}, full width [µm]")
    axes[0][0].set_ylabel("cages that jam [%]")
    return figure
