// Roller ends against the flanges of the rings, by the points of wall_contacts.hpp. A flange is
// normal to the axis of its ring, which turns at w and may, inside, be displaced by u, x_u and lean
// by B. With rho = (r + h, tau) the point's place in the roller's directions,
//   p = e (x - h a_r - tau a_t - x_u + B . (rho - u)) - c
// The points keep their place beside the roller's orbit and turn with theta'; p depends on that
// angle through `turn` = e dp/d(angle). Sliding speeds are those of the roller's end against the
// flange, radially and tangentially; the force on the ring is the opposite of that on the roller.
// Both surfaces draw oil past the point at the mean of their tangential speeds beside it,
//   u = [spin h - theta' h + (w - theta') (r + h)]/2
#pragma once

#include "src/contacts/contact_frame.hpp"
#include "src/contacts/end_film.hpp"
#include "src/contacts/sphere_flange.hpp"

namespace cagetol {

/// The ring of a flange, in the directions of a pack of rollers.
struct FlangeRing {
  double speed, x = 0, x_rate = 0;
  Pack u_r{}, u_t{}, du_r{}, du_t{}, B_r{}, B_t{};
};
inline FlangeRing inner_flange_ring(const RollerPack& q, const BorderState& b) {
  const auto r = [&](const double v[2]) { return along_r(q, splat(v[0]), splat(v[1])); };
  const auto t = [&](const double v[2]) { return along_t(q, splat(v[0]), splat(v[1])); };
  return {b.speed.inner,  b.ring_axial,   b.ring_axial_rate, r(b.ring), t(b.ring),
          r(b.ring_rate), t(b.ring_rate), r(b.tilt),         t(b.tilt)};
}

/// False where no point of an end can touch the flange, were it `margin` [m] nearer.
inline bool flange_in_reach(const Flange& flange, const RollerGroup& roller, const RollerPack& q,
                            const BorderState& b, Pack margin) {
  Pack reach = flange.side * q.x + roller.radius * (abs(q.a_r) + abs(q.a_t));
  if (flange.inner) {
    const double tilt = std::abs(b.tilt[0]) + std::abs(b.tilt[1]);
    reach += (q.r + 2.0 * roller.radius) * tilt - flange.side * b.ring_axial;
  }
  return any(reach > flange.clearance - margin);
}

/// One point of an end at its flange, with its rows over the roller's directions.
struct FlangePoint {
  double e, xi, h, tau;  ///< end, and place of the point [m]
  Pack turn, lean;       ///< lean: dp/dr over e
  Touch<Pack> touch;
  Pack rate_by[kLocalPositions];  ///< slopes of p'
  Pack v1_by_t, v2_by_t;          ///< of the sliding speeds with the orbit
  Pack drawn, drawn_vt, drawn_r;  ///< u, and its slopes by r theta' and, at that theta', by r
};
template <bool inner>
FlangePoint flange_point(const BearingModel& model, const Flange& flange, const FlangeRing& ring,
                         const RollerPack& q, const EndPoint& point) {
  const double e = flange.side, h = point.radial, tau = point.tangential;
  FlangePoint at{e, e * model.roller_half_length, h, tau, {}, {}, {}, {}, {}, {}, {}, {}, {}};
  at.turn = tau * q.a_r - h * q.a_t;
  at.rate_by[kLt] = tau * q.b_r - h * q.b_t + q.omega * (tau * q.a_t + h * q.a_r);
  at.rate_by[kLar] = tau * q.omega;
  at.rate_by[kLat] = -h * q.omega;
  at.v1_by_t = at.xi * q.b_t / q.r;
  at.v2_by_t = -at.xi * q.b_r / q.r;
  Pack place = q.x - h * q.a_r - tau * q.a_t, along = q.vx - h * q.b_r - tau * q.b_t;
  at.touch.v1 = q.vr + at.xi * q.b_r - (q.spin - ring.speed) * tau;
  at.touch.v2 = q.vt + at.xi * q.b_t + q.spin * h - ring.speed * (q.r + h);
  if constexpr (inner) {
    place += ring.B_r * (q.r + h - ring.u_r) + ring.B_t * (tau - ring.u_t) - ring.x;
    along += ring.B_r * (q.vr - ring.du_r) - ring.B_t * ring.du_t - ring.x_rate;
    at.turn += ring.B_t * (q.r + h) - ring.B_r * tau;
    at.lean = ring.B_r;
    at.rate_by[kLr] = ring.B_t * q.omega;
    at.rate_by[kLt] += ring.B_t * q.vr - (ring.B_r * (q.r + h) + ring.B_t * tau) * q.omega;
    at.touch.v1 -= ring.du_r + ring.speed * ring.u_t;
    at.touch.v2 -= ring.du_t - ring.speed * ring.u_r;
    at.v1_by_t -= (ring.du_t - ring.speed * ring.u_r) / q.r;
    at.v2_by_t += (ring.du_r + ring.speed * ring.u_t) / q.r;
  }
  at.touch.p = e * place - flange.clearance;
  at.touch.rate = e * (along + at.turn * q.omega);
  at.rate_by[kLt] /= q.r;
  for (Pack& slope : at.rate_by) slope *= e;
  at.drawn = 0.5 * ((q.spin - q.omega) * h + (ring.speed - q.omega) * (q.r + h));
  at.drawn_vt = -0.5 * (q.r + 2.0 * h) / q.r;
  at.drawn_r = 0.5 * (ring.speed - q.omega);
  return at;
}

/// What the motion of the inner ring changes: slopes of the normal force `by_p`, `by_rate`, of the
/// forces on the rollers `on_p`, `on_rate`, of the friction by both sliding speeds, and of the lost
/// power. `drawn`: slopes of the normal force by the roller's velocities by way of u; `held`: by
/// its positions by way of u and p'.
struct RingSlopes {
  Pack by_p, by_rate, lost_p, lost_rate, lost_v1, lost_v2;
  Pack d11, d12, d22;
  Pack drawn[kLocalVelocities], held[kLocalPositions];
  Pack gn[kLocalVelocities], on_p[kLocalVelocities], on_rate[kLocalVelocities];
};
/// In the radial plane.
inline void add_plane_block(const RingSlopes& s, const GroupLinear& g, Linearisation& jac) {
  add_turned(g, -s.d11, -s.d12, -s.d12, -s.d22, jac.border_velocity, kRingY, kRingY);
  jac.power_velocity[kRingY] += sum(g.cosine * s.lost_v1 - g.sine * s.lost_v2);
  jac.power_velocity[kRingZ] += sum(g.sine * s.lost_v1 + g.cosine * s.lost_v2);
}
/// Between its axial place and its place in the plane, which a leaning flange ties together.
inline void add_lean_coupling(const RingSlopes& s, const FlangeRing& ring, const GroupLinear& g,
                              Mask wet, int slot, Linearisation& jac) {
  const Pack lean[2] = {select(wet, g.cosine * ring.B_r - g.sine * ring.B_t, Pack{}),
                        select(wet, g.sine * ring.B_r + g.cosine * ring.B_t, Pack{})};
  for (const int k : {kRingY, kRingZ}) {
    const double by_place = sum(lean[k] * s.by_p), by_speed = sum(lean[k] * s.by_rate);
    jac.border_position(k, slot) -= by_place;
    jac.border_position(slot, k) -= by_place;
    jac.border_velocity(k, slot) -= by_speed;
    jac.border_velocity(slot, k) -= by_speed;
  }
}
/// Along the axis, where the ring's place is free: with the rollers that touch.
inline void add_axial_coupling(const RingSlopes& s, double e, Mask wet, int group, int slot,
                               Linearisation& jac) {
  const auto column = static_cast<std::size_t>(slot - kCageY), packs = column / kLanes + 1;
  const auto lane_of_slot = static_cast<int>(column) % kLanes;
  for (int i = 0; i < kLanes; ++i) {
    if (!wet[i]) continue;
    CageCoupling& c = jac.coupling(group * kLanes + i);
    for (int k = 0; k < kLocalVelocities; ++k) {
      const auto at = static_cast<std::size_t>(k) * packs + packs - 1;
      c.position[column][k] -= e * s.on_p[k][i];
      c.velocity[column][k] -= e * s.on_rate[k][i];
      c.to_velocity[at][lane_of_slot] += e * (s.drawn[k][i] - s.by_rate[i] * s.gn[k][i]);
      if (k < kLocalPositions)
        c.to_position[at][lane_of_slot] += e * (s.held[k][i] - s.by_p[i] * s.gn[k][i]);
    }
  }
  jac.border_position(slot, slot) -= sum(select(wet, s.by_p, Pack{}));
  jac.border_velocity(slot, slot) -= sum(select(wet, s.by_rate, Pack{}));
  jac.power_position[slot] += e * sum(select(wet, s.lost_p, Pack{}));
  jac.power_velocity[slot] += e * sum(select(wet, s.lost_rate, Pack{}));
}

/// Derivatives of the forces of one point.
template <bool inner>
RingSlopes add_flange_slopes(const FlangePoint& at, const EndForces& on, const RollerPack& q,
                             double ring_speed, GroupLinear& to) {
  const double e = at.e, xi = at.xi, h = at.h, tau = at.tau;
  const auto& [p, rate, v1, v2] = at.touch;
  const auto& normal = on.contact.normal;
  const auto& fr = on.contact.friction;
  const EndFilm& film = on.film;
  const Pack push = e * on.normal, f1 = -on.drag * v1, f2 = -on.drag * v2;
  const Pack bend = normal.force * fr.bend;
  const Pack d11 = on.drag + bend * v1 * v1, d12 = bend * v1 * v2, d22 = on.drag + bend * v2 * v2;
  RingSlopes by_ring{
      normal.stiffness + film.normal_p,
      normal.damping + film.normal_rate,
      {},
      {},
      {},
      {},
      d11,
      d12,
      d22,
      {},
      {},
      {-e * at.lean, -e * at.turn / q.r, splat(-e), splat(e * h), splat(e * tau), Pack{}},
      {},
      {}};
  by_ring.drawn[kLt] = film.normal_speed * at.drawn_vt;
  by_ring.drawn[kLs] = film.normal_speed * (0.5 * h);
  for (int j = 0; j < kLocalPositions; ++j) by_ring.held[j] = by_ring.by_rate * at.rate_by[j];
  by_ring.held[kLr] += film.normal_speed * at.drawn_r;
  const Pack(&gn)[kLocalVelocities] = by_ring.gn;
  const double g1[] = {1, 0, 0, xi, 0, -tau}, g2[] = {0, 1, 0, 0, xi, h};
  auto lost = dissipation_slopes(normal.force, normal.stiffness, normal.damping, fr.ratio, fr.bend,
                                 v1, v2, normal.elastic, normal.elastic_stiffness, rate);
  lost.p += film.normal_p * rate + film.drag_p * on.contact.squared;
  lost.rate += film.normal_rate * rate + film.normal;
  lost.v1 += 2.0 * film.drag * v1;
  lost.v2 += 2.0 * film.drag * v2;
  by_ring.lost_p = lost.p, by_ring.lost_rate = lost.rate;
  // Its motion in the plane also changes the power that drives it.
  by_ring.lost_v1 = lost.v1 + ring_speed * ((q.r + h) * d12 - tau * d11);
  by_ring.lost_v2 = lost.v2 + ring_speed * ((q.r + h) * d22 - tau * d12);
  // Points and directions turn with the orbit, and so do the forces; add_inertial, which takes
  // these for held still, does the same again: less that.
  to.position[kLr][kLt] -= (f2 - push * at.turn / q.r) / q.r;
  to.position[kLt][kLt] += f1 / q.r;
  to.position[kLar][kLt] -= (xi * f2 + tau * push) / q.r;
  to.position[kLat][kLt] += (xi * f1 + h * push) / q.r;
  const Pack v1_held = at.v1_by_t + q.omega, v2_held = at.v2_by_t - q.vr / q.r;
  to.power_position[kLr] +=
      lost.v2 * ring_speed + ring_speed * f2 - rate * film.normal_speed * at.drawn_r;
  to.power_position[kLt] -= lost.v1 * v1_held + lost.v2 * v2_held;
  for (int i = 0; i < kLocalVelocities; ++i) {
    to.power_velocity[i] +=
        lost.rate * gn[i] - lost.v1 * g1[i] - lost.v2 * g2[i] - rate * by_ring.drawn[i];
    if (i < kLocalPositions) to.power_position[i] += lost.p * gn[i] - lost.rate * at.rate_by[i];
    const Pack sliding = v1 * g1[i] + v2 * g2[i], slide = gn[i] - fr.ratio * sliding;
    const Pack stiffness = slide * normal.stiffness + gn[i] * film.normal_p - film.drag_p * sliding;
    const Pack damped = slide * normal.damping + gn[i] * film.normal_rate;
    const Pack w1 = d11 * g1[i] + d12 * g2[i], w2 = d12 * g1[i] + d22 * g2[i];
    // The ring is driven by the friction that turns the roller about the bearing's axis.
    const Pack rubs_by_p = stiffness - gn[i] * by_ring.by_p,
               rubs_by_rate = damped - gn[i] * by_ring.by_rate;
    const Pack driven = i == kLt ? ring_speed * q.r : splat(i == kLs ? ring_speed : 0);
    by_ring.on_p[i] = stiffness, by_ring.on_rate[i] = damped;
    by_ring.lost_p -= driven * rubs_by_p, by_ring.lost_rate -= driven * rubs_by_rate;
    if constexpr (inner) {
      to.ring.velocity[i][0] += w1;
      to.ring.velocity[i][1] += w2;
    }
    for (int j = 0; j < kLocalVelocities; ++j) {
      const Pack rubs = w1 * g1[j] + w2 * g2[j],
                 slope = damped * gn[j] + rubs - gn[i] * by_ring.drawn[j];
      to.velocity[i][j] -= slope;
      to.power_velocity[j] -= driven * (rubs_by_rate * gn[j] + rubs);
      if (inner && i < 2) to.ring.to_velocity[i][j] += slope;  // the ring's r, t
    }
    for (int j = 0; j < kLocalPositions; ++j) {
      to.position[i][j] += damped * at.rate_by[j] - stiffness * gn[j];
      to.power_position[j] += driven * (rubs_by_rate * at.rate_by[j] - rubs_by_p * gn[j]);
      if (inner && i < 2) to.ring.to_position[i][j] += stiffness * gn[j];
    }
    to.position[i][kLr] += gn[i] * film.normal_speed * at.drawn_r - (q.omega - ring_speed) * w2;
    to.position[i][kLt] -= w1 * at.v1_by_t + w2 * at.v2_by_t;
    // Held still, directions leave out what turns the roller's velocity.
    to.power_position[kLr] += driven * ring_speed * w2;
    to.power_position[kLt] -= driven * (w1 * v1_held + w2 * v2_held);
  }
  return by_ring;
}

/// One flange.
template <bool linear, bool inner>
void flange_contact(const BearingModel& model, const Flange& flange, const FlangeRing& ring,
                    const RollerGroup& roller, const RollerPack& q, int group, RollerLoads& loads,
                    BorderLoads& border, Linearisation* jac, Observation* seen) {
  const FlatFilm& oil = flange.film;
  for (const EndPoint& point : flange.points) {
    const FlangePoint at = flange_point<inner>(model, flange, ring, q, point);
    const Touch<Pack>& touch = at.touch;
    const Mask wet = (touch.p > -oil.layer) & (roller.exists > 0.0);
    if (!any(wet)) continue;
    const EndForces on =
        end_forces<linear>(model.flange, model.friction[kFlangePair], oil, touch, wet, at.drawn);
    const Pack push = at.e * on.normal, f1 = -on.drag * touch.v1, f2 = -on.drag * touch.v2;
    loads.f[kLr] += f1;
    loads.f[kLt] += f2 - push * at.turn / q.r;
    loads.f[kLx] -= push;
    loads.f[kLar] += at.xi * f1 + at.h * push;
    loads.f[kLat] += at.xi * f2 + at.tau * push;
    loads.f[kLs] += at.h * f2 - at.tau * f1;
    if constexpr (inner) {
      loads.f[kLr] -= push * at.lean;
      const Pack on_r = push * ring.B_r - f1, on_t = push * ring.B_t - f2;
      border.ring[0] += sum(q.cosine * on_r - q.sine * on_t);
      border.ring[1] += sum(q.sine * on_r + q.cosine * on_t);
      border.ring_axial += sum(push);
    }
    if constexpr (linear) {
      observe_end(on, model.flange, oil, touch, kFlangeFriction,
                  seen->flange_force.data() + group * kLanes, *seen);
      const Pack u_r = inner ? ring.u_r : Pack{}, u_t = inner ? ring.u_t : Pack{};
      seen->drive_power += ring.speed * sum((q.r + at.h - u_r) * f2 - (at.tau - u_t) * f1);
      GroupLinear& linear_group = jac->groups[static_cast<std::size_t>(group)];
      const RingSlopes slopes = add_flange_slopes<inner>(at, on, q, ring.speed, linear_group);
      if constexpr (inner) add_plane_block(slopes, linear_group, *jac);
      if (inner && model.layout.ring_axial > 0) {
        const int slot = model.layout.ring_axial_slot();
        add_axial_coupling(slopes, at.e, wet, group, slot, *jac);
        add_lean_coupling(slopes, ring, linear_group, wet, slot, *jac);
      }
    }
  }
}

template <bool linear>
void flange_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                     const BorderState& b, int group, RollerLoads& loads, BorderLoads& border,
                     Linearisation* jac, Observation* seen) {
  for (const Flange& flange : model.flanges) {
    if (flange.sphere.on) {
      sphere_flange(model, flange, roller, q, b, group, loads, border, jac, seen);
      continue;
    }
    if (!flange_in_reach(flange, roller, q, b, splat(flange.film.layer))) continue;
    if (flange.inner)
      flange_contact<linear, true>(model, flange, inner_flange_ring(q, b), roller, q, group, loads,
                                   border, jac, seen);
    else
      flange_contact<linear, false>(model, flange, {b.speed.outer}, roller, q, group, loads, border,
                                    jac, seen);
  }
}

}  // namespace cagetol
