"""Viscosity of an oil over temperature, by Walther (ASTM D341).

  log10 log10(nu + 0.7) = A - B log10 T        nu in mm2/s, T in K
  beta = -d ln nu/dT                           [1/K]
"""

from math import log, log10

KELVIN = 273.15


def curve(at_40, at_100):
    """(A, B) of an oil with these viscosities at 40 and 100 degC."""
    low, high = (log10(log10(nu + 0.7)) for nu in (at_40, at_100))
    B = (low - high) / (log10(100 + KELVIN) - log10(40 + KELVIN))
    return low + B * log10(40 + KELVIN), B


def viscosity(oil, celsius):
    """nu [mm2/s]."""
    A, B = oil
    return 10 ** 10 ** (A - B * log10(celsius + KELVIN)) - 0.7


def viscosity_fall(oil, celsius):
    """beta [1/K]."""
    nu = viscosity(oil, celsius)
    return oil[1] * (nu + 0.7) * log(nu + 0.7) / (nu * (celsius + KELVIN))
