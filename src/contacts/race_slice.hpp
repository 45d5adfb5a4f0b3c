// A slice of a roller at a raceway: kinematics, loads and derivatives, whatever the law. n is the
// direction of the force on the roller, d from the axis of the race to the axis of the roller in
// the radial plane at the slice, s = +1 inside (inner race), -1 outside:
//   n = s d/|d|,  p = s (R_race - |d|) + R_slice
//   p' = -n . (velocity of the roller's axis - velocity of the race's axis)
// The inner race may be tilted: its axis passes the slice at u + B X, X the slice's axial place, so
// n has the axial part -n.B. Sliding speeds: v1 along t = e_x x n, v2 along e_x, of the roller's
// surface at -R_slice n relative to the race's surface: a tapered or profiled roller slides
// differentially along its length. Where the tilt is free it has its own row in each channel: the
// axis at the slice moves with B' X, the race's surface axially with -s R_race n.B'.
//
// A law answers with four numbers of the slice, functions of z = (p, p', u, |v|^2) with u the
// entrainment speed:
//   surface force along t   F_1 = -ratio v_1 - F_r       on the roller, lever R_slice
//   axis force along t      F_c = F_r 2 R/R_slice        R reduced radius, F_r rolling resistance
//   surface force along x   F_2 = -ratio v_2
//   normal force            Q along n
// Above 400 lines: one slice, its loads beside their derivatives.
#pragma once

#include "src/contact_laws/normal_force.hpp"
#include "src/contacts/contact_frame.hpp"
#include "src/numerics/dual.hpp"

namespace cagetol {

struct RaceSide {
  double sign;                ///< s
  double radius;              ///< R_race [m]
  double speed;               ///< of the race about its axis [rad/s]
  Pack u_r, u_t, du_r, du_t;  ///< its centre and its velocity in the rollers' directions
  Pack B_r, B_t;              ///< slope of its axis, likewise
  double x = 0, x_rate = 0;   ///< of its ring [m], [m/s]
  const std::array<Waviness, kHarmonics>* form = nullptr;  ///< of the raceway (wavy_race.hpp)
  double turned = 0;                                       ///< angle of its ring [rad]

