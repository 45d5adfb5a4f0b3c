// Normal force of one contact point, slice or station.
//
//   impact:  Q = max(0, K p^e + c_max S(p/d) p')
//   hertz:   Q = K p^e max(0, 1 + chi p'),   e = 10/9,   K = 77,652 L^(8/9) N/mm^(10/9)
//
// p penetration [m], p' its rate [m/s], positive while the bodies approach; Q = 0 for p <= 0. The
// clamp at zero is part of the law: without it the damper would pull the bodies together as they
// separate.
//
// Sources. impact: Adams IMPACT; Xin et al. 2024 (doi 10.3390/app14209433) eq. (5). hertz: line
// contact of steel on steel, L in mm, K of one contact, which is 2^(10/9) times c_L of ISO/TS 16281
// (of the roller's two contacts in series). Palmgren's formula is 3.8 % stiffer:
//   delta = 3.84e-5 Q^0.9/L^0.8
// It goes with (Q/E')^0.9: of another pair of materials K is that of steel times E'/E'_steel. What
// the two-dimensional theory says instead: line_approach.hpp.
//
// Penetrations are scaled by 1 um inside, so that the power is taken of numbers near one.
#pragma once

#include "src/contact_laws/contact_parameters.hpp"
#include "src/contact_laws/step.hpp"
#include "src/numerics/fixed_power.hpp"

namespace cagetol {

struct NormalLaw {
  bool hertz = false;
  double stiffness = 0;  ///< K (1 um)^e [N]
  double exponent = 10.0 / 9.0;
  FixedPower softening{1.0 / 9.0};  ///< to the exponent less one
  double damping = 0;               ///< c_max [N s/m], impact only
  double inverse_depth = 0;         ///< 1/d [1/m], impact only
  double chi = 0;                   ///< [s/m], hertz only
};

/// E' (hertz_line.hpp) of steel on steel, for which K is stated [Pa].
inline constexpr double kSteelModulus = 2 / ((1 - 0.3 * 0.3) / 208e9 + (1 - 0.3 * 0.3) / 208e9);

/// Makes a law of `shares` equal parts (slices, stations, points, lands) of one contact. `length`
/// is the contact's length [m], `modulus` E' of its two bodies [Pa] (both hertz only). Throws
/// std::domain_error if the restitution coefficient is not in (0, 1].
NormalLaw make_normal_law(const ContactParameters& parameters, double length, long shares,
                          double modulus = kSteelModulus);

/// chi of the Hunt-Crossley damper that gives the coefficient `restitution` e at approach speed
/// `speed` v_in [m/s]. With u = chi v_in and w = chi v_out = e u, the energy balance is exactly
///   u - ln(1 + u) = -w - ln(1 - w)
/// whatever the exponent.
double hunt_crossley_chi(double restitution, double speed);

template <class T>
struct NormalForce {
  T force;              ///< Q [N]
  T elastic;            ///< K p^e [N]
  T stiffness;          ///< dQ/dp [N/m]
  T damping;            ///< dQ/dp' [N s/m]
  T elastic_stiffness;  ///< d(K p^e)/dp [N/m]
};

/// Inlined, so that what the caller does not look at is not computed.
template <class T>
[[gnu::always_inline]] inline NormalForce<T> normal_force(const NormalLaw& law, T p, T rate) {
  const auto touching = p > 0.0;
  const T scaled = select(touching, p * 1e6, T{} + 1.0);
  const T w = law.stiffness * law.softening(scaled);
  const T elastic = w * scaled;
  const T slope = 1e6 * law.exponent * w;
  T force, stiffness, damping;
  if (law.hertz) {
    const T factor = 1.0 + law.chi * rate;
    force = elastic * factor;
    stiffness = slope * factor;
    damping = elastic * law.chi;
  } else {
    const T z = p * law.inverse_depth;
    damping = law.damping * smooth_step(z);
    force = elastic + damping * rate;
    stiffness = slope + law.damping * law.inverse_depth * smooth_step_slope(z) * rate;
  }
  const auto pushing = force > 0.0;
  const T zero{};
  return {select(touching, max(force, zero), zero), select(touching, elastic, zero),
          select(touching, select(pushing, stiffness, zero), zero),
          select(touching, select(pushing, damping, zero), zero), select(touching, slope, zero)};
}

/// Elastic energy K p^(e+1)/(e+1) [J].
template <class T>
T elastic_energy(const NormalLaw& law, T p) {
  const T scaled = select(p > 0.0, p * 1e6, T{} + 1.0);
  const T energy =
      law.stiffness * power(scaled, law.exponent + 1.0) * (1e-6 / (law.exponent + 1.0));
  return select(p > 0.0, energy, T{});
}

/// Penetration at which the elastic force is `force` [m].
double elastic_penetration(const NormalLaw& law, double force);

}  // namespace cagetol
