"""Rolling resistance and sliding traction of a line contact, per length. SI units.

  f   = (f_E^-3 + f_I^-3)^(-1/3)
  f_E = 4.317 (alpha eta u/R)^0.658228 W^0.012658 R/alpha,  W = q/(E' R)      Goksem and Hargreaves 1978, isothermal
  f_I = 2.0796 sqrt(eta u q)                                                  rigid, by Reynolds' equation
acts on each of the two surfaces; the power lost is 2 f u. Shear heating in the inlet replaces f_E by
  f_E = W K R/alpha,  D = 11.81220746 alpha E' (eta u/(E' R))/W^1.5,  L = eta beta u^2/k
  ln K = (0.658228 + 0.0106383 L^0.3174603) ln D - (0.162625 + ln(1 + 0.411483 L^0.707071))

Traction of the film in the Hertz zone (b half width, p mean pressure) and of the inlet:
  tau  = tau_E asinh(eta_p du/(tau_E h)),   eta_p = eta exp(a),  a = alpha p/(1 + (alpha p/15)^8)^(1/8)
  mu q = 2 b tau/sqrt(1 + (tau/(Lambda p))^2) + 2.849 eta du sqrt(R/h)
"""

from math import asinh, exp, log, pi, sqrt

CONDUCTIVITY = 0.14  # k of the oil [W/(m K)]


def elastic_rolling(contact, load):
    W = load / (contact.modulus * contact.radius)
    alpha = contact.pressure_viscosity
    entrained = alpha * contact.viscosity * contact.speed / contact.radius
    return 4.317 * entrained ** 0.658228 * W ** 0.012658 * contact.radius / alpha


def rigid_rolling(contact, load):
    return 2.0796 * sqrt(contact.viscosity * contact.speed * load)


def heated_rolling(contact, load, fall):
    """f_E [N/m] with heating; `fall`: beta [1/K]."""
    U, G, W = contact.numbers(load)
    heating = contact.viscosity * fall * contact.speed ** 2 / CONDUCTIVITY
    return W * exp(log_rolling(11.81220746 * G * U / W ** 1.5, heating)) * contact.radius / contact.pressure_viscosity


def log_rolling(D, L):
    """ln K."""
    return (0.658228 + 0.0106383 * L ** 0.3174603) * log(D) - (0.162625 + log(1 + 0.411483 * L ** 0.707071))


def rolling_resistance(contact, load, fall=0.0):
    """f [N/m] at q = load [N/m], with heating where `fall` = beta is given; 0 without load."""
    if load <= 0:
        return 0.0
    elastic = heated_rolling(contact, load, fall) if fall else elastic_rolling(contact, load)
    return (elastic ** -3 + rigid_rolling(contact, load) ** -3) ** (-1 / 3)


def traction_coefficient(contact, load, film, sliding, eyring=5e6, limiting=0.06):
    """Friction coefficient of the film alone at sliding speed du [m/s] and thickness `film` [m]."""
    half_width = sqrt(8 * load * contact.radius / (pi * contact.modulus))
    pressure = load / (2 * half_width)
    barus = contact.pressure_viscosity * pressure
    thickened = contact.viscosity * exp(barus / (1 + (barus / 15) ** 8) ** 0.125)
    stress = eyring * asinh(thickened * sliding / (eyring * film))
    limited = stress / sqrt(1 + (stress / (limiting * pressure)) ** 2)
    inlet = 2.849 * contact.viscosity * sliding * sqrt(contact.radius / film)
    return (2 * half_width * limited + inlet) / load
