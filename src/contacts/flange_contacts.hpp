// Roller ends against the flanges of the rings, by the points of wall_contacts.hpp. A flange is
// normal to the axis of its ring, which turns at w and may, inside, be displaced by u, x_u and lean
// by B. With rho = (r + h, tau) the point's place in the roller's directions,
//   p = e (x - h a_r - tau a_t - x_u + B . (rho - u)) - c
// The points keep their place beside the roller's orbit and turn with theta'; p depends on that
// angle through `turn` = e dp/d(angle). Sliding speeds are those of the roller's end against the
// flange, radially and tangentially; the force on the ring is the opposite of that on the roller.
// Both surfaces draw oil past the point at the mean of their tangential speeds beside it,
//   u = [spin h - theta' h + (w - theta') (r + h)]/2
// Derivatives by dual numbers; what is left out of them: src/NOTATION.md.
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

/// What a point's forces depend on: positions and velocities of the roller (enum Local), and what
/// counts of the inner ring's motion: sliding along e_r and e_t, axial place and its rate.
inline constexpr int kFlangeSpeed = kLocalPositions;
enum { kSlideR = kFlangeSpeed + kLocalVelocities, kSlideT, kRingX, kRingXRate, kFlangeMotions };
template <bool inner>
using FlangeSlopes = Dual<Pack, inner ? int{kFlangeMotions} : int{kSlideR}>;

/// A vector of the radial plane in a roller's directions. It stands still in space, so that going
/// round turns its parts into each other.
template <class T>
struct PlaneVector {
  T r, t;
};
template <class T>
PlaneVector<T> held_still(const RollerPack& q, Pack r, Pack t) {
  const Pack zero{};
  return {with_slopes<T>(r, zero, t / q.r), with_slopes<T>(t, zero, -r / q.r)};
}

/// One point of an end at its flange. T: Pack, or with slopes by the roller's positions, at theta'
/// and all other rates held.
template <class T>
struct FlangePoint {
  Pack turn, lean;          ///< lean: dp/dr over e
  T motion[kEndVariables];  ///< p, p', both sliding speeds, u
};
template <class T, bool inner>
FlangePoint<T> flange_point(const BearingModel& model, const Flange& flange, const FlangeRing& ring,
                            const RollerPack& q, const EndPoint& point) {
  const double e = flange.side, h = point.radial, tau = point.tangential,
               xi = e * model.roller_half_length;
  PlaneVector<T> a = held_still<T>(q, q.a_r, q.a_t);
  const PlaneVector<T> b = held_still<T>(q, q.b_r, q.b_t);
  if constexpr (!std::is_same_v<T, Pack>) a.r.slope[kLar] = a.t.slope[kLat] = splat(1);
  const T out = variable<T>(q.r, kLr) + h;
  T place = variable<T>(q.x, kLx) - h * a.r - tau * a.t, along = q.vx - h * b.r - tau * b.t,
    turn = tau * a.r - h * a.t;
  T v1 = q.vr + xi * b.r - (q.spin - ring.speed) * tau;
  T v2 = follow(out, q.vt, q.omega) + xi * b.t + q.spin * h - ring.speed * out;
  if constexpr (inner) {
    const PlaneVector<T> B = held_still<T>(q, ring.B_r, ring.B_t),
                         u = held_still<T>(q, ring.u_r, ring.u_t),
                         du = held_still<T>(q, ring.du_r, ring.du_t);
    place += B.r * (out - u.r) + B.t * (tau - u.t) - ring.x;
    along += B.r * (q.vr - du.r) - B.t * du.t - ring.x_rate;
    turn += B.t * out - tau * B.r;
    v1 = v1 - (du.r + ring.speed * u.t);
    v2 = v2 - (du.t - ring.speed * u.r);
  }
  const T drawn = 0.5 * ((q.spin - q.omega) * h + (ring.speed - q.omega) * out);
  return {value_of(turn),
          ring.B_r,
          {e * place - flange.clearance, e * (along + turn * q.omega), v1, v2, drawn}};
}

