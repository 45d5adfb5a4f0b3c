"""Clearance of the pockets: peak bar force, slip and torque, beside the scatter between starts of one cage."""

import random
from statistics import mean, stdev

from matplotlib import pyplot

from bearings import NU205
from report import WIDTH, logarithmic, number
from skid_section import start_of

HALF_CLEARANCES = (5, 10, 15, 25, 40, 50, 75, 100, 150, 200)  # [um]
STARTS = 5
MUCH = 1.3  # ratio of peaks between starts that is looked into
LONG_SETTLING = 30  # cage revolutions
QUANTITIES = (("peak bar force, N", "pocket_force_peak_N", 1), ("rms bar force, N", "pocket_force_rms_N", 1),
              ("slip, %", "driving_slip_ratio", 100), ("torque, N mm", "friction_torque_Nmm", 1))


def measured(page, program, half, starts, more=()):
    """{quantity: values over starts}; `more`: further settings."""
    diameter = NU205.file["roller"]["diameter_mm"]
    values = {key: [] for _, key, _ in QUANTITIES}
    for k, start in enumerate(starts):
        run = program.run(NU205.scene, NU205.settings | start | {
            "cage.pocket_width_mm": round(diameter + 2e-3 * half, 4)} | dict(more))
        if page.note_failure(f"half clearance {half:g} um, start {k}", run):
            continue
        for _, key, scale in QUANTITIES:
            values[key].append(scale * run[key])
    return values


def draw_clearance(by_half):
    figure, axes = pyplot.subplots(1, 3, figsize=(1.4 * WIDTH, 2.8))
    shown = [QUANTITIES[0], QUANTITIES[2], QUANTITIES[3]]
    for axis, (name, key, _) in zip(axes, shown):
        halves = [h for h in by_half if by_half[h][key]]
        axis.errorbar(halves, [mean(by_half[h][key]) for h in halves],
                      yerr=[stdev(by_half[h][key]) if len(by_half[h][key]) > 1 else 0 for h in halves],
                      fmt="o-", capsize=2)
        logarithmic(axis, (5, 10, 25, 50, 100, 200))
        axis.set_xlabel("half clearance of the pockets [um]")
        axis.set_ylabel(name.replace(", ", " [") + "]")
    logarithmic(axes[0], (5, 10, 20, 30, 50), "y")
    return figure


def clearance_section(page, program, quick):
    page.heading("Pocket clearance")
    page.add(f"NU 205, 1 kN, 6000 r/min, 20 um of oil, {STARTS} starts for each clearance (as above, seed 7):",
             "mean ± standard deviation between starts. The last row: standard deviation between the clearances'",
             "means, over the mean standard deviation between starts.", "")
    draw = random.Random(7)
    starts = [start_of(NU205, draw) for _ in range(2 if quick else STARTS)]
    by_half, rows = {}, []
    for half in ((15,) if quick else HALF_CLEARANCES):
        values = by_half[half] = measured(page, program, half, starts)
        peaks = values["pocket_force_peak_N"]
        rows.append([f"{half:g}"] + [f"{number(mean(values[k]))} ± {number(stdev(values[k]), 2)}"
                                     if len(values[k]) > 1 else "-" for _, k, _ in QUANTITIES]
                    + [f"{number(min(peaks))} to {number(max(peaks))}" if peaks else "-"])
    if not quick:
        rows.append(["between clearances / between starts", *(between(by_half, k) for _, k, _ in QUANTITIES), "-"])
    page.table(["half clearance, um"] + [name for name, _, _ in QUANTITIES] + ["peaks of the starts, N"], rows)
    if not quick:
        judge(page, by_half)
        several_motions(page, program, by_half, starts)
        page.figure("validation-clearance", draw_clearance(by_half),
                    "Peak bar force, slip and torque over the clearance of pockets")


def several_motions(page, program, by_half, starts):
    """Where peaks differ much between starts of one cage: do they still after long settling?"""
    rows = []
    for half, values in by_half.items():
        peaks = values["pocket_force_peak_N"]
        if not peaks or max(peaks) < MUCH * min(peaks):
            continue
        late = measured(page, program, half, starts, {"window.settle_revolutions": LONG_SETTLING})
        for name, of in (("2", values), (f"{LONG_SETTLING}", late)):
            rows.append([f"{half:g}", name, ", ".join(number(p) for p in of["pocket_force_peak_N"]),
                         ", ".join(number(s) for s in of["driving_slip_ratio"])])
    page.add("### One cage, several motions", "",
             f"Clearances at which the largest peak of the starts is {MUCH:g} times the least or more, again after",
             f"{LONG_SETTLING} turns of settling. What then differs between starts lasts: the motion of such a cage depends",
             "on how it began, not on its dimensions alone.", "")
    page.table(["half clearance, um", "settling, turns", "peak bar force of each start, N", "slip, %"], rows)


def between(by_half, key):
    means = [mean(v[key]) for v in by_half.values() if len(v[key]) > 1]
    within = [stdev(v[key]) for v in by_half.values() if len(v[key]) > 1]
    return number(stdev(means) / mean(within)) if len(means) > 1 and mean(within) > 0 else "-"


def judge(page, by_half):
    def means(key):
        return {half: mean(v[key]) for half, v in by_half.items() if v[key]}

    peak, slip, torque = (means(k) for k in ("pocket_force_peak_N", "driving_slip_ratio", "friction_torque_Nmm"))
    best = min(peak, key=peak.get)
    page.bar("pocket clearance", "least peak bar force at 10 to 40 um", f"{best:g} um",
             10 <= best <= 40)
    for name, values, rises in (("peaks grow from there", peak, True), ("slip grows from there", slip, True),
                                ("torque falls from there", torque, False)):
        wide = [half for half in sorted(values) if half >= best]
        steps = [values[b] - values[a] for a, b in zip(wide, wide[1:])]
        against = sum(1 for s in steps if (s < 0) == rises and s != 0)
        page.bar("pocket clearance", name,
                 "at every step" if not against else f"against it {against} of {len(steps)} steps", not against)
