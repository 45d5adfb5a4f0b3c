"""What is shown, and in which order: the selections that templates make from report.json. Nothing is computed here.

Above 400 lines: one short function for each table or list of a page."""

import math

from page_text import (code, fixed, general, is_number, jam_share, joined, percent_interval, plain, pockets_alike, readable, rounded, scene_items,
                       unit_suffix, value_text)


class Chapter:
    def __init__(self, name, title):
        self.name, self.title = name, title


def front(report):
    """The pages to send."""
    chapters = [Chapter("verdict", verdict_title(report))]
    if report["bearing"] and "groups" in report["bearing"]:
        chapters.append(Chapter("operating", "Operating point"))
    if report["tolerance"] or operating_points(report):
        chapters.append(Chapter("curves", "Yield, optimum and limits"))
    return chapters


def worded(report, text):
    """A sentence with quantities by their names in place of their keys."""
    for key in sorted((entry["quantity"] for entry in report["quantities"]), key=len, reverse=True):
        text = text.replace(key, readable(key))
    return text


def may_be_printed(report):
    return report["verdict"]["status"] in ("confirmed", "recommended")


def verdict_title(report):
    return "What may be printed on the drawing" if may_be_printed(report) else "No tolerance to print on the drawing yet"


MOST_CONVERGENCE = 24


def convergence_rows(report):
    """Those that need the most runs, in the order of the study."""
    rows = report["convergence"]["rows"]
    need = lambda row: -row["runs_needed"] if is_number(row["runs_needed"]) else 0
    kept = sorted(rows, key=need)[:MOST_CONVERGENCE]
    return [row for row in rows if row in kept], len(rows) - len(kept)


def title(report):
    """The study's name, without that of its stage."""
    return report["provenance"]["study_name"].removesuffix(", mixture")


def report_number(report):
    return report["document"]["number"]


def title_block(report):
    """Name and text of what the document states, its date and number."""
    document = report["document"]
    named = [("customer", "customer"), ("project", "project"), ("drawing", "drawing"), ("revision", "revision"), ("author", "author"),
             ("checked by", "checked_by"), ("date", "date")]
    return [(name, document[key]) for name, key in named if document.get(key)] + [("report", report_number(report))]


def css_text(text):
    """As a string of a style sheet within a page."""
    return "".join(c if c.isalnum() or c in " :,.-" else f"\\{ord(c):06x}" for c in text)


def assumed_ranges(report):
    """Ranges that the verdict may be judged under, else those of the scene."""
    verdicts = report["assumption_verdicts"]
    ranges = verdicts["ranges"] if verdicts else report["assumptions"]["ranged"]
    return [{**entry, "unit": unit_of_key(entry["key"])} for entry in ranges]


def assumptions_title(report):
    verdicts = report["assumption_verdicts"]
    return "Assumptions that decide" if verdicts and verdicts["judged"] > 0 else "Assumptions that nobody has judged"


GRAVITY = "environment.gravity_m_s2"


def front_ranges(report):
    """Without that of gravity, which only says how the shaft lies, unless the target fails at its end."""
    verdicts = report["assumption_verdicts"]
    alternatives = verdicts["alternatives"] if verdicts else []
    decides = any(each["key"] == GRAVITY and each["verdict"] != "holds" for each in alternatives)
    return [entry for entry in assumed_ranges(report) if entry["key"] != GRAVITY or entry["value"] != 9.81 or decides]


def used_value(entry, name="value"):
    """"200 µm" of an assumption as runs take it; "auto: 200 µm" where the scene leaves it open."""
    value = entry[name]
    text = plain(value) + unit_suffix(UNITS.get(entry["unit"], entry["unit"])) if is_number(value) else value_text(value)
    return "auto" if value is None else f"auto: {text}" if entry.get("automatic") else text


