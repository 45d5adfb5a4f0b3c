"""Skidding: slip over load, the load at which a tenth slips, its scatter over starts, and whether the state is one."""

import random
from math import log
from statistics import mean, stdev

from matplotlib import pyplot

from bearings import NU205, NU208, NU215
from report import WIDTH, logarithmic, number, percent, signed_percent
from torque_models import SERIES, ntn_minimum_load, schaeffler_minimum_load, skf_minimum_load

TENTH = 0.1
SPEEDS = {NU205: (3000, 6000, 12000), NU208: (3000, 6000, 9000)}
LOADS = {NU205: (20, 50, 100, 130, 160, 200, 300, 450, 1000), NU208: (50, 100, 200, 300, 450, 700, 1000, 2000)}
START_LOADS = (60, 80, 100, 120, 140, 160, 180)  # around a tenth at 6000 r/min
STARTS = 20
LOADED_SPEEDS = (1000, 3000, 5000)  # NU 215
LOADED_SHARES = (0.25, 0.5, 1, 2, 4)  # of SKF's minimum load
LOADED_MOST = 0.04  # slip at that load, by published tests of this bearing
HISTORY_LOADS = (50, 150, 300, 1000)
LONG_SETTLING = 50  # cage revolutions


def load_of_a_tenth(slips):
    """Load at which slip passes a tenth, from {load: slip}; slip falls about exponentially. None where it does not."""
    loads = sorted(slips)
    for less, more in zip(loads, loads[1:]):
        if slips[less] >= TENTH > slips[more] > 0:
            return less + (more - less) * log(slips[less] / TENTH) / log(slips[less] / slips[more])
    return None


def start_of(bearing, draw):
    """A start of the cage: anywhere within half of its guide clearance, turned by any angle of a pitch."""
    b, cage = bearing.file["bearing"], bearing.file["cage"]
    half = 250 * (b["shoulder_diameter_mm"] - cage["outer_diameter_mm"])  # half of the radial clearance [um]
    return {"start.cage_offset_y_um": round(draw.uniform(-half, half), 3),
            "start.cage_offset_z_um": round(draw.uniform(-half, half), 3),
            "start.cage_phase_deg": round(draw.uniform(0, 360 / b["roller_count"]), 4)}


def slip_over_load(page, program, bearing, speeds, loads):
    """{speed: {load: slip of the rollers that drive}}"""
    found = {}
    for rpm in speeds:
        for load in loads:
            run = program.run(bearing.scene, bearing.settings | {"load.radial_N": load, "speed.inner_rpm": rpm})
            if not page.note_failure(f"slip, {bearing.title}, {load:g} N, {rpm:g} r/min", run):
                found.setdefault(rpm, {})[load] = run["driving_slip_ratio"]
    return found


def draw_slip(found):
    figure, axes = pyplot.subplots(1, len(found), figsize=(WIDTH, 3.0), squeeze=False)
    for axis, (bearing, speeds) in zip(axes[0], found.items()):
        for colour, (rpm, slips) in enumerate(speeds.items()):
            line, = axis.plot(list(slips), [100 * s for s in slips.values()], "o-", label=f"{rpm:g} r/min")
            least = skf_minimum_load(SERIES[bearing.series], bearing.bore, bearing.outside, rpm, bearing.reference_rpm)
            axis.axvline(least, color=line.get_color(), linestyle=":", linewidth=1.2)
        axis.axhline(100 * TENTH, color="#8A8A8A", linewidth=0.8)
        logarithmic(axis, (20, 50, 100, 200, 500, 1000, 2000))
        axis.set_xlim(0.9 * LOADS[bearing][0], 1.1 * LOADS[bearing][-1])
        axis.set_xlabel("load [N]")
        axis.set_ylabel("slip of the driving rollers [%]")
        axis.set_title(f"{bearing.title} (dotted: SKF's minimum load)")
        axis.legend()
    return figure


def over_load_and_speed(page, program, quick):
    found = {}
    rows = []
    for bearing in ((NU205,) if quick else SPEEDS):
        speeds, loads = ((6000,), (160,)) if quick else (SPEEDS[bearing], LOADS[bearing])
        found[bearing] = slip_over_load(page, program, bearing, speeds, loads)
        page.add(f"### {bearing.title}: slip of the rollers that drive (`driving_slip_ratio`), %", "")
        page.table(["r/min"] + [f"{load:g} N" for load in loads],
                   [[f"{rpm:g}"] + [percent(found[bearing].get(rpm, {}).get(load, float("nan")), 3) for load in loads]
                    for rpm in speeds])
        for rpm in speeds:
            tenth = load_of_a_tenth(found[bearing].get(rpm, {}))
            skf = skf_minimum_load(SERIES[bearing.series], bearing.bore, bearing.outside, rpm, bearing.reference_rpm)
            rows.append([bearing.title, f"{rpm:g}", number(tenth), number(skf), number(tenth / skf if tenth else None),
                         number(schaeffler_minimum_load(bearing.C0)), number(ntn_minimum_load(bearing.C0))])
    page.add("### Load at which slip passes 10 %, against the makers' minimum loads, N", "")
    page.table(["bearing", "r/min", "10 % slip at", "SKF", "ratio to SKF", "Schaeffler, C0/60", "NTN, 0.04 C0"], rows)
    page.add("A maker's minimum load is advice with a margin that no maker states, not a measured slip.", "")
    if quick:
        return
    slips = found[NU205].get(6000, {})
    light, heavy = sorted(slips), [s for load, s in slips.items() if load >= 450]
    falls = all(slips[a] > slips[b] for a, b in zip(light, light[1:]))
    page.bar("slip, NU 205, 6000 r/min", "falls with load", "falls" if falls else "does not", falls)
    page.bar("slip, NU 205, 6000 r/min, from 450 N", "below 1.5 %", percent(max(heavy)) + " %", max(heavy) < 0.015)
    page.figure("validation-slip", draw_slip(found), "Slip over load at several speeds")


