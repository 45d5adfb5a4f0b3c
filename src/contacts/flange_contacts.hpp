// Roller ends against the flanges of the outer ring, by the points of wall_contacts.hpp. The flange
// is normal to the bearing's axis:
//   p = e (x - h a_r - tau a_t) - c_fl/2
// and turns with its ring.
// The points keep their place beside the roller's orbit and turn with theta'; p depends on that
// angle through `turn` = e dp/d(angle) at a centre held still.
#pragma once

#include "src/contacts/contact_frame.hpp"
#include "src/contacts/end_film.hpp"

namespace cagetol {

/// False where no point of an end can touch its flange, were flanges `margin` [m] nearer.
inline bool flanges_in_reach(const BearingModel& model, const RollerGroup& roller,
                             const RollerPack& q, Pack margin) {
  const Pack reach = abs(q.x) + roller.radius * (abs(q.a_r) + abs(q.a_t));
  return any(reach > model.flange_half_clearance - margin);
}

/// One point of an end at its flange, with its rows over the roller's directions.
struct FlangePoint {
  double e, xi, h, tau;  ///< end, and place of the point [m]
  Pack turn;
  Touch<Pack> touch;
};
inline FlangePoint flange_point(const BearingModel& model, const RollerPack& q, double ring_speed,
                                double e, const EndPoint& point) {
  FlangePoint at{e, e * model.roller_half_length, point.radial, point.tangential, {}, {}};
  at.turn = at.tau * q.a_r - at.h * q.a_t;
  at.touch.p = e * (q.x - at.h * q.a_r - at.tau * q.a_t) - model.flange_half_clearance;
  at.touch.rate = e * (q.vx - at.h * q.b_r - at.tau * q.b_t + at.turn * q.omega);
  at.touch.v1 = q.vr + at.xi * q.b_r - (q.spin - ring_speed) * at.tau;
  at.touch.v2 = q.vt + at.xi * q.b_t + q.spin * at.h - ring_speed * (q.r + at.h);
  return at;
}

/// Derivatives of the forces of one point.
inline void add_flange_slopes(const FlangePoint& at, const EndForces& on, const RollerPack& q,
                              double ring_speed, GroupLinear& to) {
  const double e = at.e, xi = at.xi, h = at.h, tau = at.tau;
  const auto& [p, rate, v1, v2] = at.touch;
  const auto& normal = on.contact.normal;
  const auto& fr = on.contact.friction;
  const EndFilm& film = on.film;
  const Pack push = e * on.normal, f1 = -on.drag * v1, f2 = -on.drag * v2;
  const Pack bend = normal.force * fr.bend;
  const Pack d11 = on.drag + bend * v1 * v1, d12 = bend * v1 * v2, d22 = on.drag + bend * v2 * v2;
  const Pack gn[] = {Pack{}, -e * at.turn / q.r, splat(-e), splat(e * h), splat(e * tau), Pack{}};
  const double g1[] = {1, 0, 0, xi, 0, -tau}, g2[] = {0, 1, 0, 0, xi, h};
  auto lost = dissipation_slopes(normal.force, normal.stiffness, normal.damping, fr.ratio, fr.bend,
                                 v1, v2, normal.elastic, normal.elastic_stiffness, rate);
  lost.p += film.normal_p * rate + film.drag_p * on.contact.squared;
  lost.rate += film.normal_rate * rate + film.normal;
  lost.v1 += 2.0 * film.drag * v1;
  lost.v2 += 2.0 * film.drag * v2;
  // Points and directions turn with the orbit, and so do the forces; add_inertial, which takes
  // these for held still, does the same again: less that.
  const Pack rate_turn =
      e * (tau * q.b_r - h * q.b_t + q.omega * (tau * q.a_t + h * q.a_r));  // dp'/d(theta)
  to.position[kLr][kLt] -= (f2 - push * at.turn / q.r) / q.r;
  to.position[kLt][kLt] += f1 / q.r;
  to.position[kLar][kLt] -= (xi * f2 + tau * push) / q.r;
  to.position[kLat][kLt] += (xi * f1 + h * push) / q.r;
  for (int i = 0; i < kLocalVelocities; ++i) {
    to.power_velocity[i] += lost.rate * gn[i] - lost.v1 * g1[i] - lost.v2 * g2[i];
    if (i < kLocalPositions) to.power_position[i] += lost.p * gn[i];
    const Pack sliding = v1 * g1[i] + v2 * g2[i], slide = gn[i] - fr.ratio * sliding;
    const Pack stiffness = slide * normal.stiffness + gn[i] * film.normal_p - film.drag_p * sliding;
    const Pack damped = slide * normal.damping + gn[i] * film.normal_rate;
    const Pack w1 = d11 * g1[i] + d12 * g2[i], w2 = d12 * g1[i] + d22 * g2[i];
    // The ring is driven by what turns the roller about the bearing's axis.
    const Pack driven = i == kLt ? ring_speed * q.r : splat(i == kLs ? ring_speed : 0);
    for (int j = 0; j < kLocalVelocities; ++j) {
      const Pack slope = damped * gn[j] + w1 * g1[j] + w2 * g2[j];
      to.velocity[i][j] -= slope;
      to.power_velocity[j] -= driven * slope;
    }
    for (int j = 0; j < kLocalPositions; ++j) {
      to.position[i][j] -= stiffness * gn[j];
      to.power_position[j] -= driven * stiffness * gn[j];
    }
    to.position[i][kLr] -= (q.omega - ring_speed) * w2;
    to.position[i][kLt] += (damped * rate_turn - xi * (w1 * q.b_t - w2 * q.b_r)) / q.r;
    to.position[i][kLar] += e * q.omega * tau * damped;
    to.position[i][kLat] -= e * q.omega * h * damped;
  }
}

template <bool linear>
void flange_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                     double ring_speed, int group, RollerLoads& loads, Linearisation* jac,
                     Observation* seen) {
  const FlatFilm& oil = model.flange_film;
  if (!flanges_in_reach(model, roller, q, splat(oil.layer))) return;
  for (const double e : {-1.0, 1.0})
    for (const EndPoint& point : model.flange_points) {
      const FlangePoint at = flange_point(model, q, ring_speed, e, point);
      const Touch<Pack>& touch = at.touch;
      const Mask wet = (touch.p > -oil.layer) & (roller.exists > 0.0);
      if (!any(wet)) continue;
      const EndForces on =
          end_forces<linear>(model.flange, model.friction[kFlangePair], oil, touch, wet);
      const Pack push = e * on.normal, f1 = -on.drag * touch.v1, f2 = -on.drag * touch.v2;
      loads.f[kLr] += f1;
      loads.f[kLt] += f2 - push * at.turn / q.r;
      loads.f[kLx] -= push;
      loads.f[kLar] += at.xi * f1 + at.h * push;
      loads.f[kLat] += at.xi * f2 + at.tau * push;
      loads.f[kLs] += at.h * f2 - at.tau * f1;
      if constexpr (linear) {
        observe_end(on, model.flange, oil, touch, kFlangeFriction,
                    seen->flange_force.data() + group * kLanes, *seen);
        seen->drive_power += ring_speed * sum((q.r + at.h) * f2 - at.tau * f1);
        add_flange_slopes(at, on, q, ring_speed, jac->groups[static_cast<std::size_t>(group)]);
      }
    }
}

}  // namespace cagetol
