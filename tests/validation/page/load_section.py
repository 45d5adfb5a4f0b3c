"""Ratings of the chosen rollers, and static load distribution against ISO/TS 16281."""

from dataclasses import replace
from math import pi

from matplotlib import pyplot

from bearings import BEARINGS, NU205
from film_formulas import effective_modulus
from load_distribution import distribution, hertz_pressure, laminae_of_load
from report import WIDTH, number, percent, signed_percent

STATICS = {"lubrication.model": "none", "environment.gravity_m_s2": 0, "speed.inner_rpm": 1,
           "start.state": "equilibrium", "window.settle_time_s": 0, "window.measure_time_s": 2e-5}
DOWN = -90  # phase of the cage that puts the first roller under the load [deg]
YOUNG, POISSON = 208e3, 0.3  # of the scenes' steel [MPa]


def ratings(page, _program, _quick):
    page.heading("Ratings of the rollers chosen")
    page.add("A catalogue gives neither Z nor L_we. In each scene they give the catalogue's C by ISO 281 and C0 by",
             "ISO 76.", "")
    rows = []
    for b in BEARINGS:
        g, r = b.file["bearing"], b.file["roller"]
        C, C0 = b.dynamic_rating(), b.static_rating()
        cells = [b.title, g["roller_count"], number(r["diameter_mm"]), number(r["length_mm"]), f"{b.factor:g}"]
        for found, due in ((C, b.C), (C0, b.C0)):
            cells += [number(found / 1e3), number(due / 1e3) if due else "-"]
            cells.append(signed_percent(found / due - 1) if due else "-")
        rows.append(cells)
        if b.C:
            worst = max(abs(C / b.C - 1), abs(C0 / b.C0 - 1))
            page.bar(f"ratings, {b.title}", "C and C0 within 3 %", f"{percent(worst)} %", worst <= 0.03)
    page.table(["bearing", "Z", "D_we, mm", "L_we, mm", "b_m", "C, kN", "catalogue", "%", "C0, kN", "catalogue", "%"],
               rows)
    page.add("NU 205 is the default scene as it is shipped. Its rollers of 9 mm fit the rating of 32.5 kN of",
             "newer catalogues with b_m = 1.1, but not C0 = 27 kN; 7.77 mm would give both of the catalogue here",
             "(28.6 and 27 kN).", "")


def pressure(bearing, line_load):
    """Largest pressure on the inner race [MPa]; line load [N/mm]."""
    roller, race = bearing.file["roller"]["diameter_mm"] / 2, bearing.inner_race()
    return hertz_pressure(line_load, roller * race / (roller + race), effective_modulus(YOUNG, POISSON))


def pressures(bearing, rollers, largest, due, slices):
    """Cells: by the program's largest roller load over its slices, by ISO/TS 16281, error."""
    ours = pressure(bearing, laminae_of_load(rollers, largest, slices).max() * slices / rollers.length)
    theirs = pressure(bearing, due.largest_line_load(rollers.length))
    return [number(ours, 4), number(theirs, 4), signed_percent(ours / theirs - 1, 2)]


def draw(found):
    figure, axes = pyplot.subplots(2, 3, figsize=(1.3 * WIDTH, 4.6))
    for axis, (bearing, (due, loads)) in zip(axes.flat, found.items()):
        angle = [(180 / pi * a + 180) % 360 - 180 for a in due.angles]
        order = sorted(range(len(angle)), key=lambda j: angle[j])
        axis.plot([angle[j] for j in order], [due.loads[j] / 1e3 for j in order], "-", label="ISO/TS 16281")
        axis.plot([angle[j] for j in order], [loads[j] / 1e3 for j in order], "o", label="cagetol")
        axis.set_title(f"{bearing.title}, {bearing.load / 1e3:g} kN")
        axis.set_xlabel("angle from the load [deg]")
        axis.set_xlim(-120, 120)
    for row in axes:
        row[0].set_ylabel("load of a roller [kN]")
    axes[0][0].legend(loc="upper left")
    return figure


def distributions(page, program, quick):
    page.heading("Load distribution against ISO/TS 16281")
    page.add("Dry, at standstill (1 r/min, no gravity), steel, a roller under the load or the load between two:",
             "static equilibrium of the program against the lamina model with 41 laminae",
             "(`page/load_distribution.py`). Both hold contacts to the same law, so what differs is the number",
             "of slices: the scenes have 5, the second table 41. Error of a roller: largest difference over the",
             "largest load. Pressure: on the inner race, of the heaviest lamina of the most loaded roller,",
             "elastic line contact.", "")
    found = {}
    for slices in (5, 41):
        rows = []
        for bearing in ([NU205] if quick else BEARINGS):
            for tilt, between in ((0.0, False), (0.0, True), (0.3, False)):
                turned = 180 / bearing.rollers().count if between else 0.0
                run = program.run(bearing.scene, bearing.settings | STATICS | {
                    "bearing.misalignment_z_mrad": tilt, "discretisation.race_slices": slices,
                    "start.cage_phase_deg": DOWN + turned}, ("inner_force", "ring_displacement"))
                page.note_failure(f"statics, {bearing.title}", run)
                rollers = replace(bearing.rollers(), misalignment=1e-3 * tilt)
                due = distribution(rollers, bearing.load, turned * pi / 180)
                loads, moved = run.history["inner_force"], run.history["ring_displacement"]
                worst = max(abs(a - b) for a, b in zip(loads, due.loads)) / max(due.loads)
                cells = [bearing.title, f"{bearing.load:g}", f"{tilt:g}", "between" if between else "under",
                         number(max(loads), 4), number(max(due.loads), 4), percent(worst), number(moved, 4),
                         number(1e3 * due.displacement, 4), signed_percent(1e-3 * moved / due.displacement - 1, 2)]
                cells += pressures(bearing, rollers, max(loads), due, slices) if tilt == 0 else ["-"] * 3
                if slices == 5 and tilt == 0 and not between:
                    found[bearing] = (due, loads)
                rows.append(cells)
        page.add(f"### {slices} slices", "")
        page.table(["bearing", "load, N", "misaligned, mrad", "roller", "largest roller load, N", "ISO/TS 16281",
                    "error of a roller, %", "displacement, um", "ISO/TS 16281", "error, %", "pressure, MPa",
                    "ISO/TS 16281", "error, %"], rows)
    if not quick:
        page.figure("validation-load", draw(found), "Load of each roller beside ISO/TS 16281")
