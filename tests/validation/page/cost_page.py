"""Error against cost of methods, tolerances and models, and what simulating costs as bearing, model and study grow: results
for accuracy_page.py (tests/validation/results/cost.json), figures (tests/figures) and a page with every table,
build/cost-page/COST.md.

    python3 tests/validation/page/cost_page.py --program build/cagetol

Needs Debian's python3-matplotlib and Debian's interpreter (/usr/bin/python3) where another comes first on the PATH,
and a quiet machine: times are wall times of one core. Runs are kept in build/cost-page by scene, settings and program,
so an interrupted page goes on where it stopped. --quick runs few points and writes to build/cost-page/quick: a test that
the command works, no result.
"""

import argparse
import hashlib
import json
import math
import os
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from chart_section import limited_chapter, method_chapter, rung_chapter
from program import MPI, Program
from report import ROOT, WIDTH, Page, logarithmic, number, pyplot, table, ticks_within
from results import RESULTS, stamp, write_results

NU205 = ROOT / "inputs/scenes/nu205.toml"
STUDY = ROOT / "inputs/studies/nu205-displacement.toml"
DYNAMIC_STUDY = ROOT / "inputs/studies/nu205-rated.toml"
REPEATS = 3  # starts of each point, of which the fastest counts: what else runs on the machine only adds
WINDOW = {"window.peak_revolutions": "auto", "window.settle_revolutions": 1,
          "window.measure_revolutions": 2, "window.longest_settle_revolutions": 0, "watch.cage_drift_max": 1e9,
          "watch.power_surplus_max": 1e9, "watch.static_consistency_max": 1e9}
SHORT = {"window.settle_revolutions": 0.1, "window.measure_revolutions": 0.1, "cage.corner_radius_mm": 0}
# Lightly loaded bearings still drift, one slice rights no roller: only the cost is asked for.


@dataclass(frozen=True)
class Axis:
    """One number that grows: its points and the settings of each."""
    name: str
    title: str
    points: tuple
    settings: callable
    note: str = ""


def roller_settings(count):
    """Rollers of the NU 205 at their pitch, on a circle that grows with their number; load and sliding of each stay."""
    pitch = 39.0 * count / 13  # mm
    grown = pitch - 39.0
    return {"bearing.roller_count": count, "bearing.bore_diameter_mm": 25 + grown if grown > -15 else 6.0,
            "bearing.outside_diameter_mm": 52 + grown, "bearing.inner_raceway_diameter_mm": 31.5 + grown,
            "bearing.outer_raceway_diameter_mm": 46.5 + grown, "bearing.shoulder_diameter_mm": 43.8 + grown,
            "cage.inner_diameter_mm": 37.0 + grown, "cage.outer_diameter_mm": 43.4 + grown,
            "load.radial_N": 1000.0 * count / 13, "speed.inner_rpm": 6000 * 31.5 / (31.5 + grown)}


def mode_settings(modes):
    return {"cage.model": "flexible", "cage.modes": modes} if modes else {"cage.model": "rigid"}


def axes(quick):
    few = (lambda points: (points[0], points[-1])) if quick else tuple
    return [
        Axis("Z", "rollers Z", few((8, 10, 13, 16, 20, 26, 32, 40)), roller_settings,
             "Rollers are computed eight at a time (four without AVX-512): the cost rises in steps."),
        Axis("slices", "slices of a race contact", few((3, 5, 7, 11, 15, 21)),
             lambda n: {"discretisation.race_slices": n}, "One slice would right no roller that leans."),
        Axis("modes", "modes of the cage, 0: rigid", few((0, 6, 12, 20, 28, 36)), mode_settings,
             "The exponent leaves the rigid cage out."),
        Axis("speed", "speed, r/min", few((1000, 2000, 4000, 6000, 9000, 12000)), lambda n: {"speed.inner_rpm": n},
             "Per simulated second. Per revolution of the cage the exponent is less by one."),
        Axis("load", "load, N", few((100, 300, 1000, 3000, 10000)), lambda n: {"load.radial_N": n}),
    ]


def exponent(points):
    """Slope of log cost over log size by least squares, and between the last two points."""
    shown = [(math.log(x), math.log(y)) for x, y in points if x > 0 and y > 0]
    if len(shown) < 2:
        return math.nan, math.nan
    mean_x, mean_y = (sum(column) / len(shown) for column in zip(*shown))
    slope = sum((x - mean_x) * (y - mean_y) for x, y in shown) / sum((x - mean_x) ** 2 for x, _ in shown)
    (x0, y0), (x1, y1) = shown[-2:]
    return slope, (y1 - y0) / (x1 - x0)


