"""Scenes that `cagetol scene` writes, run: bearings drawn from the table with a fixed seed, flexible cage, 0.1 C, half
the limiting speed, an oil of 20 mm2/s. Each run must be "ok" and its torque within a factor of 1.8 of the nearer of
SKF's and Palmgren's models. Cages of every make and guidance, of a small and a large bearing, must be "ok" too. Ends
with 1 otherwise:

    python3 tests/validation/page/catalogue_runs.py --program build/cagetol

Runs are kept in build/catalogue-runs by scene, settings and program. --json FILE writes what accuracy_page.py reads.
"""

import argparse
import os
import random
import subprocess
import sys
import tomllib
from pathlib import Path

from program import Program
from results import stamp, write_results
from torque_models import SERIES, palmgren_torque, ratio_to_nearer, skf_torque

ROOT = Path(__file__).resolve().parents[3]
SEED = 42
VISCOSITY = 20         # kinematic, at the temperature of the oil [mm2/s]
DENSITY = 839          # of the scene's oil at that temperature [kg/m3]
BAR = 1.8
SETTINGS = {"lubrication.viscosity_Pa_s": 1e-6 * VISCOSITY * DENSITY,
            "temperature.balance": False, "window.settle_revolutions": 1.0, "window.measure_revolutions": 2.0}
MAKES = ("steel-sheet", "steel-machined", "brass-machined", "polyamide", "peek-machined")
SIZES = ("NU 202 ECP", "NU 1030 ML")
QUICK = {"cage.model": "rigid", "window.settle_revolutions": 0.5, "window.measure_revolutions": 1.0}


def output_of(program, *arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join([str(program), *arguments])}\nended with code {done.returncode}:\n{done.stderr}")
    return done.stdout


def with_raceways(program):
    """Designations of all bearings with E and F."""
    names = []
    for line in output_of(program, "scene", "--list").splitlines()[1:]:
        if line[13:].split()[4] != "-":
            names.append(line[:13].strip())
    return names


def series_of(designation):
    """"22" of "NU 2208 ECP": the number without its last two digits."""
    return designation.split()[1][:-2]


def run_of(program, settings, name, *options):
    """Run of a bearing's scene, and the scene."""
    path = program.cache / f"scene-{os.getpid()}.toml"
    path.write_text(output_of(program.path, "scene", name, *options), encoding="utf-8")
    run = program.run(path, settings)
    scene = tomllib.loads(path.read_text(encoding="utf-8"))
    path.unlink()
    return run, scene


def row_of(program, name, settings):
    """Designation, run, (SKF, Palmgren) [N mm], torque over the nearer."""
    run, scene = run_of(program, settings, name)
    which = (SERIES[series_of(name)], scene["bearing"]["bore_diameter_mm"], scene["bearing"]["outside_diameter_mm"],
             scene["load"]["radial_N"], scene["speed"]["inner_rpm"], VISCOSITY)
    models = (skf_torque(*which), palmgren_torque(*which))
    return name, run, models, ratio_to_nearer(run["friction_torque_Nmm"], *models)


def makes_of(program, settings):
    """A row for each make and guidance that fits: bearing, make, guidance, status, peak stress [MPa]."""
    rows = []
    for name in SIZES:
        for make in MAKES:
            for guidance in ("outer", "inner", "roller"):
                if (make, guidance) == ("steel-sheet", "roller"):
                    continue  # refused
                run, _ = run_of(program, settings, name, "--cage", make, "--guidance", guidance)
                rows.append((name, make, guidance, run.status, run["cage_stress_peak_MPa"]))
                print(f"{name:<14} {run.status:<7} {run['friction_torque_Nmm']:8.0f} "
                      f"{run['cage_stress_peak_MPa']:8.1f} MPa  {make}, {guidance}  {run.reason}", flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/cagetol"), help="executable (build/cagetol)")
    parser.add_argument("--cache", help="directory of kept runs (catalogue-runs beside the program)")
    parser.add_argument("--quick", action="store_true", help="two bearings, rigid cages, one revolution")
    parser.add_argument("--json", help="file for the results (tests/validation/results/catalogue.json)")
    options = parser.parse_args()
    beside = Path(options.program).resolve().parent / "catalogue-runs"
    program = Program(options.program, options.cache or beside)
    names = random.Random(SEED).sample(with_raceways(program.path), 2 if options.quick else 20)
    settings = SETTINGS | (QUICK if options.quick else {})
    failures, rows = 0, []
    print(f"{'bearing':<14} {'run':<7} {'torque':>8} {'SKF':>8} {'Palmgren':>8} {'ratio':>6} {'slip':>7}  [N mm]")
    for name in names:
        _, run, models, ratio = row_of(program, name, settings)
        kept = run.ok and 1 / BAR <= ratio <= BAR
        failures += not kept
        rows.append((name, run.status, run["friction_torque_Nmm"], *models, ratio, run["cage_slip_ratio"]))
        print(f"{name:<14} {run.status:<7} {run['friction_torque_Nmm']:8.0f} {models[0]:8.0f} {models[1]:8.0f} "
              f"{ratio:6.2f} {run['cage_slip_ratio']:7.4f}  {'' if kept else 'MISSED ' + run.reason}", flush=True)
    print(f"{len(names) - failures} of {len(names)} within a factor of {BAR}")
    makes = [] if options.quick else makes_of(program, settings)
    failures += sum(status != "ok" for _, _, _, status, _ in makes)
    if options.json:
        write_results(options.json, stamp(program), bar=BAR, bearings=rows, makes=makes)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
