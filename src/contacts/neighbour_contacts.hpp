// Rollers of a full complement against the next ones around the bearing, at stations along them. A
// is a roller, B the next one; a station s lies in the middle between both, so at
// xi_A = s + (x_B - x_A)/2 on A and at xi_B = s - (x_B - x_A)/2 on B. In the radial plane:
//   d = (r e_r + xi a)_B - (r e_r + xi a)_A,  D = |d|,  n = d/D,  t = e_x x n
//   p = R_A + R_B - D,   p' = -n . d'
//   v_1 = t . (v_A - v_B) + w_A R_A + w_B R_B     sliding of A on B along t: spins add up
//   v_2 = x'_A - x'_B - R_A W_A.t - R_B W_B.t     along x, W = w a + e_x x a'
//   u   = (R_A w_A - R_B w_B)/2                   entrainment, next to nothing
// R with the taper at s. Forces on both rollers are the transposes. With oil the film is that of
// bars (lubricated_pocket.hpp) between two rollers, without rolling resistance: surfaces slide
// against each other, hardly drag oil in, and rub in mixed friction.
#pragma once

#include "src/contacts/lubricated_pocket.hpp"
#include "src/contacts/race_contacts.hpp"

namespace cagetol {

inline constexpr int kMostGroups = 64 / kLanes;  ///< of rollers (bearing.roller_count)

/// One side of a contact: the roller as a row of speeds over its local directions sees it.
struct NeighbourRows {
  Pack gn[kLocalVelocities], g1[kLocalVelocities], g2[kLocalVelocities];  ///< -p', v_1, v_2
  Pack tau[kLocalVelocities];  ///< of d along t: zero for the spin
  Pack gu;                     ///< of u by the spin
  double side;                 ///< 1: A, -1: B
  Pack t_r, t_t, n_r, n_t;
  Pack radius, lever;  ///< R, and R a.n
};

/// `side`: 1 for A, -1 for B. `n_y`, `n_z`: n. `mean_n`, `mean_t`: mean lean of both along n and t.
inline NeighbourRows neighbour_rows(const RollerPack& q, double side, Pack n_y, Pack n_z,
                                    Pack radius, Pack xi, Pack mean_n, Pack mean_t) {
  NeighbourRows g;
  g.side = side;
  g.radius = radius;
  g.n_r = along_r(q, n_y, n_z);
  g.n_t = along_t(q, n_y, n_z);
  g.t_r = -g.n_t;
  g.t_t = g.n_r;
  const Pack zero{}, a_n = g.n_r * q.a_r + g.n_t * q.a_t, a_t = g.t_r * q.a_r + g.t_t * q.a_t;
  g.lever = radius * a_n;
  const Pack n[kLocalVelocities] = {g.n_r, g.n_t, -mean_n, xi * g.n_r, xi * g.n_t, zero};
  const Pack t[kLocalVelocities] = {g.t_r, g.t_t, -mean_t, xi * g.t_r, xi * g.t_t, zero};
  for (int i = 0; i < kLocalVelocities; ++i) {
    g.gn[i] = -side * n[i];
    g.tau[i] = -side * t[i];
    g.g1[i] = side * t[i];
    g.g2[i] = zero;
  }
  g.g1[kLx] = zero;
  g.g1[kLs] = radius;
  g.g2[kLx] = splat(side);
  g.g2[kLar] = -radius * g.n_r;
  g.g2[kLat] = -radius * g.n_t;
  g.g2[kLs] = -radius * a_t;
  g.gu = 0.5 * side * radius;
  return g;
}

/// Speed of a row.
inline Pack speed_of(const Pack (&g)[kLocalVelocities], const RollerPack& q) {
  return g[kLr] * q.vr + g[kLt] * q.vt + g[kLx] * q.vx + g[kLar] * q.b_r + g[kLat] * q.b_t +
         g[kLs] * q.spin;
}

/// The contact of a pack of rollers with the next ones at one station.
struct NeighbourTouch {
  NeighbourRows a, b;
  Pack p, inverse;  ///< 1/D
  Pack rate, v1, v2, u;
  Pack rate_turn, v1_turn, v2_turn;  ///< as d goes along t
};
inline NeighbourTouch neighbour_touch(const RollerPack& A, const RollerPack& B, Pack R_A, Pack R_B,
                                      double station) {
  const Pack shift = 0.5 * (B.x - A.x), xi_A = station + shift, xi_B = station - shift;
  const auto place = [](const RollerPack& q, Pack xi, Pack& y, Pack& z) {
    const Pack r = q.r + xi * q.a_r, along = xi * q.a_t;
    y = q.cosine * r - q.sine * along;
    z = q.sine * r + q.cosine * along;
  };
  Pack y_A, z_A, y_B, z_B;
  place(A, xi_A, y_A, z_A);
  place(B, xi_B, y_B, z_B);
  const Pack d_y = y_B - y_A, d_z = z_B - z_A;
  NeighbourTouch touch;
  // Padding may stand anywhere.
  const Pack distance = sqrt(max(d_y * d_y + d_z * d_z, splat(1e-12)), touch.inverse);
  touch.p = R_A + R_B - distance;
  const Pack n_y = d_y * touch.inverse, n_z = d_z * touch.inverse;
  const auto lean = [](const RollerPack& q, Pack y, Pack z) {
    return along_r(q, y, z) * q.a_r + along_t(q, y, z) * q.a_t;
  };
  const Pack mean_n = 0.5 * (lean(A, n_y, n_z) + lean(B, n_y, n_z)),
             mean_t = 0.5 * (lean(A, -n_z, n_y) + lean(B, -n_z, n_y));
  touch.a = neighbour_rows(A, 1, n_y, n_z, R_A, xi_A, mean_n, mean_t);
  touch.b = neighbour_rows(B, -1, n_y, n_z, R_B, xi_B, mean_n, mean_t);
  const NeighbourRows &a = touch.a, &b = touch.b;
  touch.rate = -(speed_of(a.gn, A) + speed_of(b.gn, B));
  touch.v1 = speed_of(a.g1, A) + speed_of(b.g1, B);
  touch.v2 = speed_of(a.g2, A) + speed_of(b.g2, B);
  touch.u = a.gu * A.spin + b.gu * B.spin;
  touch.rate_turn = -touch.inverse * (speed_of(a.tau, A) + speed_of(b.tau, B));
  touch.v1_turn = -touch.inverse * (touch.rate + a.gn[kLx] * A.vx + b.gn[kLx] * B.vx);  // without x
  const auto across = [](const NeighbourRows& g, const RollerPack& q) {
    return g.lever * q.spin - g.radius * (g.t_r * q.b_r + g.t_t * q.b_t);
  };
  touch.v2_turn = touch.inverse * (across(a, A) + across(b, B));
  return touch;
}

/// What the law says of a station, and whether it counts in a lane.
struct NeighbourLaw {
  SliceLaw law;
  Pack film, steady;  ///< with oil: of the film with its squeeze, and steady [N]
  Pack depth;         ///< dry
};
template <bool linear>
NeighbourLaw neighbour_law(const BearingModel& m, const NeighbourTouch& at, Mask wet) {
  NeighbourLaw on{};
  const Pack squared = at.v1 * at.v1 + at.v2 * at.v2;
  if (m.lubricated && m.oiled_bars) {
    using D = std::conditional_t<linear, Dual<Pack, 4>, Pack>;
    const LineForces<D> f = oil_forces<D>(m.bar_line, wet, at.p, at.rate, at.u, squared);
    if constexpr (linear) {
      on.law.normal = f.at.normal;
      on.law.ratio = f.ratio;
    } else {
      on.law.normal.value = f.at.normal;
      on.law.ratio.value = f.ratio;
    }
    on.film = value_of(f.at.film);
    on.steady = value_of(f.at.steady);
    return on;
  }
  FilmContact<Pack> contact{};
  contact.normal = normal_force(m.bar, select(wet, at.p, splat(-1.0)), at.rate);
  on.depth = max(at.p, Pack{});
  on.law = dry_law(contact, friction(m.friction[kBarPair], squared));
  return on;
}

/// Accounts of one station.
inline void observe_neighbours(const BearingModel& m, const NeighbourTouch& at,
                               const NeighbourLaw& on, Observation& seen) {
  const Pack normal = on.law.normal.value;
  seen.rub(kNeighbourFriction, sum(on.law.ratio.value * (at.v1 * at.v1 + at.v2 * at.v2)));
  if (m.lubricated && m.oiled_bars) {
    seen.damp(kSqueeze, sum((on.film - on.steady) * at.rate));
    seen.damp(kDamping, sum((normal - on.film) * at.rate));
    seen.damp(kFilm, sum(on.steady * at.rate));
    return;
  }
  const Pack elastic = on.law.storing.value;
  seen.damp(kDamping, sum((normal - elastic) * at.rate));
  seen.elastic_energy += sum(elastic * on.depth * (1 / (m.bar.exponent + 1)));
}

/// Forces on one of both rollers.
inline void add_neighbour_loads(const NeighbourRows& g, Pack normal, Pack f1, Pack f2,
                                RollerLoads& loads) {
  for (int i = 0; i < kLocalVelocities; ++i)
    loads.f[i] += normal * g.gn[i] + f1 * g.g1[i] + f2 * g.g2[i];
}

/// Derivatives of the forces on roller `on` by the motion of roller `by`; `lean`: of v_2 by the
/// lean of the latter.
/// Left out: what the place of the station on a roller does to friction.
inline void add_neighbour_block(const NeighbourTouch& at, const NeighbourRows& on,
                                const NeighbourRows& by, const ForceSlopes& force, Pack normal,
                                Pack f1, Pack f2, const Pack (&lean)[2], RollerOnRoller& to) {
  for (int i = 0; i < kLocalVelocities; ++i) {
    const auto project = [&](Pack n, Pack one, Pack two) {
      return on.gn[i] * n + on.g1[i] * one + on.g2[i] * two;
    };
    const BySlice s{project(force.n.p, force.one.p, force.two.p),
                    project(force.n.rate, force.one.rate, force.two.rate),
                    project(force.n.u, force.one.u, force.two.u),
                    project(Pack{}, force.one.v1, force.two.v1),
                    project(Pack{}, force.one.v2, force.two.v2)};
    // Forces held fast, as n turns.
    Pack turned = normal * on.tau[i];
    if (i != kLx) turned += f1 * on.gn[i];
    if (i == kLar) turned -= f2 * on.radius * on.t_r;
    if (i == kLat) turned -= f2 * on.radius * on.t_t;
    if (i == kLs) turned += f2 * on.lever;
    const Pack along =
        at.inverse * turned + s.rate * at.rate_turn + s.v1 * at.v1_turn + s.v2 * at.v2_turn;
    for (int j = 0; j < kLocalVelocities; ++j) {
      to.velocity[i][j] += s.v1 * by.g1[j] + s.v2 * by.g2[j] - s.rate * by.gn[j];
      if (j < kLocalPositions) to.position[i][j] += along * by.tau[j] - s.p * by.gn[j];
    }
    to.velocity[i][kLs] += s.u * by.gu;
    to.position[i][kLar] += s.v2 * lean[0];
    to.position[i][kLat] += s.v2 * lean[1];
  }
  // Where on the rollers the station lies follows both axial places.
  const Pack half = 0.5 * normal;
  to.position[kLar][kLx] += by.side * half * on.n_r;
  to.position[kLat][kLx] += by.side * half * on.n_t;
  to.position[kLx][kLar] += on.side * half * by.n_r;
  to.position[kLx][kLat] += on.side * half * by.n_t;
  if (on.side == by.side) {
    to.position[kLs][kLar] -= f2 * on.radius * on.t_r;
    to.position[kLs][kLat] -= f2 * on.radius * on.t_t;
  }
}

/// Gradient of the net power by the motion of one of both rollers.
inline void add_neighbour_power(const NeighbourTouch& at, const NeighbourRows& by,
                                const BySlice& net, const Pack (&lean)[2],
                                Pack (&position)[kLocalPositions],
                                Pack (&velocity)[kLocalVelocities]) {
  const Pack along = net.rate * at.rate_turn + net.v1 * at.v1_turn + net.v2 * at.v2_turn;
  for (int j = 0; j < kLocalVelocities; ++j) {
    velocity[j] += net.v1 * by.g1[j] + net.v2 * by.g2[j] - net.rate * by.gn[j];
    if (j < kLocalPositions) position[j] += along * by.tau[j] - net.p * by.gn[j];
  }
  velocity[kLs] += net.u * by.gu;
  position[kLar] += net.v2 * lean[0];
  position[kLat] += net.v2 * lean[1];
}

/// All derivatives of one station; those of the next rollers by their own motion into `next`.
inline void add_neighbour_slopes(const NeighbourTouch& at, const NeighbourLaw& on,
                                 const RollerPack& A, const RollerPack& B, Pack f1, Pack f2,
                                 NeighbourLinear& to, NeighbourLinear::Own& next) {
  static const FilmLaw none{};
  static const RaceSide still{1, 0, 0, none, {}, {}, {}, {}, {}, {}};
  SliceMotion m{};
  m.rate = at.rate;
  m.v1 = at.v1;
  m.v2 = at.v2;
  const ForceSlopes force = force_slopes(on.law, m, Pack{});
  const BySlice net = net_power_slopes(on.law, m, still, force, at.u);
  const NeighbourRows &a = at.a, &b = at.b;
  const Pack normal = on.law.normal.value;
  const Pack lean_A[2] = {-a.radius * A.spin * a.t_r, -a.radius * A.spin * a.t_t},
             lean_B[2] = {-b.radius * B.spin * b.t_r, -b.radius * B.spin * b.t_t};
  add_neighbour_block(at, a, a, force, normal, f1, f2, lean_A, to.own.forces);
  add_neighbour_block(at, a, b, force, normal, f1, f2, lean_B, to.ahead);
  add_neighbour_block(at, b, a, force, normal, f1, f2, lean_A, to.behind);
  add_neighbour_block(at, b, b, force, normal, f1, f2, lean_B, next.forces);
  add_neighbour_power(at, a, net, lean_A, to.own.power_position, to.own.power_velocity);
  add_neighbour_power(at, b, net, lean_B, next.power_position, next.power_velocity);
}

/// What neighbours do to the rollers of a full complement, before any other contact is computed.
struct NeighbourLoads {
  RollerPack rollers[kMostGroups];
  RollerLoads loads[kMostGroups];
};

/// Roller after the roller in this lane.
inline int next_roller(const BearingModel& m, int group, int lane) {
  const int j = group * kLanes + lane + 1;
  return j < m.layout.rollers ? j : 0;
}
/// Copies of the packs that hold, lane by lane, the next rollers; T: packs alone.
template <class T, class At>
T next_lanes(const BearingModel& m, int group, const At& at) {
  static_assert(sizeof(T) % sizeof(Pack) == 0);
  T next{};
  constexpr std::size_t packs = sizeof(T) / sizeof(Pack);
  auto* const to = reinterpret_cast<double*>(&next);
  for (int lane = 0; lane < kLanes; ++lane) {
    const int j = next_roller(m, group, lane);
    const auto* const from = reinterpret_cast<const double*>(&at(j / kLanes));
    for (std::size_t k = 0; k < packs; ++k)
      to[k * kLanes + static_cast<std::size_t>(lane)] =
          from[k * kLanes + static_cast<std::size_t>(j % kLanes)];
  }
  return next;
}
/// Adds packs over the next rollers to theirs.
template <class T, class At>
void add_to_next(const BearingModel& m, int group, const T& next, const At& at) {
  constexpr std::size_t packs = sizeof(T) / sizeof(Pack);
  const auto* const from = reinterpret_cast<const double*>(&next);
  for (int lane = 0; lane < kLanes; ++lane) {
    if (m.groups[static_cast<std::size_t>(group)].exists[lane] == 0) continue;
    const int j = next_roller(m, group, lane);
    auto* const to = reinterpret_cast<double*>(&at(j / kLanes));
    for (std::size_t k = 0; k < packs; ++k)
      to[k * kLanes + static_cast<std::size_t>(j % kLanes)] +=
          from[k * kLanes + static_cast<std::size_t>(lane)];
  }
}

/// One pack of rollers with the next ones. False where no station touches.
template <bool linear>
bool touch_next(const BearingModel& m, int group, NeighbourLoads& all, Linearisation* jac,
                Observation* seen) {
  struct Size {
    Pack radius, taper;
  };
  const auto k = static_cast<std::size_t>(group);
  const RollerGroup& roller = m.groups[k];
  const RollerPack &A = all.rollers[group],
                   B = next_lanes<RollerPack>(
                       m, group, [&](int g) -> auto& { return all.rollers[g]; });
  Size sizes[kMostGroups];
  for (int g = 0; g < m.layout.groups; ++g)
    sizes[g] = {m.groups[static_cast<std::size_t>(g)].radius,
                m.groups[static_cast<std::size_t>(g)].taper_slope};
  const Size next = next_lanes<Size>(
      m, group, [&](int g) -> auto& { return sizes[g]; });
  const bool oiled = m.lubricated && m.oiled_bars;
  const Pack margin = splat(oiled ? m.bar_line.layer : 0.0);
  RollerLoads on_next{};
  NeighbourLinear::Own next_linear;
  Pack pressed{};
  bool touched = false;
  for (const double station : m.bar_stations) {
    const NeighbourTouch at = neighbour_touch(A, B, roller.radius + station * roller.taper_slope,
                                              next.radius + station * next.taper, station);
    const Mask wet = (at.p > -margin) & (roller.exists > 0.0);
    if (!any(wet)) continue;
    touched = true;
    const NeighbourLaw on = neighbour_law<linear>(m, at, wet);
    const Pack normal = on.law.normal.value, f1 = -on.law.ratio.value * at.v1,
               f2 = -on.law.ratio.value * at.v2;
    add_neighbour_loads(at.a, normal, f1, f2, all.loads[group]);
    add_neighbour_loads(at.b, normal, f1, f2, on_next);
    pressed += normal;
    if constexpr (linear) {
      observe_neighbours(m, at, on, *seen);
      add_neighbour_slopes(at, on, A, B, f1, f2, jac->neighbours[k], next_linear);
    }
  }
  if (!touched) return false;
  add_to_next(
      m, group, on_next, [&](int g) -> auto& { return all.loads[g]; });
  if constexpr (linear) {
    store(seen->neighbour_force.data() + group * kLanes, pressed);
    add_to_next(
        m, group, next_linear, [&](int g) -> auto& {
          return jac->neighbours[static_cast<std::size_t>(g)].own;
        });
  }
  return true;
}

/// All contacts between neighbours; `rollers` of `all` are there. Derivatives in frozen directions.
template <bool linear>
void neighbour_contacts(const BearingModel& m, NeighbourLoads& all, Linearisation* jac,
                        Observation* seen) {
  bool touched = false;
  for (int group = 0; group < m.layout.groups; ++group) {
    all.loads[group] = {};
    if constexpr (linear) jac->neighbours[static_cast<std::size_t>(group)] = {};
  }
  for (int group = 0; group < m.layout.groups; ++group)
    if (touch_next<linear>(m, group, all, jac, seen)) touched = true;
  if constexpr (linear) jac->neighbours_touch = touched;
}

}  // namespace cagetol
