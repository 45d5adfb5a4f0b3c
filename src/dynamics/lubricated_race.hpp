// Roller against a raceway with an oil film (src/lubrication/lubricated_line.hpp), sliced along the
// roller: the kinematics of race_contacts.hpp with another law. Beside the normal force and the two
// components of traction there is rolling resistance, whose pressure pulls on the roller's axis:
//
//   surface force along t   F_1 = -ratio v_1 - F_r       on the roller, lever R_slice
//   axis force along t      F_c = F_r 2 R/R_slice        R reduced radius
//   power                   P   = -Q p' + ... = Q p' + ratio |v|^2 + 2 F_r u
//
// The law is a function of four numbers of a slice, z = (p, p', u, |v|^2), and differentiated by
// these; rows carry that to the roller's directions.
#pragma once

#include "src/dynamics/race_contacts.hpp"
#include "src/lubrication/lubricated_line.hpp"

namespace cagetol {

/// What a race does to a pack of rollers, summed over the slices.
struct RaceTotals {
  Pack normal{};                ///< [N]
  Pack sliding{};               ///< normal force times sliding speed [W]
  Pack normal_r{}, normal_t{};  ///< of the force on the rollers [N]
  Pack drive{};                 ///< power of the turning race [W]
  /// Derivatives of the bodies' elastic energy by the speeds that make the film: it changes with
  /// these at a gap held still [J s/m], [J s].
  Pack energy_by_vt{}, energy_by_spin{};
};

/// Signed entrainment speed along t and its derivatives.
struct SignedEntrainment {
  Pack speed;
  Pack by_vt, by_spin;
};
inline SignedEntrainment signed_entrainment(const RaceSide& race, const RollerGroup& roller,
                                            const RollerPack& q) {
  const Pack lever = race.sign * (0.5 - race.radius / (race.radius + race.sign * roller.radius));
  const Pack forward = 0.5 * (race.sign * race.speed * race.radius - roller.radius * q.spin) +
                       lever * (q.vt - race.du_t);
  return {forward, lever, -0.5 * roller.radius};
}

/// Kinematics of one slice: see the top of race_contacts.hpp.
struct SliceMotion {
  double xi;                       ///< place along the roller [m]
  Pack radius;                     ///< of the roller there [m]
  Pack p, n_r, n_t, n_x, inverse;  ///< penetration, normal, s over the distance of the axes
  Pack place;                      ///< x of the slice [m]
  Pack rate, along;                ///< p', velocity of the axes along t
  Pack w_r, w_t;                   ///< turning of the roller's axis across itself
  Pack v1, v2;                     ///< sliding speeds
  Pack askew, swash;               ///< the race's axis along t, and what it does as it turns
};
template <bool moving, bool tilting>
SliceMotion slice_motion(const Slice& slice, const SliceGap& gap, const RollerGroup& roller,
                         const RollerPack& q, const RaceSide& race, const RingTilt* tilt) {
  SliceMotion m;
  m.xi = slice.position;
  m.p = gap.p;
  m.n_r = gap.n_r;
  m.n_t = gap.n_t;
  m.inverse = gap.inverse;
  m.place = q.x + m.xi;
  m.radius = roller.radius + (m.xi * roller.taper_slope - slice.drop);
  Pack v_r = q.vr + m.xi * q.b_r, v_t = q.vt + m.xi * q.b_t;
  m.n_x = Pack{};
  if constexpr (moving) {
    m.n_x = -(m.n_r * race.B_r + m.n_t * race.B_t);
    v_r -= race.du_r;
    v_t -= race.du_t;
  }
  if constexpr (tilting) {
    v_r -= m.place * tilt->rate_r;
    v_t -= m.place * tilt->rate_t;
  }
  m.rate = -(m.n_r * v_r + m.n_t * v_t);
  if constexpr (moving) m.rate -= m.n_x * q.vx;
  m.along = m.n_r * v_t - m.n_t * v_r;
  m.w_r = q.spin * q.a_r - q.b_t;
  m.w_t = q.spin * q.a_t + q.b_r;
  m.v1 = m.along - m.radius * q.spin;
  m.v2 = q.vx + m.radius * (m.n_r * m.w_t - m.n_t * m.w_r);
  m.askew = m.swash = Pack{};
  if constexpr (moving) {
    const double surface = race.sign * race.speed * race.radius;  // along t
    m.askew = race.B_r * m.n_t - race.B_t * m.n_r;
    m.swash = surface * m.askew;
    m.v1 -= surface;
    m.v2 -= m.swash;
  }
  if constexpr (tilting)
    m.v2 += race.sign * race.radius * (m.n_r * tilt->rate_r + m.n_t * tilt->rate_t);
  return m;
}

/// Change of one number of a slice's law with z = (p, p', u, v1, v2).
struct BySlice {
  Pack p, rate, u, v1, v2;
};

/// Adds the derivatives of one slice. `f`: forces with their derivatives by (p, p', u, |v|^2),
/// `storing` that of the bodies' elasticity.
template <bool moving, bool tilting>
void add_slice(const RollerPack& q, const RaceSide& race, const SliceMotion& m,
               const LineForces<Dual<Pack, 4>>& f, const Dual<Pack, 4>& storing,
               const SignedEntrainment& oil, Pack axis_share, GroupLinear& jac,
               [[maybe_unused]] RingTilt* tilt) {
  const Pack zero{}, one = splat(1.0), &v1 = m.v1, &v2 = m.v2, squared = v1 * v1 + v2 * v2;
  const Pack ratio = f.ratio.value, roll = f.rolling.value, normal = f.at.normal.value;
  [[maybe_unused]] const double surface = race.sign * race.speed * race.radius,
                                arm = race.sign * race.radius;
  const Pack *N = f.at.normal.slope, *G = f.ratio.slope, *F = f.rolling.slope,
             *S = storing.slope;  // by p, p', u, |v|^2
  const Pack bend = 2.0 * G[3];
  const BySlice by_n{N[0], N[1], N[2], zero, zero};
  const BySlice by_1{-G[0] * v1 - F[0], -G[1] * v1 - F[1], -G[2] * v1 - F[2],
                     -ratio - bend * v1 * v1, -bend * v1 * v2};
  const BySlice by_2{-G[0] * v2, -G[1] * v2, -G[2] * v2, by_1.v2, -ratio - bend * v2 * v2};
  const BySlice by_c{axis_share * F[0], axis_share * F[1], axis_share * F[2], zero, zero};
  // Net power = drive - what the contact takes.
  const Pack slide = 2.0 * ratio + bend * squared;
  BySlice net{
      (S[0] - N[0]) * m.rate - G[0] * squared - 2.0 * F[0] * oil.speed,
      (S[1] - N[1]) * m.rate + storing.value - normal - G[1] * squared - 2.0 * F[1] * oil.speed,
      (S[2] - N[2]) * m.rate - G[2] * squared - 2.0 * (F[2] * oil.speed + roll), -slide * v1,
      -slide * v2};
  if constexpr (moving) {  // the drive: (F_r - ratio v1) surface + F_2 swash
    net.p += surface * (F[0] - G[0] * v1) + m.swash * by_2.p;
    net.rate += surface * (F[1] - G[1] * v1) + m.swash * by_2.rate;
    net.u += surface * (F[2] - G[2] * v1) + m.swash * by_2.u;
    net.v1 += surface * by_1.v1 + m.swash * by_2.v1;
    net.v2 += surface * by_1.v2 + m.swash * by_2.v2;
  }
  const Pack f1 = -ratio * v1 - roll, f2 = -ratio * v2, along = f1 + axis_share * roll;
  // Rows over the roller's velocities, then the ring's tilt: of -p', v1, v2, and of the axis along
  // t.
  constexpr int rows = kLocalVelocities + (tilting ? 2 : 0);
  const Pack lean = m.n_r * q.a_t - m.n_t * q.a_r;
  Pack gn[rows] = {m.n_r, m.n_t, m.n_x, m.xi * m.n_r, m.xi * m.n_t, zero};
  Pack gc[rows] = {-m.n_t, m.n_r, zero, -m.xi * m.n_t, m.xi * m.n_r, zero};
  Pack g2[rows] = {zero, zero, one, m.radius * m.n_r, m.radius * m.n_t, m.radius * lean};
  if constexpr (tilting)
    for (int k = 0; k < 2; ++k) {
      gn[kLocalVelocities + k] = -m.place * gn[k];
      gc[kLocalVelocities + k] = -m.place * gc[k];
      g2[kLocalVelocities + k] = arm * gn[k];
    }
  const auto g1 = [&](int i) { return i == kLs ? -m.radius : gc[i]; };
  // As the axis moves along t by tau, n turns, and with it p', v1, v2 and the swash.
  const auto tau = [&](int j) { return moving && j == kLx ? m.askew : gc[j]; };
  const Pack rate_turn = -m.inverse * m.along, v1_turn = m.inverse * m.rate;
  Pack v2_turn = -m.inverse * m.radius * (m.n_r * m.w_r + m.n_t * m.w_t), swash_turn{};
  if constexpr (moving) {
    swash_turn = m.inverse * surface * (race.B_r * m.n_r + race.B_t * m.n_t);
    v2_turn -= swash_turn;
  }
  const Pack lean_r = -m.radius * q.spin * m.n_t, lean_t = m.radius * q.spin * m.n_r;
  // What v2 loses to the swash as the ring tilts.
  [[maybe_unused]] const Pack swashing[2] = {-arm * race.speed * m.n_t, arm * race.speed * m.n_r};

  const auto by_velocity = [&](const BySlice& by, int j) {
    Pack sum = -by.rate * gn[j] + by.v1 * g1(j) + by.v2 * g2[j];
    if (j == kLt) sum += by.u * oil.by_vt;
    if (j == kLs) sum += by.u * oil.by_spin;
    return sum;
  };
  const auto by_position = [&](const BySlice& by, int j, Pack turned) {
    Pack sum =
        -by.p * gn[j] + (turned + by.rate * rate_turn + by.v1 * v1_turn + by.v2 * v2_turn) * tau(j);
    if (j == kLar) sum += by.v2 * lean_r;
    if (j == kLat) sum += by.v2 * lean_t;
    if (j >= kLocalVelocities) sum += by.v2 * swashing[j - kLocalVelocities];
    return sum;
  };
  const Pack drive_turn = moving ? f2 * swash_turn : zero;
#pragma GCC unroll 8
  for (int j = 0; j < kLocalVelocities; ++j) {
    jac.power_velocity[j] += by_velocity(net, j);
    if (j < kLocalPositions) jac.power_position[j] += by_position(net, j, drive_turn);
  }
  if constexpr (tilting)
    for (int k = 0; k < 2; ++k) {
      const int j = kLocalVelocities + k;
      tilt->linear->power_velocity[k] += by_velocity(net, j);
      tilt->linear->power_position[k] +=
          by_position(net, j, drive_turn) - f2 * swashing[k];  // the drive's own swash
    }
  // What forces do, held fast, as n turns with t and with it the lever of F2.
  const Pack spread = m.inverse * normal, across = m.inverse * along, lever = m.inverse * f2;
#pragma GCC unroll 8
  for (int i = 0; i < rows; ++i) {
    Pack turned = spread * gc[i] - across * gn[i];
    if (moving && i == kLx) turned = spread * m.askew;
    if (i == kLar) turned -= m.radius * m.n_t * lever;
    if (i == kLat) turned += m.radius * m.n_r * lever;
    if (i == kLs) turned = -m.radius * (m.n_r * q.a_r + m.n_t * q.a_t) * lever;
    if constexpr (tilting) {
      if (i == kLocalVelocities) turned -= arm * m.n_t * lever;
      if (i == kLocalVelocities + 1) turned += arm * m.n_r * lever;
    }
    const auto on = [&](Pack n, Pack one_, Pack two, Pack c) {
      return gn[i] * n + g1(i) * one_ + g2[i] * two + (i == kLs ? zero : gc[i]) * c;
    };
    const BySlice by{on(by_n.p, by_1.p, by_2.p, by_c.p),
                     on(by_n.rate, by_1.rate, by_2.rate, by_c.rate),
                     on(by_n.u, by_1.u, by_2.u, by_c.u), on(zero, by_1.v1, by_2.v1, zero),
                     on(zero, by_1.v2, by_2.v2, zero)};
    const LinearRow row = linear_row<tilting>(i, jac, tilt);
#pragma GCC unroll 8
    for (int j = 0; j < kLocalVelocities; ++j) {
      row.velocity[j] += by_velocity(by, j);
      if (j < kLocalPositions) row.position[j] += by_position(by, j, turned);
    }
    if constexpr (tilting)
      for (int k = 0; k < 2; ++k) {
        row.tilt_velocity[k] += by_velocity(by, kLocalVelocities + k);
        row.tilt_position[k] += by_position(by, kLocalVelocities + k, turned);
      }
  }
  jac.position[kLs][kLar] -= m.radius * m.n_t * f2;
  jac.position[kLs][kLat] += m.radius * m.n_r * f2;
  if constexpr (tilting) {
    RingCoupling& coupling = tilt->linear->coupling;
    // n_x follows the tilt, and the force's lever on the ring the roller's axial place.
    coupling.position[kLx][0] -= normal * m.n_r;
    coupling.position[kLx][1] -= normal * m.n_t;
    coupling.to_position[0][kLx] -= normal * m.n_r - along * m.n_t;
    coupling.to_position[1][kLx] -= normal * m.n_t + along * m.n_r;
  }
}

/// `moving`, `tilting` as of race_contacts. `law`: of one slice.
template <bool linear, bool moving, bool tilting = false>
void lubricated_race(const BearingModel& model, const LubricatedLine& law,
                     const RollerGroup& roller, const RollerPack& q, const RaceSide& race,
                     RollerLoads& loads, GroupLinear* jac, Observation* seen, RaceTotals& totals,
                     RingTilt* tilt = nullptr) {
  const SignedEntrainment oil = signed_entrainment(race, roller, q);
  // 2 R/R_roller: with that of the race it adds up to two, so that the forces of a pair vanish.
  const Pack axis_share = 2.0 * race.radius / (race.radius + race.sign * roller.radius);
  const double surface = race.sign * race.speed * race.radius, arm = race.sign * race.radius;
  using D = std::conditional_t<linear, Dual<Pack, 4>, Pack>;
  LineSpeed<D> speed;
  if constexpr (linear)
    speed = line_speed<D>(law, variable<D>(oil.speed, 2));
  else
    speed = line_speed<Pack>(law, oil.speed);
  for (const Slice& slice : model.race_slices) {
    const SliceGap gap = slice_gap<moving>(roller, q, race, slice);
    Mask wet = roller.exists > 0.0;
    if (law.starved) wet &= -gap.p < law.layer;
    if (!any(wet)) continue;
    const SliceMotion m = slice_motion<moving, tilting>(slice, gap, roller, q, race, tilt);
    // Lanes without a contact take part with an open gap, whose forces are set to nothing.
    const Pack p = select(wet, m.p, splat(law.starved ? -0.5 * law.layer : -1e-5));
    const Pack squared = m.v1 * m.v1 + m.v2 * m.v2;
    const Pack one = select(wet, splat(1.0), Pack{});
    LineForces<D> f;
    if constexpr (linear)
      f = line_forces<D>(law, speed, -variable<D>(p, 0), -variable<D>(m.rate, 1),
                         variable<D>(squared, 3));
    else
      f = line_forces<Pack>(law, speed, -p, -m.rate, squared);
    f.at.normal = f.at.normal * one;
    f.ratio = f.ratio * one;
    f.rolling = f.rolling * one;
    const Pack normal = value_of(f.at.normal), ratio = value_of(f.ratio),
               roll = value_of(f.rolling);
    const Pack f1 = -ratio * m.v1 - roll, f2 = -ratio * m.v2, axis = roll * axis_share;
    const Pack f_r = normal * m.n_r - (f1 + axis) * m.n_t,
               f_t = normal * m.n_t + (f1 + axis) * m.n_r;
    const Pack lean = m.n_r * q.a_t - m.n_t * q.a_r;
    loads.f[kLr] += f_r;
    loads.f[kLt] += f_t;
    if constexpr (moving) loads.f[kLx] += normal * m.n_x;
    loads.f[kLx] += f2;
    loads.f[kLar] += m.xi * f_r + m.radius * m.n_r * f2;
    loads.f[kLat] += m.xi * f_t + m.radius * m.n_t * f2;
    loads.f[kLs] += m.radius * (f2 * lean - f1);
    if constexpr (tilting) {
      tilt->moment[0] += arm * m.n_r * f2 - m.place * f_r;
      tilt->moment[1] += arm * m.n_t * f2 - m.place * f_t;
    }
    if constexpr (linear) {
      totals.normal += normal;
      totals.sliding += normal * sqrt(squared);
      totals.normal_r += normal * m.n_r;
      totals.normal_t += normal * m.n_t;
      if constexpr (moving) totals.drive += (roll - ratio * m.v1) * surface + f2 * m.swash;
      const Pack film = value_of(f.at.film) * one, steady = value_of(f.at.steady) * one;
      seen->rub(kRaceSliding, sum(ratio * squared));
      seen->rub(kRollingResistance, sum(2.0 * roll * oil.speed));
      seen->damp(kSqueeze, sum((film - steady) * m.rate));
      seen->damp(kDamping, sum((normal - film) * m.rate));
      const auto [energy, pushing] = elastic_store(law, f.at, variable<D>(p, 0));
      const D storing = pushing * one;
      seen->elastic_energy += sum(energy.value * one);
      totals.energy_by_vt += energy.slope[2] * one * oil.by_vt;
      totals.energy_by_spin += energy.slope[2] * one * oil.by_spin;
      seen->damp(kFilm, sum((steady - storing.value) * m.rate));
      seen->thinnest_film = std::min(
          seen->thinnest_film, smallest(select(normal > model.film_watch,
                                               value_of(f.at.state.thickness), splat(kNoFilm))));
      add_slice<moving, tilting>(q, race, m, f, storing, oil, axis_share, *jac, tilt);
    }
  }
}

}  // namespace cagetol
