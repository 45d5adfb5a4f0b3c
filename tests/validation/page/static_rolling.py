"""Torque of rolling resistance without slip: 2 f u of both races summed over a static load distribution.

Every roller presses on the outer race with its share of the load and its centrifugal force m r w_c^2, unloaded ones
with that alone; the inner race of an unloaded roller has no film to speak of. u is the same at both races.
"""

from math import pi

import numpy as np

from contact_forces import rolling_resistance
from film_formulas import LineContact, effective_modulus
from load_distribution import distribution

STEEL = 7810.0  # density of rollers [kg/m3]
PHASES = 40


def rolling_kinematics(bearing, rpm):
    """(ring speed, orbit speed [rad/s], entrainment speed [m/s])"""
    inner, outer = 1e-3 * bearing.inner_race(), 1e-3 * bearing.outer_race()
    ring = rpm * pi / 30
    orbit = ring * inner / (inner + outer)
    return ring, orbit, (ring - orbit) * inner


def centrifugal_force(bearing, rpm):
    """Of a roller [N]."""
    r = bearing.file["roller"]
    mass = r.get("density_kg_m3", STEEL) * pi / 4 * (1e-3 * r["diameter_mm"]) ** 2 * 1e-3 * r["length_mm"]
    return mass * 1e-3 * bearing.pitch / 2 * rolling_kinematics(bearing, rpm)[1] ** 2


def static_rolling(bearing, load, rpm=None, heating=False):
    """(inner race, outer race) torque [N mm], mean over one pitch of roller angles."""
    rpm = rpm or bearing.rpm
    r = bearing.file["roller"]
    roller, length = r["diameter_mm"] / 2e3, 1e-3 * r["length_mm"]
    inner, outer = 1e-3 * bearing.inner_race(), 1e-3 * bearing.outer_race()
    ring, _, speed = rolling_kinematics(bearing, rpm)
    oil = bearing.dynamic_viscosity, bearing.oil[2]
    inside = LineContact(*oil, roller * inner / (roller + inner), effective_modulus(), speed)
    outside = LineContact(*oil, roller * outer / (outer - roller), effective_modulus(), speed)
    fall = bearing.viscosity_fall if heating else 0.0
    pressed = centrifugal_force(bearing, rpm)
    sums = []
    for phase in (np.arange(PHASES) + 0.5) / PHASES * 2 * pi / bearing.file["bearing"]["roller_count"]:
        loads = distribution(bearing.rollers(), load, phase).loads
        sums.append((sum(rolling_resistance(inside, q / length, fall) for q in loads),
                     sum(rolling_resistance(outside, (q + pressed) / length, fall) for q in loads)))
    return tuple(1e3 * 2 * speed * length / ring * np.mean(sums, axis=0))
