"""Lays KIND.json out (report, rig, map, history): write_pages.py REPORT_JSON REPORT_HTML [--figures SCRIPTS OUTPUT_DIR] [--pdf REPORT_PDF].

The PDF has the front pages; appendix.pdf beside it the rest of a report.

Every number on the pages comes from report.json. The page is one self-contained file. What is missing is named in the last line on
standard error, and the exit code is 1; the page is written without figures where they cannot be drawn. Without Jinja2 it is 3,
for a report.json of another version 4, and there is no page; it is 5 where a page could not be written (a full disk).
"""

import argparse
import base64
import datetime
import json
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
REPORT_VERSION = 3  # of report.json: what these pages read
MOST_PAGES = 4  # of report.pdf


def draw(scripts, report, report_file, output_dir):
    """Draws the figures; what went wrong, in a line."""
    sys.path.insert(0, scripts)
    try:
        import draw as drawing
    except ImportError as missing:
        return f"figures are missing: {missing}"
    try:
        failed = drawing.main(report_file, output_dir)
    except ImportError as missing:
        return f"figures are missing: {missing}; Debian's python3-matplotlib draws them"
    return "some figures are missing, see figures/pages.log" if failed else ""


class Figures:
    """The figures that were drawn, embedded in the page."""

    def __init__(self, directory):
        self.files = {} if directory is None else {file.stem: file for file in sorted(pathlib.Path(directory).glob("*.svg"))}

    def source(self, name):
        file = self.files.get(name)
        return None if file is None else "data:image/svg+xml;base64," + base64.b64encode(file.read_bytes()).decode()


def motion_of(report, directory):
    """What the sweep left of its worst and median sample's motion (motion.json); None where it belongs to other runs."""
    for name, place in (("DIR/mixture", directory / "mixture"), ("DIR", directory)):
        try:
            motion = json.loads((place / "motion.json").read_text(encoding="utf-8"))
        except (OSError, ValueError):
            continue
        of = report["provenance"]
        if motion["key"]["study_hash"] == of["study_hash"] and motion["key"]["build"] == of["build"]:
            return {**motion, "directory": name}
    return None


def page_of(report, figures, problem):
    """What lays a part of the pages out: "front", "appendix", or both; `brief`, 0 to 2: without more and more of what the
    appendix has as well."""
    import jinja2
    import page_parts
    import page_text
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "templates"), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    environment.filters.update(page_text.filters())
    environment.tests.update(page_text.tests())
    environment.globals["figure_source"] = figures.source
    environment.globals.update({name: macro for name, macro in vars(environment.get_template("macros.html.j2").module).items()
                                if not name.startswith("_")})
    style = (HERE / "templates" / "style.css").read_text(encoding="utf-8")
    if report.get("motion"):
        style += (HERE / "motion.css").read_text(encoding="utf-8")
        environment.globals["motion_script"] = (HERE / "motion.js").read_text(encoding="utf-8")
    page = environment.get_template(f"{report.get('kind', 'report')}.html.j2")
    return lambda part="", brief=0: page.render(report=report, parts=page_parts, problem=problem, style=style, part=part, brief=brief)


def replace(file, write):
    """The file whole or not at all: `write` fills a temporary one beside it."""
    temporary = pathlib.Path(str(file) + ".tmp")
    try:
        write(temporary)
        os.replace(temporary, file)
    except OSError as problem:
        print(f"{file}: {problem.strerror}", file=sys.stderr)
        sys.exit(5)
    finally:
        temporary.unlink(missing_ok=True)


def write_pdf(page, pdf, appendix):
    """The front pages, and `appendix` in a file of its own where there is one; what went wrong, in a line."""
    try:
        import logging
        logging.getLogger("weasyprint").setLevel(logging.CRITICAL)  # links from one file into the other
        import weasyprint
    except ImportError as missing:
        return f"report.pdf is not written: {missing}; Debian's weasyprint writes it"
    for brief in range(3):
        front = weasyprint.HTML(string=page("front", brief)).render()
        if len(front.pages) <= MOST_PAGES:
            break
    replace(pdf, front.write_pdf)
    if appendix:
        replace(appendix, weasyprint.HTML(string=page("appendix")).write_pdf)
    return ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("report")
    parser.add_argument("html")
    parser.add_argument("--figures", nargs=2, metavar=("SCRIPTS", "OUTPUT_DIR"))
    parser.add_argument("--pdf")
    options = parser.parse_args()
    try:
        import jinja2  # noqa: F401  before figures are drawn for a page that cannot be written
    except ImportError as missing:
        print(missing, file=sys.stderr)
        return 3
    with open(options.report, encoding="utf-8") as source:
        report = json.load(source)
    if report.get("report_version") != REPORT_VERSION:
        print(f"{options.report} has report_version {report.get('report_version')}, the pages in {HERE} lay out {REPORT_VERSION}: "
              "program and pages are of different builds; build both anew and run cagetol report DIR", file=sys.stderr)
        return 4
    sys.path.insert(0, str(HERE))
    import page_text
    problems = [page_text.without_font(json.dumps(report, ensure_ascii=False)) if options.figures or options.pdf else ""]
    if options.figures:
        problems.append(draw(options.figures[0], report, options.report, options.figures[1]))
    problem = "; ".join(filter(None, problems))
    if "document" in report:
        report["document"]["date"] = report["document"].get("date") or datetime.date.today().isoformat()
    report["motion"] = motion_of(report, pathlib.Path(options.report).parent)
    page = page_of(report, Figures(options.figures and options.figures[1]), problem)
    replace(options.html, lambda file: file.write_text(page(), encoding="utf-8"))
    if options.pdf:
        appendix = None if report.get("kind") else pathlib.Path(options.pdf).with_name("appendix.pdf")
        problem = "; ".join(filter(None, [problem, write_pdf(page, options.pdf, appendix)]))
    if problem:
        print(problem, file=sys.stderr)
    return 1 if problem else 0


if __name__ == "__main__":
    sys.exit(main())