def range_entries(ranges):
    """"20 (5 to 50) µm" of each assumption."""
    value = lambda entry: general(entry["value"]) if is_number(entry["value"]) else entry["value"] or "auto"
    return [(entry["name"], f"{value(entry)} ({general(entry['low'])} to {general(entry['high'])}){unit_suffix(entry['unit'])}")
            for entry in ranges]


def scene_entries(scene):
    return [(code(key), value) for key, value in scene_items(scene)]


def constant_entries(quantities):
    return [(readable(entry["quantity"]), rounded(entry["statistics"]["mean"]["value"]) + unit_suffix(entry["unit"])) for entry in quantities]


def halves(groups):
    """Two columns of groups, as equal in height as their order allows."""
    heights = [len(group["entries"]) + 1.3 for group in groups]
    cut = min(range(1, len(groups) + 1), key=lambda k: abs(sum(heights[:k]) - sum(heights[k:])))
    return groups[:cut], groups[cut:]


def subtitle(report):
    """The operating point in a line."""
    bearing = report["bearing"]
    runs = f"{rounded(report['outcomes']['samples_with_attempts'])} runs"
    if not bearing or "section" not in bearing:
        return runs
    section = bearing["section"]
    parts = [bearing["name"]]
    if bearing["points"]:
        parts.append(f"{len(bearing['points'])} operating points")
    else:
        parts.append(f"{rounded(section['radial_load_N'])} N")
        parts.append(f"{rounded(section['inner_speed_rpm'] or section['outer_speed_rpm'])} r/min")
    for group in bearing["groups"]:
        if group["title"] == "Lubricant":
            parts.append(" ".join(entry.get("text") or f"at {rounded(entry['value'])} {entry['unit']}" for entry in group["entries"][:2]))
    return ", ".join(parts + [runs])


MOST_POINTS = 4  # on the page of the operating point; more have the next page


def operating_points(report):
    return (report["bearing"] or {}).get("points", [])


def strength(report):
    """Of a flexible cage; none where it is not known."""
    return (report["bearing"] or {}).get("strength")


def tolerances(report):
    """Of the attempt that confirmed, else those recommended."""
    if not report["tolerance"]:
        return []
    return report["tolerance"]["tolerances"]


def judged_revolutions(report):
    """Cage revolutions that all limits are for; None where they differ."""
    over = {limit["cage_revolutions"] for limit in report["limits"]["each"]}
    return over.pop() if len(over) == 1 else None


def judged_by(report):
    over = judged_revolutions(report)
    return f"each judged by one start over {rounded(over)} revolutions" if over else "each judged by one start"


def sized_tolerances(report):
    """Tolerances to print whose limits of size and scatter are known."""
    return [tolerance for tolerance in tolerances(report) if not tolerance["not_binding"] and is_number(tolerance.get("size", {}).get("capability"))]


def fit_requirement(width):
    """What the share of cages that fit hangs on beside Pp: centring, and how the variance is split."""
    fit = width.get("fit")
    if not fit:
        return ""
    off = width["size"]["mean_mm"]
    words = f", centred within {fixed(1e3 * fit['offset_mm'], 0)} µm"
    if abs(off) > fit["offset_mm"]:
        words = f", its mean {fixed(1e3 * off, 0)} µm beside the middle{' and outside of the tolerance' if abs(off) > width['tolerance_width_mm'] / 2 else ''}"
    if is_number(fit["lot_share"]):
        share = fit["lot_share"]
        words += f", {'half' if abs(share - 0.5) < 0.005 else f'{100 * share:.0f} %'} of the variance from cage to cage"
    return words


def fit_matters(width):
    """Whether more than 10 ppm of the cages hang on the centring or the split of that dimension."""
    fit = width.get("fit")
    return bool(fit) and any(abs(fit[name] - fit["share"]) > 1e-5 for name in ("off_centre", "pockets_alone", "lots_alone"))