/// The same by all that it depends on. By velocities p' has the slopes of p by positions.
template <bool inner>
void spread(const FlangePoint<Dual<Pack, kLocalPositions>>& at, const RollerPack& q, double e,
            double xi, const EndPoint& point, FlangeSlopes<inner> (&by)[kEndVariables]) {
  const double h = point.radial, v1[] = {1, 0, 0, xi, 0, -point.tangential},
               v2[] = {0, 1, 0, 0, xi, h};
  for (int z = 0; z < kEndVariables; ++z) {
    by[z].value = at.motion[z].value;
    for (int j = 0; j < kLocalPositions; ++j) by[z].slope[j] = at.motion[z].slope[j];
  }
  for (int j = 0; j < kLocalVelocities; ++j) {
    if (j < kLocalPositions) by[kEndRate].slope[kFlangeSpeed + j] = by[kEndP].slope[j];
    by[kEndV1].slope[kFlangeSpeed + j] = splat(v1[j]);
    by[kEndV2].slope[kFlangeSpeed + j] = splat(v2[j]);
  }
  by[kEndDrawn].slope[kFlangeSpeed + kLt] = -0.5 * (q.r + 2.0 * h) / q.r;
  by[kEndDrawn].slope[kFlangeSpeed + kLs] = splat(0.5 * h);
  if constexpr (inner) {
    by[kEndP].slope[kRingX] = by[kEndRate].slope[kRingXRate] = splat(-e);
    by[kEndV1].slope[kSlideR] = by[kEndV2].slope[kSlideT] = splat(-1);
  }
}

/// What the roller's motion changes. `power`: the net power.
template <class T>
void add_roller_slopes(const T (&force)[kLocalVelocities], const T& power, const RollerPack& q,
                       GroupLinear& to) {
  const Pack* by_velocity = power.slope + kFlangeSpeed;
  for (int j = 0; j < kLocalVelocities; ++j) {
    for (int i = 0; i < kLocalVelocities; ++i) {
      to.velocity[i][j] += force[i].slope[kFlangeSpeed + j];
      if (j < kLocalPositions) to.position[i][j] += force[i].slope[j];
    }
    to.power_velocity[j] += by_velocity[j];
    if (j < kLocalPositions) to.power_position[j] += power.slope[j];
  }
  // Held still, directions leave out what turns the roller's velocity.
  to.power_position[kLr] -= q.omega * by_velocity[kLt];
  to.power_position[kLt] -= q.vr / q.r * by_velocity[kLt] - q.omega * by_velocity[kLr];
}

/// What the sliding of the inner ring changes, and the force on it in the plane.
inline void add_plane_slopes(const FlangeSlopes<true> (&force)[kLocalVelocities],
                             const FlangeSlopes<true>& power, const FlangeSlopes<true>& p, double e,
                             GroupLinear& g, Linearisation& jac) {
  const auto by_slide = [&](int i, int k) { return force[i].slope[kSlideR + k]; };
  add_turned(g, -by_slide(kLr, 0), -by_slide(kLr, 1), -by_slide(kLt, 0), -by_slide(kLt, 1),
             jac.border_velocity, kRingY, kRingY);
  const Pack &by_r = power.slope[kSlideR], &by_t = power.slope[kSlideT];
  jac.power_velocity[kRingY] += sum(g.cosine * by_r - g.sine * by_t);
  jac.power_velocity[kRingZ] += sum(g.sine * by_r + g.cosine * by_t);
  for (int i = 0; i < kLocalVelocities; ++i)
    for (int k = 0; k < 2; ++k) {
      g.ring.velocity[i][k] += by_slide(i, k);
      g.ring.to_velocity[k][i] -= force[k].slope[kFlangeSpeed + i];
      // Left out: what positions change but p.
      if (i < kLocalPositions) g.ring.to_position[k][i] += e * force[k].slope[kRingX] * p.slope[i];
    }
}
/// Along the axis, where the ring's place is free: with the rollers that touch, and with its place
/// in the plane, which a leaning flange ties to it.
inline void add_axial_slopes(const FlangeSlopes<true> (&force)[kLocalVelocities],
                             const FlangeSlopes<true>& power, const double tilt[2], Mask wet,
                             int group, int slot, Linearisation& jac) {
  const auto column = static_cast<std::size_t>(slot - kCageY), packs = column / kLanes + 1;
  const auto lane_of_slot = static_cast<int>(column) % kLanes;
  for (int i = 0; i < kLanes; ++i) {
    if (!wet[i]) continue;
    CageCoupling& c = jac.coupling(group * kLanes + i);
    for (int k = 0; k < kLocalVelocities; ++k) {
      const auto at = static_cast<std::size_t>(k) * packs + packs - 1;
      c.position[column][k] += force[k].slope[kRingX][i];
      c.velocity[column][k] += force[k].slope[kRingXRate][i];
      c.to_velocity[at][lane_of_slot] -= force[kLx].slope[kFlangeSpeed + k][i];
      if (k < kLocalPositions) c.to_position[at][lane_of_slot] -= force[kLx].slope[k][i];
    }
  }
  const auto add = [&](int variable, Eigen::MatrixXd& block, Eigen::VectorXd& powers) {
    const double stiffness = sum(force[kLx].slope[variable]);
    block(slot, slot) -= stiffness;
    for (const int k : {kRingY, kRingZ}) {
      block(k, slot) -= tilt[k] * stiffness;
      block(slot, k) -= tilt[k] * stiffness;
    }
    powers[slot] += sum(power.slope[variable]);
  };
  add(kRingX, jac.border_position, jac.power_position);
  add(kRingXRate, jac.border_velocity, jac.power_velocity);
}

