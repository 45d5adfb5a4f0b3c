// Roller against the bars of its pocket through oil (src/lubrication/lubricated_line.hpp): the
// kinematics of pocket_contacts.hpp with another law. The bar's face is flat and at rest in the
// cage, so the contact travels with the roller's axis:
//
//   v_c = speed of the roller's axis along e_R relative to the cage
//   u   = v_1/2 - v_c                        entrainment along e_R, v_1 sliding speed
//   F_1 = -ratio v_1 - F_r on the roller's surface,   F_c = 2 F_r on its axis, both along e_R
//
// and the bar feels the opposite forces along the same lines.
#pragma once

#include "src/dynamics/pocket_contacts.hpp"
#include "src/lubrication/lubricated_line.hpp"

namespace cagetol {

/// Slopes of one lane from the law's derivatives by (p, p', u, |v|^2). `f`: forces of a station.
inline FilmContactSlopes film_slopes_of(const LineForces<Dual<Pack, 4>>& f, Pack v1, Pack v2,
                                        Pack rate, Pack u, int lane) {
  const int i = lane;
  const double s1 = v1[i], s2 = v2[i], ratio = f.ratio.value[i], roll = f.rolling.value[i];
  const double squared = s1 * s1 + s2 * s2, bend = 2 * f.ratio.slope[3][i];
  FilmContactSlopes to;
  using F = FilmContactSlopes;
  enum { kN, k1, k2, kC };
  const auto& N = f.at.normal.slope;
  const auto& G = f.ratio.slope;
  const auto& R = f.rolling.slope;
  double by_u[ContactRows::kMostChannels], power_u = 0;
  for (int z = 0; z < 3; ++z) {  // p, p', u
    double* by = z < 2 ? to.force[z] : by_u;
    by[kN] = N[z][i];
    by[k1] = -G[z][i] * s1 - R[z][i];
    by[k2] = -G[z][i] * s2;
    by[kC] = 2 * R[z][i];
    (z < 2 ? to.power[z] : power_u) = -N[z][i] * rate[i] - G[z][i] * squared - 2 * R[z][i] * u[i];
  }
  to.power[F::kRate] -= f.at.normal.value[i];
  power_u -= 2 * roll;
  to.force[F::kV1][k1] = -ratio - bend * s1 * s1;
  to.force[F::kV1][k2] = to.force[F::kV2][k1] = -bend * s1 * s2;
  to.force[F::kV2][k2] = -ratio - bend * s2 * s2;
  to.power[F::kV1] = -(2 * ratio + bend * squared) * s1;
  to.power[F::kV2] = -(2 * ratio + bend * squared) * s2;
  for (int m = 0; m < ContactRows::kMostChannels; ++m) {  // u = v1/2 - v_c
    to.force[F::kV1][m] += 0.5 * by_u[m];
    to.force[F::kAxis][m] -= by_u[m];
  }
  to.power[F::kV1] += 0.5 * power_u;
  to.power[F::kAxis] -= power_u;
  return to;
}

template <bool linear>
void lubricated_pocket(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                       const PocketFrame& f, const BorderState& b, const ModalState& modal,
                       int group, RollerLoads& loads, BorderLoads& border, ContactRows* rows,
                       Linearisation* jac, Observation* seen) {
  const LubricatedLine& law = model.bar_line;
  const Pack kappa = f.A_T + roller.squareness;
  const Pack least = roller.radius - roller.half_width, R = roller.radius;
  const int stations = static_cast<int>(model.bar_stations.size());
  PocketLoads on;
  bool touched = false;
  for (int k = 0; k < stations; ++k) {
    const double xi = model.bar_stations[static_cast<std::size_t>(k)];
    const Pack X = f.X + xi, D_R = f.D_R + xi * f.a_R, D_T = f.D_T + xi * f.a_T;
    const Pack shift = D_T - kappa * X;
    const Pack shift_rate =
        f.v_T + xi * f.b_T - kappa * f.v_x - b.phi_rate * (D_R - X * f.A_R) - X * f.dA_T;
    // Penetration of the bar ahead (s = 1) and of the one behind (s = -1).
    const Pack bars[2] = {shift + least, least - shift};
    Mask oiled[2];
    bool near = false;
    for (const Pack& p : bars)
      near |= any((p > -modal.farthest - law.layer) & (roller.exists > 0.0));
    if (!near) continue;
    const int points[2] = {stations + k, k};
    Pack depth[2];
    for (int side = 0; side < 2; ++side) {
      depth[side] = bars[side];
      if (modal.flexible())
        depth[side] -= (side == 0 ? 1.0 : -1.0) * modal.along(group, points[side], 1, modal.q);
      oiled[side] = (depth[side] > -law.layer) & (roller.exists > 0.0);
    }
    if (!any(oiled[0] | oiled[1])) continue;
    touched = true;
    // Rollers hardly ever have oil at both bars: then each lane takes its own one, all at once.
    const bool apart = any(oiled[0] & oiled[1]);
    for (int side = 0; side < (apart ? 2 : 1); ++side) {
      const Mask wet = apart ? oiled[side] : oiled[0] | oiled[1];
      if (!any(wet)) continue;
      const Mask lead = apart ? (side == 0 ? Mask{} == 0 : Mask{} != 0) : ~oiled[1];
      const Pack s = select(lead, splat(1.0), splat(-1.0));
      const auto of_bar = [&](int direction, const double* coordinate) {
        if (apart) return modal.along(group, points[side], direction, coordinate);
        return select(lead, modal.along(group, points[0], direction, coordinate),
                      modal.along(group, points[1], direction, coordinate));
      };
      const Pack p = select(lead, depth[0], depth[1]);
      Pack rate = s * shift_rate;
      if (modal.flexible()) rate -= s * of_bar(1, modal.rate);
      const Pack reach = D_T + s * R;
      Pack axis_speed = f.v_R + xi * f.b_R + b.phi_rate * (D_T - X * f.A_T) - X * f.dA_R;
      Pack v2 = f.v_x + s * R * (q.spin * f.a_R - f.b_T) -
                b.phi_rate * (f.A_R * reach - f.A_T * D_R) + f.dA_T * reach + f.dA_R * D_R;
      if (modal.flexible()) {
        axis_speed -= of_bar(0, modal.rate);
        v2 -= of_bar(2, modal.rate);
      }
      const Pack v1 = axis_speed + s * R * (b.phi_rate - q.spin);
      const Pack u = 0.5 * v1 - axis_speed, squared = v1 * v1 + v2 * v2;
      const Pack place = select(wet, p, splat(-0.5 * law.layer)),
                 one = select(wet, splat(1.0), Pack{});
      using D = std::conditional_t<linear, Dual<Pack, 4>, Pack>;
      LineForces<D> forces;
      if constexpr (linear)
        forces = line_forces<D>(law, line_speed<D>(law, variable<D>(u, 2)), -variable<D>(place, 0),
                                -variable<D>(rate, 1), variable<D>(squared, 3));
      else
        forces = line_forces<Pack>(law, line_speed<Pack>(law, u), -place, -rate, squared);
      const Pack normal = value_of(forces.at.normal) * one, ratio = value_of(forces.ratio) * one,
                 roll = value_of(forces.rolling) * one;
      const Pack f1 = -ratio * v1 - roll, f2 = -ratio * v2, axis = 2.0 * roll, along = f1 + axis;
      const Pack push = s * normal;
      if (modal.flexible())
        for (int bar = 0; bar < 2; ++bar) {
          if (apart && bar != side) continue;
          const Pack mine = select(bar == 0 ? lead : ~lead, splat(1.0), Pack{});
          modal.push(group, points[bar], -along * mine, push * mine, -f2 * mine);
        }
      on.f_R += along;
      on.f_T -= push;
      on.f_x += kappa * push + f2;
      on.t_R += xi * along;
      on.t_T -= xi * push + s * R * f2;
      on.t_s += s * R * (f.a_R * f2 - f1);
      on.c_phi += push * (D_R - X * f.A_R) + f1 * (reach - f.A_T * X) + axis * (D_T - f.A_T * X) +
                  f2 * (f.A_T * D_R - f.A_R * reach);
      on.c_AR += D_R * f2 - X * along;
      on.c_AT += X * push + reach * f2;
      if constexpr (linear) {
        const auto add = [&](PackVector& force, Mask mine) {
          double* const at = force.data() + group * kLanes;
          store(at, load(at) + select(mine, normal, Pack{}));
        };
        add(seen->leading_force, lead);
        add(seen->trailing_force, ~lead);
        const Pack film = value_of(forces.at.film) * one, steady = value_of(forces.at.steady) * one;
        seen->rub(kPocketFriction, sum(ratio * squared + 2.0 * roll * u));
        seen->damp(kSqueeze, sum((film - steady) * rate));
        seen->damp(kDamping, sum((normal - film) * rate));
        seen->damp(kFilm, sum(steady * rate));
        for (int i = 0; i < kLanes; ++i) {
          if (!wet[i]) continue;
          const double si = s[i], Ri = R[i], rest = reach[i], A_R = f.A_R[i], A_T = f.A_T[i],
                       x = X[i];
          const int point = points[si > 0 ? 0 : 1];
          if (modal.cage->model)
            seen->bar_force[2 * stations * (group * kLanes + i) + point] = push[i];
          const double rolling[4][kLocalVelocities] = {{0, -si, si * kappa[i], 0, -si * xi, 0},
                                                       {1, 0, 0, xi, 0, -si * Ri},
                                                       {0, 0, 1, 0, -si * Ri, si * Ri * f.a_R[i]},
                                                       {1, 0, 0, xi, 0, 0}};
          const double caging[4][kCageRigid] = {
              {0, si, -si * kappa[i], si * (D_R[i] - x * A_R), 0, si * x},
              {-1, 0, 0, rest - A_T * x, -x, 0},
              {0, 0, -1, A_T * D_R[i] - A_R * rest, D_R[i], rest},
              {-1, 0, 0, D_T[i] - A_T * x, -x, 0}};
          fill_pocket_rows<4>(f, b, modal, group, point, i, rolling, caging,
                              {{0, si, 0}, {-1, 0, 0}, {0, 0, -1}, {-1, 0, 0}}, *rows);
          rows->lean[kLar] = si * Ri * q.spin[i] * f.cos_b[i];
          rows->lean[kLat] = -si * Ri * q.spin[i] * f.sin_b[i];
          add_film_contact(*rows, film_slopes_of(forces, v1, v2, rate, u, i), group * kLanes + i,
                           *jac);
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
