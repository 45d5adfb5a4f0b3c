"""Names, colours and small helpers shared by all figures."""

import math

BLUE, RED, GREEN, PINK, ORANGE, SKY, BLACK = (
    "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
GREY = "#8A8A8A"
WIDTH = 6.7  # inch: the text width of an A4 page


def known(value):
    """A number, or NaN where the report has none."""
    return math.nan if value is None else float(value)


def interval_bars(entries):
    """Distances of the lower and upper ends from the values, as errorbar wants them; 0 where there is no interval."""
    low, high = [], []
    for entry in entries:
        value = known(entry["value"])
        lower, upper = known(entry["lower"]), known(entry["upper"])
        low.append(0.0 if math.isnan(lower) else max(value - lower, 0.0))
        high.append(0.0 if math.isnan(upper) else max(upper - value, 0.0))
    return [low, high]


def with_unit(name, unit):
    return name if unit in ("", "-") else f"{name} [{unit}]"


def readable(quantity):
    """"cage_stress_peak_MPa" -> "cage stress peak"."""
    key, at, label = quantity.partition("@")
    if at:  # of an operating point or a phase
        return f"{readable(key)} @ {label}"
    units = {"MPa", "N", "J", "um", "mrad", "W", "Nmm", "s2", "m", "s", "mm", "deg", "C"}
    words = quantity.split("_")
    while len(words) > 1 and words[-1] in units:
        words.pop()
    return " ".join(words)


def quantity_of(report, name):
    for entry in report["quantities"]:
        if entry["quantity"] == name:
            return entry
    return None


def pockets_alike(report):
    """Whether runs start at any angle of the cage, and no pocket or roller has a nominal value of its own.

    That one pocket explains more than its neighbours is chance then.
    """
    inputs, scene = report["provenance"]["inputs"], report["provenance"]["scene"] or {}
    starts = [entry["noise"] for entry in inputs if entry["key"] == "start.cage_phase_deg" and entry["noise"]]
    if not any(law["law"] == "uniform" and law["upper"] - law["lower"] >= 360 for law in starts):
        return False
    nominal = [entry["nominal"] for entry in inputs]
    nominal += [value for part in ("cage", "roller") for value in scene.get(part, {}).values()]
    return not any(isinstance(values, list) and any(value != values[0] for value in values) for values in nominal)


def draw_limits(axis, limit, label=True):
    """Vertical lines at the limits of a quantity."""
    first = True
    for key in ("minimum", "maximum"):
        value = None if limit is None else limit[key]
        if value is not None:
            axis.axvline(value, color=RED, linestyle="--", linewidth=1.4, label="limit" if first and label else None)
            first = False
