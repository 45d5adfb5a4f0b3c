"""Holds inputs/QUANTITIES.md to what the program says of its quantities: quantities_page.py SOURCE_DIR PROGRAM [--write]."""

import json
import pathlib
import subprocess
import sys

HEAD = """# Quantities of interest

What a run yields, a limit may name and a report shows. Written by the program; `cagetol quantities NAME` prints the same.
A run that lacks what a quantity needs has no value of it. Peaks, minima and quantiles are taken over
`window.peak_revolutions`, all else over the whole window.

| quantity | unit | definition | needs | over | use |
|---|---|---|---|---|---|
"""


def cell(text):
    return str(text).replace("|", "\\|")


source, program = pathlib.Path(sys.argv[1]), sys.argv[2]
quantities = json.loads(subprocess.run([program, "quantities", "--json"], check=True, capture_output=True, text=True).stdout)
columns = ("unit", "definition", "needs", "over", "use")
text = HEAD + "".join(
    f"| `{q['name']}` | " + " | ".join(cell(q[column]) for column in columns) + " |\n" for q in quantities)
page = source / "inputs/QUANTITIES.md"
if "--write" in sys.argv[3:]:
    page.write_text(text, encoding="utf-8")
elif page.read_text(encoding="utf-8") != text:
    sys.exit("inputs/QUANTITIES.md differs from what the program says of its quantities; remedy:\n"
             f"  python3 tests/regression/quantities_page.py . {program} --write")