/// One flange.
template <bool linear, bool inner>
void flange_contact(const BearingModel& model, const Flange& flange, const FlangeRing& ring,
                    const RollerGroup& roller, const RollerPack& q, const BorderState& b, int group,
                    RollerLoads& loads, BorderLoads& border, Linearisation* jac,
                    Observation* seen) {
  using T = std::conditional_t<linear, FlangeSlopes<inner>, Pack>;
  using Place = std::conditional_t<linear, Dual<Pack, kLocalPositions>, Pack>;
  using Law = std::conditional_t<linear, EndSlopes, Pack>;
  const double e = flange.side, xi = e * model.roller_half_length;
  for (const EndPoint& point : flange.points) {
    const double h = point.radial, tau = point.tangential;
    const FlangePoint<Place> at = flange_point<Place, inner>(model, flange, ring, q, point);
    const auto motion = [&](int i) { return value_of(at.motion[i]); };
    const Touch<Pack> touch{motion(kEndP), motion(kEndRate), motion(kEndV1), motion(kEndV2)};
    const Mask wet = (touch.p > -flange.film.layer) & (roller.exists > 0.0);
    if (!any(wet)) continue;
    const EndForces<Law> on = end_forces<Law>(model.flange, model.friction[kFlangePair],
                                              flange.film, touch, wet, motion(kEndDrawn));
    T by[kEndVariables] = {};
    if constexpr (linear) spread<inner>(at, q, e, xi, point, by);
    const T push = e * composed(on.both.normal, by), f1 = composed(on.both.f1, by),
            f2 = composed(on.both.f2, by);
    const T force[kLocalVelocities] = {inner ? f1 - push * at.lean : f1,
                                       f2 - push * Pack(at.turn / q.r),
                                       -push,
                                       xi * f1 + h * push,
                                       xi * f2 + tau * push,
                                       h * f2 - tau * f1};
    for (int i = 0; i < kLocalVelocities; ++i) loads.f[i] += value_of(force[i]);
    if constexpr (inner) {
      const Pack pushed = value_of(push), on_r = pushed * ring.B_r - value_of(f1),
                 on_t = pushed * ring.B_t - value_of(f2);
      border.ring[0] += sum(q.cosine * on_r - q.sine * on_t);
      border.ring[1] += sum(q.sine * on_r + q.cosine * on_t);
      border.ring_axial += sum(pushed);
    }
    if constexpr (linear) {
      observe_end(on, model.flange, flange.film, touch, kFlangeFriction,
                  seen->flange_force.data() + group * kLanes, *seen);
      const T drive = ring.speed * (Pack(q.r + h - ring.u_r) * f2 - Pack(tau - ring.u_t) * f1),
              power = drive - composed(on.both.lost, by);
      seen->drive_power += sum(drive.value);
      GroupLinear& g = jac->groups[static_cast<std::size_t>(group)];
      add_roller_slopes(force, power, q, g);
      g.power_position[kLr] += ring.speed * f2.value;
      // Points and directions turn with the orbit, and so do the forces; add_inertial, which takes
      // these for held still, does the same again: less that.
      g.position[kLr][kLt] -= force[kLt].value / q.r;
      g.position[kLt][kLt] += f1.value / q.r;
      g.position[kLar][kLt] -= force[kLat].value / q.r;
      g.position[kLat][kLt] += force[kLar].value / q.r;
      if constexpr (inner) add_plane_slopes(force, power, by[kEndP], e, g, *jac);
      if constexpr (inner)
        if (model.layout.ring_axial > 0)
          add_axial_slopes(force, power, b.tilt, wet, group, model.layout.ring_axial_slot(), *jac);
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
      flange_contact<linear, true>(model, flange, inner_flange_ring(q, b), roller, q, b, group,
                                   loads, border, jac, seen);
    else
      flange_contact<linear, false>(model, flange, {b.speed.outer}, roller, q, b, group, loads,
                                    border, jac, seen);
  }
}

}  // namespace cagetol
