"""Error against cost of every method and tolerance, and of the rungs of the model ladder."""

import json
import math
import sys

from report import ROOT, WIDTH, logarithmic, number, pyplot, ticks_within

sys.path.insert(0, str(ROOT / "analysis/figures"))
from common import known  # noqa: E402
from engine import error_against_cost, legend_below  # noqa: E402

OFFSETS = ((-9, 4), (-9, 5), (-10, 2), (10, 2), (-9, -4), (-2, 10), (2, -10), (10, 3))  # of the numbers, points
NU205 = ROOT / "inputs/scenes/nu205.toml"
STUDY = ROOT / "inputs/studies/nu205-rated.toml"
LOADS = (150, 1000, 10000)  # N
RUNG_LOADS = (150, 1000)  # N; at 10 kN the explicit reference of the rungs would take hours
CAGES = {"rigid": {"cage.model": "rigid"}, "flexible": {"cage.model": "flexible"}}
TRAJECTORIES = ["--replicas", "0", "--horizon-ms", "1", "--starts", "24"]
RUNGS = ["--methods", "rodas3", "--replicas", "12", "--rungs", "--horizon-ms", "0.1", "--starts", "1"]
QUICK = ["--methods", "rodas3", "--horizon-ms", "0.1", "--starts", "1"]  # no result
QUICK_WINDOW = {"window.settle_revolutions": 0.05, "window.measure_revolutions": 0.05, "cage.mesh_density": 2,
                "cage.corner_radius_mm": 0}


def loads(quick):
    return LOADS[:1] if quick else LOADS


def measured(program, settings, options):
    """chart.json of `cagetol chart` on the NU 205; kept by program, settings and options."""
    place = program.directory("chart", NU205, "chart.json", options, settings)
    return json.loads((place / "chart.json").read_text(encoding="utf-8"))


def side_by_side(page, name, caption, charts, draw, y_label):
    """One panel a load; one legend."""
    figure, (axes,) = pyplot.subplots(1, len(charts), figsize=(WIDTH, 3.1), sharey=True, squeeze=False)
    for axis, (load, chart) in zip(axes, charts.items()):
        draw(axis, chart)
        axis.set_title(f"{load:,} N".replace(",", " "), fontsize=9)
        axis.set_xlabel("wall time / simulated time")
    axes[0].set_ylabel(y_label)
    named = {label: handle for axis in axes for handle, label in zip(*axis.get_legend_handles_labels())}
    legend_below(figure, list(named.values()), list(named), 0.13)
    page.figure(name, figure, caption)


def front_rows(charts):
    rows = []
    for load, chart in charts.items():
        for point in chart["points"]:
            run = point["trajectory"]
            if run["on_front"] or point["default"]:
                mark = ", the default" + ("" if run["on_front"] else ", **not on the front**") if point["default"] else ""
                rows.append([f"{load}", point["label"] + mark, number(run["rtf"]),
                             number(run["rhs_evaluations_per_s"] / 1000), f"{run['error']:.1e}"])
    return rows


def method_chapter(page, program, quick):
    page.heading("Error against cost: methods and tolerances")
    page.add("`cagetol chart inputs/scenes/nu205.toml`, one millisecond from 24 starts: long enough for every contact to take",
             "part, short enough that chaos has not parted the runs. Error: root mean square over the state, in error scales",
             "(1 um, 1 cm/s, and these over lever arms), against a run at tolerance 1e-5 by a method of another kind (explicit Runge-Kutta for the",
             "linearly implicit ones, rodasp for the others). Medians over the starts; the search for the steady start is",
             "not in the time. The largest step, 50 us, holds for all.", "")
    for cage, model in CAGES.items():
        charts = {load: measured(program, model | {"load.radial_N": load} | (QUICK_WINDOW if quick else {}),
                                 QUICK + ["--replicas", "0"] if quick else TRAJECTORIES) for load in loads(quick)}
        page.add(f"### {cage.capitalize()} cage", "")
        side_by_side(page, f"cost-methods-{cage}", f"Error against cost of every method, {cage} cage", charts,
                     lambda axis, chart: error_against_cost(chart, "trajectory", "error", "rtf")(axis),
                     "error after 1 ms [error scales]")
        page.add("The default, and what is on the front (nothing measured is both cheaper and more accurate):", "")
        page.table(["load, N", "setting", "wall time / simulated time", "thousand right-hand sides a second", "error"],
                   front_rows(charts))


