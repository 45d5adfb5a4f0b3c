// Roller ends against the end walls of their pocket and against the flanges of the outer ring. Each
// end e = +-1 carries two points off the axis, at radial h and tangential tau from the centre of
// the end face, so that the force rights a skewed roller and the spin enters the sliding speed. The
// wall is normal to the cage's axis A, the flange to the bearing's axis:
//   wall:    p = e (x - x_c + A . D) + L_w/2 - L_j/2,     flange:  p = e (x - h a_r - tau a_t) -
//   c_fl/2
// with D the point's radial-plane place relative to the cage's geometric centre, x at the point
// likewise less h a_r + tau a_t. The points keep their place beside the roller's orbit: they turn
// with theta', not with the spin, so a roller whose lean goes round with it neither approaches nor
// recedes, and p depends on theta through `turn` = dp/dtheta (times e) at a centre held still.
#pragma once

#include "src/dynamics/contact_frame.hpp"

namespace cagetol {

/// The cage's motion in the pack's roller directions.
struct CageInRoller {
  Pack c_r, c_t, dc_r, dc_t;  ///< centre
  Pack a_r, a_t, da_r, da_t;  ///< axis
};

inline CageInRoller cage_in_roller(const RollerPack& q, const BorderState& b) {
  const auto r = [&](const double v[2]) { return along_r(q, splat(v[0]), splat(v[1])); };
  const auto t = [&](const double v[2]) { return along_t(q, splat(v[0]), splat(v[1])); };
  return {r(b.cage), t(b.cage), r(b.cage_rate), t(b.cage_rate),
          r(b.axis), t(b.axis), r(b.axis_rate), t(b.axis_rate)};
}

template <bool linear>
void wall_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                   const BorderState& b, int group, RollerLoads& loads, BorderLoads& border,
                   ContactRows* rows, Linearisation* jac, Observation* seen, Pack& touch) {
  const CageInRoller c = cage_in_roller(q, b);
  const double half = model.roller_half_length;
  // Every point of an end lies below this: skip the points when even the whole face clears the
  // wall.
  const Pack reach =
      roller.radius * (max(q.a_r - c.a_r, c.a_r - q.a_r) + max(q.a_t - c.a_t, c.a_t - q.a_t));
  const Pack offset = q.x - b.cage[2] + c.a_r * (q.r - c.c_r) - c.a_t * c.c_t;
  const Pack slack = roller.half_length - half;
  if constexpr (!linear)
    if (!any(max(offset, -offset) + reach > slack)) return;
  const double phi = b.phi_rate;
  for (int end = -1; end <= 1; end += 2) {
    const double e = end, xi = e * half;
    for (const EndPoint& point : model.wall_points) {
      const double h = point.radial, tau = point.tangential;
      const Pack D_r = q.r + xi * q.a_r + h - c.c_r, D_t = xi * q.a_t + tau - c.c_t;
      const Pack X = q.x + xi - h * q.a_r - tau * q.a_t - b.cage[2];
      const Pack p = e * (X + c.a_r * D_r + c.a_t * D_t) - roller.half_length;
      const Pack V_r = q.vr + xi * q.b_r - c.dc_r, V_t = q.vt + xi * q.b_t - c.dc_t;
      const Pack turn = h * (c.a_t - q.a_t) - tau * (c.a_r - q.a_r);
      const Pack rate = e * (q.vx - h * q.b_r - tau * q.b_t - b.cage_rate[2] + c.a_r * V_r +
                             c.a_t * V_t + c.da_r * D_r + c.da_t * D_t + turn * q.omega);
      if constexpr (linear) touch = min(touch, touch_time(p, rate, roller.exists));
      const Mask touching = (p > 0.0) & (roller.exists > 0.0);
      if (!any(touching)) continue;
      const Pack lever_r = D_r - X * c.a_r, lever_t = D_t - X * c.a_t;
      const Pack v1 = V_r - q.spin * tau - X * c.da_r + phi * lever_t;
      const Pack v2 = V_t + q.spin * h - X * c.da_t - phi * lever_r;
      const auto normal = normal_force(model.wall, select(touching, p, splat(-1.0)), rate);
      const Pack speed2 = v1 * v1 + v2 * v2;
      const auto fr = friction(model.friction, speed2);
      const Pack g = fr.ratio * normal.force, f1 = -g * v1, f2 = -g * v2, push = e * normal.force;
      loads.f[kLr] += f1 - push * c.a_r;
      loads.f[kLt] += f2 - push * (c.a_t + turn / q.r);
      loads.f[kLx] -= push;
      loads.f[kLar] += xi * f1 + push * (h - xi * c.a_r);
      loads.f[kLat] += xi * f2 + push * (tau - xi * c.a_t);
      loads.f[kLs] += h * f2 - tau * f1;
      const Pack F_r = push * c.a_r - f1, F_t = push * c.a_t - f2;
      const Pack T_r = -push * D_r - X * f1, T_t = -push * D_t - X * f2;
      border.cage[0] += sum(q.cosine * F_r - q.sine * F_t);
      border.cage[1] += sum(q.sine * F_r + q.cosine * F_t);
      border.cage[2] += sum(push);
      border.cage[3] += sum(f1 * lever_t - f2 * lever_r);
      border.cage[4] += sum(q.cosine * T_r - q.sine * T_t);
      border.cage[5] += sum(q.sine * T_r + q.cosine * T_t);
      if constexpr (linear) {
        double* const force = seen->wall_force.data() + group * kLanes;
        store(force, load(force) + normal.force);
        seen->friction_power += sum(g * speed2);
        seen->damping_power += sum((normal.force - normal.elastic) * rate);
        seen->elastic_energy += sum(normal.elastic * max(p, Pack{})) / (model.wall.exponent + 1);
        for (int i = 0; i < kLanes; ++i) {
          if (!touching[i]) continue;
          const double A_r = c.a_r[i], A_t = c.a_t[i];
          const double rolling[3][kLocalVelocities] = {
              {-e * A_r, -e * (A_t + turn[i] / q.r[i]), -e, e * (h - xi * A_r),
               e * (tau - xi * A_t), 0},
              {1, 0, 0, xi, 0, -tau},
              {0, 1, 0, 0, xi, h}};
          const double caging[3][6] = {{e * A_r, e * A_t, e, 0, -e * D_r[i], -e * D_t[i]},
                                       {-1, 0, 0, lever_t[i], -X[i], 0},
                                       {0, -1, 0, -lever_r[i], 0, -X[i]}};
          for (int k = 0; k < 3; ++k) {
            for (int j = 0; j < kLocalVelocities; ++j) rows->roller[k][j] = rolling[k][j];
            const double* r = caging[k];
            const double co = q.cosine[i], si = q.sine[i];
            const double at_centre[kCageRigid] = {
                co * r[0] - si * r[1], si * r[0] + co * r[1], r[2], r[3],
                co * r[4] - si * r[5], si * r[4] + co * r[5]};
            fill_cage_row(at_centre, b, rows->border[k]);
          }
          add_contact(
              *rows,
              {normal.force[i], normal.stiffness[i], normal.damping[i], fr.ratio[i], fr.bend[i],
               v1[i], v2[i], normal.elastic[i], normal.elastic_stiffness[i], rate[i]},
              group * kLanes + i, *jac);
        }
      }
    }
  }
}

