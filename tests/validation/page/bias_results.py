"""Biases that regression/nightly_bias.sh found, as results for accuracy_page.py:

    python3 tests/validation/page/bias_results.py build/bias/BUILD-SAMPLES-SEED/bias.json --program build/cagetol
"""

import argparse
import json
from pathlib import Path

from program import Program
from report import ROOT
from results import RESULTS, stamp, write_results

JUDGED = ("cage_stress_rms_MPa", "cage_stress_peak_MPa", "driving_slip_ratio", "friction_torque_Nmm", "pocket_force_rms_N")


def row_of(found):
    """Quantity, pairs, bias and its standard error in % of the mean, and in standard errors of a 1000-sample study."""
    percent = 100 / abs(found["mean"])
    return (found["quantity"], found["pairs"], found["bias"] * percent, found["standard_error"] * percent,
            found["bias"] / found["allowed"], found["standard_error"] / found["allowed"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("found", help="bias.json of nightly_bias.sh")
    parser.add_argument("--program", default=str(ROOT / "build/cagetol"), help="executable that was judged")
    parser.add_argument("--json", default=RESULTS / "bias.json", help="file for the results")
    options = parser.parse_args()
    found = {row["quantity"]: row for row in json.loads(Path(options.found).read_text(encoding="utf-8"))["biases"]}
    made = stamp(Program(options.program, Path(options.program).resolve().parent / "bias"))
    write_results(options.json, made, biases=[row_of(found[name]) for name in JUDGED])


if __name__ == "__main__":
    main()
