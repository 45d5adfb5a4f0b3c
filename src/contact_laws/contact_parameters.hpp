// Parameters of contacts as the laws read them: normal_force.hpp, friction.hpp.
#pragma once

#include "src/input/given.hpp"

namespace cagetol {

/// Normal force law; impact: Adams IMPACT, hertz: line contact with Hunt-Crossley damping.
enum class ForceLaw { impact, hertz };

/// Parameters of one contact kind.
struct ContactParameters {
  ForceLaw law = ForceLaw::impact;
  /// K of `impact` in N/mm^e, as in [P] Table 1; make_normal_law() converts it.
  double stiffness = 1.5e5;
  double exponent = 10.0 / 9.0;    ///< e
  double damping = 750e3;          ///< c_max [N s/m]
  double damping_depth = 0.1e-3;   ///< d, penetration at which damping reaches c_max [m]
  double restitution = 0.9;        ///< coefficient of `hertz` at restitution_speed
  double restitution_speed = 0.1;  ///< [m/s]
  /// Friction (src/contact_laws/friction.hpp); kAuto: the values of Contacts.
  double friction_static = kAuto, friction_dynamic = kAuto, static_speed = kAuto,
         dynamic_speed = kAuto;
  double roughness = kAuto;  ///< composite, rms; kAuto: the value of Lubrication [m]
};

}  // namespace cagetol