template <bool linear>
void flange_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                     int group, RollerLoads& loads, Linearisation* jac, Observation* seen,
                     Pack& touch) {
  const double half = model.roller_half_length;
  const Pack reach = roller.radius * (max(q.a_r, -q.a_r) + max(q.a_t, -q.a_t));
  if constexpr (!linear)
    if (!any(max(q.x, -q.x) + reach > model.flange_half_clearance)) return;
  for (int end = -1; end <= 1; end += 2) {
    const double e = end, xi = e * half;
    for (const EndPoint& point : model.flange_points) {
      const double h = point.radial, tau = point.tangential;
      const Pack p = e * (q.x - h * q.a_r - tau * q.a_t) - model.flange_half_clearance;
      const Pack turn = tau * q.a_r - h * q.a_t;
      const Pack rate = e * (q.vx - h * q.b_r - tau * q.b_t + turn * q.omega);
      if constexpr (linear) touch = min(touch, touch_time(p, rate, roller.exists));
      const Mask touching = (p > 0.0) & (roller.exists > 0.0);
      if (!any(touching)) continue;
      const Pack v1 = q.vr + xi * q.b_r - q.spin * tau, v2 = q.vt + xi * q.b_t + q.spin * h;
      const auto normal = normal_force(model.flange, select(touching, p, splat(-1.0)), rate);
      const Pack speed2 = v1 * v1 + v2 * v2;
      const auto fr = friction(model.friction, speed2);
      const Pack g = fr.ratio * normal.force, f1 = -g * v1, f2 = -g * v2, push = e * normal.force;
      loads.f[kLr] += f1;
      loads.f[kLt] += f2 - push * turn / q.r;
      loads.f[kLx] -= push;
      loads.f[kLar] += xi * f1 + h * push;
      loads.f[kLat] += xi * f2 + tau * push;
      loads.f[kLs] += h * f2 - tau * f1;
      if constexpr (linear) {
        double* const force = seen->flange_force.data() + group * kLanes;
        store(force, load(force) + normal.force);
        seen->friction_power += sum(g * speed2);
        seen->damping_power += sum((normal.force - normal.elastic) * rate);
        seen->elastic_energy += sum(normal.elastic * max(p, Pack{})) / (model.flange.exponent + 1);
        GroupLinear& to = jac->groups[static_cast<std::size_t>(group)];
        const Pack d11 = normal.force * (fr.ratio + fr.bend * v1 * v1),
                   d12 = normal.force * fr.bend * v1 * v2;
        const Pack d22 = normal.force * (fr.ratio + fr.bend * v2 * v2);
        const Pack gn[] = {Pack{},       -e * turn / q.r, splat(-e),
                           splat(e * h), splat(e * tau),  Pack{}};
        const double g1[] = {1, 0, 0, xi, 0, -tau}, g2[] = {0, 1, 0, 0, xi, h};
        const auto lost =
            dissipation_slopes(normal.force, normal.stiffness, normal.damping, fr.ratio, fr.bend,
                               v1, v2, normal.elastic, normal.elastic_stiffness, rate);
        for (int i = 0; i < kLocalVelocities; ++i) {
          to.power_velocity[i] += lost.rate * gn[i] - lost.v1 * g1[i] - lost.v2 * g2[i];
          if (i < kLocalPositions) to.power_position[i] += lost.p * gn[i];
          const Pack slide = gn[i] - fr.ratio * v1 * g1[i] - fr.ratio * v2 * g2[i];
          const Pack w1 = d11 * g1[i] + d12 * g2[i], w2 = d12 * g1[i] + d22 * g2[i];
          for (int j = 0; j < kLocalVelocities; ++j)
            to.velocity[i][j] -= slide * normal.damping * gn[j] + w1 * g1[j] + w2 * g2[j];
          for (int j = 0; j < kLocalPositions; ++j)
            to.position[i][j] -= slide * normal.stiffness * gn[j];
        }
      }
    }
  }
}

}  // namespace cagetol
