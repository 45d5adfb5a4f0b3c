"""Yield against the centre of a tolerance."""

import matplotlib.pyplot as plt
import numpy as np

from common import BLUE, RED, WIDTH, known


def centre_curves(report):
    """One panel for each dimension: yield with its bounds over the setting beside the nominal value."""
    centres = report["tolerance"].get("centres") if report["tolerance"] else None
    if not centres:
        return None
    panels = [(number, dimension, [point for point in dimension["points"] if point["shown"]])
              for number, dimension in enumerate(centres["dimensions"])]
    panels = [panel for panel in panels if len(panel[2]) > 1]
    if not panels:
        return None
    figure, axes = plt.subplots(1, len(panels), figsize=(WIDTH, 3.0), sharey=True, squeeze=False)
    for axis, (number, dimension, points) in zip(axes[0], panels):
        shifts = [1e3 * point["shifts_mm"][number] for point in points]
        value, lower, upper = ([100 * known(point["yield"][key]) for point in points]
                               for key in ("if_unknown_fail", "lower_bound", "upper_bound"))
        axis.fill_between(shifts, lower, upper, color=BLUE, alpha=0.15, linewidth=0, label="between the bounds")
        axis.plot(shifts, value, "o-", color=BLUE, label="yield")
        axis.axhline(100 * report["verdict"]["target_yield"], color=RED, linestyle="--", linewidth=1.2, label="target")
        axis.set_xlabel(f"centre of {dimension['name']}\nbeside the nominal value [µm]")
        axis.set_xticks(shifts)
        axis.set_xticklabels([f"{shift:+.0f}\n({point['effective_runs']:.0f})" for shift, point in zip(shifts, points)],
                             fontsize=7)
    axes[0][0].set_ylabel("yield [%]")
    axes[0][0].legend(loc="best")
    return figure


def centre_map(report):
    """Yield over two centres together."""
    centres = report["tolerance"].get("centres") if report["tolerance"] else None
    if not centres or sum(point["shown"] for point in centres["map"]) < 2:
        return None
    rows = sorted({point["shifts_mm"][0] for point in centres["map"]})
    columns = sorted({point["shifts_mm"][1] for point in centres["map"]})
    value = np.full((len(rows), len(columns)), np.nan)
    figure, axis = plt.subplots(figsize=(WIDTH, 0.9 + 0.5 * len(rows)))
    target = 100 * report["verdict"]["target_yield"]
    reach = max(100 - target, 1.0)  # the colours end at 100 % and as far below the target
    for point in centres["map"]:
        place = rows.index(point["shifts_mm"][0]), columns.index(point["shifts_mm"][1])
        words = f"({point['effective_runs']:.0f})"
        if point["shown"]:
            value[place] = 100 * point["yield"]["if_unknown_fail"]
            words = f"{value[place]:.1f} %\n{words}"
        strong = abs(np.nan_to_num(value[place], nan=target) - target) > 0.5 * reach
        axis.text(place[1], place[0], words, ha="center", va="center", fontsize=8, color="white" if strong else "black")
    image = axis.imshow(value, cmap="PuOr", vmin=target - reach, vmax=target + reach, aspect="auto", origin="lower")
    first, second = centres["dimensions"][:2]
    axis.set_xticks(range(len(columns)), [f"{1e3 * shift:+.0f} µm" for shift in columns])
    axis.set_yticks(range(len(rows)), [f"{1e3 * shift:+.0f} µm" for shift in rows])
    axis.set_xlabel(f"centre of {second['name']} beside the nominal value")
    axis.set_ylabel(f"centre of {first['name']}")
    axis.grid(False)
    figure.colorbar(image, ax=axis, pad=0.02).set_label("yield [%]")
    return figure


def centre_responses(report):
    """One panel for each dimension: peak force on a pocket over its centre, fit and optimum."""
    responses = report["tolerance"].get("centre_responses", []) if report["tolerance"] else []
    if not responses:
        return None
    figure, axes = plt.subplots(1, len(responses), figsize=(WIDTH, 3.0), squeeze=False)
    for axis, response in zip(axes[0], responses):
        optimum = response["optimum"]
        if optimum["lower"] is not None and optimum["upper"] is not None:
            axis.axvspan(optimum["lower"], optimum["upper"], color=RED, alpha=0.12, linewidth=0)
        axis.axvline(optimum["value"], color=RED, linestyle="--", linewidth=1.2, label="optimum, with its interval")
        axis.plot(response["at"], response["fitted"], color=BLUE, label="fit")
        means = [mean for mean in response["means"] if mean["standard_error"] is not None]
        axis.errorbar([mean["centre"] for mean in means], [mean["mean"] for mean in means],
                      yerr=[2 * mean["standard_error"] for mean in means], fmt="o", color=BLUE, capsize=3, label="means")
        axis.set_xlabel(f"nominal {response['name']} [{response['unit']}]")
        axis.set_ylabel(f"peak force on a pocket [{response['quantity_unit']}]")
        axis.legend(loc="best", fontsize=8)
    return figure