  double surface() const { return sign * speed * radius; }  ///< its speed along t [m/s]
  double arm() const { return sign * radius; }              ///< of its surface along n [m]
};

/// Mean speed at which both surfaces carry oil into the contact, as seen from the contact, which
/// travels with the roller; the same along the whole roller. Positive along t.
struct Entrainment {
  Pack speed;           ///< u [m/s]
  Pack by_vt, by_spin;  ///< its derivatives
};
inline Entrainment entrainment(const RaceSide& race, const RollerGroup& roller,
                               const RollerPack& q) {
  const Pack lever = race.sign * (0.5 - race.radius / (race.radius + race.sign * roller.radius));
  const Pack forward = 0.5 * (race.surface() - roller.radius * q.spin) + lever * (q.vt - race.du_t);
  return {forward, lever, -0.5 * roller.radius};
}
/// The free tilt of the inner ring, as a pack of rollers sees it.
struct RingTilt {
  Pack rate_r, rate_t;  ///< B' in the rollers' directions
  Pack moment[2] = {};  ///< of the rollers on the ring, conjugate to (B_r, B_t)
  TiltLinear* linear = nullptr;
};

/// What a race does to a pack of rollers, summed over the slices.
struct RaceTotals {
  Pack normal{};                ///< [N]
  Pack heaviest{};              ///< largest normal force of a slice [N]
  Pack sliding{};               ///< normal force times sliding speed [W]
  Pack rubbing{};               ///< power of sliding [W]
  Pack normal_r{}, normal_t{};  ///< of the elastic force on the rollers [N]
  Pack drive{};                 ///< power of the turning race [W]
  /// Derivatives of the bodies' elastic energy by the speeds that make the film: it changes with
  /// these at a gap held still [J s/m], [J s].
  Pack energy_by_vt{}, energy_by_spin{};
};

/// What the form of a raceway adds at a pack of rollers (wavy_race.hpp).
struct WavyRace {
  Pack w, rate;             ///< w [m], w' [m/s]
  Pack g[2], H[2][2];       ///< by d, in r and t [-], [1/m]
  Pack rate_by_place[2];    ///< of w' [1/s]
  Pack w_t, w_t_by[2];      ///< change with time alone [m/s], and of that with place [1/s]
  Pack rate_by_time, w_tt;  ///< of w' and of w_t [m/s^2]
  Pack power_by_time{};     ///< net power of the slices with time alone [W/s]
};

/// A slice's penetration, its normal, and s over the distance of the axes.
struct SliceGap {
  Pack p, n_r, n_t, inverse;
};
/// `moving`: the race may move and be tilted; else `race` turns where it stands, straight and
/// centred, and nothing of what that would do is computed. `tilting`: its tilt is free.
template <bool moving = true>
[[gnu::always_inline]] inline SliceGap slice_gap(const RollerGroup& roller, const RollerPack& q,
                                                 const RaceSide& race, const Slice& slice) {
  Pack d_r = q.r + slice.position * q.a_r, d_t = slice.position * q.a_t;
  if constexpr (moving) {
    const Pack place = q.x + slice.position - race.x;
    d_r = d_r - race.u_r - race.B_r * place;
    d_t = d_t - race.u_t - race.B_t * place;
  }
  SliceGap gap;
  const Pack distance = sqrt(d_r * d_r + d_t * d_t, gap.inverse);
  gap.inverse *= race.sign;
  gap.n_r = d_r * gap.inverse;
  gap.n_t = d_t * gap.inverse;
  gap.p = race.sign * (race.radius - distance) + roller.radius +
          (slice.position * roller.taper_slope - slice.drop);
  return gap;
}

struct SliceMotion {
  double xi;                       ///< place along the roller [m]
  Pack radius;                     ///< of the roller there [m]
  Pack p, n_r, n_t, n_x, inverse;  ///< penetration, normal, s over the distance of the axes
  Pack place;                      ///< x of the slice [m]
  Pack rate, along;                ///< p', velocity of the axes along t
  Pack w_r, w_t;                   ///< turning of the roller's axis across itself
  Pack v1, v2;                     ///< sliding speeds
  Pack askew, drift;  ///< the race's axis along t, and the axial speed of its surface due to it
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
  m.place = q.x + m.xi - race.x;
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
  if constexpr (moving) m.rate -= m.n_x * (q.vx - race.x_rate);
  m.along = m.n_r * v_t - m.n_t * v_r;
  m.w_r = q.spin * q.a_r - q.b_t;
  m.w_t = q.spin * q.a_t + q.b_r;
  m.v1 = m.along - m.radius * q.spin;
  m.v2 = q.vx + m.radius * (m.n_r * m.w_t - m.n_t * m.w_r);
  m.v1 -= race.surface();
  m.askew = m.drift = Pack{};
  if constexpr (moving) {
    m.askew = race.B_r * m.n_t - race.B_t * m.n_r;
    m.drift = race.surface() * m.askew;
    m.v2 -= m.drift + race.x_rate;
  }
  if constexpr (tilting) m.v2 += race.arm() * (m.n_r * tilt->rate_r + m.n_t * tilt->rate_t);
  return m;
}

/// Forces of one slice [N]: the law's, and what they are along t.
struct SliceForces {
  Pack normal, ratio, rolling;  ///< Q, traction over sliding speed [N s/m], F_r
  Pack f1, f2;                  ///< on the surface along t and along x
  Pack along;                   ///< on surface and axis along t
};
/// `axis_share`: F_c/F_r.
inline SliceForces slice_forces(const SliceMotion& m, Pack normal, Pack ratio, Pack rolling,
                                Pack axis_share) {
  const Pack f1 = -ratio * m.v1 - rolling;
  return {normal, ratio, rolling, f1, -ratio * m.v2, f1 + axis_share * rolling};
}

/// Adds them to the loads on rollers and ring.
template <bool moving, bool tilting>
void add_slice_loads(const RollerPack& q, const RaceSide& race, const SliceMotion& m,
                     const SliceForces& on, RollerLoads& loads, [[maybe_unused]] RingTilt* tilt) {
  const Pack f_r = on.normal * m.n_r - on.along * m.n_t, f_t = on.normal * m.n_t + on.along * m.n_r;
  const Pack lean = m.n_r * q.a_t - m.n_t * q.a_r;
  loads.f[kLr] += f_r;
  loads.f[kLt] += f_t;
  if constexpr (moving) loads.f[kLx] += on.normal * m.n_x;
  loads.f[kLx] += on.f2;
  loads.f[kLar] += m.xi * f_r + m.radius * m.n_r * on.f2;
  loads.f[kLat] += m.xi * f_t + m.radius * m.n_t * on.f2;
  loads.f[kLs] += m.radius * (on.f2 * lean - on.f1);
  if constexpr (tilting) {
    tilt->moment[0] += race.arm() * m.n_r * on.f2 - m.place * f_r;
    tilt->moment[1] += race.arm() * m.n_t * on.f2 - m.place * f_t;
  }
}

/// The law's numbers with their derivatives by z = (p, p', u, |v|^2).
struct SliceLaw {
  using D = Dual<Pack, 4>;
  D normal, ratio, rolling;
  D storing;  ///< force that stores elastic energy as the gap closes [N]
};

/// Change of one number of a slice with (p, p', u, v1, v2).
struct BySlice {
  Pack p, rate, u, v1, v2;
};

/// Changes of the forces along n, t (surface), x (surface), and t (axis).
struct ForceSlopes {
  BySlice n, one, two, axis;
};
inline ForceSlopes force_slopes(const SliceLaw& law, const SliceMotion& m, Pack axis_share) {
  const Pack zero{}, &v1 = m.v1, &v2 = m.v2, ratio = law.ratio.value;
  const Pack *N = law.normal.slope, *G = law.ratio.slope, *F = law.rolling.slope;
  const Pack bend = 2.0 * G[3], across = -bend * v1 * v2;
  return {
      {N[0], N[1], N[2], zero, zero},
      {-G[0] * v1 - F[0], -G[1] * v1 - F[1], -G[2] * v1 - F[2], -ratio - bend * v1 * v1, across},
      {-G[0] * v2, -G[1] * v2, -G[2] * v2, across, -ratio - bend * v2 * v2},
      {axis_share * F[0], axis_share * F[1], axis_share * F[2], zero, zero}};
}

/// Change of the net power: the drive of the turning race less what the contact takes,
///   (F_r - ratio v_1) surface + F_2 drift - (Q p' + ratio |v|^2 + 2 F_r u), elastic part left out.
inline BySlice net_power_slopes(const SliceLaw& law, const SliceMotion& m, const RaceSide& race,
                                const ForceSlopes& by, Pack u) {
  const Pack &v1 = m.v1, &v2 = m.v2, squared = v1 * v1 + v2 * v2;
  const Pack *N = law.normal.slope, *G = law.ratio.slope, *F = law.rolling.slope,
             *S = law.storing.slope;
  const Pack slide = 2.0 * law.ratio.value + 2.0 * G[3] * squared;
  BySlice net{(S[0] - N[0]) * m.rate - G[0] * squared - 2.0 * F[0] * u,
              (S[1] - N[1]) * m.rate + law.storing.value - law.normal.value - G[1] * squared -
                  2.0 * F[1] * u,
              (S[2] - N[2]) * m.rate - G[2] * squared - 2.0 * (F[2] * u + law.rolling.value),
              -slide * v1, -slide * v2};
  const double surface = race.surface();
  net.p += surface * (F[0] - G[0] * v1) + m.drift * by.two.p;
  net.rate += surface * (F[1] - G[1] * v1) + m.drift * by.two.rate;
  net.u += surface * (F[2] - G[2] * v1) + m.drift * by.two.u;
  net.v1 += surface * by.one.v1 + m.drift * by.two.v1;
  net.v2 += surface * by.one.v2 + m.drift * by.two.v2;
  return net;
}

/// Rows of a slice over the roller's velocities, then the ring's tilt: of -p', of the axis along t,
/// of v2 (that of v1 is the axis' less R_slice times the spin); and how the same change as the axis
/// moves along t, which turns n.
/// `wavy`: the race is no circle.
template <bool moving, bool tilting, bool wavy = false>
struct SliceRows {
  static constexpr int kRows = kLocalVelocities + (tilting ? 2 : 0);
  Pack gn[kRows], gc[kRows], g2[kRows];
  Pack radius, askew;
  Pack rate_turn, v1_turn, v2_turn, drift_turn;
  Pack lean_r, lean_t;  ///< of v2 by the lean of the roller's axis
  Pack drifting[2];     ///< of v2 by the ring's tilt
  Pack rate_by[2];      ///< of p' by place, where wavy

