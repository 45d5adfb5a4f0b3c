"""What Xin et al. 2024 say of pocket dimensions beside the shipped studies of their bearing: tests/PAPER.md.

    python3 tests/validation/page/paper_page.py --program build/cagetol

Claims are in paper.toml, verdicts in paper_judge.py. Needs Debian's python3-scipy, python3-h5py and python3-pandas.
Sweeps are kept in build/paper-page by program and study. --runs N takes N runs of each cage instead of the studies' 16.
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

PAGE = Path(__file__).resolve().parent
CLAIMS = tomllib.loads((PAGE / "paper.toml").read_text(encoding="utf-8"))["claim"]
WIDTH, LENGTH = "cage.pocket_width_mm", "cage.pocket_length_mm"
STUDIES = {name: (ROOT / f"inputs/studies/{name}.toml", WIDTH if "width" in name else LENGTH)
           for name in ("paper-length", "paper-length-tight", "paper-width", "paper-width-tight")}
SETTINGS = {0: "square, aligned", 2: "askew, misaligned"}  # by bearing.misalignment_z_mrad
ROLLER = {WIDTH: "diameter_mm", LENGTH: "length_mm"}


def allowed_change(claim, first):
    """The change that a claim speaks of, in the quantity's unit; `first`: mean at the first level."""
    return claim.get("within_value", max(claim.get("within", 0), claim.get("at_least", 0)) * abs(first))


class Responses:
    """Values of the runs of a study by setting, level and start."""

    def __init__(self, study, key):
        samples = study.samples
        nominal = next(entry["nominal"] for entry in study.plan["inputs"] if entry["key"] == key)
        nominal = nominal[0] if isinstance(nominal, list) else nominal
        levels = (samples[f"{key}[0]"] - nominal).round(6) + 0.0
        self.cells = [samples["bearing.misalignment_z_mrad"].round(6), levels]
        self.levels = sorted(levels.unique())
        self.values = study.quantities.where(samples["status"] == "ok").assign(start=samples["replicate"])
        self.runs = int(samples["replicate"].max()) + 1
        self.failed = f"{(samples['status'] != 'ok').sum()} of {len(samples)} runs failed"
        roller = study.plan["scene"]["roller"][ROLLER[key]]
        self.clearance = nominal - (roller[0] if isinstance(roller, list) else roller)

    def of(self, quantity, setting, level):
        """By start; NaN for a run without a value."""
        here = (self.cells[0] == setting) & (self.cells[1] == level)
        return self.values[here].set_index("start")[quantity].reindex(range(self.runs)).to_numpy()

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
            "studies run every level from several starts, with pockets square and the ring aligned, as in the paper,",
            "and with pockets 1 mrad out of square and the ring misaligned by 2 mrad.", "",
            "A claim counts once and agrees where all its readings do. A reading is judged by the 95 % interval of the",
            "paired difference, second level less first (Student's t, the k-th runs of all levels start alike): it",
            "agrees where the whole interval does what is claimed, disagrees where none of it does, and cannot be told",
            "otherwise. Each interval holds by itself: some are wrong by chance. How much \"far above\" (twice) and",
            "\"hardly\" (5 %; 0.001 of slip) mean is our reading (`tests/validation/page/paper.toml`).", ""]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/cagetol"), help="executable (build/cagetol)")
    parser.add_argument("--runs", type=int, default=16, help="runs of each cage (16, as in the studies)")
    parser.add_argument("--page", default=ROOT / "tests/PAPER.md", help="file for the page")
    options = parser.parse_args()
    from cagetol.study import read_study  # pandas

    program = Program(options.program, Path(options.program).resolve().parent / "paper-page")
    lines = []
    for name, (path, key) in STUDIES.items():
        scene = path.parent / tomllib.loads(path.read_text(encoding="utf-8"))["scene"]["file"]
        settings = {"extra_replicates": options.runs - 1, "allowed_failure_share": 1}
        place = program.directory("sweep", path, "study.h5", settings=settings, reads=[scene])
        lines += study_chapter(name, Responses(read_study(place), key))
    command = "python3 tests/validation/page/paper_page.py --program build/cagetol"
    command += f" --runs {options.runs}" if options.runs != 16 else ""
    Path(options.page).write_text("\n".join(head(stamp(program), command) + lines).rstrip() + "\n", encoding="utf-8")
    print(options.page)


if __name__ == "__main__":
    main()