def rung_chapter(page, program, quick):
    page.heading("Error against cost: how much model")
    page.add("Rungs of `cagetol ladder` over the scene's window, twelve replicas with the cage started elsewhere: root mean",
             "square over the quantities of the bias against the highest rung integrated tightly, in standard deviations of a",
             "quantity between replicas. Below the dotted line twelve replicas resolve nothing.", "")
    charts = {load: measured(program, {"load.radial_N": load} | (QUICK_WINDOW if quick else {}),
                             QUICK + ["--replicas", "2", "--rungs"] if quick else RUNGS)
              for load in (RUNG_LOADS[:1] if quick else RUNG_LOADS)}

    def draw(axis, chart):
        noise = sorted(rung["window"]["bias_noise"] for rung in chart["rungs"] if rung["window"]["bias_noise"])
        if noise:
            axis.axhline(noise[len(noise) // 2], linestyle=":", color="grey", linewidth=1.2, label="resolved above")
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.margins(x=0.12, y=0.12)
        shown = [(known(rung["window"]["rtf"]), known(rung["window"]["bias_rms"])) for rung in chart["rungs"]]
        axis.plot(*zip(*shown), "*", color="black", markersize=8, markerfacecolor="gold", markeredgewidth=0.6,
                  label=f"rung, against {chart['rungs'][-1]['rung']}")
        for number_of_rung, (place, offset) in enumerate(zip(shown, OFFSETS), 1):
            if not all(math.isfinite(value) and value > 0 for value in place):
                continue
            axis.annotate(str(number_of_rung), place, xytext=offset, textcoords="offset points", fontsize=8,
                          ha="center", va="center")

    side_by_side(page, "cost-rungs", "Bias against cost of the rungs of the model ladder", charts, draw,
                 "bias [std. deviations]")
    names = [rung["rung"] for rung in next(iter(charts.values()))["rungs"]]
    by_load = [{rung["rung"]: rung["window"] for rung in chart["rungs"]} for chart in charts.values()]
    page.table(["number", "rung"] + [f"{load} N: time, bias" for load in charts],
               [[f"{place}", name] + [f"{number(rungs[name]['rtf'])}, {number(rungs[name]['bias_rms'], 2)}" for rungs in by_load]
                for place, name in enumerate(names, 1)])


def laddered(program):
    """ladder.json of the default study; kept by program and study."""
    place = program.directory("ladder", STUDY, "ladder.json", reads=[NU205])
    return json.loads((place / "ladder.json").read_text(encoding="utf-8"))


def limited_chapter(page, program):
    ladder = laddered(program)
    limited = [quantity for quantity in ladder["quantities"] if quantity["limited"]]
    cost = {rung["name"]: rung["cost_ratio"] for rung in ladder["rungs"]}
    page.heading("Error against cost: the quantities that the default study limits")
    page.add("`cagetol ladder inputs/studies/nu205-rated.toml`: the same 24 cages on every rung. Error: shift of the mean against the",
             "highest rung, in per cent of that mean, the bar its 95 % interval; an arrow where the interval reaches zero: the",
             "error is below its end. A rung that does not define a quantity is not drawn.", "")
    figure, axes = pyplot.subplots(-(-len(limited) // 2), 2, figsize=(WIDTH, 5.2), squeeze=False)
    for axis in axes.flat[len(limited):]:
        axis.set_visible(False)
    rows = []
    for axis, quantity in zip(axes.flat, limited):
        shown = [rung for rung in quantity["rungs"] if rung["shift"] is not None and rung["rung"] in cost]
        scale = 100 / abs(quantity["mean"])
        tops = []
        for rung in shown:
            low, high = sorted(abs(rung[end]) * scale for end in ("lower", "upper"))
            told = rung["lower"] * rung["upper"] > 0
            x, y = cost[rung["rung"]], abs(rung["shift"]) * scale if told else high
            if y == 0:
                continue
            axis.errorbar(x, y, yerr=[[max(0.0, y - low)], [max(0.0, high - y)]] if told else [[0.6 * y], [0]],
                          uplims=not told, marker="o", markersize=4, color="C0" if told else "grey", linewidth=1)
            axis.annotate(rung["rung"], (x, high), xytext=(0, 3), textcoords="offset points", fontsize=7,
                          ha={"bars": "right", "rotating": "left"}.get(rung["rung"], "center"))  # these two cost the same
            tops.append((low, high))
        logarithmic(axis, (0.2, 0.3, 0.4, 0.6))
        logarithmic(axis, ticks_within(min(low for low, _ in tops) / 2 or 0.01, 2 * max(high for _, high in tops))
                    if tops else (1,), "y")
        axis.margins(y=0.25)
        axis.set_xlim(0.22, 1)
        axis.set_title(quantity["quantity"], fontsize=8)
        rows.append([f"`{quantity['quantity']}`: {number(quantity['mean'], 4)}"]
                    + [next((f"{100 * r['shift'] / abs(quantity['mean']):+.2g} ± "
                             f"{50 * (r['upper'] - r['lower']) / abs(quantity['mean']):.2g}"
                             for r in shown if r["rung"] == name), "-") for name in cost])
    for axis in axes.flat[max(0, len(limited) - 2):]:
        axis.set_xlabel("cost over that of the highest rung")
    for axis in axes[:, 0]:
        axis.set_ylabel("error of the mean, %")
    page.figure("cost-limited", figure, "Error against cost of the quantities that the default study limits")
    page.table(["quantity, mean"] + [f"{name}: {number(ratio, 2)}" for name, ratio in cost.items()], rows)
