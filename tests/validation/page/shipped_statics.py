"""Every shipped bearing at rest against ISO/TS 16281 (load_distribution.py): load of each roller, displacement of the
inner ring and largest pressure, dry, of steel, without axial load, by the approach law of that standard, each within
0.5 %. Ends with 1 otherwise:

    python3 tests/validation/page/shipped_statics.py --program build/cagetol

Largest pressures come from elastic line contact at the inner race. Runs are kept in build/shipped-statics by scene,
settings and program.
"""

import argparse
import re
import sys
import tomllib
from dataclasses import replace
from math import isnan, pi
from pathlib import Path

from film_formulas import effective_modulus
from load_distribution import RollerSet, distribution, hertz_pressure
from load_section import POISSON, STATICS, YOUNG
from program import Program
from results import stamp, write_results

ROOT = Path(__file__).resolve().parents[3]
BAR = 5e-3
SLICES = 41
DOWN = -90  # phase of the cage that puts the first roller under the load [deg]
# The standard's law, and nothing that its static model does not know.
ALONE = {"contact.race.force_law": "hertz", "contact.race.approach": "palmgren",
         "discretisation.race_slices": SLICES, "cage.model": "rigid", "load.axial_N": 0, "load.direction_deg": 0,
         "load.ramp_ms": 0, "speed.outer_rpm": 0, "load.rotating_N": 0, "roller.material": "bearing-steel"}
GROWTH = r"(?ms)^\[(fit|temperature)\]\n.*?(?=^\[)|^centrifugal_growth = [^\n]*\n"  # parts of a scene


def bearing_of(scene):
    """Rollers, radius of the inner race [mm] and load [N] of a scene file."""
    b, r = scene["bearing"], scene["roller"]
    play = 1e-3 * b["internal_clearance_um"]
    left = b["outer_raceway_diameter_mm"] - b["inner_raceway_diameter_mm"] - 2 * r["diameter_mm"]
    rollers = RollerSet(b["roller_count"], r["diameter_mm"], r["length_mm"], left + play,
                        r.get("profile", "none") == "logarithmic")
    return rollers, b["inner_raceway_diameter_mm"] / 2 - play / 4, float(scene["load"]["radial_N"])


def as_made(path, folder):
    """The scene with the dimensions that it gives: parts that grow change its clearance."""
    copy = folder / path.name
    copy.write_text(re.sub(GROWTH, "", path.read_text(encoding="utf-8")), encoding="utf-8")
    return copy


def errors_of(program, path):
    """Of loads over the largest, displacement and pressure, worst of three places; and why a run failed."""
    scene = tomllib.loads(path.read_text(encoding="utf-8"))
    rollers, race, load = bearing_of(scene)
    worst = [0.0, 0.0, 0.0]
    for tilt, turned in ((0.0, 0.0), (0.0, 180 / rollers.count), (0.3, 0.0)):
        run = program.run(path, STATICS | ALONE | {
            "bearing.misalignment_z_mrad": tilt, "start.cage_phase_deg": DOWN + turned},
            ("inner_force", "ring_displacement"))
        if not run.ok:
            return None, run.reason
        due = distribution(replace(rollers, misalignment=1e-3 * tilt), load, turned * pi / 180)
        radius = rollers.diameter / 2 * race / (rollers.diameter / 2 + race)
        pressure = hertz_pressure(due.largest_line_load(rollers.length), radius, effective_modulus(YOUNG, POISSON))
        loads = max(abs(a - b) for a, b in zip(run.history["inner_force"], due.loads)) / max(due.loads)
        found = (loads, abs(1e-3 * run.history["ring_displacement"] / due.displacement - 1),
                 abs(run["race_pressure_peak_MPa"] / pressure - 1))
        worst = [float("inf") if isnan(b) else max(a, b) for a, b in zip(worst, found)]
    return worst, ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--cache", default=ROOT / "build/shipped-statics")
    parser.add_argument("--json", help="file for the results (tests/validation/results/statics.json)")
    arguments = parser.parse_args()
    program = Program(arguments.program, arguments.cache)
    failures, rows = 0, []
    print(f"{'scene':<28}{'rollers, %':>12}{'displacement, %':>18}{'pressure, %':>14}")
    for path in sorted((ROOT / "inputs/scenes").glob("*.toml")):
        worst, why = errors_of(program, as_made(path, program.cache))
        wrong = worst is None or max(worst) > BAR
        failures += wrong
        rows.append((path.stem, worst))
        cells = why if worst is None else f"{1e2 * worst[0]:>12.3f}{1e2 * worst[1]:>18.3f}{1e2 * worst[2]:>14.3f}"
        print(f"{path.stem:<28}{cells}{'  failed' if wrong else ''}")
    if arguments.json:
        write_results(arguments.json, stamp(program), bar=BAR, scenes=rows)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