def cost_of_point(page, program, axis, size, quick):
    """Of the fastest of some starts: wall time per simulated second, steps per second, time of a step [us]."""
    best = None
    for start in range(1 if quick else REPEATS):
        settings = WINDOW | (SHORT if quick else {}) | {"start.cage_phase_deg": 7.0 * start} | axis.settings(size)
        run = program.run(NU205, settings)
        if page.note_failure(f"{axis.title} = {size:g}", run):
            continue
        cost = run.run["wall_s"] / run.run["simulated_s"]
        if best is None or cost < best[0]:
            best = (cost, run.run["steps"] / run.run["simulated_s"], 1e6 * run.run["wall_s"] / run.run["steps"])
    return best or (math.nan, math.nan, math.nan)


def bearing_chapter(page, program, quick):
    """Tables of all axes; the points for the figure."""
    page.heading("As the bearing grows: a simulated second")
    page.add("`inputs/scenes/nu205.toml` with one number changed, its default method and tolerance, three cage",
             f"revolutions; the fastest of {1 if quick else REPEATS} starts. Z grows with the pitch circle: load and",
             "sliding speed of a roller stay, so a larger bearing turns more slowly.", "")
    drawn = []
    for axis in axes(quick):
        rows, points, step_times = [], [], []
        for size in axis.points:
            cost, steps, each = cost_of_point(page, program, axis, size, quick)
            rows.append([f"{size:g}", number(cost), number(steps / 1000), number(each)])
            points.append((size, cost))
            step_times.append((size, each))
        slope, last = exponent(points)
        page.add(f"### {axis.title}", "")
        page.table([axis.title, "wall time / simulated time", "thousand steps a simulated second", "us a step"], rows)
        page.add(f"Exponent {number(slope, 2)} by least squares, {number(last, 2)} between the last two points; of the",
                 f"time of a step {number(exponent(step_times)[0], 2)}. {axis.note}".rstrip(), "")
        drawn.append((axis.title, points, slope))
    return drawn


class Studies:
    """Sweeps that are timed once and kept."""

    def __init__(self, program, cache):
        self.program, self.cache = program, Path(cache)

    def seconds(self, study, samples, settings):
        """Wall time of a sweep by one process without that of cage tables, which are made once, and of the report on it [s]."""
        key = json.dumps([self.program.build, Path(study).name, samples, sorted(settings.items())])
        place = self.cache / ("sweep-" + hashlib.sha256(key.encode()).hexdigest()[:24])
        kept = place.with_suffix(".json")
        if kept.exists():
            return json.loads(kept.read_text(encoding="utf-8"))
        shutil.rmtree(place, ignore_errors=True)  # of a sweep that was interrupted nobody knows the time
        command = [str(self.program.path), "sweep", str(study), "-o", str(place), "--set", f"samples={samples}"]
        for name, value in settings.items():
            command += ["--set", f"{name}={value}"]
        sweep, said = self._time(command)
        own = re.search(r"([0-9.]+) s on 1 ranks", said)
        times = [float(own[1]) if own else sweep, self._time([str(self.program.path), "report", str(place)])[0]]
        shutil.rmtree(place)
        kept.write_text(json.dumps(times), encoding="utf-8")
        return times

    @staticmethod
    def _time(command):
        began = time.monotonic()
        done = subprocess.run(command, env=os.environ | MPI, capture_output=True, text=True)
        if done.returncode not in (0, 3):
            sys.exit(f"{' '.join(command)}\nended with code {done.returncode}:\n{done.stderr}")
        return time.monotonic() - began, done.stderr


