"""Markdown and figures of the page."""

import math
import os
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot, ticker  # noqa: E402

ROOT = Path(__file__).resolve().parents[3]
pyplot.style.use(ROOT / "analysis/figures/cagetol.mplstyle")
WIDTH = 6.7  # inch: the text width of an A4 page


def number(value, digits=3):
    """Rounded to significant digits, without exponents between 1e-4 and 1e7; a dash where there is none."""
    if value is None or not math.isfinite(value):
        return "-"
    if value == 0:
        return "0"
    size = math.floor(math.log10(abs(value)))
    if not -4 <= size < 7:
        return f"{value:.{digits - 1}e}"
    rounded = round(value, digits - 1 - size)
    return f"{rounded:.{max(0, digits - 1 - size)}f}"


def percent(value, digits=2):
    """A share in per cent, without the sign."""
    return number(100 * value, digits)


def signed_percent(value, places=1):
    return f"{100 * value:+.{places}f}" if math.isfinite(value) else "-"


def logarithmic(axis, places, which="x"):
    """A logarithmic axis with ticks at these places alone, as plain numbers, thousands as k."""
    chosen = axis.xaxis if which == "x" else axis.yaxis
    (axis.set_xscale if which == "x" else axis.set_yscale)("log")
    chosen.set_major_locator(ticker.FixedLocator(list(places)))
    chosen.set_minor_locator(ticker.NullLocator())
    chosen.set_major_formatter(ticker.FuncFormatter(lambda x, _: f"{x / 1000:g}k" if x >= 1000 else f"{x:g}"))


def ticks_within(low, high):
    """1, 2, 5 times powers of ten from low to high; 1, 1.5, 2, 3, 5, 7 where these are too few."""
    for steps in ((1, 2, 5), (1, 1.5, 2, 2.5, 3, 4, 5, 7)):
        found = [s * 10.0 ** e for e in range(-3, 7) for s in steps if low <= s * 10.0 ** e <= high]
        if len(found) >= 3:
            break
    return found


def verdict(met):
    return "met" if met else "**not met**"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows] + [""]


class Page:
    """Lines of the page, its figures, and the runs that failed."""

    def __init__(self, text, figures):
        self.text, self.figures = Path(text), Path(figures)
        self.lines, self.failures, self.bars = [], [], []
        self.headings, self.tables = [""], {}  # tables by their heading, as results
        self.figures.mkdir(parents=True, exist_ok=True)

    def add(self, *lines):
        for line in lines:
            if line.startswith("#"):
                self.headings.append(line.lstrip("# "))
        self.lines += lines

    def heading(self, title):
        self.add(f"## {title}", "")

    def table(self, head, rows):
        title = self.headings[-1]
        while title in self.tables:
            title += ", continued"
        self.tables[title] = {"head": list(head), "rows": [[str(cell) for cell in row] for row in rows]}
        self.add(*table(head, rows))

    def results(self):
        """All that accuracy_page.py may want of the page."""
        return {"bars": [list(row) for row in self.bars], "failures": [list(row) for row in self.failures],
                "tables": self.tables}

    def bar(self, what, asked, found, met):
        """Notes a bar that a result was held to, for the table at the top."""
        self.bars.append((what, asked, found, verdict(met)))

    def note_failure(self, what, run):
        """Records a run whose status is not ok; true where it failed."""
        if not run.ok:
            self.failures.append((what, run.status, run.reason.replace("\n", " ").replace("|", "/")))
        return not run.ok

    def figure(self, name, figure, caption):
        figure.savefig(self.figures / f"{name}.svg", metadata={"Date": None})
        pyplot.close(figure)
        self.add(f"![{caption}]({os.path.relpath(self.figures, self.text.parent)}/{name}.svg)", "")
