"""Whether every number on the pages of a report is one of report.json: numbers_of_pages.py REPORT_JSON REPORT_HTML.

A number may stand there rounded, and as a share in percent. Each section is held against the chapters that it is made from, without
their lists of plain numbers (histograms, curves), which only figures show: among all numbers of the file a wrong one would find its
like. Prints what is in neither and ends with 1.
"""

import bisect
import html
import json
import re
import sys

NUMBER = re.compile(r"(?<![\w.])[-+±]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w])")
# What the templates say whatever the study is: standards, sources, definitions.
FIXED = ["ISO 286", "ISO/TS 16281", "L10", "C0/60", "0.135 %, 50 % and 99.865 %", "20 kHz",
         "shares of 5 % and more", "holds 90 % of the runs", "5 to 95 % of them", "with their 5 to 95 % range", "band from 5 to 95 %", "95 % quantile",
         "5 % quantile", "95 % of runs below", "numbered from 0", "at 100 %", "up to 100 %"]


FRONT = ["verdict", "margins", "passed_over", "bearing", "tolerance", "confirmation", "limits", "assumptions", "assumption_verdicts",
         "outcomes"]
# The chapters of report.json that a section shows; "" for all others: the chapter of its name.
CHAPTERS = {"verdict": FRONT + ["contributors", "document"], "operating": ["bearing"], "curves": FRONT + ["contributors"], "appendix": [],
            "outcomes": ["outcomes", "limits", "verdict"], "confirmation": ["confirmation", "verdict"], "tolerance": ["tolerance", "verdict"],
            "assumed": ["assumption_verdicts", "verdict"], "contributors": ["contributors", "outcomes", "quantities"],
            "quantities": ["quantities", "intervals"], "errors": ["error_budget"], "cage": ["cage", "bearing"],
            "capability": ["capability", "confirmation"],
            "failures": ["failures", "limits", "worst_samples", "confirmation"],
            "model": ["fidelity", "assumptions", "assumption_verdicts", "provenance", "bearing"],
            "definitions": ["quantities"], "scene": ["provenance"],
            "provenance": ["provenance", "outcomes", "intervals"]}


def leaves(node):
    """Numbers of the tree, those within its texts, and the lengths of its lists."""
    if isinstance(node, bool) or node is None:
        return
    if isinstance(node, (int, float)):
        yield float(node)
    elif isinstance(node, str):
        yield from (float(text.lstrip("±")) for text in NUMBER.findall(node))
        yield from (float(text) for text in re.findall(r"\d+(?:\.\d+)?", node))
    elif isinstance(node, dict):
        for key, value in node.items():
            yield from leaves(key)
            yield from leaves(list(map(str, value)) if key == "levels" else value)  # heads of a table
    else:
        yield float(len(node))
        if not (len(node) > 3 and all(isinstance(item, (int, float)) for item in node)):
            for item in node:
                yield from leaves(item)


def half_step(text):
    """Half of what the last digit shown counts; zeros before the point may be rounded."""
    digits = text.lstrip("+-±")
    power = int(digits.split("e")[1]) if "e" in digits else 0
    mantissa = digits.split("e")[0]
    if "." in mantissa:
        return 0.5 * 10.0 ** (power - len(mantissa.split(".")[1]))
    zeros = len(mantissa) - len(mantissa.rstrip("0")) if len(mantissa) > 4 else 0
    return 0.5 * 10.0 ** (power + zeros)


def visible(page):
    """The text that a reader sees."""
    page = re.sub(r"<(style|script|title|nav)\b.*?</\1>", " ", page, flags=re.S)
    page = page.replace("<wbr>", "")
    text = html.unescape(re.sub(r"<[^>]+>", " ", page))
    text = re.sub(r"\s+", " ", text)
    for pattern in FIXED:
        text = re.sub(pattern if "\\" in pattern else re.escape(pattern), " ", text)
    return text


def sections(page):
    """Name and content of each."""
    marks = [(match.start(), match.group(1)) for match in re.finditer(r'<section id="(\w+)"', page)] + [(len(page), "")]
    return [(name, page[begin:end]) for (begin, name), (end, _) in zip(marks, marks[1:])]


def missing_numbers(report, name, content):
    known = {}
    chapters = [report.get(chapter) for chapter in CHAPTERS.get(name, [name])]
    for scale in (1, 100):
        known[scale] = sorted({scale * number for number in leaves(chapters)})

    def found(value, step, scale):
        return any(place < len(known[scale]) and known[scale][place] <= sign * value + step
                   for sign in (1, -1) for place in [bisect.bisect_left(known[scale], sign * value - step)])

    text = visible(content)
    missing, count = [], 0
    for match in NUMBER.finditer(text):
        count += 1
        shown = abs(float(match.group().lstrip("±")))
        bound = text[:match.start()].rstrip().endswith(("≥", "least", "beyond"))  # rounded to its safe side, by a whole step
        step = half_step(match.group()) * (2 if bound else 1) * (1 + 1e-9) + 1e-12
        if match.group() == "99.99":  # a share as near to one is rounded down
            step = 100 - shown
        if not (found(shown, step, 1) or found(shown, step, 100)):
            missing.append(f"{name}: ...{text[max(0, match.start() - 50):match.end() + 20]}...")
    return missing, count


def main(json_file, page_file):
    with open(json_file, encoding="utf-8") as source:
        report = json.load(source)
    with open(page_file, encoding="utf-8") as source:
        page = source.read()
    missing, count = [], 0
    for name, content in sections(page):
        if name == "motion":
            continue  # its numbers come from motion.json
        of_section, numbers = missing_numbers(report, name, content)
        missing += of_section
        count += numbers
    for place in missing:
        print(f"not in report.json: {place}")
    print(f"{count} numbers on the pages")
    return 1 if missing or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