def fit_loss(width):
    fit = width["fit"]
    loss = lambda name: jam_share(1 - fit[name])
    off = "further off" if abs(width["size"]["mean_mm"]) > fit["offset_mm"] else "off"
    words = f"{width['name'].capitalize()}: {loss('share')} of the cages jam; with its mean {off} by {fixed(1e3 * fit['offset_mm'], 0)} µm {loss('off_centre')}"
    if is_number(fit["lot_share"]):
        words += f", with all of its variance among the pockets of a cage {loss('pockets_alone')}, from cage to cage {loss('lots_alone')}"
    return words + "."


def widest(report):
    """Dimensions recommended at the widest candidate."""
    return [tolerance["name"] for tolerance in tolerances(report) if tolerance["widest_studied"] and not tolerance["not_binding"]]


def tolerance_name(tolerance):
    grade = f" {tolerance['grade']}" if tolerance["grade"] else f" {tolerance['tolerance_width_mm']:.3f} mm"
    return f"{tolerance['name']}{grade}"


def wider_candidates(report):
    """Attempts that did not confirm, then candidates that no attempt tried."""
    rows = []
    for attempt in (report["confirmation"] or {"attempts": []})["attempts"]:
        if attempt["passed"] and not attempt["judged_again"]:
            continue
        jams = f", {rounded(attempt['jammed_runs'])} jam" if attempt["jammed_runs"] else ""
        tried, kind = ("judged again", "") if attempt["judged_again"] else ("tried", "fresh ")
        rows.append({"name": ", ".join(tolerance_name(tolerance) for tolerance in attempt["tolerances"]), "command": None,
                     "reason": f"{tried} and not confirmed: {rounded(attempt['meeting_runs'])} of {rounded(attempt['runs'])} {kind}runs "
                               f"meet all limits{jams}"})
    return rows + report["passed_over"]


MOST_WIDER = 3  # on the front pages; the appendix has them all


def limits_shown(report):
    """The limits; those alike at several operating points in one row."""
    rows = {}
    for limit in report["limits"]["each"]:
        quantity, _, point = limit["quantity"].partition("@")
        row = rows.setdefault((quantity, limit["text"], limit["source"], limit.get("note")), {**limit, "names": readable(quantity), "points": []})
        row["points"] += [point] if point else []
    return [{**row, "names": row["names"] + (" @ " + ", ".join(row["points"]) if row["points"] else "")} for row in rows.values()]


MOST_MARGINS = 8


def margins_shown(margins):
    """The smallest margins where there are many, in the order of the study."""
    each = margins["each"]
    order = sorted(each, key=lambda m: m["extreme_margin"] if is_number(m["extreme_margin"]) else math.inf)[:MOST_MARGINS]
    return [margin for margin in each if margin in order], [margin for margin in each if margin not in order]


MOST_WARNINGS = 4  # that page is to stay one page


def bearing_warnings(bearing):
    """Those for the page of the operating point, and those that the appendix takes."""
    if not bearing or "warnings" not in bearing:
        return [], []
    warnings = bearing["warnings"] + [f"at {point['name']}: {warning}" for point in bearing["points"] for warning in point["warnings"]]
    return warnings[:MOST_WARNINGS], warnings[MOST_WARNINGS:]


UNITS = {"um": "µm", "C": "°C", "mrad": "mrad", "mm": "mm", "N": "N", "rpm": "r/min", "deg": "deg", "MPa": "MPa", "GPa": "GPa",
         "degC": "°C", "m/s^2": "m/s²"}  # by the ends of keys, and as report.json has them


def unit_of_key(key):
    """The unit that a key of the scene ends with."""
    if key.endswith("_m_s2"):
        return "m/s²"
    return UNITS.get(key.rsplit("_", 1)[-1], "")


def binding_sentence(tolerance):
    """Which dimensions change the yield, in a sentence for each answer."""
    answers = {}
    for dimension in tolerance["dimensions"]:
        answers.setdefault(dimension["binding"], []).append(dimension["name"])
    words = {"binding": "changes the yield within the widths studied", "not binding": "changes no yield within the widths studied"}
    answers.pop("undecided", None)
    return " ".join(f"{' and '.join(names).capitalize()}: the tolerance {words.get(answer, answer)}." for answer, names in answers.items())


