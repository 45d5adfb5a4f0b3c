"""What the rungs of the model ladder are worth on other shipped bearings: results for accuracy_page.py
(tests/validation/results/rungs.json).

    python3 tests/validation/page/rung_results.py --program build/cagetol

Every rung of every bearing runs from eight starts, half a turn of the cage to settle and one measured: some minutes of two
cores. Runs are kept in build/rung-results by program, scene and settings.
"""

import argparse
import json
from pathlib import Path

from program import Program
from report import ROOT, number
from results import RESULTS, stamp, write_results

SCENES = ("nu208-brass", "bore10-small", "nu2322-gearbox", "n1014-spindle", "aero118-outer")
WINDOW = {"window.settle_revolutions": 0.5, "window.measure_revolutions": 1.0}
WITHIN = 0.05  # of the mean
QUANTITIES = {"displacement": "ring_displacement_mean_um", "torque": "friction_torque_Nmm", "slip": "driving_slip_ratio",
              "pocket force, rms": "pocket_force_rms_N", "stress, rms": "cage_stress_rms_MPa"}
SHIFTS = {"rigid-5: pocket force": ("pocket_force_rms_N", ("rigid-5",)),
          "flexible-6, bars: stress": ("cage_stress_rms_MPa", ("flexible-6", "bars"))}


def quantity_of(ladder, name):
    """The entry of a quantity; None where the scene does not define it."""
    return next((entry for entry in ladder["quantities"] if entry["quantity"] == name), None)


def minimum_rung(ladder, name):
    """Name and cost of the lowest rung from which on all are within 5 % of the highest; "-" where the scene has no such
    quantity."""
    quantity = quantity_of(ladder, name)
    if quantity is None or not quantity["mean"]:
        return "-"
    shifts = {rung["rung"]: rung["shift"] for rung in quantity["rungs"]}
    least = None
    for rung in reversed(ladder["rungs"]):
        shift = 0 if rung["name"] == ladder["reference"] else shifts.get(rung["name"])
        if shift is None or abs(shift) > WITHIN * abs(quantity["mean"]):
            break
        least = rung
    return f"{least['name']} ({number(least['cost_ratio'], 2)})"


def shifts_of(ladder, name, rungs):
    """Shifts against the highest rung in per cent of its mean, with half their 95 % intervals."""
    quantity = quantity_of(ladder, name)
    found = [] if quantity is None else [rung for wanted in rungs for rung in quantity["rungs"]
                                         if rung["rung"] == wanted and rung["shift"] is not None]
    scale = 100 / abs(quantity["mean"]) if found else 0
    return ", ".join(f"{scale * rung['shift']:+.0f} ± {scale * (rung['upper'] - rung['lower']) / 2:.0f}" for rung in found) or "-"


def row_of(scene, ladder):
    return [scene, *(minimum_rung(ladder, name) for name in QUANTITIES.values()),
            *(shifts_of(ladder, *shift) for shift in SHIFTS.values())]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/cagetol"), help="executable (build/cagetol)")
    parser.add_argument("--json", default=RESULTS / "rungs.json", help="file for the results")
    options = parser.parse_args()
    program = Program(options.program, Path(options.program).resolve().parent / "rung-results")
    rows = []
    for scene in SCENES:
        place = program.directory("ladder", ROOT / f"inputs/scenes/{scene}.toml", "ladder.json", ["--samples", "8"], WINDOW)
        rows.append(row_of(scene, json.loads((place / "ladder.json").read_text(encoding="utf-8"))))
    table = {"head": ["scene", *QUANTITIES, *SHIFTS], "rows": rows}
    write_results(options.json, stamp(program), tables={"rungs": table})


if __name__ == "__main__":
    main()
