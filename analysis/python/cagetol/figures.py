"""The figures of a report, drawn again from its report.json by the scripts that drew the report."""

import base64
import pathlib
import subprocess
import sys
import tempfile


class Drawing:
    """One figure: its SVG text; a notebook shows it."""

    def __init__(self, name, svg):
        self.name, self.svg = name, svg

    def _repr_html_(self):
        # As an image: converters of notebooks strip SVG that stands in the page.
        return f'<img alt="{self.name}" src="data:image/svg+xml;base64,{base64.b64encode(self.svg.encode()).decode()}">'

    def save(self, path):
        pathlib.Path(path).write_text(self.svg, encoding="utf-8")


def scripts():
    """Where draw.py is: beside this package where it was installed, else in the tree."""
    here = pathlib.Path(__file__).resolve().parent
    for place in (here / "scripts", here.parents[1] / "figures"):
        if (place / "draw.py").is_file():
            return place
    raise FileNotFoundError("the figures' scripts (draw.py) are missing: install the package again from analysis/python")


def figures(directory):
    """{name: Drawing} of DIR/report.json, which `cagetol report DIR` writes. Throws FileNotFoundError, and RuntimeError with the
    message of a figure that cannot be drawn."""
    report = pathlib.Path(directory) / "report.json"
    if not report.is_file():
        raise FileNotFoundError(f"{report} is missing: run `cagetol report {directory}` first")
    with tempfile.TemporaryDirectory() as drawn:
        done = subprocess.run([sys.executable, "-B", str(scripts() / "draw.py"), str(report), drawn], capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip() or f"drawing ended with code {done.returncode}")
        return {file.stem: Drawing(file.stem, file.read_text(encoding="utf-8")) for file in sorted(pathlib.Path(drawn).glob("*.svg"))}
