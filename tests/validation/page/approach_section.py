"""Elastic approach of roller and race: both laws of the program beside the two-dimensional theory."""

from math import sqrt
from statistics import mean, stdev

from bearings import NU205
from line_approach import line_approach, palmgren_approach, races
from load_section import DOWN, STATICS
from report import number, signed_percent

FORCES = (10, 30, 50, 100, 300, 385, 1000, 3000)  # [N]
RUN_LOADS = (1000, 3000)
STARTS = 8  # cage phases over one pitch
QUANTITIES = (("ring_displacement_mean_um", "displacement, um"), ("friction_torque_Nmm", "torque, N mm"),
              ("pocket_force_rms_N", "pocket force, rms, N"), ("cage_slip_ratio", "slip"),
              ("film_min_um", "minimum film, um"))


def laws(page):
    length, count = NU205.file["roller"]["length_mm"], NU205.file["bearing"]["roller_count"]
    both = races(NU205)
    at = 5 * NU205.load / count
    share = sum(line_approach(race, at / length) for race in both) / (2 * palmgren_approach(at, length))
    rows = []
    for force in FORCES:
        due = [line_approach(race, force / length) for race in both]
        cells = [f"{force:g}"] + [number(1e3 * d) for d in due]
        for factor in (1, share):
            ours = factor * palmgren_approach(force, length)
            cells += [number(1e3 * ours)] + [signed_percent(ours / d - 1) for d in due]
            cells.append(signed_percent(2 * ours / sum(due) - 1))
        rows.append(cells)
    page.table(["roller load, N", "theory inside, um", "outside", '"palmgren"', "inside, %", "outside, %", "both, %",
                '"line"', "inside, %", "outside, %", "both, %"], rows)


def of_starts(values):
    """Mean and its standard error, where there are several."""
    if len(values) == 1:
        return number(values[0], 4)
    return f"{number(mean(values), 4)} ± {number(stdev(values) / sqrt(len(values)), 2)}"


def runs(page, program, quick):
    rows, count = [], NU205.file["bearing"]["roller_count"]
    for load in RUN_LOADS[:1] if quick else RUN_LOADS:
        for law in ("palmgren", "line"):
            settings = NU205.settings | {"load.radial_N": load, "contact.race.approach": law}
            still = program.run(NU205.scene, settings | STATICS | {"start.cage_phase_deg": DOWN}, ("inner_force",))
            page.note_failure(f"statics, NU 205, {load:g} N, {law}", still)
            forces = still.history["inner_force"]
            found = []
            for start in range(1 if quick else STARTS):
                run = program.run(NU205.scene, settings | {"start.cage_phase_deg": start * 360 / (count * STARTS)})
                page.note_failure(f"approach, NU 205, {load:g} N, {law}, start {start}", run)
                found.append(run)
            rows.append([f"{load:g}", law, number(max(forces), 4), sum(q > 0 for q in forces)]
                        + [of_starts([run[key] for run in found]) for key, _ in QUANTITIES])
    page.table(["load, N", "approach", "largest roller load, N", "loaded rollers"] + [name for _, name in QUANTITIES],
               rows)


def approach_section(page, program, quick):
    page.heading("Approach of roller and race against the two-dimensional theory")
    page.add('The program\'s two laws (`contact.race.approach`) beside Johnson\'s relation of a long line contact',
             "(`page/line_approach.py`), whose depth in the ring is an assumption: the ring's thickness, 3.25 mm",
             'inside and 2.75 mm outside. NU 205, steel. "line" is as stiff as the theory says of both races',
             f"together at the most loaded roller's load by Stribeck's estimate, 5 F/Z, here of {NU205.load:g} N; it keeps",
             "the exponent 10/9 and one stiffness for both races. `unit.src` LineApproach holds it to sums of",
             "point loads on disc and half-plane.", "")
    laws(page)
    page.add("What that moves. Roller loads by static equilibrium (dry, at standstill, a roller under the load); the",
             f"rest from the lubricated bearing, mean over {STARTS} starts and its standard error.", "")
    runs(page, program, quick)
