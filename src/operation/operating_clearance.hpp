// What a mounted, warm and turning bearing has for dimensions, against those that its scene gives:
// fits of the rings, temperatures of the parts, moisture of the cage, and growth by rotation. All
// changes are zero unless the scene asks for them ([fit], temperature.growth,
// cage.swelling_percent, speed.centrifugal_growth).
//
//   rings         thick rings from the bore d to the raceway F, and from the raceway E to the
//                 outside D (press_fit.hpp). That is exact for a ring without flanges; shoulders
//                 move as the raceway does, and their stiffness is left out.
//   rollers       D_we (1 + g) + u, u of a solid disc at the spin of rolling without slip,
//                 w_s = (w_c (R_i + R_o)/2 - w_i R_i)/R_roller
//   cage          every length by 1 + g + w; its radii and what lies along its circumference also
//                 by 1 + e, e = m w_c^2 r / (2 pi E A): a thin ring of mean radius r, whose bars
//                 ride on the section A of both side rings. Without pockets e = rho w_c^2 r^2/E.
//   w_c           (w_i R_i + w_o R_o)/(R_i + R_o), speed of the cage without slip
//   g             alpha (T - T_ref), thermal strain
//   w             swelling of a polymer by moisture, alike in all directions; the water's mass is
//                 left out
//
// A flexible cage has the same e; its elastic modes answer centrifugal load besides
// (cage.centrifugal), of which the lowest ones hold next to nothing of a uniform growth.
// Speeds are the full ones of the scene, also during a ramp. A housing without a diameter does not
// grow by rotation.
#pragma once

#include "src/operation/press_fit.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct OperatingClearance {
  Growth inner_raceway, outer_raceway;  ///< of the diameters F and E [m]
  Growth bore, outside;                 ///< of the diameters d and D [m]
  FitState inner_fit{kAuto, 0}, outer_fit{kAuto, 0};
  double inner_ring_heat = 0, outer_ring_heat = 0, roller_heat = 0;  ///< g
  double cage_growth = 0;                                            ///< g + w
  double roller_spin = 0;  ///< growth of a roller's diameter [m]
  double cage_spin = 0;    ///< e

  /// Of the diametral internal clearance with rollers of this diameter [m].
  Growth internal(double roller_diameter) const {
    return {outer_raceway.fit - inner_raceway.fit,
            outer_raceway.heat - inner_raceway.heat - 2 * roller_diameter * roller_heat,
            outer_raceway.spin - inner_raceway.spin - 2 * roller_spin};
  }
};

/// Whether a part of the scene grows by its rotation.
bool grows_by_rotation(const Scene& scene);

/// Whether anything of a scene changes its dimensions in operation.
bool changes_in_operation(const Scene& scene);

OperatingClearance operating_clearance(const Scene& scene);

}  // namespace cagetol
