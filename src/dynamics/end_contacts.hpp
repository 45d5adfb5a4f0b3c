// Roller ends against the end walls of their pocket and against the flanges of the outer ring. Each
// end e = +-1 carries two points off the axis, at radial h and tangential tau from the centre of
// the end face, so that the force rights a skewed roller and the spin enters the sliding speed. The
// wall is normal to the cage's axis A, the flange to the bearing's axis:
//   wall:    p = e (x - x_c + A . D - w_x) + L_w/2 - L_j/2,
//   flange:  p = e (x - h a_r - tau a_t) - c_fl/2
// with D the point's radial-plane place relative to the cage's geometric centre, x at the point
// likewise less h a_r + tau a_t, w_x how far the wall has bent along e_x. The points do not spin
// with the roller. A wall's keep their place beside the pocket and turn with phi' (so that moving
// roller and cage together changes nothing), a flange's beside the roller's orbit and turn with
// theta'; p depends on that angle through `turn` = e dp/d(angle) at a centre held still.
#pragma once

#include "src/dynamics/pocket_frame.hpp"
#include "src/lubrication/flat_film.hpp"

namespace cagetol {

/// Oil of one point of an end (src/lubrication/flat_film.hpp): its forces at penetration p, and
/// their slopes by p and p'.
struct EndFilm {
  Pack normal{}, normal_p{}, normal_rate{};  ///< pushes apart [N]
  Pack drag{}, drag_p{};                     ///< times the sliding velocity, against it [N s/m]
};
template <bool linear>
EndFilm end_film(const FlatFilm& law, Mask wet, Pack p, Pack rate) {
  EndFilm film;
  const Pack gap = select(wet, -p, splat(0.5 * law.layer)), one = select(wet, splat(1.0), Pack{});
  if constexpr (linear) {
    using D = Dual<Pack, 2>;
    const FlatFilmForces<D> f = flat_film(law, -variable<D>(-gap, 0), -variable<D>(rate, 1));
    film = {f.normal.value * one, f.normal.slope[0] * one, f.normal.slope[1] * one,
            f.drag.value * one, f.drag.slope[0] * one};
  } else {
    const FlatFilmForces<Pack> f = flat_film(law, gap, -rate);
    film.normal = f.normal * one;
    film.drag = f.drag * one;
  }
  return film;
}

/// False where no point of an end can touch its wall, were walls `margin` [m] nearer: all lie below
/// what the whole face reaches.
inline bool walls_in_reach(const BearingModel& model, const RollerGroup& roller,
                           const PocketFrame& f, Pack margin) {
  const double half = model.roller_half_length;
  const Pack reach = roller.radius * (abs(f.a_R - f.A_R) + abs(f.a_T - f.A_T)) +
                     half * abs(f.A_R * f.a_R + f.A_T * f.a_T);
  const Pack offset = abs(f.X + f.A_R * f.D_R + f.A_T * f.D_T);
  return any(offset + reach > roller.half_length - half - margin);
}

/// Slopes of one lane's film.
inline FilmContactSlopes end_film_slopes(const EndFilm& film, double v1, double v2, double rate,
                                         int lane) {
  using F = FilmContactSlopes;
  const double drag = film.drag[lane], drag_p = film.drag_p[lane], squared = v1 * v1 + v2 * v2;
  F to;
  to.force[F::kP][0] = film.normal_p[lane];
  to.force[F::kRate][0] = film.normal_rate[lane];
  to.force[F::kP][1] = -drag_p * v1;
  to.force[F::kP][2] = -drag_p * v2;
  to.force[F::kV1][1] = to.force[F::kV2][2] = -drag;
  to.power[F::kP] = -film.normal_p[lane] * rate - drag_p * squared;
  to.power[F::kRate] = -film.normal_rate[lane] * rate - film.normal[lane];
  to.power[F::kV1] = -2 * drag * v1;
  to.power[F::kV2] = -2 * drag * v2;
  return to;
}

template <bool linear>
void wall_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                   const PocketFrame& f, const BorderState& b, const ModalState& modal, int group,
                   RollerLoads& loads, BorderLoads& border, ContactRows* rows, Linearisation* jac,
                   Observation* seen) {
  const double half = model.roller_half_length, phi = b.phi_rate;
  PocketLoads on;
  bool touched = false;
  for (int end = 0; end < 2; ++end) {
    const double e = 2 * end - 1, xi = e * half;
    const Pack V_R = f.v_R + xi * f.b_R, V_T = f.v_T + xi * f.b_T;
    for (int side = 0; side < 2; ++side) {
      const auto [h, tau] = model.wall_points[static_cast<std::size_t>(side)];
      const int point = 2 * static_cast<int>(model.bar_stations.size()) + 2 * end + side;
      const Pack D_R = f.D_R + xi * f.a_R + h, D_T = f.D_T + xi * f.a_T + tau;
      const Pack X = f.X + xi - h * f.a_R - tau * f.a_T;
      const Pack turn = h * (f.A_T - f.a_T) - tau * (f.A_R - f.a_R);
      Pack p = e * (X + f.A_R * D_R + f.A_T * D_T) - roller.half_length;
      Pack rate = e * (f.v_x - h * f.b_R - tau * f.b_T + f.A_R * V_R + f.A_T * V_T + f.dA_R * D_R +
                       f.dA_T * D_T + turn * phi);
      if (!any((p > -model.wall_film.layer - modal.farthest) & (roller.exists > 0.0))) continue;
      if (modal.flexible()) {
        p -= e * modal.along(group, point, 2, modal.q);
        rate -= e * modal.along(group, point, 2, modal.rate);
      }
      const Mask touching = (p > 0.0) & (roller.exists > 0.0),
                 wet = (p > -model.wall_film.layer) & (roller.exists > 0.0);
      if (!any(wet)) continue;
      touched = true;
      const Pack lever_R = D_R - X * f.A_R, lever_T = D_T - X * f.A_T;
      Pack v1 = V_R - q.spin * tau - X * f.dA_R + phi * lever_T;
      Pack v2 = V_T + q.spin * h - X * f.dA_T - phi * lever_R;
      if (modal.flexible()) {
        v1 -= modal.along(group, point, 0, modal.rate);
        v2 -= modal.along(group, point, 1, modal.rate);
      }
      const auto normal = normal_force(model.wall, select(touching, p, splat(-1.0)), rate);
      const Pack speed2 = v1 * v1 + v2 * v2;
      const auto fr = friction(model.friction[kEndPair], speed2);
      EndFilm film;
      Pack g = fr.ratio * normal.force, push = e * normal.force;
      if (model.wall_film.on) {
        film = end_film<linear>(model.wall_film, wet, p, rate);
        g += film.drag;
        push += e * film.normal;
      }
      const Pack f1 = -g * v1, f2 = -g * v2;
      if (modal.flexible()) modal.push(group, point, -f1, -f2, push);
      on.f_R += f1 - push * f.A_R;
      on.f_T += f2 - push * f.A_T;
      on.f_x -= push;
      on.t_R += xi * f1 + push * (h - xi * f.A_R);
      on.t_T += xi * f2 + push * (tau - xi * f.A_T);
      on.t_s += h * f2 - tau * f1;
      on.c_phi += f1 * lever_T - f2 * lever_R - push * turn;
      on.c_AR -= push * D_R + X * f1;
      on.c_AT -= push * D_T + X * f2;
      if constexpr (linear) {
        double* const force = seen->wall_force.data() + group * kLanes;
        store(force, load(force) + normal.force + film.normal);
        seen->rub(kEndFriction, sum(g * speed2));
        seen->damp(kDamping, sum((normal.force - normal.elastic) * rate));
        if (model.wall_film.on) seen->damp(kSqueeze, sum(film.normal * rate));
        seen->elastic_energy += sum(normal.elastic * max(p, Pack{})) / (model.wall.exponent + 1);
        for (int i = 0; i < kLanes; ++i) {
          if (!wet[i]) continue;
          const double A_R = f.A_R[i], A_T = f.A_T[i];
          const double rolling[3][kLocalVelocities] = {
              {-e * A_R, -e * A_T, -e, e * (h - xi * A_R), e * (tau - xi * A_T), 0},
              {1, 0, 0, xi, 0, -tau},
              {0, 1, 0, 0, xi, h}};
          const double caging[3][kCageRigid] = {
              {e * A_R, e * A_T, e, -e * turn[i], -e * D_R[i], -e * D_T[i]},
              {-1, 0, 0, lever_T[i], -X[i], 0},
              {0, -1, 0, -lever_R[i], 0, -X[i]}};
          fill_pocket_rows<3>(f, b, modal, group, point, i, rolling, caging,
                              {{0, 0, e}, {-1, 0, 0}, {0, -1, 0}}, *rows);
          if (touching[i])
            add_contact(
                *rows,
                {normal.force[i], normal.stiffness[i], normal.damping[i], fr.ratio[i], fr.bend[i],
                 v1[i], v2[i], normal.elastic[i], normal.elastic_stiffness[i], rate[i]},
                group * kLanes + i, *jac);
          if (model.wall_film.on)
            add_film_contact(*rows, end_film_slopes(film, v1[i], v2[i], rate[i], i),
                             group * kLanes + i, *jac);
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

/// False where no point of an end can touch its flange, were flanges `margin` [m] nearer.
inline bool flanges_in_reach(const BearingModel& model, const RollerGroup& roller,
                             const RollerPack& q, Pack margin) {
  const Pack reach = abs(q.x) + roller.radius * (abs(q.a_r) + abs(q.a_t));
  return any(reach > model.flange_half_clearance - margin);
}

template <bool linear>
void flange_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                     int group, RollerLoads& loads, Linearisation* jac, Observation* seen) {
  const double half = model.roller_half_length;
  if (!flanges_in_reach(model, roller, q, splat(model.flange_film.layer))) return;
  for (int end = -1; end <= 1; end += 2) {
    const double e = end, xi = e * half;
    for (const EndPoint& point : model.flange_points) {
      const double h = point.radial, tau = point.tangential;
      const Pack p = e * (q.x - h * q.a_r - tau * q.a_t) - model.flange_half_clearance;
      const Pack turn = tau * q.a_r - h * q.a_t;
      const Pack rate = e * (q.vx - h * q.b_r - tau * q.b_t + turn * q.omega);
      const Mask touching = (p > 0.0) & (roller.exists > 0.0),
                 wet = (p > -model.flange_film.layer) & (roller.exists > 0.0);
      if (!any(wet)) continue;
      const Pack v1 = q.vr + xi * q.b_r - q.spin * tau, v2 = q.vt + xi * q.b_t + q.spin * h;
      const auto normal = normal_force(model.flange, select(touching, p, splat(-1.0)), rate);
      const Pack speed2 = v1 * v1 + v2 * v2;
      const auto fr = friction(model.friction[kFlangePair], speed2);
      EndFilm film;
      Pack g = fr.ratio * normal.force, push = e * normal.force;
      if (model.flange_film.on) {
        film = end_film<linear>(model.flange_film, wet, p, rate);
        g += film.drag;
        push += e * film.normal;
      }
      const Pack f1 = -g * v1, f2 = -g * v2;
      loads.f[kLr] += f1;
      loads.f[kLt] += f2 - push * turn / q.r;
      loads.f[kLx] -= push;
      loads.f[kLar] += xi * f1 + h * push;
      loads.f[kLat] += xi * f2 + tau * push;
      loads.f[kLs] += h * f2 - tau * f1;
      if constexpr (linear) {
        double* const force = seen->flange_force.data() + group * kLanes;
        store(force, load(force) + normal.force + film.normal);
        seen->rub(kFlangeFriction, sum(g * speed2));
        seen->damp(kDamping, sum((normal.force - normal.elastic) * rate));
        if (model.flange_film.on) seen->damp(kSqueeze, sum(film.normal * rate));
        seen->elastic_energy += sum(normal.elastic * max(p, Pack{})) / (model.flange.exponent + 1);
        GroupLinear& to = jac->groups[static_cast<std::size_t>(group)];
        const Pack d11 = normal.force * (fr.ratio + fr.bend * v1 * v1),
                   d12 = normal.force * fr.bend * v1 * v2;
        const Pack d22 = normal.force * (fr.ratio + fr.bend * v2 * v2);
        const Pack gn[] = {Pack{},       -e * turn / q.r, splat(-e),
                           splat(e * h), splat(e * tau),  Pack{}};
        const double g1[] = {1, 0, 0, xi, 0, -tau}, g2[] = {0, 1, 0, 0, xi, h};
        auto lost =
            dissipation_slopes(normal.force, normal.stiffness, normal.damping, fr.ratio, fr.bend,
                               v1, v2, normal.elastic, normal.elastic_stiffness, rate);
        if (model.flange_film.on) {
          lost.p += film.normal_p * rate + film.drag_p * speed2;
          lost.rate += film.normal_rate * rate + film.normal;
          lost.v1 += 2.0 * film.drag * v1;
          lost.v2 += 2.0 * film.drag * v2;
        }
        // Points and directions turn with the orbit, and so do the forces; add_inertial, which
        // takes these for held still, does the same again: less that.
        const Pack rate_turn =
            e * (tau * q.b_r - h * q.b_t + q.omega * (tau * q.a_t + h * q.a_r));  // dp'/d(theta)
        to.position[kLr][kLt] -= (f2 - push * turn / q.r) / q.r;
        to.position[kLt][kLt] += f1 / q.r;
        to.position[kLar][kLt] -= (xi * f2 + tau * push) / q.r;
        to.position[kLat][kLt] += (xi * f1 + h * push) / q.r;
        for (int i = 0; i < kLocalVelocities; ++i) {
          to.power_velocity[i] += lost.rate * gn[i] - lost.v1 * g1[i] - lost.v2 * g2[i];
          if (i < kLocalPositions) to.power_position[i] += lost.p * gn[i];
          const Pack slide = gn[i] - fr.ratio * v1 * g1[i] - fr.ratio * v2 * g2[i];
          Pack stiffness = slide * normal.stiffness, damped = slide * normal.damping;
          Pack w1 = d11 * g1[i] + d12 * g2[i], w2 = d12 * g1[i] + d22 * g2[i];
          if (model.flange_film.on) {
            stiffness += gn[i] * film.normal_p - film.drag_p * (v1 * g1[i] + v2 * g2[i]);
            damped += gn[i] * film.normal_rate;
            w1 += film.drag * g1[i];
            w2 += film.drag * g2[i];
          }
          for (int j = 0; j < kLocalVelocities; ++j)
            to.velocity[i][j] -= damped * gn[j] + w1 * g1[j] + w2 * g2[j];
          for (int j = 0; j < kLocalPositions; ++j) to.position[i][j] -= stiffness * gn[j];
          to.position[i][kLr] -= q.omega * w2;
          to.position[i][kLt] += (damped * rate_turn - xi * (w1 * q.b_t - w2 * q.b_r)) / q.r;
          to.position[i][kLar] += e * q.omega * tau * damped;
          to.position[i][kLat] -= e * q.omega * h * damped;
        }
      }
    }
  }
}

}  // namespace cagetol
