"""Numbers and names as people read them: the filters of the templates."""

import math
import pathlib
import re
import subprocess
import sys

from markupsafe import Markup, escape

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "figures"))
from common import pockets_alike, readable  # noqa: E402, F401  the same in figures and on pages


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def decimals_for(size, digits):
    """Decimals that show `digits` significant digits of a number of this size."""
    if not size > 0:
        return 0
    return min(max(digits - 1 - math.floor(math.log10(size)), 0), 9)


def fixed(value, decimals=2):
    """A fixed number of decimals; never "-0.00"."""
    if not is_number(value):
        return "-"
    text = f"{value:.{decimals}f}"
    return text[1:] if text.startswith("-") and not text.strip("-0.") else text


def rounded(value):
    """Three significant digits, without exponent where it can be avoided; "-" for none."""
    if not is_number(value):
        return "-"
    value = float(f"{value:.9g}")  # 30.000000000002 is 30
    if value == math.floor(value) and abs(value) < 1e7:
        return f"{value:.0f}"
    if abs(value) < 1e-3 or abs(value) >= 1e7:
        return f"{value:.2e}"
    return fixed(value, decimals_for(abs(value), 3))


def fonts_with(character):
    """Families of this machine's fonts that show a character, as fontconfig lists them."""
    return subprocess.run(["fc-list", f":charset={ord(character):x}", "family"], capture_output=True, check=True).stdout


def without_font(text, fonts=fonts_with):
    """A warning for characters beyond Latin, Greek and Cyrillic that no font shows; "" where all are shown or nobody can say."""
    try:
        missing = [c for c in sorted({c for c in text if ord(c) > 0x52F and c.isalpha()})[:50] if not fonts(c).strip()]
    except (OSError, subprocess.SubprocessError):
        return ""
    return (f"no font here shows {''.join(missing)}: PDF and figures leave such characters out; Debian's fonts-noto-cjk has Chinese, "
            "Japanese and Korean" if missing else "")


def significant(value, digits=4):
    """Large numbers are rounded before their point, too."""
    if not is_number(value) or abs(value) < 10**digits:
        return rounded(value)
    return f"{round(value, digits - 1 - math.floor(math.log10(abs(value)))):.0f}"


def whole(value):
    """To the next whole number."""
    return f"{value:.0f}" if is_number(value) else "-"


def plain(value):
    """As input files have it."""
    return f"{value:.12g}" if is_number(value) else str(value)


def general(value, digits=6):
    return f"{value:.{digits}g}" if is_number(value) else "-"


def signed(value, decimals=1):
    return f"{value:+.{decimals}f}" if is_number(value) else "-"


def interval_ends(value, lower, upper):
    """The three as text, with as many decimals as the first digit of the interval's half width."""
    half = 0.5 * (upper - lower)
    if max(abs(value), abs(upper), half) < 1e-3:
        return f"{value:.3g}", f"{lower:.2g}", f"{upper:.2g}"
    decimals = decimals_for(half, 1) if half > 0 else decimals_for(abs(value), 3)
    return tuple(fixed(number, decimals) for number in (value, lower, upper))


def with_interval(estimate):
    """83.4 and, below it in small print, 82.9 to 83.9."""
    if not is_number(estimate["value"]):
        return "-"
    if not (is_number(estimate["lower"]) and is_number(estimate["upper"])):
        return rounded(estimate["value"])
    value, lower, upper = interval_ends(estimate["value"], estimate["lower"], estimate["upper"])
    return Markup(f"{value}<br><small>{lower} to {upper}</small>")


def percent(share):
    """"97.3 %" of a share."""
    if not is_number(share):
        return "-"
    x = 100 * share
    distance = min(abs(x), abs(100 - x))
    if 99.995 <= x < 100:
        x = 99.99
    return fixed(x, 2 if 0 < distance < 0.1 else 1) + " %"


def estimated_percent(estimate):
    """A yield; where no run misses, how large it is at least."""
    if estimate["missing_runs"] == 0 and is_number(estimate["lower_bound"]):
        return "≥ " + percent_down(estimate["lower_bound"])
    return percent(estimate["if_unknown_fail"])


def percent_down(share):
    """A lower bound is rounded to its safe side."""
    return fixed(math.floor(1000 * share) / 10, 1) + " %" if is_number(share) else "-"


def fit_percent(share):
    """Of cages that fit."""
    return f"{100 * share:.3f} %" if share < 0.9999 else f"all but {jam_share(1 - share)}"


def jam_share(share):
    """Of cages that do not fit: "0.57 %", "12 ppm"; a million drawn cages tell no less than 3 ppm."""
    if share < 3e-6:
        return "at most 3 ppm"
    return f"{1e6 * share:.2g} ppm" if share < 1e-4 else f"{100 * share:.3g} %"