  SliceRows(const RollerPack& q, const RaceSide& race, const SliceMotion& m)
      : gn{m.n_r, m.n_t, m.n_x, m.xi * m.n_r, m.xi * m.n_t, Pack{}},
        gc{-m.n_t, m.n_r, Pack{}, -m.xi * m.n_t, m.xi * m.n_r, Pack{}},
        g2{Pack{},           Pack{},           splat(1.0),
           m.radius * m.n_r, m.radius * m.n_t, m.radius * (m.n_r * q.a_t - m.n_t * q.a_r)},
        radius(m.radius),
        askew(m.askew) {
    if constexpr (tilting)
      for (int k = 0; k < 2; ++k) {
        gn[kLocalVelocities + k] = -m.place * gn[k];
        gc[kLocalVelocities + k] = -m.place * gc[k];
        g2[kLocalVelocities + k] = race.arm() * gn[k];
      }
    rate_turn = -m.inverse * m.along;
    v1_turn = m.inverse * m.rate;
    v2_turn = -m.inverse * m.radius * (m.n_r * m.w_r + m.n_t * m.w_t);
    drift_turn = Pack{};
    if constexpr (moving) {
      drift_turn = m.inverse * race.surface() * (race.B_r * m.n_r + race.B_t * m.n_t);
      v2_turn -= drift_turn;
    }
    lean_r = -m.radius * q.spin * m.n_t;
    lean_t = m.radius * q.spin * m.n_r;
    drifting[0] = -race.surface() * m.n_t;
    drifting[1] = race.surface() * m.n_r;
  }

