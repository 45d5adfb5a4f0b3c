"""Friction torque of cylindrical roller bearings by two makers' models, and the minimum load against skidding.

SKF (General Catalogue), torque in N mm, lengths in mm, n in r/min, nu in mm2/s, F in N:
  M    = phi_ish phi_rs G_rr (nu n)^0.6 + mu_sl S2 d_m F
  G_rr = R1 d_m^2.41 F^0.31
  phi_ish = 1/(1 + 1.84e-9 (n d_m)^1.28 nu^0.64)                         shear heating in the inlet
  phi_rs  = exp(-3e-8 nu n (d + D) sqrt(5.1/(2 (D - d))))                 replenishment, oil jet or low bath
  mu_sl   = f_bl 0.15 + (1 - f_bl) 0.02,  f_bl = exp(-2.6e-8 (n nu)^1.4 d_m),  S2 = 0.0015
Palmgren, with Schaeffler's factors:
  M = 1e-7 f0 (nu n)^(2/3) d_m^3 + f1 F d_m,   for nu n < 2000: 160e-7 f0 d_m^3 in place of the first term
Least load: SKF k_r (6 + 4 n/n_ref)(d_m/100)^2 kN; Schaeffler C0/60; NTN 0.04 C0.
d_m = (d + D)/2.
"""

from dataclasses import dataclass
from math import exp, sqrt


@dataclass(frozen=True)
class Series:
    """Factors of one dimension series: SKF's R1 and k_r, Palmgren's f0 (oil bath) and f1."""
    R1: float
    f0: float
    f1: float
    k_r: float


SERIES = {
    "10": Series(1.12e-6, 2, 0.0002, 0.10),
    "2": Series(1.09e-6, 2, 0.0003, 0.15),
    "3": Series(1.09e-6, 2, 0.00035, 0.15),
    "22": Series(1.40e-6, 3, 0.0004, 0.20),
    "23": Series(1.48e-6, 4, 0.0004, 0.25),
}


def skf_torque(series, bore, outside, load, rpm, viscosity):
    """[N mm]; mm, N, r/min, mm2/s."""
    mean = (bore + outside) / 2
    shear = viscosity * rpm
    heating = 1 / (1 + 1.84e-9 * (rpm * mean) ** 1.28 * viscosity ** 0.64)
    replenishment = exp(-3e-8 * shear * (bore + outside) * sqrt(5.1 / (2 * (outside - bore))))
    rolling = heating * replenishment * series.R1 * mean ** 2.41 * load ** 0.31 * shear ** 0.6
    boundary = exp(-2.6e-8 * shear ** 1.4 * mean)
    sliding = (boundary * 0.15 + (1 - boundary) * 0.02) * 0.0015 * mean * load
    return rolling + sliding


def palmgren_torque(series, bore, outside, load, rpm, viscosity):
    """[N mm]; mm, N, r/min, mm2/s."""
    mean = (bore + outside) / 2
    shear = viscosity * rpm
    speed_term = 1e-7 * shear ** (2 / 3) if shear >= 2000 else 160e-7
    return series.f0 * speed_term * mean ** 3 + series.f1 * load * mean


def ratio_to_nearer(torque, skf, palmgren):
    """torque over the nearer model, 1 between the two."""
    low, high = sorted((skf, palmgren))
    return torque / high if torque > high else torque / low if torque < low else 1.0


def skf_minimum_load(series, bore, outside, rpm, reference_rpm):
    """[N]."""
    mean = (bore + outside) / 2
    return 1e3 * series.k_r * (6 + 4 * rpm / reference_rpm) * (mean / 100) ** 2


def schaeffler_minimum_load(static_rating):
    """[N], of C0 [N]."""
    return static_rating / 60


def ntn_minimum_load(static_rating):
    """[N], of C0 [N]."""
    return 0.04 * static_rating
