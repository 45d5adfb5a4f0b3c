"""The error budget of nu205-rated.toml: results for accuracy_page.py (tests/validation/results/budget.json).

    python3 tests/validation/page/budget_results.py --program build/cagetol

Sweeps the default study, runs its first 24 samples refined in one thing at a time (`cagetol ladder --refine`) and takes the
budget from the report: a quarter of an hour of two cores. The sweep is kept in build/budget-results by program and study.
"""

import argparse
import json
from pathlib import Path

from program import Program
from report import ROOT
from results import RESULTS, stamp, write_results

STUDY, SCENE = ROOT / "inputs/studies/nu205-rated.toml", ROOT / "inputs/scenes/nu205.toml"
SHOWN = ("cage_fatigue_utilisation", "cage_stress_peak_MPa", "driving_slip_ratio", "whirl_scatter_ratio", "friction_torque_Nmm",
         "pocket_force_rms_N", "pocket_force_peak_N", "guide_force_rms_N", "roller_load_peak_N", "race_pressure_peak_MPa",
         "ring_displacement_mean_um")
SOURCES = ("statistical", "noise", "integrator", "modes", "slices", "mesh", "window")


def budget_of(program):
    """error_budget of the study's report.json, measured by the refining ladder."""
    place = program.directory("sweep", STUDY, "study.h5", reads=[SCENE])
    ladder = place / "ladder-refine"
    if not (ladder / "ladder.json").exists():
        program.execute(["ladder", place / "study.toml", "--refine", "-o", ladder])
    program.execute(["report", place])
    return json.loads((place / "report.json").read_text(encoding="utf-8"))["error_budget"]


def cell(source, mean):
    """An error as run minus refined in per cent of the mean, as the page shows it; noise as its share of the variance."""
    if source["source"] == "noise":
        return f"{100 * source['standard_errors'] ** 2:.0f}"
    scale = 100 / abs(mean)
    if source["source"] == "statistical":
        return f"±{scale * source['bound']:.2g}"
    if source["state"] != "resolved":
        return f"below {scale * source['bound']:.2g}"
    error = source["error"]
    return f"{scale * error['value']:+.2g} ± {scale * (error['upper'] - error['lower']) / 2:.1g}"


def rows_of(budget):
    found = {quantity["quantity"]: quantity for quantity in budget["quantities"]}
    rows = []
    for name in SHOWN:
        mean = found[name]["mean"]
        sources = {source["source"]: source for source in found[name]["sources"]}
        rows.append([f"`{name}`: {mean:.4g}", *(cell(sources[source], mean) for source in SOURCES)])
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/cagetol"), help="executable (build/cagetol)")
    parser.add_argument("--json", default=RESULTS / "budget.json", help="file for the results")
    options = parser.parse_args()
    program = Program(options.program, Path(options.program).resolve().parent / "budget-results")
    head = ["quantity, mean", *("statistical, %" if source == "statistical" else source for source in SOURCES)]
    write_results(options.json, stamp(program), tables={"budget": {"head": head, "rows": rows_of(budget_of(program))}})


if __name__ == "__main__":
    main()