def undecided_names(report):
    keys = report["verdict"]["undecided"]
    return [dimension["name"] for dimension in report["tolerance"]["dimensions"] if dimension["key"] in keys]


def appendix(report):
    """Chapters for the engineer; those that the study has nothing to say in are left out."""
    tolerance = report["tolerance"]
    contributors = report["contributors"]
    chapters = [
        ("map", "Where it matters", report.get("map")),
        ("outcomes", "Outcomes and limits", True),
        ("confirmation", "Fresh runs at the recommended tolerance", report["confirmation"]),
        ("rare", "Bad cages in a million", report.get("rare")),
        ("tolerance", "Yield against tolerance", tolerance),
        ("assumed", "What nobody knows", report["assumption_verdicts"]),
        ("process", "The measured parts", report["measured"]),
        ("contributors", "What drives the quantities", contributors["features"] and contributors["outputs"]),
        ("quantities", "Statistics of every quantity", True),
        ("errors", "Error budget", report["error_budget"]["quantities"]),
        ("cage", "Flexible cage", report["cage"]),
        ("motion", "Motion of the worst and the median sample", report.get("motion")),
        ("capability", "Capability at this tolerance" if report["confirmation"] else "Capability against the limits", report["capability"] or (report["confirmation"] or {}).get("capability")),
        ("failures", "Failures and worst samples", True),
        ("convergence", "Are there enough runs?", report["convergence"]["rows"]),
        ("health", "Run health", report["health"]),
        ("model", "Model, assumptions and scatter", True),
        ("definitions", "Definitions", defined_quantities(report)),
        ("scene", "The scene, nominal values", report["provenance"]["scene"]),
        ("provenance", "Where this comes from", True),
    ]
    return [Chapter(name, title) for name, title, content in chapters if content]


def hundred(share):
    """A share in percent."""
    return 100 * share if is_number(share) else None


def million(share):
    """A share in parts per million."""
    return 1e6 * share if is_number(share) else None


MOST_CANDIDATES = 12
MOST_FAILURES = 25


def same_yield(tolerance):
    """The yield that all candidates have, those with few runs too, where it is the same for all; else none."""
    values = {round(c["yield"]["if_unknown_fail"], 4) for c in tolerance["candidates"]}
    alike = len(values) == 1 and len(tolerance["candidates"]) > 1
    return tolerance["candidates"][0]["yield"]["if_unknown_fail"] if alike else None


def candidates_shown(tolerance):
    """All candidates where they are few, else the chosen one and those whose yields lie nearest to it."""
    candidates = tolerance["candidates"]
    if not any(candidate["shown"] for candidate in candidates):
        return []
    if len(candidates) <= MOST_CANDIDATES:
        return candidates
    candidates = [candidate for candidate in candidates if candidate["shown"]] or candidates
    chosen = next((c for c in candidates if c["candidate"] == tolerance["chosen_candidate"]), None)
    if chosen is None:
        return candidates[:MOST_CANDIDATES]
    distance = lambda candidate: sum(abs(math.log(a / b)) for a, b in zip(candidate["tolerance_widths_mm"], chosen["tolerance_widths_mm"]))
    near = sorted(candidates, key=distance)[:MOST_CANDIDATES]
    return [candidate for candidate in candidates if candidate in near]


def centres_studied(tolerance):
    """Whether candidates have nominal values of their own."""
    return any(is_number(centre) for candidate in tolerance["candidates"] for centre in candidate["centres"])


def centre_points(centres):
    return [{**point, "name": dimension["name"], "shift_mm": point["shifts_mm"][number]}
            for number, dimension in enumerate(centres["dimensions"]) for point in dimension["points"] if point["shown"]]