def over_starts(page, program, quick):
    page.add("### NU 205, 6000 r/min: scatter between starts", "",
             f"{STARTS} starts for each load, the cage off centre by up to half of its guide clearance in y and z and",
             "turned within a pitch (`start.cage_offset_y_um`, `start.cage_offset_z_um`, `start.cage_phase_deg`;",
             "seed 38).", "")
    draw = random.Random(38)
    starts = [start_of(NU205, draw) for _ in range(STARTS)]
    rows, means, per_start = [], {}, [{} for _ in starts]
    for load in ((160,) if quick else START_LOADS):
        slips, torques = [], []
        for k, start in enumerate(starts[:2] if quick else starts):
            run = program.run(NU205.scene, NU205.settings | start | {"load.radial_N": load})
            if page.note_failure(f"start {k}, NU 205, {load:g} N", run):
                continue
            slips.append(run["driving_slip_ratio"])
            torques.append(run["friction_torque_Nmm"])
            per_start[k][load] = slips[-1]
        means[load] = mean(slips)
        rows.append([f"{load:g}", len(slips), percent(mean(slips), 3), percent(stdev(slips), 2),
                     f"{percent(min(slips), 3)} to {percent(max(slips), 3)}", number(mean(torques)),
                     number(stdev(torques), 2)])
    page.table(["load, N", "starts", "mean slip, %", "standard deviation, %", "range, %", "mean torque, N mm",
                "standard deviation"], rows)
    if quick:
        return
    tenth = load_of_a_tenth(means)
    single = [t for t in (load_of_a_tenth(s) for s in per_start) if t]
    page.add(f"The mean of the starts passes 10 % at **{number(tenth)} N**; single starts at"
             f" {number(min(single, default=None))} to {number(max(single, default=None))} N.", "")
    page.bar("10 % slip, NU 205, 6000 r/min, mean of 20 starts", "between 120 and 230 N",
             f"{number(tenth)} N", tenth is not None and 120 <= tenth <= 230)


def at_least_loads(page, program, quick):
    page.add("### NU 215: slip of the rollers that drive at SKF's minimum load, %", "")
    rows, at_least, falls = [], [], True
    for rpm in LOADED_SPEEDS[:1] if quick else LOADED_SPEEDS:
        least = skf_minimum_load(SERIES[NU215.series], NU215.bore, NU215.outside, rpm, NU215.reference_rpm)
        slips = []
        for share in LOADED_SHARES:
            run = program.run(NU215.scene, NU215.settings | {"load.radial_N": round(share * least), "speed.inner_rpm": rpm})
            page.note_failure(f"slip, NU 215, {share * least:.0f} N, {rpm} r/min", run)
            slips.append(run["driving_slip_ratio"])
        at_least.append(slips[LOADED_SHARES.index(1)])
        falls &= all(a > b for a, b in zip(slips, slips[1:]))
        rows.append([f"{rpm}", f"{least:.0f}"] + [percent(slip, 3) for slip in slips])
    page.table(["r/min", "minimum load, N"] + [f"{share:g} of it" for share in LOADED_SHARES], rows)
    page.bar("slip, NU 215, at SKF's minimum load", f"at most {percent(LOADED_MOST)} %", percent(max(at_least)) + " %",
             max(at_least) <= LOADED_MOST)
    page.bar("slip, NU 215", "falls with load", "falls" if falls else "does not", falls)


def from_two_states(page, program, quick):
    page.add("### NU 205, 6000 r/min: is the state reached the only one?", "",
             "From pure rolling, and from 30 % slip: there the inner ring turns at 4200 r/min at the start, all else",
             "rolls with it, and the ring is brought to 6000 r/min within 0.2 ms. Both settle for",
             f"{LONG_SETTLING} turns of the cage. \"Steady\" is the default start.", "")
    rows = []
    rolling = {"start.state": "equilibrium", "window.settle_revolutions": LONG_SETTLING}
    slipping = rolling | {"speed.ramp_from_rpm": 4200, "speed.ramp_ms": 0.2}
    worst = 0.0
    for load in ((300,) if quick else HISTORY_LOADS):
        runs = [program.run(NU205.scene, NU205.settings | more | {"load.radial_N": load})
                for more in ({}, rolling, slipping)]
        for name, run in zip(("steady start", "from rolling", "from 30 % slip"), runs):
            page.note_failure(f"{name}, NU 205, {load:g} N", run)
        speed = [1 - run["driving_slip_ratio"] for run in runs]
        apart = abs(speed[2] / speed[1] - 1)
        worst = max(worst, apart)
        torque = [run["friction_torque_Nmm"] for run in runs]
        rows.append([f"{load:g}"] + [percent(1 - s, 3) for s in speed]
                    + [signed_percent(speed[2] / speed[1] - 1, 2), signed_percent(speed[0] / speed[1] - 1, 2),
                       signed_percent(torque[2] / torque[1] - 1, 2)])
    page.table(["load, N", "slip, %: steady", "from rolling", "from 30 %", "speed, 30 % against rolling, %",
                "speed, steady against rolling, %", "torque, 30 % against rolling, %"], rows)
    page.bar("starts at 0 and 30 % slip, NU 205", "orbital speeds end within 5 %", f"{percent(worst)} %", worst <= 0.05)


def skid_section(page, program, quick):
    page.heading("Skidding against the makers' minimum loads")
    over_load_and_speed(page, program, quick)
    over_starts(page, program, quick)
    at_least_loads(page, program, quick)
    from_two_states(page, program, quick)