def study_chapter(page, studies, quick):
    sizes = (20, 40) if quick else (100, 1000, 10000, 100000)
    measured = (4, 8) if quick else (30, 100, 300)
    moving = {f"scene.{key}": value for key, value in SHORT.items()} if quick else {}
    still = {"scene.model.motion": "'quasi-static'", "extra_replicates": 0}
    page.heading("As the study grows")
    page.add("One process. Quasi-static: `inputs/studies/nu205-displacement.toml` with",
             "`scene.model.motion = \"quasi-static\"`, every size run. Dynamic: `inputs/studies/nu205-rated.toml`,",
             f"{', '.join(map(str, measured))} samples run, cage tables apart; larger ones are **extrapolated** by the line through the",
             "first and the last of these, not run.", "")
    rows, drawn, reports = [], [], []
    for samples in sizes:
        sweep, report = studies.seconds(STUDY, samples, still)
        each = number(1000 * sweep / samples)
        rows.append(["quasi-static", f"{samples}", number(sweep), each, number(report), "run"])
        drawn.append((samples, sweep))
        reports.append((samples, report))
    dynamic = []
    for samples in measured:
        sweep, report = studies.seconds(DYNAMIC_STUDY, samples, {"extra_replicates": 0} | moving)
        rows.append(["dynamic", f"{samples}", number(sweep), number(1000 * sweep / samples), number(report), "run"])
        dynamic.append((samples, sweep))
    (n0, t0), (n1, t1) = dynamic[0], dynamic[-1]
    each = (t1 - t0) / (n1 - n0)
    for samples in (size for size in sizes if size > n1):
        sweep = t1 + each * (samples - n1)
        rows.append(["dynamic", f"{samples}", number(sweep), number(1000 * sweep / samples), "-", "extrapolated"])
    page.table(["model", "samples", "sweep, s", "ms a sample", "report, s", ""], rows)
    (sweep_slope, sweep_last), (report_slope, report_last) = exponent(drawn), exponent(reports)
    page.add(f"Exponents over samples, quasi-static: sweep {number(sweep_slope, 2)} ({number(sweep_last, 2)} between",
             f"the last two), report {number(report_slope, 2)} ({number(report_last, 2)}); dynamic: sweep",
             f"{number(exponent(dynamic)[0], 2)}.", "")
    return [("samples, quasi-static", drawn, sweep_slope), ("samples, dynamic", dynamic, exponent(dynamic)[0])]


def draw(page, panels):
    columns = 2
    rows = math.ceil(len(panels) / columns)
    figure, grid = pyplot.subplots(rows, columns, figsize=(WIDTH, 2.2 * rows), squeeze=False)
    for axis in grid.flat[len(panels):]:
        axis.set_visible(False)
    for axis, (title, points, slope) in zip(grid.flat, panels):
        shown = [(x, y) for x, y in points if x > 0 and y > 0]
        axis.plot(*zip(*shown), marker="o", markersize=4, label=f"exponent {number(slope, 2)}")
        for _, rigid in (point for point in points if point[0] == 0):
            axis.axhline(rigid, linestyle=":", label="rigid")
            shown.append((shown[-1][0], rigid))
        logarithmic(axis, [x for x, _ in points if x > 0])
        logarithmic(axis, ticks_within(min(y for _, y in shown), max(y for _, y in shown)), "y")
        axis.set_xlabel(title)
        axis.legend(fontsize=7)
        axis.set_ylabel("sweep, s" if title.startswith("samples") else "wall / simulated time")
    page.figure("cost-growth", figure, "Cost over the size of bearing, model and study")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build/cagetol"), help="executable (build/cagetol)")
    parser.add_argument("--quick", action="store_true", help="few short points, no result")
    parser.add_argument("--cache", help="directory of kept runs (cost-page beside the program)")
    parser.add_argument("--json", help="file for the results (tests/validation/results/cost.json)")
    options = parser.parse_args()
    cache = Path(options.cache) if options.cache else Path(options.program).resolve().parent / "cost-page"
    program = Program(options.program, cache)
    out = cache / "quick" if options.quick else ROOT / "tests"
    page = Page(cache / ("quick" if options.quick else "") / "COST.md", out / "figures")
    method_chapter(page, program, options.quick)
    rung_chapter(page, program, options.quick)
    if not options.quick:  # a minute at least: tables of flexible cages
        limited_chapter(page, program)
    panels = bearing_chapter(page, program, options.quick)
    panels += study_chapter(page, Studies(program, cache), options.quick)
    draw(page, panels)
    made = stamp(program)
    results = out / "cost.json" if options.quick else RESULTS / "cost.json"
    write_results(options.json or results, made, **page.results())
    head = ["# What simulating costs, and what it buys", "",
            "Generated by `python3 tests/validation/page/cost_page.py --program build/cagetol`.",
            f"Program of commit {made['commit']}, {made['machine']}, {made['date']}."
            + (" **Quick run: no result.**" if options.quick else ""), "",
            "Runs that failed:" if page.failures else "No run failed.", ""]
    if page.failures:
        head += table(["what", "status", "reason"], page.failures)
    page.text.write_text("\n".join(head + page.lines).rstrip() + "\n", encoding="utf-8")
    print(page.text)


if __name__ == "__main__":
    main()