def stated_percent(share):
    """A share that somebody stated, as stated."""
    return f"{100 * share:.6g} %" if is_number(share) else "-"


def percent_interval(estimate):
    """"97 % (96 to 98)" of an estimated share."""
    if not is_number(estimate["value"]):
        return "-"
    if not is_number(estimate["lower"]):
        return percent(estimate["value"])
    return "{} % ({} to {})".format(*(fixed(100 * estimate[key], 0) for key in ("value", "lower", "upper")))


def unit_suffix(unit):
    """" mrad"; nothing for a ratio."""
    return "" if unit in ("", "-", None) else f" {unit}"


def bracketed(unit):
    """" [1/rev]", which stays on one line."""
    return "" if unit in ("", "-", None) else Markup(' <span class="u">[{}]</span>').format(unit)


def kept(text, longest=20):
    """On one line where it is short."""
    text = text.replace(" degC", " °C")
    return Markup('<span class="u">{}</span>').format(text) if len(text) <= longest else text


def code(text):
    """A key or command; it may break after a full stop, an underscore or a slash, never within a word."""
    return Markup("<code>") + breakable(text) + Markup("</code>")


def breakable(text):
    return Markup(re.sub(r"([._/=])(?=[A-Za-z0-9])", r"\1<wbr>", str(escape(text))))


def value_text(value):
    """A value of the study as it is stored."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return f"{value:.6g}"
    if value is None:
        return "null"
    if isinstance(value, list):
        text = "[" + ", ".join(value_text(item) for item in value) + "]"
        return text if len(text) <= 60 else text[:57] + "..."
    return str(value)


def law_text(law):
    """"normal (sigma 0.009)" of a law of the study."""
    if not law:
        return ""
    parts = [f"{key} {value_text(value)}" for key, value in law.items() if key != "law" and value is not None]
    name = law.get("law", "?")
    return f"{name} ({', '.join(parts)})" if parts else name


def scene_items(section, prefix=""):
    """The keys of a scene with a value of their own, flat; assumptions have a chapter of their own."""
    items = []
    for key, value in section.items():
        if isinstance(value, dict):
            items += scene_items(value, prefix + key + ".")
        elif prefix + key != "assumption" and value not in ("auto", []):
            items.append((prefix + key, value_text(value)))
    return items


def joined(items, last=" and "):
    items = [str(item) for item in items]
    return last.join([", ".join(items[:-1]), items[-1]]) if len(items) > 1 else "".join(items)


WORDS = [  # word, pattern, meaning
    ("mixture", r"mixture|candidates mixed",
     "runs of cages from all candidate tolerances: they judge all of them at once"),
    ("effective runs", r"effective (?:number of )?runs",
     "how many equally weighted runs would say as much about one candidate"),
    ("fresh runs", r"fresh runs",
     "runs of new cages at one tolerance, drawn after it was chosen: only they confirm it"),
    ("lot", r"lots?", "cages that share one draw of a deviation, as from one setting of the tool"),
    ("noise of the start", r"noise",
     "what differs between runs of the same cage from other starts; no tolerance removes it"),
    ("Pp", r"Pp", "full width of a tolerance over six standard deviations of all scatter, from cage to cage and among pockets"),
    ("SE", r"SE", "standard error: how far a mean would scatter if the study were repeated with other samples"),
    ("DIR", r"DIR", "in commands: the directory of this report"),
]


def words_used(pages):
    """The words that these pages use in a sense of their own, with their meanings."""
    text = re.sub(r"<script\b.*?</script>", " ", str(pages), flags=re.S)
    text = re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", text))
    return [(word, meaning) for word, pattern, meaning in WORDS if re.search(rf"\b(?:{pattern})\b", text)]


def width(value, answer):
    """A width in mm; beyond what was searched where there is none."""
    return rounded(value) if is_number(value) else f"> {rounded(answer['searched_mm'])}"


def filters():
    return {"rounded": rounded, "fixed": fixed, "whole": whole, "significant": significant, "plain": plain, "general": general, "signed": signed,
            "with_interval": with_interval, "percent": percent,
            "percent_down": percent_down, "fit_percent": fit_percent, "estimated_percent": estimated_percent, "stated_percent": stated_percent, "percent_interval": percent_interval,
            "unit_suffix": unit_suffix, "bracketed": bracketed, "code": code, "kept": kept, "breakable": breakable,
            "value_text": value_text, "width": width, "law_text": law_text,
            "readable": readable, "joined": joined, "words_used": words_used}


def tests():
    return {"known": is_number}
