// Roller against the two bars of its pocket, in the pocket's directions e_R, e_T (at the pocket
// centre's angle) and e_x, at stations xi along the roller. D and X are the radial-plane and axial
// place of the roller's axis relative to the cage's geometric centre, kappa = A_T + dgamma the lean
// of the bar faces:
//   u = D_T - kappa X,   p = s u + R - S_j/2,   s = +1 at the leading bar (ahead in +T), -1 at the
//   trailing bar
// Normal row: -dp/d(velocities). Friction rows: along e_R (the roller's spin rubs) and along e_x.
#pragma once

#include "src/dynamics/contact_frame.hpp"

namespace cagetol {

/// Adds one lane of a bar contact to the derivatives.
inline void linearise_bar(const BorderState& b, int roller, double R, double spin, double xi,
                          double s, double kappa, double cos_b, double sin_b, double cos_p,
                          double sin_p, double D_R, double D_T, double X, double A_R, double A_T,
                          double a_R, const ContactSlopes& slopes, ContactRows& rows,
                          Linearisation& linear) {
  const double reach = D_T + s * R;
  // Rows in (R, T, x, a_R, a_T, spin), then turned by the small angle between pocket and roller.
  const double rolling[3][kLocalVelocities] = {{0, -s, s * kappa, 0, -s * xi, 0},
                                               {1, 0, 0, xi, 0, -s * R},
                                               {0, 0, 1, 0, -s * R, s * R * a_R}};
  const double caging[3][6] = {{0, s, -s * kappa, s * (D_R - X * A_R), 0, s * X},
                               {-1, 0, 0, reach - A_T * X, -X, 0},
                               {0, 0, -1, A_T * D_R - A_R * reach, D_R, reach}};
  for (int c = 0; c < 3; ++c) {
    const double* g = rolling[c];
    double* to = rows.roller[c];
    to[kLr] = cos_b * g[0] + sin_b * g[1];
    to[kLt] = cos_b * g[1] - sin_b * g[0];
    to[kLx] = g[2];
    to[kLar] = cos_b * g[3] + sin_b * g[4];
    to[kLat] = cos_b * g[4] - sin_b * g[3];
    to[kLs] = g[5];
    const double* k = caging[c];
    const double at_centre[kCageRigid] = {
        cos_p * k[0] - sin_p * k[1], sin_p * k[0] + cos_p * k[1], k[2], k[3],
        cos_p * k[4] - sin_p * k[5], sin_p * k[4] + cos_p * k[5]};
    fill_cage_row(at_centre, b, rows.border[c]);
  }
  rows.lean[kLar] = s * R * spin * cos_b;
  rows.lean[kLat] = -s * R * spin * sin_b;
  add_contact(rows, slopes, roller, linear);
  rows.lean[kLar] = rows.lean[kLat] = 0;
}

template <bool linear>
void pocket_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                     const BorderState& b, int group, RollerLoads& loads, BorderLoads& border,
                     ContactRows* rows, Linearisation* jac, Observation* seen, Pack& touch) {
  const Pack cos_p = b.phi_cos * roller.pocket_cos - b.phi_sin * roller.pocket_sin;
  const Pack sin_p = b.phi_sin * roller.pocket_cos + b.phi_cos * roller.pocket_sin;
  const Pack cos_b = q.cosine * cos_p + q.sine * sin_p, sin_b = q.sine * cos_p - q.cosine * sin_p;
  const Pack D_y = q.r * q.cosine - b.cage[0], D_z = q.r * q.sine - b.cage[1];
  const Pack D_R0 = cos_p * D_y + sin_p * D_z, D_T0 = cos_p * D_z - sin_p * D_y;
  const Pack A_R = cos_p * b.axis[0] + sin_p * b.axis[1],
             A_T = cos_p * b.axis[1] - sin_p * b.axis[0];
  const Pack dA_R = cos_p * b.axis_rate[0] + sin_p * b.axis_rate[1];
  const Pack dA_T = cos_p * b.axis_rate[1] - sin_p * b.axis_rate[0];
  const Pack a_R = cos_b * q.a_r - sin_b * q.a_t, a_T = sin_b * q.a_r + cos_b * q.a_t;
  const Pack b_R = cos_b * q.b_r - sin_b * q.b_t, b_T = sin_b * q.b_r + cos_b * q.b_t;
  const Pack v_R0 = cos_b * q.vr - sin_b * q.vt - (cos_p * b.cage_rate[0] + sin_p * b.cage_rate[1]);
  const Pack v_T0 = sin_b * q.vr + cos_b * q.vt - (cos_p * b.cage_rate[1] - sin_p * b.cage_rate[0]);
  const Pack v_x0 = q.vx - b.cage_rate[2];
  const Pack kappa = A_T + roller.squareness;
  const Pack X0 = q.x - b.cage[2];

  Pack f_R{}, f_T{}, f_x{}, t_R{}, t_T{}, t_s{}, c_phi{}, c_R{}, c_T{};
  bool touched = false;
  for (double xi : model.bar_stations) {
    const Pack X = X0 + xi, D_R = D_R0 + xi * a_R, D_T = D_T0 + xi * a_T;
    const Pack u = D_T - kappa * X;
    const Pack gap = roller.radius - roller.half_width;
    // Speed at which u grows.
    const Pack u_rate = v_T0 + xi * b_T - kappa * v_x0 - b.phi_rate * (D_R - X * A_R) - X * dA_T;
    for (int side = 0; side < 2; ++side) {
      const double s = side == 0 ? 1.0 : -1.0;
      const Pack p = s * u + gap;
      const Mask touching = (p > 0.0) & (roller.exists > 0.0);
      if constexpr (linear) touch = min(touch, touch_time(p, s * u_rate, roller.exists));
      if (!any(touching)) continue;
      touched = true;
      const Pack rate = s * u_rate, R = roller.radius, reach = D_T + s * R;
      const Pack v1 = v_R0 + xi * b_R - s * R * q.spin + b.phi_rate * (reach - X * A_T) - X * dA_R;
      const Pack v2 = v_x0 + s * R * (q.spin * a_R - b_T) - b.phi_rate * (A_R * reach - A_T * D_R) +
                      dA_T * reach + dA_R * D_R;
      const auto normal = normal_force(model.bar, select(touching, p, splat(-1.0)), rate);
      const Pack speed2 = v1 * v1 + v2 * v2;
      const auto fr = friction(model.friction, speed2);
      const Pack g = fr.ratio * normal.force, f1 = -g * v1, f2 = -g * v2, push = s * normal.force;
      f_R += f1;
      f_T -= push;
      f_x += kappa * push + f2;
      t_R += xi * f1;
      t_T -= xi * push + s * R * f2;
      t_s += s * R * (a_R * f2 - f1);
      c_phi += push * (D_R - X * A_R) + f1 * (reach - A_T * X) + f2 * (A_T * D_R - A_R * reach);
      c_R += D_R * f2 - X * f1;
      c_T += X * push + reach * f2;
      if constexpr (linear) {
        double* const force =
            (side == 0 ? seen->leading_force : seen->trailing_force).data() + group * kLanes;
        store(force, load(force) + normal.force);
        seen->friction_power += sum(g * speed2);
        seen->damping_power += sum((normal.force - normal.elastic) * rate);
        seen->elastic_energy += sum(normal.elastic * max(p, Pack{})) / (model.bar.exponent + 1);
        for (int i = 0; i < kLanes; ++i)
          if (touching[i])
            linearise_bar(
                b, group * kLanes + i, R[i], q.spin[i], xi, s, kappa[i], cos_b[i], sin_b[i],
                cos_p[i], sin_p[i], D_R[i], D_T[i], X[i], A_R[i], A_T[i], a_R[i],
                {normal.force[i], normal.stiffness[i], normal.damping[i], fr.ratio[i], fr.bend[i],
                 v1[i], v2[i], normal.elastic[i], normal.elastic_stiffness[i], rate[i]},
                *rows, *jac);
      }
    }
  }
  if (!touched) return;
  loads.f[kLr] += cos_b * f_R + sin_b * f_T;
  loads.f[kLt] += cos_b * f_T - sin_b * f_R;
  loads.f[kLx] += f_x;
  loads.f[kLar] += cos_b * t_R + sin_b * t_T;
  loads.f[kLat] += cos_b * t_T - sin_b * t_R;
  loads.f[kLs] += t_s;
  border.cage[0] -= sum(cos_p * f_R - sin_p * f_T);
  border.cage[1] -= sum(sin_p * f_R + cos_p * f_T);
  border.cage[2] -= sum(f_x);
  border.cage[3] += sum(c_phi);
  border.cage[4] += sum(cos_p * c_R - sin_p * c_T);
  border.cage[5] += sum(sin_p * c_R + cos_p * c_T);
}

}  // namespace cagetol
