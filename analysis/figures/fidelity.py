"""What cheaper models cost and shift: the rungs of a model ladder."""

import math

import matplotlib.pyplot as plt

from common import BLACK, BLUE, GREEN, GREY, ORANGE, PINK, RED, SKY, WIDTH, known, readable
from engine import legend_below

COLOURS = [RED, ORANGE, PINK, SKY, BLUE, GREEN, BLACK, "#7A4B2A"]  # one for each rung below the reference
MARKERS = "osD^v<>P"
USUAL = ["cage_slip_ratio", "pocket_force_rms_N", "pocket_impacts_per_revolution", "friction_torque_Nmm",
         "ring_displacement_mean_um", "cage_stress_p99_MPa"]
FLOOR = 1e-2  # budgets: what is smaller is drawn here


def shown_quantities(data):
    """The limited quantities, filled up to six with the usual ones."""
    defined = {entry["quantity"]: entry for entry in data["quantities"] if entry["budget"] not in (None, 0)}
    names = [name for name, entry in defined.items() if entry["limited"]]
    names += [name for name in USUAL if name in defined and name not in names]
    return [defined[name] for name in names[:6]]


def draw_rungs(axis, entry, costs):
    budget = entry["budget"]
    for k, rung in enumerate(entry["rungs"][:-1]):
        shift, upper = abs(known(rung["shift"])) / budget, known(rung["upper_limit"]) / budget
        cost = known(costs[k])
        if not (math.isfinite(upper) and math.isfinite(cost)):
            continue
        lower = max(2 * shift - upper, FLOOR)  # the interval is symmetric about the shift
        colour = COLOURS[k % len(COLOURS)]
        axis.plot([cost, cost], [lower, max(upper, FLOOR)], color=colour, linewidth=1.2)
        axis.plot(cost, max(shift, FLOOR), MARKERS[k % len(MARKERS)], color=colour, markersize=5.5,
                  markerfacecolor=colour if rung["verdict"] in ("adequate", "settled") else "white", label=rung["rung"])
    axis.axhline(1, color=GREY, linestyle="--", linewidth=1.2, label="budget")
    axis.set_yscale("log")
    axis.set_xscale("log")
    axis.set_ylim(bottom=0.7 * FLOOR)
    least = f": {entry['minimum_rung']}" if "minimum_rung" in entry else ""
    axis.set_title(readable(entry["quantity"]) + least, fontsize=9)


def ladder(data):
    """Size of the shift in units of the budget against cost, one panel a quantity, rungs as marks."""
    entries = shown_quantities(data)
    if not entries:
        return None
    costs = [rung["cost_ratio"] for rung in data["rungs"]]
    columns = min(2, len(entries))
    rows = math.ceil(len(entries) / columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 0.9 + 2.1 * rows), squeeze=False, sharex=True)
    for axis in axes.flat[len(entries):]:
        axis.remove()
    for axis, entry in zip(axes.flat, entries):
        draw_rungs(axis, entry, costs)
    span = [cost for cost in map(known, costs) if math.isfinite(cost)]
    ticks = [tick for tick in (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10) if 0.9 * min(span) <= tick <= 1.1 * max(span)]
    for axis in axes.flat[:len(entries)]:
        axis.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        axis.minorticks_off()
    for axis in axes.flat[max(0, len(entries) - columns):len(entries)]:
        axis.set_xlabel(f"wall time / that of {data['reference']}")
        axis.tick_params(labelbottom=True)
    figure.supylabel("|shift of the mean| / budget, 95 % interval", fontsize=9)
    named = {label: handle for axis in axes.flat[:len(entries)] for handle, label in zip(*axis.get_legend_handles_labels())}
    legend_below(figure, list(named.values()), list(named), 0.55 / (0.9 + 2.1 * rows))
    what = "what refining changes" if data.get("refining") else "minimum rung of each quantity"
    figure.suptitle(f"{data['study']}: {what}, {data['samples']} samples (filled: adequate or settled)", fontsize=10)
    return figure
