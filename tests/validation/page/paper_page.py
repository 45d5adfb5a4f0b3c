"""What Xin et al. 2024 say of pocket dimensions beside runs of their bearing: tests/PAPER.md.

    python3 tests/validation/page/paper_page.py --program build/cagetol

Claims are in paper.toml, verdicts in paper_judge.py. Needs Debian's python3-scipy, python3-h5py and python3-pandas.
Sweeps are kept in build/paper-page by program and study. --runs N takes N runs of each cage instead of 16.
"""

import argparse
import math
import sys
import tomllib
from pathlib import Path

from paper_judge import judge, judge_claim, mean_interval, paired_difference
from program import Program
from report import ROOT, number, table
from results import stamp

sys.path.insert(0, str(ROOT / "analysis/python"))
from cagetol.study import read_study  # noqa: E402

PAGE = Path(__file__).resolve().parent
STUDY = PAGE / "paper_study.toml"
CLAIMS = tomllib.loads((PAGE / "paper.toml").read_text(encoding="utf-8"))["claim"]
STUDIES = tomllib.loads((PAGE / "paper.toml").read_text(encoding="utf-8"))["study"]
SETTINGS = {0: "square, aligned", 1: "askew, misaligned"}  # pockets out of square [mrad]; the ring by twice that
ROLLER = {"pocket_width_mm": "diameter_mm", "pocket_length_mm": "length_mm"}


def allowed_change(claim, first):
    """The change that a claim speaks of, in the quantity's unit; `first`: mean at the first level."""
    return claim.get("within_value", max(claim.get("within", 0), claim.get("at_least", 0)) * abs(first))


def first_of(value):
    return value[0] if isinstance(value, list) else value


class Responses:
    """Values of the runs of a study by setting, level and start. The k-th runs of all cages start alike."""

    def __init__(self, program, plan, runs):
        scene_file = ROOT / f"inputs/scenes/{plan['scene']}.toml"
        scene = tomllib.loads(scene_file.read_text(encoding="utf-8"))
        nominal = plan.get("nominal", first_of(scene["cage"][plan["key"]]))
        self.clearance = nominal - first_of(scene["roller"][ROLLER[plan["key"]]])
        self.levels, self.runs = sorted(plan["levels"]), runs
        self.values, failed = {}, 0
        for setting in SETTINGS:
            for level in self.levels:
                settings = {"scene.file": str(scene_file), "samples": runs, "scene.bearing.misalignment_z_mrad": 2.0 * setting,
                            "scene.cage.pocket_squareness_mrad": 1.0 * setting, f"scene.cage.{plan['key']}": nominal + level}
                place = program.directory("sweep", STUDY, "study.h5", settings=settings, reads=[scene_file])
                study = read_study(place)
                ok = study.samples["status"] == "ok"
                failed += (~ok).sum()
                self.values[setting, level] = study.quantities.where(ok)
        self.failed = f"{failed} of {len(self.values) * runs} runs failed"

    def of(self, quantity, setting, level):
        """By start; NaN for a run without a value."""
        return self.values[setting, level][quantity].to_numpy()

    def means(self, quantity, setting):
        return [with_half(*mean_interval(self.of(quantity, setting, level))) for level in self.levels]


def with_half(value, half):
    return f"{number(value)} ± {number(half, 2)}" if math.isfinite(half) else number(value)


def deviation(value):
    return f"{value:+g}" if value else "0"


def claim_rows(claim, responses):
    """A row for each reading; the first one names the claim and says what becomes of it in each setting."""
    rows, verdicts = [], {setting: [] for setting in SETTINGS}
    for quantity, start, end in claim["readings"]:
        row = [f"`{quantity}`, {deviation(start)} to {deviation(end)}"]
        for setting in SETTINGS:
            found = paired_difference(responses.of(quantity, setting, start), responses.of(quantity, setting, end))
            verdicts[setting].append(judge(claim["expected"], allowed_change(claim, found.first), found))
            seen = "" if claim["expected"] == "unclear" else f": {verdicts[setting][-1]}"
            row.append(with_half(found.value, found.half) + seen)
        rows.append(["", "", *row])
    judged = [f"**{judge_claim(verdicts[setting])}**" for setting in SETTINGS]
    return [[claim["text"], claim["source"], "", *judged], *rows]


def study_chapter(name, responses):
    claims = [claim for claim in CLAIMS if name in claim["studies"]]
    clearance = number(responses.clearance, 2)
    lines = [f"## `{name}`: nominal clearance {clearance} mm, {responses.runs} runs of each cage", "",
             f"{responses.failed}. Means and pairs leave them out.", ""]
    lines += table(["claim", "in the paper", "reading: quantity, deviations in mm", *SETTINGS.values()],
                   [row for claim in claims for row in claim_rows(claim, responses)])
    quantities = dict.fromkeys(quantity for claim in claims for quantity, *_ in claim["readings"])
    lines += ["Means over the runs of each level, by the clearance of its pockets:", ""]
    head = [f"{1e3 * (responses.clearance + level):.0f} um" for level in responses.levels]
    rows = [[f"`{quantity}`", text, *responses.means(quantity, setting)]
            for quantity in quantities for setting, text in SETTINGS.items()]
    return lines + table(["quantity", "pockets and ring", *head], rows)


def head(made, command):
    return ["# What Xin et al. 2024 say, beside this program", "",
            f"Generated by `{command}`.",
            f"Program of commit {made['commit']}, {made['machine']}, {made['date']}.", "",
            "Xin et al., Appl. Sci. 2024, 14, 9433 ([doi](https://doi.org/10.3390/app14209433)) simulate one bearing",
            "with three lengths and three widths of its pockets, one run each. Their text does not state bearing, oil,",
            "clearances, start or length of a run: these are assumptions of `inputs/scenes/nu205-paper.toml`. The",
            "runs start every level from several places, with pockets square and the ring aligned, as in the paper,",
            "and with pockets 1 mrad out of square and the ring misaligned by 2 mrad.", "",
            "A claim counts once and agrees where all its readings do. A reading is judged by the 95 % interval of the",
            "paired difference, second level less first (Student's t, the k-th runs of all levels start alike): it",
            "agrees where the whole interval does what is claimed, disagrees where none of it does, and cannot be told",
            "otherwise. Each interval holds by itself: some are wrong by chance. How much \"far above\" (twice) and",
            "\"hardly\" (5 %; 0.001 of slip) mean is our reading (`tests/validation/page/paper.toml`).", ""]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/cagetol"), help="executable (build/cagetol)")
    parser.add_argument("--runs", type=int, default=16, help="runs of each cage (16, as in the study)")
    parser.add_argument("--page", default=ROOT / "tests/PAPER.md", help="file for the page")
    options = parser.parse_args()

    program = Program(options.program, Path(options.program).resolve().parent / "paper-page")
    lines = []
    for name, plan in STUDIES.items():
        lines += study_chapter(name, Responses(program, plan, options.runs))
    command = "python3 tests/validation/page/paper_page.py --program build/cagetol"
    command += f" --runs {options.runs}" if options.runs != 16 else ""
    Path(options.page).write_text("\n".join(head(stamp(program), command) + lines).rstrip() + "\n", encoding="utf-8")
    print(options.page)


if __name__ == "__main__":
    main()
