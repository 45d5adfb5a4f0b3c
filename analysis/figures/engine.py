"""How integration methods fare: error against cost, and the map of the stability suite."""

import math

import matplotlib.pyplot as plt

from common import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY, WIDTH, known

COLOURS = [BLUE, RED, GREEN, PINK, ORANGE, SKY, BLACK]
MARKERS = "os^Dv<P"


def legend_below(figure, handles, labels, height, columns=5):
    """A legend below all panels that takes this share of the figure."""
    figure.get_layout_engine().set(rect=(0, height, 1, 1 - height))
    figure.legend(handles, labels, loc="lower center", ncols=columns, fontsize=7.5)


def error_against_cost(chart, horizon, error, cost, noise=None):
    """One panel of a chart: every setting, lines along a method's tolerances, the front, the default."""
    def panel(axis):
        methods = list(dict.fromkeys(point["method"] for point in chart["points"]))
        for method, colour, marker in zip(methods, COLOURS, MARKERS):
            points = sorted((point for point in chart["points"] if point["method"] == method), key=lambda p: p["tolerance"])
            shown = [(known(p[horizon][cost]), known(p[horizon][error])) for p in points]
            shown = [(x, y) for x, y in shown if math.isfinite(x) and math.isfinite(y)]
            if shown:
                axis.plot(*zip(*shown), marker=marker, color=colour, linewidth=0.8, markersize=4, label=method)
        front = sorted((p[horizon][cost], p[horizon][error]) for p in chart["points"] if p[horizon]["on_front"])
        if front and cost == "rtf":  # the front is one of wall time
            axis.plot(*zip(*front), color=GREY, linewidth=5, alpha=0.35, solid_capstyle="round", zorder=0, label="front")
        own = chart["points"][0][horizon]
        if own[cost] is not None and own[error] is not None:
            axis.plot(own[cost], own[error], "o", markersize=11, markerfacecolor="none", color=BLACK, label="default")
        if noise is not None:
            axis.axhline(noise, color=GREY, linestyle=":", linewidth=1.2, label="resolved above")
        axis.set_xscale("log")
        axis.set_yscale("log")
    return panel


def rung_marks(axis, chart, cost):
    """The rungs of the model ladder, with their own settings, against the highest one integrated tightly."""
    shown = [(known(rung["window"][cost]), known(rung["window"]["bias_rms"]), rung["rung"]) for rung in chart.get("rungs", [])]
    shown = [(x, y, name) for x, y, name in shown if x > 0 and y > 0]
    if not shown:
        return
    axis.plot([x for x, _, _ in shown], [y for _, y, _ in shown], "*", color=BLACK, markersize=8, markerfacecolor="gold",
              markeredgewidth=0.6, zorder=5, label=f"rung, against {chart['rungs'][-1]['rung']}")
    for x, y, name in shown:
        near = [other for other, height, _ in shown if abs(math.log10(height / y)) < 0.12 and 0 < abs(math.log10(other / x)) < 0.6]
        left = bool(near) and x < min(near)  # of two labels side by side one goes to the left
        axis.annotate(name, (x, y), xytext=(-5 if left else 5, 3), textcoords="offset points", fontsize=6.5,
                      ha="right" if left else "left")


def chart(data):
    """Trajectory error (left) and bias (right), against wall time (above) and right-hand sides (below)."""
    long = [point["window"]["bias_noise"] for point in data["points"] if point["window"]["bias_noise"] is not None]
    columns = [("trajectory", "error", f"error after {1e3 * data['horizon_s']:g} ms [error scales]", None)]
    if long:
        columns.append(("window", "bias_rms", f"bias, {data['replicas']} replicas [std. deviations]", sorted(long)[len(long) // 2]))
    costs = [("rtf", "wall time / simulated time"), ("rhs_evaluations_per_s", "right-hand sides per simulated second")]
    figure, axes = plt.subplots(len(costs), len(columns), figsize=(WIDTH, 6.0), squeeze=False)
    for row, (cost, x_label) in zip(axes, costs):
        for axis, (horizon, error, y_label, noise) in zip(row, columns):
            error_against_cost(data, horizon, error, cost, noise)(axis)
            axis.set_xlabel(x_label)
            axis.set_ylabel(y_label)
            if horizon == "window":
                axis.margins(x=0.18, y=0.1)
                rung_marks(axis, data, cost)
    named = {label: handle for axis in axes.flat for handle, label in zip(*axis.get_legend_handles_labels())}
    legend_below(figure, list(named.values()), list(named), 0.1)
    figure.suptitle(data["scene"], fontsize=10)
    return figure


def stability(data):
    """Scenes down, methods across: right, degraded, wrong, failed."""
    colours = {"right": GREEN, "degraded": ORANGE, "wrong": RED, "failed": GREY, "unresolved": SKY}
    scenes, methods = data["scenes"], data["methods"]
    figure, axis = plt.subplots(figsize=(WIDTH, 0.9 + 0.27 * len(scenes)))
    for row, scene in enumerate(scenes):
        for column, method in enumerate(methods):
            cell = scene["results"].get(method)
            if cell is None:
                continue
            axis.add_patch(plt.Rectangle((column + 0.03, row + 0.06), 0.94, 0.88, color=colours[cell["verdict"]], alpha=0.75))
            axis.text(column + 0.5, row + 0.5, cell["brief"], ha="center", va="center", fontsize=6.5)
    axis.set_xlim(0, len(methods))
    axis.set_ylim(len(scenes), 0)
    axis.set_xticks([k + 0.5 for k in range(len(methods))], methods, fontsize=7, rotation=15)
    axis.set_yticks([k + 0.5 for k in range(len(scenes))], [scene["name"] for scene in scenes], fontsize=7.5)
    axis.xaxis.tick_top()
    axis.tick_params(length=0)
    axis.grid(False)
    for spine in axis.spines.values():
        spine.set_visible(False)
    patches = [plt.Rectangle((0, 0), 1, 1, color=colour, alpha=0.75) for colour in colours.values()]
    legend_below(figure, patches, list(colours), 0.06)
    return figure
