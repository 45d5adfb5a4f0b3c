"""Measured cages one by one: every pocket, and the mean of each cage, between the limits of the tolerance."""

import matplotlib.pyplot as plt

from common import BLUE, GREY, RED, WIDTH, with_unit

MOST_NAMES = 40  # that fit below one another's ticks


def process(report):
    """A panel for each measured key with cages; None without any."""
    measured = [entry for entry in report["measured"] if entry["group"]]
    if not measured:
        return None
    figure, axes = plt.subplots(len(measured), 1, figsize=(WIDTH, 2.4 * len(measured)), squeeze=False)
    for axis, entry in zip(axes[:, 0], measured):
        offset = entry["offset"] if entry["centred"] else 0.0  # the process, not the law
        gaps = {int(gap) for gap in entry["gaps"]}
        known = [i for i in range(len(entry["values"])) if i not in gaps]
        axis.plot([entry["cage"][i] for i in known], [entry["values"][i] + offset for i in known], ".", color=GREY, markersize=3,
                  label="pockets")
        axis.plot([mean + offset for mean in entry["means"]], "_", color=BLUE, markersize=10, markeredgewidth=2, label="mean of the cage")
        axis.axhline(0, color=GREY, linewidth=0.6)
        width = entry["process"]["tolerance_width"]
        for side in (-0.5, 0.5) if width else ():
            axis.axhline(side * width, color=RED, linestyle="--", linewidth=1.4, label="tolerance" if side > 0 else None)
        names = entry["names"]
        axis.set_xticks(range(len(names)), names if len(names) <= MOST_NAMES else [""] * len(names), rotation=90, fontsize=7)
        axis.set_ylabel(with_unit(f"{entry['name']},\ndeviation", entry["unit"]))
        axis.legend(loc="upper left", bbox_to_anchor=(1, 1), fontsize=8)
    axes[-1, 0].set_xlabel("measured cage")
    return figure
