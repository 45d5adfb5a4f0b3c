"""Static load distribution of a radial roller bearing by the lamina model of ISO/TS 16281.

  q_jk   = c_s max(0, delta_jk)^(10/9),  c_s = 35948 L_we^(8/9)/n_s               [N], lengths in mm
  delta_jk = (delta_r + psi x_k) cos phi_j - s/2 - 2 P(x_k)
  P(x)   = 0.00035 D_we ln(1/(1 - (2 x/L_we)^2))
phi_j angle from the load's direction, psi misalignment in the load's plane, s diametral clearance; rollers have no
mass. Both contacts of a roller together approach by delta. The program holds each contact to 2^(10/9) c_s: the same
law.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

PAIR_STIFFNESS = 35948.0  # c_L [N/mm^(17/9)]
LAMINAE = 41


@dataclass(frozen=True)
class RollerSet:
    """Rollers of a bearing, lengths in mm, misalignment psi in rad."""
    count: int
    diameter: float
    length: float
    clearance: float
    logarithmic: bool = True
    misalignment: float = 0.0

    def places(self, laminae=LAMINAE):
        return ((np.arange(laminae) + 0.5) / laminae - 0.5) * self.length

    def profile(self, places):
        """P(x) [mm]."""
        if not self.logarithmic:
            return np.zeros_like(places)
        return 0.00035 * self.diameter * np.log(1 / (1 - (2 * places / self.length) ** 2))


@dataclass(frozen=True)
class Distribution:
    displacement: float   # delta_r [mm]
    angles: np.ndarray    # phi_j [rad]
    loads: np.ndarray     # of the rollers [N]
    laminae: np.ndarray   # of the laminae [N], rollers in rows

    def largest_line_load(self, length):
        """Of any lamina [N/mm]."""
        return self.laminae.max() * self.laminae.shape[1] / length


def lamina_loads(rollers, displacement, angles, laminae=LAMINAE):
    places = rollers.places(laminae)
    stiffness = PAIR_STIFFNESS * rollers.length ** (8 / 9) / laminae
    approach = (np.outer(np.cos(angles), displacement + rollers.misalignment * places)
                - rollers.clearance / 2 - 2 * rollers.profile(places))
    return stiffness * np.maximum(approach, 0) ** (10 / 9)


def distribution(rollers, load, first_angle=0.0, laminae=LAMINAE):
    """Equilibrium under `load` [N]; the first roller stands at `first_angle` [rad] from the load's direction."""
    angles = first_angle + 2 * np.pi * np.arange(rollers.count) / rollers.count

    def carried(displacement):
        q = lamina_loads(rollers, displacement, angles, laminae)
        return float(q.sum(axis=1) @ np.cos(angles))

    found = brentq(lambda x: carried(x) - load, 0, rollers.clearance + 1.0, xtol=1e-12)
    q = lamina_loads(rollers, found, angles, laminae)
    return Distribution(found, angles, q.sum(axis=1), q)


def laminae_of_load(rollers, load, laminae=LAMINAE):
    """Lamina loads [N] of one straight roller that carries `load` [N]."""
    def under(approach):
        places = rollers.places(laminae)
        stiffness = PAIR_STIFFNESS * rollers.length ** (8 / 9) / laminae
        return stiffness * np.maximum(approach - 2 * rollers.profile(places), 0) ** (10 / 9)

    return under(brentq(lambda a: under(a).sum() - load, 0, 1.0, xtol=1e-13))


def hertz_pressure(line_load, radius, modulus):
    """Largest pressure [MPa] of a line contact; N/mm, mm, MPa."""
    return float(np.sqrt(line_load * modulus / (2 * np.pi * radius)))
