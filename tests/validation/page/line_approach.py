"""Elastic approach of a roller's axis and a ring. Steel, lengths in mm, N, MPa.

  Palmgren's kind  delta = (Q/(77652 L^(8/9)))^0.9                      the program's "palmgren"
  line             delta = q k (2 ln(4 R/a) - 1 + 2 ln(2 t/a) - nu/(1 - nu)),  k = (1 - nu^2)/(pi E)
                   a^2 = 8 q R'/(pi E'),  1/R' = 1/R +- 1/R_race        Johnson, Contact Mechanics, 5.6
R of the roller, t depth in the ring, q = Q/L.
"""

from dataclasses import dataclass
from math import log, pi, sqrt

STIFFNESS = 77652.0  # K [N/mm^(17/9)]


@dataclass(frozen=True)
class Race:
    roller: float     # R
    curvature: float  # 1/R_race, concave negative
    depth: float      # t


def palmgren_approach(force, length):
    return (force / (STIFFNESS * length ** (8 / 9))) ** 0.9


def line_approach(race, load, young=208e3, poisson=0.3):
    """At q = load."""
    half_width = sqrt(8 * load * (1 - poisson ** 2) / (pi * young * (1 / race.roller + race.curvature)))
    softness = (1 - poisson ** 2) / (pi * young)
    roller = 2 * log(4 * race.roller / half_width) - 1
    return load * softness * (roller + 2 * log(2 * race.depth / half_width) - poisson / (1 - poisson))


def races(bearing):
    """Inner and outer, the depth being the ring's thickness."""
    b, radius = bearing.file["bearing"], bearing.file["roller"]["diameter_mm"] / 2
    inner, outer, clearance = (b["inner_raceway_diameter_mm"], b["outer_raceway_diameter_mm"],
                               1e-3 * b["internal_clearance_um"])
    return (Race(radius, 2 / (inner - clearance / 2), (inner - bearing.bore) / 2),
            Race(radius, -2 / (outer + clearance / 2), (bearing.outside - outer) / 2))
