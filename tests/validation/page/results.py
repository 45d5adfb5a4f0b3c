"""Results that page commands leave: small JSON files, stamped with commit, date and machine, from which
accuracy_page.py writes tests/ACCURACY.md anywhere."""

import json
import math
import platform
from datetime import date
from pathlib import Path

RESULTS = Path(__file__).resolve().parents[1] / "results"


def processor():
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def stamp(program):
    """Commit of the program, today, and this machine."""
    return {"commit": program.commit(), "date": date.today().isoformat(), "machine": processor()}


def rounded(value):
    """Numbers to six digits, none for what is not finite: JSON knows no NaN."""
    if isinstance(value, float):
        return float(f"{value:.6g}") if math.isfinite(value) else None
    if isinstance(value, (list, tuple)):
        return [rounded(each) for each in value]
    return {key: rounded(each) for key, each in value.items()} if isinstance(value, dict) else value


def lines_of(value, indent):
    """JSON with each row of a table on a line of its own."""
    inner = " " * (indent + 1)
    if isinstance(value, dict) and value:
        parts = [f"{json.dumps(key)}: {lines_of(each, indent + 1)}" for key, each in value.items()]
        return "{\n" + ",\n".join(inner + part for part in parts) + "\n" + " " * indent + "}"
    if isinstance(value, list) and any(isinstance(each, (list, dict)) for each in value):
        return "[\n" + ",\n".join(inner + lines_of(each, indent + 1) if isinstance(each, dict) else
                                  inner + json.dumps(each, ensure_ascii=False) for each in value) + "\n" + " " * indent + "]"
    return json.dumps(value, ensure_ascii=False)


def write_results(path, of, **content):
    """Writes results with the stamp `of` a run."""
    Path(path).write_text(lines_of(rounded({"stamp": of} | content), 0) + "\n", encoding="utf-8")


def stored(name):
    """Content of a file of results."""
    return json.loads((RESULTS / f"{name}.json").read_text(encoding="utf-8"))
