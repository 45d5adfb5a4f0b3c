"""Whether a claim about two levels of a dimension agrees with runs at them, by their paired difference."""

from dataclasses import dataclass

import numpy as np
from scipy import stats

AGREES, DISAGREES, OPEN, UNCLEAR = "agrees", "disagrees", "cannot be told", "the paper contradicts itself"


@dataclass(frozen=True)
class Difference:
    """Second level less first: mean, half of its interval (NaN with fewer than two pairs), mean at the first level."""
    value: float
    half: float
    first: float


def mean_interval(values, confidence=0.95):
    """Mean of the known values, and half of its interval by Student's t."""
    known = np.asarray(values, dtype=float)
    known = known[~np.isnan(known)]
    if len(known) < 2:
        return (known.mean() if len(known) else np.nan), np.nan
    return known.mean(), stats.t.ppf((1 + confidence) / 2, len(known) - 1) * known.std(ddof=1) / np.sqrt(len(known))


def paired_difference(first, second, confidence=0.95):
    """The k-th runs of both levels start alike. NaN: a run without a value; its partner is left out."""
    first, second = np.asarray(first, dtype=float), np.asarray(second, dtype=float)
    both = ~np.isnan(first) & ~np.isnan(second)
    value, half = mean_interval(second[both] - first[both], confidence)
    return Difference(value, half, first[both].mean() if both.any() else np.nan)


def judge(expected, change, found):
    """`change`: the claimed one of rises and falls, the allowed one of level."""
    if expected == "unclear":
        return UNCLEAR
    low, high = found.value - found.half, found.value + found.half
    if expected == "level":
        agrees, disagrees = low > -change and high < change, low >= change or high <= -change
    else:
        if expected == "falls":
            low, high = -high, -low
        agrees, disagrees = low > change, high <= change
    return AGREES if agrees else DISAGREES if disagrees else OPEN


def judge_claim(readings):
    """A claim counts once: it agrees where all its readings do."""
    if UNCLEAR in readings:
        return UNCLEAR
    if all(reading == AGREES for reading in readings):
        return AGREES
    if AGREES in readings:
        return f"agrees in part ({readings.count(AGREES)} of {len(readings)} readings)"
    return DISAGREES if DISAGREES in readings else OPEN
