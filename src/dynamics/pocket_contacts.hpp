// Roller against the two bars of its pocket, in the pocket's directions e_R, e_T (at the pocket
// centre's angle) and e_x, at stations xi along the roller. D and X are the radial-plane and axial
// place of the roller's axis relative to the cage's geometric centre, kappa = A_T + dgamma the lean
// of the bar faces, w_T how far the bar has bent along e_T:
//   u = D_T - kappa X - w_T
//   p = s u + R - S_j/2,   s = +1 at the leading bar (ahead in +T), -1 at the trailing bar
// Normal row: -dp/d(velocities). Friction rows: along e_R (the roller's spin rubs) and along e_x.
#pragma once

#include "src/dynamics/pocket_frame.hpp"

namespace cagetol {

/// Distance of the farthest station from the roller's middle [m].
inline double farthest_station(const BearingModel& model) {
  return std::max(-model.bar_stations.front(), model.bar_stations.back());
}

/// False where no station of a bar can touch, were bars `margin` [m] nearer: along the roller u
/// goes in proportion to the place.
inline bool bars_in_reach(const BearingModel& model, const RollerGroup& roller,
                          const PocketFrame& f, Pack margin) {
  const double farthest = farthest_station(model);
  const Pack kappa = f.A_T + roller.squareness;
  const Pack u = abs(f.D_T - kappa * f.X) + farthest * abs(f.a_T - kappa);
  return any((u + roller.radius - roller.half_width > -margin) & (roller.exists > 0.0));
}

/// The largest rate of u at any station, which goes in proportion to the place, too.
inline Pack fastest_at_bars(const BearingModel& model, const RollerGroup& roller,
                            const PocketFrame& f, const BorderState& b) {
  const Pack kappa = f.A_T + roller.squareness;
  return abs(f.v_T - kappa * f.v_x - b.phi_rate * (f.D_R - f.X * f.A_R) - f.X * f.dA_T) +
         farthest_station(model) * abs(f.b_T - b.phi_rate * (f.a_R - f.A_R) - f.dA_T);
}

template <bool linear>
void pocket_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                     const PocketFrame& f, const BorderState& b, const ModalState& modal, int group,
                     RollerLoads& loads, BorderLoads& border, ContactRows* rows, Linearisation* jac,
                     Observation* seen, StepLimit<Pack>& limit) {
  const Pack kappa = f.A_T + roller.squareness;
  const Pack gap = roller.radius - roller.half_width, R = roller.radius;
  const int stations = static_cast<int>(model.bar_stations.size());
  PocketLoads on;
  bool touched = false;
  for (int k = 0; k < stations; ++k) {
    const double xi = model.bar_stations[static_cast<std::size_t>(k)];
    const Pack X = f.X + xi, D_R = f.D_R + xi * f.a_R, D_T = f.D_T + xi * f.a_T;
    const Pack u = D_T - kappa * X;
    // Speed at which u grows.
    const Pack u_rate =
        f.v_T + xi * f.b_T - kappa * f.v_x - b.phi_rate * (D_R - X * f.A_R) - X * f.dA_T;
    for (int side = 0; side < 2; ++side) {
      const double s = side == 0 ? 1.0 : -1.0;
      const int point = side == 0 ? stations + k : k;
      Pack p = s * u + gap, rate = s * u_rate;
      const auto near = linear ? modal.may_touch(p, rate, limit.longest()) : p > -modal.farthest;
      if (!any(near & (roller.exists > 0.0))) continue;
      if (modal.flexible()) p -= s * modal.along(group, point, 1, modal.q);
      const Mask touching = (p > 0.0) & (roller.exists > 0.0);
      if constexpr (!linear)
        if (!any(touching)) continue;
      if (modal.flexible()) rate -= s * modal.along(group, point, 1, modal.rate);
      if constexpr (linear) {
        limit.touch(p, rate, roller.exists > 0.0);
        limit.grow(p, rate, roller.exists > 0.0);
        limit.touch(-p, -rate, roller.exists > 0.0);  // partings, too
        if (!any(touching)) continue;
      }
      touched = true;
      const Pack reach = D_T + s * R;
      Pack v1 = f.v_R + xi * f.b_R - s * R * q.spin + b.phi_rate * (reach - X * f.A_T) - X * f.dA_R;
      Pack v2 = f.v_x + s * R * (q.spin * f.a_R - f.b_T) -
                b.phi_rate * (f.A_R * reach - f.A_T * D_R) + f.dA_T * reach + f.dA_R * D_R;
      if (modal.flexible()) {
        v1 -= modal.along(group, point, 0, modal.rate);
        v2 -= modal.along(group, point, 2, modal.rate);
      }
      const auto normal = normal_force(model.bar, select(touching, p, splat(-1.0)), rate);
      // The few heavy impacts make the mean square of the force: it is taken from these states.
      if constexpr (linear)
        limit.at_most(model.heavy_step, touching & (normal.force > model.heavy_force));
      const Pack speed2 = v1 * v1 + v2 * v2;
      const auto fr = friction(model.friction[kBarPair], speed2);
      const Pack g = fr.ratio * normal.force, f1 = -g * v1, f2 = -g * v2, push = s * normal.force;
      if (modal.flexible()) modal.push(group, point, -f1, push, -f2);
      on.f_R += f1;
      on.f_T -= push;
      on.f_x += kappa * push + f2;
      on.t_R += xi * f1;
      on.t_T -= xi * push + s * R * f2;
      on.t_s += s * R * (f.a_R * f2 - f1);
      on.c_phi +=
          push * (D_R - X * f.A_R) + f1 * (reach - f.A_T * X) + f2 * (f.A_T * D_R - f.A_R * reach);
      on.c_AR += D_R * f2 - X * f1;
      on.c_AT += X * push + reach * f2;
      if constexpr (linear) {
        double* const force =
            (side == 0 ? seen->leading_force : seen->trailing_force).data() + group * kLanes;
        store(force, load(force) + normal.force);
        seen->rub(kPocketFriction, sum(g * speed2));
        seen->damp(kDamping, sum((normal.force - normal.elastic) * rate));
        seen->elastic_energy += sum(normal.elastic * max(p, Pack{})) / (model.bar.exponent + 1);
        for (int i = 0; i < kLanes; ++i) {
          if (!touching[i]) continue;
          if (modal.cage->model)
            seen->bar_force[2 * stations * (group * kLanes + i) + point] = push[i];
          const double Ri = R[i], rest = reach[i], A_R = f.A_R[i], A_T = f.A_T[i], x = X[i];
          const double rolling[3][kLocalVelocities] = {{0, -s, s * kappa[i], 0, -s * xi, 0},
                                                       {1, 0, 0, xi, 0, -s * Ri},
                                                       {0, 0, 1, 0, -s * Ri, s * Ri * f.a_R[i]}};
          const double caging[3][kCageRigid] = {
              {0, s, -s * kappa[i], s * (D_R[i] - x * A_R), 0, s * x},
              {-1, 0, 0, rest - A_T * x, -x, 0},
              {0, 0, -1, A_T * D_R[i] - A_R * rest, D_R[i], rest}};
          fill_pocket_rows<3>(f, b, modal, group, point, i, rolling, caging,
                              {{0, s, 0}, {-1, 0, 0}, {0, 0, -1}}, *rows);
          rows->lean[kLar] = s * Ri * q.spin[i] * f.cos_b[i];
          rows->lean[kLat] = -s * Ri * q.spin[i] * f.sin_b[i];
          add_contact(
              *rows,
              {normal.force[i], normal.stiffness[i], normal.damping[i], fr.ratio[i], fr.bend[i],
               v1[i], v2[i], normal.elastic[i], normal.elastic_stiffness[i], rate[i]},
              group * kLanes + i, *jac);
          rows->lean[kLar] = rows->lean[kLat] = 0;
        }
      }
    }
  }
  if (!touched) return;
  on.c_R = -on.f_R;
  on.c_T = -on.f_T;
  on.c_x = -on.f_x;
  add_pocket_loads(f, on, loads, border);
}

}  // namespace cagetol
