"""Load ratings of a radial cylindrical roller bearing (one row, steel) from its rollers.

  C  = b_m f_c L_we^(7/9) Z^(3/4) D_we^(29/27)                     [N], lengths in mm   ISO 281:2007, 7.1
  f_c = 207.9 lv g^(2/9) (1 - g)^(29/27) / (1 + g)^(1/4)
        {1 + [1.04 ((1 - g)/(1 + g))^(143/108)]^(9/2)}^(-2/9)      lv = 0.83, g = D_we/D_pw   ISO/TR 1281-1
  C0 = 44 (1 - g) Z L_we D_we                                      [N]                  ISO 76:2006, 7.1

b_m = 1.1 is the factor of ISO 281 for contemporary steel; ratings that SKF has raised ("Explorer") fit 1.26.
"""

STANDARD_FACTOR = 1.1
EXPLORER_FACTOR = 1.26
REDUCTION = 0.83  # lambda nu: unequal pressure along and between rollers


def geometry_factor(ratio):
    """f_c for g = D_we/D_pw."""
    slim = (1 - ratio) / (1 + ratio)
    inner_and_outer = (1 + (1.04 * slim ** (143 / 108)) ** 4.5) ** (-2 / 9)
    one_ring = 207.9 * REDUCTION * ratio ** (2 / 9) * (1 - ratio) ** (29 / 27) / (1 + ratio) ** 0.25
    return one_ring * inner_and_outer


def dynamic_rating(count, diameter, length, pitch, factor=STANDARD_FACTOR):
    """C [N]; diameter D_we, length L_we, pitch D_pw [mm]."""
    return (factor * geometry_factor(diameter / pitch) * length ** (7 / 9) * count ** 0.75
            * diameter ** (29 / 27))


def static_rating(count, diameter, length, pitch):
    """C0 [N]."""
    return 44 * (1 - diameter / pitch) * count * length * diameter


def length_for_dynamic(rating, count, diameter, pitch, factor=STANDARD_FACTOR):
    """L_we [mm] that gives C [N]."""
    return (rating / dynamic_rating(count, diameter, 1.0, pitch, factor)) ** (9 / 7)


def length_for_static(rating, count, diameter, pitch):
    """L_we [mm] that gives C0 [N]."""
    return rating / static_rating(count, diameter, 1.0, pitch)


def rollers_for(dynamic, static, diameter, pitch, factor=STANDARD_FACTOR, counts=range(8, 40)):
    """(Z, L_we, error of C, error of C0): the number of rollers at which one length meets both ratings best."""
    best = None
    for count in counts:
        length = (length_for_dynamic(dynamic, count, diameter, pitch, factor)
                  * length_for_static(static, count, diameter, pitch)) ** 0.5
        errors = (dynamic_rating(count, diameter, length, pitch, factor) / dynamic - 1,
                  static_rating(count, diameter, length, pitch) / static - 1)
        worst = max(abs(e) for e in errors)
        if best is None or worst < best[0]:
            best = (worst, count, length, *errors)
    return best[1:]
