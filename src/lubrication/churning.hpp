// Drag of the oil and air in the free space (drag.hpp) on rollers and cage:
//
//   roller            F = 1/2 rho C_d D L v |v|,   v = r theta' - kappa r phi'
//   side of the cage  M = disc_moment((1 - kappa) phi')          each of two
//   bore of the cage  M = gap_moment(w_i - phi')                 drives it, brakes the inner ring
//   its outside       M = gap_moment(phi' - w_o)          brakes it, drives the outer ring
//
// phi' cage speed, theta' orbit of a roller at radius r, w_i, w_o speeds of the rings [rad/s],
// kappa share of the cage's speed at which the fluid turns. The surface that is guided has its own
// film (guide_film.hpp) and none of this. Rollers give their power to the fluid, not to the cage.
#pragma once

#include "src/lubrication/drag.hpp"

namespace cagetol {

struct Churning {
  bool on = false;
  double roller = 0;         ///< 1/2 rho C_d D L [kg/m]
  double carried_along = 0;  ///< kappa
  FreeSpaceFluid fluid;
  double inner_radius = 0, outer_radius = 0, width = 0;  ///< of the cage [m]
  double bore_gap = 0, outer_gap = 0;                    ///< 0: guided there, or touching [m]
};

/// Moments along their turning, and the power that the fluid takes.
template <class T>
struct ChurningLoads {
  T cage, inner, outer;  ///< [N m]
  T lost;                ///< [W]
};

template <class T>
ChurningLoads<T> cage_churning(const Churning& c, T cage_speed, double inner_speed,
                               double outer_speed) {
  const T sides = 2.0 * disc_moment(c.fluid, (1 - c.carried_along) * cage_speed, c.outer_radius,
                                    c.inner_radius);
  T bore{}, outside{};
  if (c.bore_gap > 0)
    bore = gap_moment(c.fluid, inner_speed - cage_speed, c.inner_radius, c.width, c.bore_gap);
  if (c.outer_gap > 0)
    outside = gap_moment(c.fluid, cage_speed - outer_speed, c.outer_radius, c.width, c.outer_gap);
  return {bore - sides - outside, -1.0 * bore, outside,
          bore * (inner_speed - cage_speed) + sides * cage_speed +
              outside * (cage_speed - outer_speed)};
}

}  // namespace cagetol
