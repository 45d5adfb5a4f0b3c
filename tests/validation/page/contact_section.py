"""Rolling resistance and traction: tables, and the rolling share of a run against a static sum."""

from math import pi

from bearings import NU205
from contact_forces import elastic_rolling, rigid_rolling, rolling_resistance, traction_coefficient
from film_formulas import LineContact, both_regimes, effective_modulus
from report import number, signed_percent
from static_rolling import static_rolling

LENGTH = 9e-3  # of the rollers of the tables [m]
INNER = LineContact(0.02, 1.8e-8, 3.0288e-3, effective_modulus(), 5.8995)
OUTER = LineContact(0.02, 1.8e-8, 4.4712e-3, effective_modulus(), 5.8995)
# Rolling force f L [N] at roller load [N]: inner elastic, rigid, both, outer both; by an independent script.
ROLLING = {1: (0.4771, 0.0678, 0.0677, 0.0677), 4: (0.4855, 0.1355, 0.1346, 0.1349),
           20: (0.4955, 0.3031, 0.2830, 0.2888), 100: (0.5057, 0.6777, 0.4504, 0.4904),
           314.2: (0.5131, 1.2012, 0.5004, 0.5626), 567: (0.5169, 1.6137, 0.5114, 0.5785)}
# Friction coefficient of the film at 0.01, 0.1 and 1 m/s, as tests/unit/src/traction_test.cpp holds the program to.
TRACTION = {20: (3.448e-5, 3.448e-4, 3.446e-3), 100: (2.814e-4, 2.800e-3, 2.081e-2),
            300: (7.268e-3, 2.528e-2, 3.900e-2), 567: (2.431e-2, 3.519e-2, 4.261e-2)}
SLIDING = (0.01, 0.1, 1.0)
SUM_LOADS = (300, 1000, 3000, 10000)


def contact_section(page, program, quick):
    page.heading("Rolling resistance and traction of one contact")
    page.add("0.02 Pa s, 18 1/GPa, u = 5.8995 m/s, 9 mm long, R 3.0288 mm inside and 4.4712 mm outside, no oil",
             "layer. The page's own formulas (`page/contact_forces.py`) against numbers computed once by an",
             "independent script, to which the program's laws are held by `unit.src` RollingResistance and",
             "Traction.", "")
    rows = []
    for load, due in ROLLING.items():
        q = load / LENGTH
        found = [LENGTH * f for f in (elastic_rolling(INNER, q), rigid_rolling(INNER, q), rolling_resistance(INNER, q),
                                      rolling_resistance(OUTER, q))]
        rows.append([f"{load:g}"] + [number(f, 4) for f in found]
                    + [signed_percent(max((f / d - 1 for f, d in zip(found, due)), key=abs), 2)])
    page.table(["load, N", "f_E L inside, N", "f_I L", "f L inside", "f L outside", "largest difference, %"], rows)
    rows = []
    for load, due in TRACTION.items():
        q = load / LENGTH
        film = both_regimes(INNER, q)
        found = [traction_coefficient(INNER, q, film, du) for du in SLIDING]
        rows.append([f"{load:g}", number(1e6 * film, 4)] + [f"{mu:.3e}" for mu in found]
                    + [signed_percent(max((f / d - 1 for f, d in zip(found, due)), key=abs), 2)])
    page.table(["load, N", "h, um"] + [f"mu at {du:g} m/s" for du in SLIDING] + ["largest difference, %"], rows)
    page.add("### Rolling share of a run against the sum over static loads", "",
             "NU 205, 6000 r/min, all gaps flooded (pockets: 10 mm) and inlet heating off. Sum: 2 f u over both races, mean over",
             "roller angles; unloaded rollers press on the outer race by their centrifugal force. N mm.", "")
    rows = []
    for load in ((1000,) if quick else SUM_LOADS):
        run = program.run(NU205.scene, NU205.settings | {
            "load.radial_N": load, "lubrication.race_layer_um": "flooded", "lubrication.outer_layer_um": "flooded",
            "lubrication.land_layer_um": "flooded", "lubrication.pocket_layer_um": 10000,
            "lubrication.inlet_heating": False})
        page.note_failure(f"rolling share, NU 205, {load:g} N", run)
        ours = 1e3 * run["power_rolling_W"] / (NU205.rpm * pi / 30)
        due = sum(static_rolling(NU205, load))
        bar = 0.20 if load == 300 else 0.15
        page.bar(f"rolling share, NU 205, {load:g} N", f"within {100 * bar:g} % of the static sum",
                 signed_percent(ours / due - 1) + " %", abs(ours / due - 1) <= bar)
        rows.append([f"{load:g}", number(ours), number(due), signed_percent(ours / due - 1)])
    page.table(["load, N", "program, rolling", "static sum", "%"], rows)
