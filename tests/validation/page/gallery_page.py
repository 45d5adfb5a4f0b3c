"""Writes inputs/GALLERY.md and its pictures: every shipped bearing with what a run of it gives.

    python3 tests/validation/page/gallery_page.py --program build/cagetol

Needs Debian's python3-matplotlib. Runs are kept in build/gallery by scene and program. --quick draws one bearing and
writes to build/gallery/quick: a test that the command works, no page.
"""

import argparse
import sys
import tomllib
from math import asin, cos, degrees, pi, sin
from pathlib import Path
from textwrap import wrap

from load_distribution import distribution
from program import Program
from report import ROOT, Page, number, percent, pyplot
from shipped_statics import bearing_of
from matplotlib import cm, colors, patches  # after report, which chooses the backend

SCENES = ROOT / "inputs/scenes"
SIZE = 2.6  # inch
STEEL, CAGE = "0.85", "tab:olive"
HIDDEN = ("nu205-jams", "nu205-paper-tight", "speed-z16", "speed-z16-skew")  # variants of nu205 and nu205-paper, and what speed is measured on


def ring(axis, inside, outside):
    axis.add_patch(patches.Annulus((0, 0), outside, outside - inside, facecolor=STEEL, edgecolor="0.3", lw=0.6))


def draw(scene):
    """Front view, rollers coloured by their static load, the load pointing down."""
    b, c = scene["bearing"], scene["cage"]
    rollers, _, load = bearing_of(scene)
    loads = distribution(rollers, load).loads
    count, radius = rollers.count, rollers.diameter / 2
    pitch = (b["inner_raceway_diameter_mm"] + b["outer_raceway_diameter_mm"]) / 4
    figure, axis = pyplot.subplots(figsize=(SIZE, SIZE), layout="none")
    figure.subplots_adjust(0, 0, 1, 1)
    ring(axis, b["bore_diameter_mm"] / 2, b["inner_raceway_diameter_mm"] / 2)
    ring(axis, b["outer_raceway_diameter_mm"] / 2, b["outside_diameter_mm"] / 2)
    shade = colors.Normalize(0, max(loads))
    angles = [-90 + 360 * j / count for j in range(count)]
    low, high = c["inner_diameter_mm"] / 2, c["outer_diameter_mm"] / 2
    half_pocket = degrees(asin(c["pocket_width_mm"] / 2 / pitch))
    for angle in angles:
        bar = patches.Wedge((0, 0), high, angle + half_pocket, angle + 360 / count - half_pocket, width=high - low)
        bar.set(facecolor=CAGE, edgecolor="none")
        axis.add_patch(bar)
    for angle, carried in zip(angles, loads):
        place = (pitch * cos(angle * pi / 180), pitch * sin(angle * pi / 180))
        axis.add_patch(patches.Circle(place, radius, facecolor=cm.Reds(shade(carried)), edgecolor="0.2", lw=0.6))
    edge = b["outside_diameter_mm"] / 2 * 1.03
    axis.set(xlim=(-edge, edge), ylim=(-edge, edge), aspect="equal")
    axis.axis("off")
    return figure


def title_of(path):
    """The first sentence of a scene file's comment."""
    comment = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        comment.append(line.lstrip("# "))
    return " ".join(comment).split(". ")[0].rstrip(".") + "."


def facts(scene):
    b, r = scene["bearing"], scene["roller"]
    cage = scene["cage"].get("material", "steel-q235")
    return (f"{b['bore_diameter_mm']:g} x {b['outside_diameter_mm']:g} x {b['width_mm']:g} mm, {b['roller_count']} "
            f"rollers of {r['diameter_mm']:g} x {r['length_mm']:g} mm, {cage}; "
            f"{scene['load']['radial_N']:g} N, inner ring {scene['speed']['inner_rpm']:g} r/min"
            + (f", outer ring {scene['speed']['outer_rpm']:g} r/min" if scene["speed"].get("outer_rpm") else ""))


def results(run):
    """Main results, one a line."""
    said = [f"friction torque **{number(run['friction_torque_Nmm'])} N mm**, {number(run['power_loss_W'])} W",
            f"slip of the rollers that drive {percent(run['driving_slip_ratio'])} %",
            f"largest race pressure {number(run['race_pressure_peak_MPa'])} MPa"]
    if run["lambda_min_ratio"] > 0:
        said.append(f"smallest film over roughness {number(run['lambda_min_ratio'])}")
    if run["guide_force_p99_N"] > 0:
        said.append(f"99 % of the time the cage leans on its guide with less than {number(run['guide_force_p99_N'])} N")
    if run["cage_fatigue_utilisation"] > 0:
        said.append(f"fatigue utilisation of the cage {number(run['cage_fatigue_utilisation'])}")
    return [f"- {line}" for line in said]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--cache", default=ROOT / "build/gallery")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    program = Program(arguments.program, arguments.cache)
    folder = program.cache / "quick" if arguments.quick else ROOT / "inputs"
    page = Page(folder / "GALLERY.md", folder / "gallery")
    page.add("# The bearings that are shipped", "",
             "Each picture shows a bearing from the front, to no common scale: its rollers the redder the more of the",
             "static load they carry at the clearance as made, which points down, and its cage's bars. Results are",
             "those of one run of the scene as it stands (`cagetol simulate inputs/scenes/NAME.toml`); what is assumed",
             "stands in each file. Written by tests/validation/page/gallery_page.py from commit "
             f"{program.commit()}.", "")
    for path in sorted(SCENES.glob("bore10-small.toml" if arguments.quick else "*.toml")):
        if path.stem in HIDDEN:
            continue
        scene = tomllib.loads(path.read_text(encoding="utf-8"))
        run = program.run(path, {"cage.model": "rigid"} if arguments.quick else {})
        if not run.ok:
            sys.exit(f"{path}: {run.reason}")
        page.heading(f"`{path.stem}`")
        page.add(*wrap(title_of(path), 118), "")
        page.figure(path.stem, draw(scene), f"{path.stem} from the front")
        page.add(*wrap(f"{facts(scene)}.", 118), "", *results(run), "")
        print(path.stem, flush=True)
    page.text.write_text("\n".join(page.lines).rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
