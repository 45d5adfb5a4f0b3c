"""Film thickness of a line contact. SI units.

  Dowson-Higginson   h = 2.65  U^0.70  G^0.54  W^-0.13  R        minimum film, elastic and piezoviscous
  Pan-Hamrock        h = 1.714 U^0.694 G^0.568 W^-0.128 R        minimum film, likewise
  rigid, isoviscous  h = 4.895 eta u R/q                          Martin's contact, by Reynolds' equation
  U = eta u/(E' R),  G = alpha E',  W = q/(E' R)
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class LineContact:
    """Oil and bodies: eta [Pa s], alpha [1/Pa], R [m], E' [Pa], u the entrainment speed [m/s]."""
    viscosity: float
    pressure_viscosity: float
    radius: float
    modulus: float
    speed: float

    def numbers(self, load):
        """(U, G, W) at q = load [N/m]."""
        scale = self.modulus * self.radius
        return self.viscosity * self.speed / scale, self.pressure_viscosity * self.modulus, load / scale


def effective_modulus(young=208e9, poisson=0.3):
    """E' of two equal bodies [Pa]."""
    return young / (1 - poisson ** 2)


def dowson_higginson(contact, load):
    """[m] at q = load [N/m]."""
    U, G, W = contact.numbers(load)
    return 2.65 * U ** 0.70 * G ** 0.54 * W ** -0.13 * contact.radius


def pan_hamrock(contact, load):
    U, G, W = contact.numbers(load)
    return 1.714 * U ** 0.694 * G ** 0.568 * W ** -0.128 * contact.radius


def rigid_isoviscous(contact, load):
    return 4.895 * contact.viscosity * contact.speed * contact.radius / load


def both_regimes(contact, load):
    """(h_E^4 + h_I^4)^(1/4), h_E Dowson-Higginson."""
    return (dowson_higginson(contact, load) ** 4 + rigid_isoviscous(contact, load) ** 4) ** 0.25