def names_with_units(quantities):
    return [readable(entry["quantity"]) + (f" [{entry['unit']}]" if entry["unit"] not in ("", "-") else "")
            for entry in quantities]


def labelled(name):
    """Of an operating point or a phase."""
    return "@" in name


def limited_names(report):
    return [entry["quantity"] for entry in report["limits"]["each"]]


MINIMUM_SHARE = 0.05  # of a contributor without an interval


def strongest(output):
    """Up to three contributors whose intervals do not reach zero."""
    shares = sorted((share for share in output["shares"] if is_number(share["value"])), key=lambda share: -share["value"])
    texts = []
    for share in shares[:3]:
        if (share["lower"] if is_number(share["lower"]) else share["value"] - MINIMUM_SHARE) <= 0:
            break
        texts.append(f"{share['feature']} {percent_interval(share)}")
    return texts


def noise_text(report, name):
    quantity = next((entry for entry in report["quantities"] if entry["quantity"] == name), None)
    if quantity is None:
        return "-"
    share = quantity["noise"]["share"]
    if not is_number(share["value"]) or share["value"] <= 1:
        return percent_interval(share)
    lower = share["lower"]
    return f"all of it (above {100 * min(lower, 1):.0f} %)" if is_number(lower) else "all of it"


def contributor_groups(report):
    """What decides first, then the other quantities."""
    first = ["meets all limits", "jams"] + limited_names(report)
    rows = [{"output": output["output"], "strongest": strongest(output), "unexplained": percent_interval(output["not_explained"]),
             "noise": noise_text(report, output["output"])}
            for output in report["contributors"]["outputs"] if not bookkeeping(report, output["output"])]
    deciding = sorted((row for row in rows if row["output"] in first), key=lambda row: first.index(row["output"]))
    others = [row for row in rows if row["output"] not in first and row["strongest"] and not labelled(row["output"])]
    groups = [("", deciding), ("Quantities without limits", others)]
    return [(title, outputs) for title, outputs in groups if outputs]


def deciding_contributors(report):
    """Of passing the limits, of jams and of the limited quantities."""
    groups = contributor_groups(report) if report["contributors"]["features"] and report["limits"]["each"] else []
    return groups[0][1] if groups and groups[0][0] == "" else []


def without_contributor(report):
    """Quantities without limits for which no feature stands out."""
    first = ["meets all limits", "jams"] + limited_names(report)
    return [readable(output["output"]) for output in report["contributors"]["outputs"]
            if output["output"] not in first and not bookkeeping(report, output["output"]) and not labelled(output["output"])
            and not strongest(output)]


def bookkeeping(report, name):
    quantity = next((entry for entry in report["quantities"] if entry["quantity"] == name), None)
    return quantity is not None and quantity.get("bookkeeping", False)


class QuantityGroups:
    def __init__(self, report):
        self.limited, self.others, self.constant, self.missing, self.bound_refused = [], [], [], [], ""
        self.left_out = False
        names = limited_names(report)
        for entry in report["quantities"]:
            statistics = entry["statistics"]
            if statistics["runs_with_value"] == 0:
                if not labelled(entry["quantity"]):  # what a point or a phase leaves out says nothing new
                    self.missing.append(readable(entry["quantity"]))
                continue
            self.bound_refused = statistics["bound_refused"] or self.bound_refused
            if entry["quantity"] in names:
                self.limited.append(entry)
            elif labelled(entry["quantity"]) or entry["bookkeeping"]:
                self.left_out = True
            elif entry["constant"]:
                self.constant.append(entry)
            else:
                self.others.append(entry)


def quantity_groups(report):
    return QuantityGroups(report)


def quantile(statistics, level):
    return next((entry for entry in statistics["quantiles"] if entry["level"] == level), statistics["quantiles"][0])


MOST_CAGES = 30  # of a table

MOST_UNLIMITED = 8


