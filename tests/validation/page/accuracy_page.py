"""Writes tests/ACCURACY.md from the results that page commands leave in tests/validation/results:

    python3 tests/validation/page/accuracy_page.py [--program build/cagetol]

Without --program from the stored results, on any machine within a second. With it the commands below run first (an hour
or two; kept runs are not run again) and store theirs. --check compares with the page that is there, counts its words and
looks for the tests that it names; it ends with 1 where one of them is wrong.

The words are in accuracy_text.md.in, where {{name}} stands for a table or a number; the cases are in cases.toml.
"""

import argparse
import math
import re
import subprocess
import sys
import tomllib
from pathlib import Path

from results import RESULTS, stored

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PAGE = ROOT / "tests/ACCURACY.md"
WORDS = 1500     # beside tables
COLUMNS = 120    # beside tables
MEASURED = {"statics": "shipped_statics", "catalogue": "catalogue_runs", "validation": "validation_page",
            "budget": "budget_results", "rungs": "rung_results", "cost": "cost_page"}
MADE_BY = {name: f"`page/{script}.py`" for name, script in MEASURED.items()} | {
    "bias": "`regression/nightly_bias.sh`, `page/bias_results.py`"}


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def signed(value, error):
    """Value ± error with as many places as the error's first digit has."""
    places = 3 if error < 0.05 else 2 if error < 0.5 else 1
    return f"{value:+.{places}f} ± {error:.{places}f}"


def stamps(results):
    keys = ("commit", "date", "machine", "note")
    return table(["results", "written by", *keys],
                 [(f"`{name}.json`", MADE_BY[name], *(content["stamp"].get(key, "") for key in keys))
                  for name, content in results.items()])


def verification(results, cases):
    worst = [max(values) for values in zip(*(errors for _, errors in results["statics"]["scenes"]))]
    found = ", ".join(f"{100 * value:.2f} %" for value in worst)
    bar = f"{100 * results['statics']['bar']:g} %"
    count = len(results["statics"]["scenes"])
    rows = [*cases["verification"], [f"{count} shipped bearings at rest: roller loads, displacement, pressure",
                                     "ISO/TS 16281, 41 laminae", f"{found} at worst", bar, "validation.shipped.statics"]]
    return table(["case", "reference", "error", "bar", "test"], rows)


def validation(results, cases):
    catalogue = results["catalogue"]
    ratios = [row[5] for row in catalogue["bearings"]]
    bar = f"{1 / catalogue['bar']:.2f} to {catalogue['bar']:g}"
    rows = [[f"Torque of {len(ratios)} catalogue bearings", "nearer of SKF and Palmgren",
             f"{min(ratios):.2f} to {max(ratios):.2f}", bar, "validation.nightly.catalogue"], *cases["validation"]]
    return table(["case", "reference", "ratio or error", "bar", "test"], rows)


def bars(results):
    return table(["what", "asked", "found", "bar"], results["validation"]["bars"])


def met(results):
    verdicts = [row[3] for row in results["validation"]["bars"]]
    return f"{verdicts.count('met')} of {len(verdicts)}"


def catalogue(results):
    rows = [(name, status, f"{torque:.0f}", f"{skf:.0f}", f"{palmgren:.0f}", f"{ratio:.2f}", f"{100 * slip:.1f}")
            for name, status, torque, skf, palmgren, ratio, slip in results["catalogue"]["bearings"]]
    return table(["bearing", "run", "torque, N mm", "SKF", "Palmgren", "ratio", "slip, %"], rows)


def makes(results):
    """How many runs of every make and guidance are "ok"."""
    rows = results["catalogue"]["makes"]
    return f"{sum(row[3] == 'ok' for row in rows)} of {len(rows)}"


def bias(results):
    rows = [(f"`{name}`", signed(percent, error), signed(times, times_error))
            for name, _, percent, error, times, times_error in results["bias"]["biases"]]
    return table(["mean", "bias, %", "in standard errors of a 1000-sample study"], rows)


def part(results, which, title):
    content = results[which]["tables"][title]
    return table(content["head"], content["rows"])


def methods(results):
    """The default and the front at 1 kN, without explicit methods."""
    rows = []
    for cage in ("Rigid", "Flexible"):
        content = results["cost"]["tables"][f"{cage} cage"]
        for load, setting, time, _, error in content["rows"]:
            if load == "1000" and "arkode" not in setting:
                rows.append((cage.lower(), setting, time, error))
    return table(["cage", "setting", "wall time / simulated time", "error"], rows)