  void add_form(const WavyRace& form) {
    for (int i = 0; i < 2; ++i) {
      gn[i] -= form.g[i];
      rate_by[i] = form.rate_by_place[i];
    }
  }

  Pack g1(int i) const { return i == kLs ? -radius : gc[i]; }
  /// Motion of the axis along t.
  Pack tau(int j) const { return moving && j == kLx ? askew : gc[j]; }

  /// Change of a number with velocity j.
  [[gnu::always_inline]] Pack by_velocity(const BySlice& by, const Entrainment& oil, int j) const {
    Pack sum = -by.rate * gn[j] + by.v1 * g1(j) + by.v2 * g2[j];
    if (j == kLt) sum += by.u * oil.by_vt;
    if (j == kLs) sum += by.u * oil.by_spin;
    return sum;
  }
  /// And with position j; `turned`: with the turning of n alone.
  [[gnu::always_inline]] Pack by_position(const BySlice& by, Pack turned, int j) const {
    Pack sum =
        -by.p * gn[j] + (turned + by.rate * rate_turn + by.v1 * v1_turn + by.v2 * v2_turn) * tau(j);
    if constexpr (wavy)
      if (j < 2) sum += by.rate * rate_by[j];
    if (j == kLar) sum += by.v2 * lean_r;
    if (j == kLat) sum += by.v2 * lean_t;
    if (j >= kLocalVelocities) sum += by.v2 * drifting[j - kLocalVelocities];
    return sum;
  }
};

/// Row of the derivatives: of a local direction of the roller, or, beyond these, of the tilt's.
struct LinearRow {
  Pack *position, *velocity;            ///< over the roller's directions
  Pack *tilt_position, *tilt_velocity;  ///< over the tilt
};
template <bool tilting>
LinearRow linear_row(int i, GroupLinear& of_roller, [[maybe_unused]] RingTilt* tilt) {
  if constexpr (tilting) {
    TiltLinear& of_tilt = *tilt->linear;
    RingCoupling& c = of_tilt.coupling;
    if (const int k = i - kLocalVelocities; k >= 0)
      return {c.to_position[k], c.to_velocity[k], of_tilt.position[k], of_tilt.velocity[k]};
    return {of_roller.position[i], of_roller.velocity[i], c.position[i], c.velocity[i]};
  }
  return {of_roller.position[i], of_roller.velocity[i], nullptr, nullptr};
}

/// Adds the gradient of the net power.
template <bool moving, bool tilting, bool wavy>
[[gnu::always_inline]] inline void add_net_power(const SliceRows<moving, tilting, wavy>& rows,
                                                 const BySlice& net, const SliceForces& on,
                                                 const Entrainment& oil, GroupLinear& jac,
                                                 [[maybe_unused]] RingTilt* tilt) {
  const Pack drive_turn = moving ? on.f2 * rows.drift_turn : Pack{};
#pragma GCC unroll 8
  for (int j = 0; j < kLocalVelocities; ++j) {
    jac.power_velocity[j] += rows.by_velocity(net, oil, j);
    if (j < kLocalPositions) jac.power_position[j] += rows.by_position(net, drive_turn, j);
  }
  if constexpr (tilting)
    for (int k = 0; k < 2; ++k) {
      const int j = kLocalVelocities + k;
      tilt->linear->power_velocity[k] += rows.by_velocity(net, oil, j);
      tilt->linear->power_position[k] +=
          rows.by_position(net, drive_turn, j) - on.f2 * rows.drifting[k];  // the drive's own drift
    }
}

/// What the forces, held fast, do to direction i as n turns with t, and with it the lever of F2.
template <bool moving, bool tilting, bool wavy>
[[gnu::always_inline]] inline Pack turned_force(const SliceRows<moving, tilting, wavy>& rows,
                                                const SliceForces& on, const SliceMotion& m,
                                                const RollerPack& q, const RaceSide& race, int i) {
  const Pack spread = m.inverse * on.normal, lever = m.inverse * on.f2;
  Pack turned = spread * rows.gc[i] - m.inverse * on.along * rows.gn[i];
  if (moving && i == kLx) turned = spread * m.askew;
  if (i == kLar) turned -= m.radius * m.n_t * lever;
  if (i == kLat) turned += m.radius * m.n_r * lever;
  if (i == kLs) turned = -m.radius * (m.n_r * q.a_r + m.n_t * q.a_t) * lever;
  if (i == kLocalVelocities) turned -= race.arm() * m.n_t * lever;
  if (i == kLocalVelocities + 1) turned += race.arm() * m.n_r * lever;
  return turned;
}

/// Net power of a slice by what the form adds, and how that changes with time alone [W/s].
inline Pack add_form_power(const WavyRace& form, const SliceForces& on, BySlice& net,
                           const ForceSlopes& force, GroupLinear& jac) {
  net.p += form.w_t * force.n.p;
  net.rate += form.w_t * force.n.rate;
  net.u += form.w_t * force.n.u;
  for (int j = 0; j < 2; ++j) {
    jac.power_position[j] += on.normal * form.w_t_by[j];
    for (int i = 0; i < 2; ++i) jac.position[i][j] -= on.normal * form.H[i][j];
  }
  return net.p * form.w_t + net.rate * form.rate_by_time + on.normal * form.w_tt;
}

/// Adds the derivatives of one slice. `form`: where the race is wavy.
template <bool moving, bool tilting, bool wavy = false>
void add_slice_slopes(const RollerPack& q, const RaceSide& race, const SliceMotion& m,
                      const SliceForces& on, const SliceLaw& law, const Entrainment& oil,
                      Pack axis_share, GroupLinear& jac, [[maybe_unused]] RingTilt* tilt,
                      [[maybe_unused]] WavyRace* form = nullptr) {
  SliceRows<moving, tilting, wavy> rows(q, race, m);
  const ForceSlopes force = force_slopes(law, m, axis_share);
  BySlice net = net_power_slopes(law, m, race, force, oil.speed);
  if constexpr (wavy) {
    rows.add_form(*form);
    form->power_by_time += add_form_power(*form, on, net, force, jac);
  }
  add_net_power(rows, net, on, oil, jac, tilt);
  const Pack zero{};
#pragma GCC unroll 8
  for (int i = 0; i < rows.kRows; ++i) {
    const auto on_direction = [&](Pack n, Pack one, Pack two, Pack axis) {
      return rows.gn[i] * n + rows.g1(i) * one + rows.g2[i] * two +
             (i == kLs ? zero : rows.gc[i]) * axis;
    };
    const BySlice by{on_direction(force.n.p, force.one.p, force.two.p, force.axis.p),
                     on_direction(force.n.rate, force.one.rate, force.two.rate, force.axis.rate),
                     on_direction(force.n.u, force.one.u, force.two.u, force.axis.u),
                     on_direction(zero, force.one.v1, force.two.v1, zero),
                     on_direction(zero, force.one.v2, force.two.v2, zero)};
    const Pack turned = turned_force(rows, on, m, q, race, i);
    const LinearRow row = linear_row<tilting>(i, jac, tilt);
#pragma GCC unroll 8
    for (int j = 0; j < kLocalVelocities; ++j) {
      row.velocity[j] += rows.by_velocity(by, oil, j);
      if (j < kLocalPositions) row.position[j] += rows.by_position(by, turned, j);
    }
    if constexpr (tilting)
      for (int k = 0; k < 2; ++k) {
        row.tilt_velocity[k] += rows.by_velocity(by, oil, kLocalVelocities + k);
        row.tilt_position[k] += rows.by_position(by, turned, kLocalVelocities + k);
      }
  }
  jac.position[kLs][kLar] -= m.radius * m.n_t * on.f2;
  jac.position[kLs][kLat] += m.radius * m.n_r * on.f2;
  if constexpr (tilting) {
    RingCoupling& coupling = tilt->linear->coupling;
    // n_x follows the tilt, and the force's lever on the ring the roller's axial place.
    coupling.position[kLx][0] -= on.normal * m.n_r;
    coupling.position[kLx][1] -= on.normal * m.n_t;
    coupling.to_position[0][kLx] -= on.normal * m.n_r - on.along * m.n_t;
    coupling.to_position[1][kLx] -= on.normal * m.n_t + on.along * m.n_r;
  }
}

}  // namespace cagetol