def budget_groups(report):
    """Limited quantities; the others, where they vary, only if more than their statistical error was measured."""
    budget = report["error_budget"]
    idle = {entry["quantity"] for entry in report["quantities"] if entry["constant"] or entry["bookkeeping"]}
    limited = [entry for entry in budget["quantities"] if entry["limited"]]
    others = [entry for entry in budget["quantities"] if not entry["limited"] and entry["quantity"] not in idle]
    if not limited:
        return [("", others[:MOST_UNLIMITED])]
    return [("", limited)] + ([("Quantities without limits", others)] if budget["evidence"]["state"] == "measured" else [])


def measured_sources(quantities):
    """Sources that were measured for one quantity at least."""
    names = [source["source"] for source in quantities[0]["sources"]]
    return [name for name in names
            if any(source["source"] == name and source["state"] != "not measured" for entry in quantities for source in entry["sources"])]


def capability(report):
    """Entries with an index, and whether they are those of the confirmed tolerance."""
    confirmed = report["confirmation"]
    entries = confirmed["capability"] if confirmed else report["capability"]
    return [entry for entry in entries if not entry.get("no_index")], bool(confirmed)


def without_capability(report):
    entries = report["confirmation"]["capability"] if report["confirmation"] else report["capability"]
    return [entry for entry in entries if entry.get("no_index")]


def fresh_losses(report):
    """Fresh runs that jammed or have no result, a sentence for each attempt that has such."""
    sentences = []
    for attempt in (report["confirmation"] or {"attempts": []})["attempts"]:
        counts = [(attempt["jammed_runs"], "jammed"), (attempt["unknown_runs"], "gave no result")]
        losses = [f"{rounded(count)} {what}" for count, what in counts if count]
        if losses:
            sentences.append(f"Of {rounded(attempt['runs'])} fresh runs in {attempt['stage']}, {joined(losses)}.")
    return sentences


def worst_samples(report):
    misses = [entry for entry in report["worst_samples"] if not entry["meets_limit"]]
    missed = {(entry["quantity"], entry["limit"]) for entry in misses}
    nearest = {}
    for entry in report["worst_samples"]:
        if (entry["quantity"], entry["limit"]) not in missed:
            nearest.setdefault((entry["quantity"], entry["limit"]), entry)
    return misses, list(nearest.values())


def assumption_rows(report):
    """Key, reason, value and range of each stated assumption."""
    ranges = {entry["key"]: entry for entry in assumed_ranges(report)}
    rows = stated_assumptions(report["assumptions"]["stated"])
    used = (report["bearing"] or {}).get("assumed", {})
    for row in rows:
        row["used"] = used_value(used[row["key"]]) if row["key"] in used else ""
        known = ranges.get(row["key"])
        if known and not row["range"]:
            row["range"] = f"{value_text(known['low'])} to {value_text(known['high'])}"
    return rows


def stated_assumptions(stated):
    """The same in whatever form the study has them."""
    if isinstance(stated, dict):
        return [{"key": key, "note": value_text(text), "range": ""} for key, text in stated.items()]
    rows = []
    for entry in stated:
        if isinstance(entry, dict):
            both = "low" in entry and "high" in entry
            rows.append({"key": entry.get("key", ""), "note": value_text(entry.get("note", "")),
                         "range": f"{value_text(entry['low'])} to {value_text(entry['high'])}" if both else ""})
        else:
            rows.append({"key": value_text(entry), "note": "", "range": ""})
    return rows


def defined_quantities(report):
    """Those with a value; of points and phases a quantity is defined alike."""
    names = [entry["quantity"] for entry in report["quantities"]]
    return [entry for entry in report["quantities"] if entry["statistics"]["runs_with_value"] > 0
            and not (labelled(entry["quantity"]) and entry["quantity"].split("@")[0] in names)]


def libraries_text(libraries):
    if isinstance(libraries, dict):
        return ", ".join(f"{name} {value_text(version)}" for name, version in libraries.items())
    return value_text(libraries)