def exponent(points):
    """Slope of log time over log size by least squares; a size of 0 is left out."""
    logs = [(math.log(x), math.log(y)) for x, y in points if x > 0]
    mean_x, mean_y = (sum(column) / len(logs) for column in zip(*logs))
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs)


def growing(results):
    """Time over each axis of the cost page: its ends, and the exponents of all points and of the last two."""
    rows = []
    for title, content in results["cost"]["tables"].items():
        if content["head"][0] == title:  # a table of one number that grows
            points = [(float(row[0]), float(row[1])) for row in content["rows"]]
            (first, least), (last, most) = points[0], points[-1]
            rows.append((title, f"{first:g} to {last:g}", f"{least:g} to {most:g}", f"{exponent(points):.2f}",
                         f"{exponent(points[-2:]):.2f}"))
    return table(["one number changed", "from, to", "wall time / simulated time", "exponent", "of the last two"], rows)


def written():
    results = {name: stored(name) for name in MADE_BY}
    cases = tomllib.loads((HERE / "cases.toml").read_text(encoding="utf-8"))
    values = {"stamps": stamps(results), "verification": verification(results, cases),
              "validation": validation(results, cases), "bars": bars(results), "met": met(results),
              "catalogue": catalogue(results), "makes": makes(results), "bias": bias(results), "methods": methods(results),
              "pairs": str(results["bias"]["biases"][0][1]),
              "budget": part(results, "budget", "budget"), "rungs": part(results, "rungs", "rungs"),
              "limited": part(results, "cost", "Error against cost: the quantities that the default study limits"),
              "growing": growing(results), "growth": part(results, "cost", "As the study grows")}
    text = (HERE / "accuracy_text.md.in").read_text(encoding="utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda found: values[found.group(1)], text)


def missing_tests():
    """Tests that cases.toml names and no file has."""
    cases = tomllib.loads((HERE / "cases.toml").read_text(encoding="utf-8"))
    ctest = (ROOT / "tests/CMakeLists.txt").read_text(encoding="utf-8")
    missing = []
    for name in sorted({row[4] for rows in cases.values() for row in rows}):
        place, _, suite = name.partition(", ")
        if suite:
            sources = (ROOT / "tests" / place.replace(".", "/")).glob("*_test.cpp")
            pattern = re.compile(rf"\bTEST(?:_[FP])?\({suite},")
            found = any(pattern.search(path.read_text(encoding="utf-8")) for path in sources)
        else:
            found = f"add_test(NAME {name} " in ctest
        if not found:
            missing.append(name)
    return missing


def faults(text, page):
    """What is wrong with the page, a line each."""
    lines = [line for line in text.splitlines() if not line.startswith("|")]
    words = sum(len(line.split()) for line in lines)
    found = [] if words <= WORDS else [f"{words} words beside tables, more than {WORDS}: shorten accuracy_text.md.in"]
    found += [f"line of {len(line)} columns: {line[:60]}..." for line in lines if len(line) > COLUMNS]
    found += [f"cases.toml names a test that is not there: {name}" for name in missing_tests()]
    if not page.exists() or page.read_text(encoding="utf-8") != text:
        found.append(f"{page} is not what accuracy_page.py writes: run it, and edit accuracy_text.md.in or cases.toml instead")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", help="measure anew with this executable")
    parser.add_argument("--check", action="store_true", help="compare with the page that is there, write nothing")
    parser.add_argument("--page", default=PAGE, type=Path, help="the page (tests/ACCURACY.md)")
    options = parser.parse_args()
    for name, script in MEASURED.items() if options.program else ():
        command = [sys.executable, "-B", HERE / f"{script}.py", "--program", options.program,
                   "--json", RESULTS / f"{name}.json"]
        if subprocess.run(command).returncode not in (0, 1):  # 1: a bar is missed, and stored as such
            sys.exit(f"{script}.py failed")
    text = written()
    if not options.check:
        options.page.write_text(text, encoding="utf-8")
    wrong = faults(text, options.page)
    print("\n".join(wrong) if wrong else f"{options.page} is as written from the stored results")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
