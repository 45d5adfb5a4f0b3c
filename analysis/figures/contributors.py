"""Which features of a cage drive which quantity."""

import math

import matplotlib.pyplot as plt
import numpy as np

from common import BLUE, GREY, SKY, WIDTH, interval_bars, known, pockets_alike, readable, with_unit


def outputs_to_explain(report):
    """The outputs that decide: pass or fail, jams, then the limited quantities."""
    names = ["meets all limits", "jams"] + [entry["quantity"] for entry in report["limits"]["each"]]
    by_name = {entry["output"]: entry for entry in report["contributors"]["outputs"]}
    chosen = [by_name[name] for name in names if name in by_name]
    return chosen or report["contributors"]["outputs"][:2]


def stands_out(share):
    """Whether its interval lies above zero."""
    return known(share["lower"]) > 0


def pareto(report):
    """Largest contributors of each deciding output, with intervals."""
    outputs = [output for output in outputs_to_explain(report) if any(stands_out(share) for share in output["shares"])]
    if not outputs:
        return None
    most = 6
    columns = min(2, len(outputs))
    rows = -(-len(outputs) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 2.1 * rows), squeeze=False, sharex=True)
    for axis in axes.flat[len(outputs):]:
        axis.set_visible(False)
    for axis, output in zip(axes.flat, outputs):
        shares = sorted(output["shares"], key=lambda share: -known(share["value"]))[:most]
        places = range(len(shares))
        axis.barh(places, [100 * max(known(share["value"]), 0) for share in shares], color=SKY, height=0.65,
                  xerr=100 * np.array(interval_bars(shares)), error_kw={"ecolor": "#333333", "elinewidth": 1, "capsize": 2})
        axis.set_yticks(places, [share["feature"] for share in shares], fontsize=7)
        axis.set_ylim(max(len(shares), 4) - 0.5, -0.5)
        axis.set_title(readable(output["output"]), loc="right", fontsize=8.5)
        axis.set_xlim(0, 100)
        axis.grid(axis="y", visible=False)
        axis.set_xlabel("share of variance [%]")
        axis.xaxis.set_tick_params(labelbottom=True)
    return figure


MOST_ROWS = 26  # what a page has room for; report.json holds all
MINIMUM_PRINTED = 5  # a smaller share [%] is a colour without a number


def most_explained(report):
    """The deciding outputs, then those that one feature explains most of; no bookkeeping."""
    idle = {entry["quantity"] for entry in report["quantities"] if entry["bookkeeping"]}
    outputs = [output for output in report["contributors"]["outputs"] if output["output"] not in idle and output["shares"]]
    deciding = [output for output in outputs_to_explain(report) if output in outputs]
    share = lambda output: -max((known(s["value"]) for s in output["shares"] if not math.isnan(known(s["value"]))), default=0)
    return (deciding + sorted((output for output in outputs if output not in deciding), key=share))[:MOST_ROWS]


def matrix(report):
    """Contributor by quantity heat map, of the features that explain something."""
    outputs = most_explained(report)
    features = np.array([feature["name"] for feature in report["contributors"]["features"]])
    if not outputs or not features.size:
        return None
    shares = np.array([[100 * known(share["value"]) for share in output["shares"]] for output in outputs])
    felt = (np.nan_to_num(shares) >= MINIMUM_PRINTED).any(axis=0)
    if not felt.any():
        return None
    shares, features = shares[:, felt], features[felt]
    figure, axis = plt.subplots(figsize=(WIDTH, 2.1 + 0.225 * len(outputs)))
    image = axis.imshow(np.clip(shares, 0, None), cmap="Blues", vmin=0, vmax=100, aspect="auto")
    for row in range(shares.shape[0]):
        for column in range(shares.shape[1]):
            value = shares[row, column]
            if not math.isnan(value) and value >= MINIMUM_PRINTED:
                axis.text(column, row, f"{value:.0f}", ha="center", va="center", fontsize=8,
                          color="white" if value > 50 else "black")
    axis.set_xticks(range(len(features)), features, rotation=55, ha="right", rotation_mode="anchor", fontsize=8)
    axis.set_yticks(range(len(outputs)), [readable(output["output"]) for output in outputs], fontsize=8)
    axis.grid(False)
    figure.colorbar(image, ax=axis, pad=0.01).set_label("share of variance [%]")
    return figure


def standing_out(report):
    """The two clearest maps in which a single pocket explains more than its neighbours."""
    return sorted(report["contributors"]["pockets"], key=lambda entry: -max(known(share) for share in entry["shares"]))[:2]


def pocket_map(report):
    """Share of each single pocket around the bearing; none where one pocket is as good as another."""
    maps = [] if pockets_alike(report) else standing_out(report)
    if not maps:
        return None
    figure, axes = plt.subplots(1, len(maps), figsize=(WIDTH, 3.2), subplot_kw={"projection": "polar"}, squeeze=False)
    for axis, entry in zip(axes[0], maps):
        shares = [max(100 * known(share), 0) for share in entry["shares"]]
        count = len(shares)
        angles = 2 * np.pi * np.arange(count) / count
        axis.bar(angles, shares, width=0.8 * 2 * np.pi / count, color=BLUE)
        axis.set_xticks(angles, [str(pocket) for pocket in range(count)])
        axis.tick_params(pad=1)
        axis.set_rlabel_position(360 / count * 0.5)
        axis.set_title(f"{entry['name']} → {readable(entry['output'])}\nshare of variance [%] by pocket", loc="center", fontsize=8.5)
    return figure


def responses(report):
    """Mean of each deciding output over its strongest contributor."""
    outputs = [output for output in outputs_to_explain(report) if output.get("response", {}).get("points")]
    if not outputs:
        return None
    columns = min(2, len(outputs))
    rows = -(-len(outputs) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, 2.2 * rows), squeeze=False)
    for axis in axes.flat[len(outputs):]:
        axis.set_visible(False)
    for axis, output in zip(axes.flat, outputs):
        points = output["response"]["points"]
        indicator = output["output"] in ("meets all limits", "jams")
        factor = 100 if indicator else 1
        error = [2 * factor * (0 if math.isnan(known(p["standard_error"])) else p["standard_error"]) for p in points]
        axis.errorbar([known(p["feature"]) for p in points], [factor * known(p["mean"]) for p in points], yerr=error,
                      fmt="o-", color=BLUE, ecolor=GREY, capsize=2)
        axis.set_xlabel(with_unit(output["response"]["feature"], output["response"]["unit"]))
        axis.set_ylabel(f"runs that {'meet' if 'meets' in output['output'] else 'jam'} [%]" if indicator
                        else with_unit("mean", output["unit"]))
        axis.set_title(readable(output["output"]))
        axis.locator_params(axis="x", nbins=5)
    return figure
