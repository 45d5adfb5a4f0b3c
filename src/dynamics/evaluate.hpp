// The right-hand side of the whole bearing at one state: state unpacked, contacts in their order,
// accelerations. Dry and lubricated bearings are compiled apart (forces.cpp,
// lubricated_forces.cpp): what one holds must not change how the compiler lays out the other.
#pragma once

#include <algorithm>
#include <cmath>

#include "src/dynamics/churning_loads.hpp"
#include "src/dynamics/end_contacts.hpp"
#include "src/dynamics/finish_derivatives.hpp"
#include "src/dynamics/land_contacts.hpp"
#include "src/dynamics/lubricated_pocket.hpp"
#include "src/dynamics/lubricated_race.hpp"
#include "src/dynamics/pocket_contacts.hpp"
#include "src/dynamics/race_contacts.hpp"

namespace cagetol {

using Evaluation = void (*)(const BearingModel&, double t, const double* y, double* rate,
                            Linearisation*, Observation*);
/// Of a lubricated model: its rates alone, or with derivatives and what is seen.
Evaluation lubricated_rates(const BearingModel& model);
Evaluation lubricated_linearisation(const BearingModel& model);

namespace {  // each source compiles its own

/// Planar rollers are at x = 0, straight and still in the directions in which they are held,
/// whatever the state says of these.
template <bool planar>
RollerPack unpack_rollers(const StateLayout& l, const double* y, int group) {
  const int j = group * kLanes;
  RollerPack p;
  p.r = load(y + l.position(kRadius, j));
  sine_cosine(load(y + l.position(kAngle, j)), p.sine, p.cosine);
  p.vr = load(y + l.velocity(kRadialSpeed, j));
  p.omega = load(y + l.velocity(kOrbitRate, j));
  p.vt = p.r * p.omega;
  p.spin = load(y + l.velocity(kSpin, j));
  if constexpr (planar) {
    p.x = p.a_r = p.a_t = p.vx = p.b_r = p.b_t = Pack{};
    return p;
  }
  p.x = load(y + l.position(kAxial, j));
  const Pack ay = load(y + l.position(kAxisY, j)), az = load(y + l.position(kAxisZ, j));
  p.a_r = along_r(p, ay, az);
  p.a_t = along_t(p, ay, az);
  p.vx = load(y + l.velocity(kAxialSpeed, j));
  const Pack by = load(y + l.velocity(kAxisRateY, j)), bz = load(y + l.velocity(kAxisRateZ, j));
  p.b_r = along_r(p, by, bz);
  p.b_t = along_t(p, by, bz);
  return p;
}

BorderState unpack_border(const BearingModel& m, double t, const double* y) {
  const double *q = y + m.layout.border_position(0), *v = y + m.layout.border_velocity(0);
  BorderState b;
  const double phi = q[kCagePhi];
  b.phi = phi;
  Pack sine, cosine;  // a pack's costs less than the library's two
  sine_cosine(splat(phi), sine, cosine);
  b.phi_cos = cosine[0];
  b.phi_sin = sine[0];
  b.phi_rate = v[kCagePhi];
  b.unbalance[0] = b.phi_cos * m.unbalance_y - b.phi_sin * m.unbalance_z;
  b.unbalance[1] = b.phi_sin * m.unbalance_y + b.phi_cos * m.unbalance_z;
  b.ring[0] = q[kRingY];
  b.ring[1] = q[kRingZ];
  b.ring_rate[0] = v[kRingY];
  b.ring_rate[1] = v[kRingZ];
  const bool tilting = m.layout.ring_tilt > 0;
  const double misalignment[2] = {m.misalignment_y, m.misalignment_z};
  for (int k = 0; k < 2; ++k) {
    b.tilt[k] = tilting ? q[m.layout.ring_tilt_slot() + k] : misalignment[k];
    b.tilt_rate[k] = tilting ? v[m.layout.ring_tilt_slot() + k] : 0;
  }
  b.cage[0] = q[kCageY] - b.unbalance[0];
  b.cage[1] = q[kCageZ] - b.unbalance[1];
  b.cage[2] = q[kCageX];
  b.cage_rate[0] = v[kCageY] + b.phi_rate * b.unbalance[1];
  b.cage_rate[1] = v[kCageZ] - b.phi_rate * b.unbalance[0];
  b.cage_rate[2] = v[kCageX];
  b.axis[0] = q[kCageAxisY];
  b.axis[1] = q[kCageAxisZ];
  b.axis_rate[0] = v[kCageAxisY];
  b.axis_rate[1] = v[kCageAxisZ];
  b.inner_speed = inner_speed_at(m, t);
  return b;
}

/// Accelerations of a pack of rollers from its loads; velocities into the position rates.
template <bool planar>
void store_rates(const BearingModel& m, const RollerGroup& roller, const RollerPack& q,
                 const RollerLoads& loads, const double* y, double* rate, int group) {
  const StateLayout& l = m.layout;
  const int j = group * kLanes;
  const auto velocity = [&](RollerVelocity slot) { return load(y + l.velocity(slot, j)); };
  const auto put = [&](int slot, Pack value) { store(rate + slot, value * roller.exists); };
  put(l.position(kRadius, j), velocity(kRadialSpeed));
  put(l.position(kAngle, j), velocity(kOrbitRate));
  put(l.position(kAxial, j), velocity(kAxialSpeed));
  put(l.position(kAxisY, j), velocity(kAxisRateY));
  put(l.position(kAxisZ, j), velocity(kAxisRateZ));
  const Pack gravity_r = -m.gravity * q.sine, gravity_t = -m.gravity * q.cosine;
  put(l.velocity(kRadialSpeed, j), loads.f[kLr] * roller.inverse_mass + gravity_r + q.vt * q.omega);
  put(l.velocity(kOrbitRate, j),
      (loads.f[kLt] * roller.inverse_mass + gravity_t - 2.0 * q.vr * q.omega) / q.r);
  put(l.velocity(kSpin, j), loads.f[kLs] * roller.inverse_polar);
  if constexpr (planar) {
    for (const RollerVelocity slot : {kAxialSpeed, kAxisRateY, kAxisRateZ})
      put(l.velocity(slot, j), Pack{});
    return;
  }
  put(l.velocity(kAxialSpeed, j), loads.f[kLx] * roller.inverse_mass);
  const Pack gyro = roller.polar * q.spin;
  const Pack lean_r = (loads.f[kLar] - gyro * q.b_t) * roller.inverse_transverse;
  const Pack lean_t = (loads.f[kLat] + gyro * q.b_r) * roller.inverse_transverse;
  put(l.velocity(kAxisRateY, j), q.cosine * lean_r - q.sine * lean_t);
  put(l.velocity(kAxisRateZ, j), q.sine * lean_r + q.cosine * lean_t);
}

/// `modal_force`: of the contacts on the elastic modes.
void store_border_rates(const BearingModel& m, double t, const BorderState& b,
                        const BorderLoads& loads, const double* modal_force, const double* y,
                        double* rate) {
  const double* v = y + m.layout.border_velocity(0);
  double *dq = rate + m.layout.border_position(0), *dv = rate + m.layout.border_velocity(0);
  for (int i = 0; i < m.layout.border(); ++i) dq[i] = v[i];
  for (int i = m.layout.border(); i < m.layout.padded_border(); ++i) dq[i] = dv[i] = 0;
  const RingLoad load = load_at(m, t);
  dv[kRingY] = loads.ring[0] / m.ring_mass;
  dv[kRingZ] = (loads.ring[1] - load.radial) / m.ring_mass - m.gravity;
  if (m.layout.ring_tilt > 0) {
    const int tilt = m.layout.ring_tilt_slot();
    const double gyro = m.ring_polar * b.inner_speed;
    const double held_y = m.tilt_stiffness * (b.tilt[0] - m.misalignment_y),
                 held_z = m.tilt_stiffness * (b.tilt[1] - m.misalignment_z);
    const double moment_y = loads.tilt[0] + load.moment_y - held_y - gyro * b.tilt_rate[1],
                 moment_z = loads.tilt[1] + load.moment_z - held_z + gyro * b.tilt_rate[0];
    dv[tilt] = moment_y / m.ring_transverse;
    dv[tilt + 1] = moment_z / m.ring_transverse;
  }
  dv[kCageY] = loads.cage[0] / m.cage_mass;
  dv[kCageZ] = loads.cage[1] / m.cage_mass - m.gravity;
  dv[kCageX] = loads.cage[2] / m.cage_mass;
  // Moment about the mass centre: the forces act about the geometric centre, at -e from it.
  const double torque =
      loads.cage[3] + loads.cage[0] * b.unbalance[1] - loads.cage[1] * b.unbalance[0];
  dv[kCagePhi] = torque / m.cage_polar;
  const double gyro = m.cage_polar * b.phi_rate;
  dv[kCageAxisY] = (loads.cage[4] - gyro * b.axis_rate[1]) / m.cage_transverse;
  dv[kCageAxisZ] = (loads.cage[5] + gyro * b.axis_rate[0]) / m.cage_transverse;
  if (m.layout.modes == 0) return;
  const double* q = y + m.layout.border_position(0);
  for (int k = 0; k < m.layout.modes; ++k) {
    const auto at = static_cast<std::size_t>(k);
    dv[kModes + k] = modal_force[k] - m.flexible.stiffness[at] * q[kModes + k] -
                     m.flexible.damping[at] * v[kModes + k];
  }
  couple_spin(m.flexible, m.cage_polar, b.phi_rate, q + kModes, v + kModes, dv + kModes,
              dv[kCagePhi]);
}

/// `tilting`: the inner ring's tilt is free. `lubricated`: there is oil by src/lubrication.
template <bool linear, bool planar, bool tilting, bool lubricated>
void evaluate(const BearingModel& m, double t, const double* y, double* rate, Linearisation* jac,
              Observation* seen) {
  const BorderState b = unpack_border(m, t, y);
  BorderLoads border;
  Pack modal_force[kMostModes];
  const double *modes = y + m.layout.border_position(kModes),
               *mode_rates = y + m.layout.border_velocity(kModes);
  const ModalState modal{&m.flexible, modes, mode_rates, modal_force,
                         farthest_displacement(m.flexible, modes)};
  ContactRows* rows = nullptr;
  if constexpr (linear) {
    jac->clear();
    seen->clear();
    rows = &jac->scratch;
    set_cage_block(m, b, y, *jac, *seen);
  }
  [[maybe_unused]] double on_ring[2] = {0, 0};  // likewise by the ring's velocity
  for (int group = 0; group < m.layout.groups; ++group) {
    const RollerGroup& roller = m.groups[static_cast<std::size_t>(group)];
    const RollerPack q = unpack_rollers<planar>(m.layout, y, group);
    GroupLinear* g = nullptr;
    if constexpr (linear) {
      g = &jac->groups[static_cast<std::size_t>(group)];
      g->cosine = q.cosine;
      g->sine = q.sine;
      g->radius = q.r;
      g->inverse_radius = 1.0 / q.r;
    }
    const auto r = [&](const double v[2]) { return along_r(q, splat(v[0]), splat(v[1])); };
    const auto tt = [&](const double v[2]) { return along_t(q, splat(v[0]), splat(v[1])); };
    const RaceSide inner{1,          m.inner_radius, b.inner_speed,   m.inner_film, r(b.ring),
                         tt(b.ring), r(b.ring_rate), tt(b.ring_rate), r(b.tilt),    tt(b.tilt)};
    const RaceSide outer{-1, m.outer_radius, 0, m.outer_film, {}, {}, {}, {}, {}, {}};
    [[maybe_unused]] RingTilt tilt;
    if constexpr (tilting) {
      tilt.rate_r = r(b.tilt_rate);
      tilt.rate_t = tt(b.tilt_rate);
      if constexpr (linear) tilt.linear = &jac->tilts[static_cast<std::size_t>(group)];
    }
    RollerLoads loads;
    [[maybe_unused]] Pack by_vt{}, by_spin{};  // elastic energy, by the speeds that make films
    Pack total{}, sliding{}, elastic_r{}, elastic_t{}, drive{};
    if constexpr (lubricated) {
      RaceTotals on;
      lubricated_race<linear, true, tilting>(m, m.inner_line, roller, q, inner, loads, g, seen, on,
                                             tilting ? &tilt : nullptr);
      total = on.normal, sliding = on.sliding, drive = on.drive;
      elastic_r = on.normal_r, elastic_t = on.normal_t;
      by_vt = on.energy_by_vt, by_spin = on.energy_by_spin;
      if constexpr (linear) {
        on_ring[0] += sum(by_vt * q.sine);
        on_ring[1] -= sum(by_vt * q.cosine);
        seen->damp(kFilm, -sum(by_vt * q.omega * inner.du_r));
      }
    } else {
      race_contacts<linear, true, tilting>(m, roller, q, inner, loads, g, seen, total, sliding,
                                           elastic_r, elastic_t, drive, tilting ? &tilt : nullptr);
    }
    border.ring[0] -= sum(q.cosine * loads.f[kLr] - q.sine * loads.f[kLt]);
    border.ring[1] -= sum(q.sine * loads.f[kLr] + q.cosine * loads.f[kLt]);
    if constexpr (tilting) {
      border.tilt[0] += sum(q.cosine * tilt.moment[0] - q.sine * tilt.moment[1]);
      border.tilt[1] += sum(q.sine * tilt.moment[0] + q.cosine * tilt.moment[1]);
    }
    if constexpr (linear) {
      finish_inner(q, *g);
      for (int k = 0; k < 2; ++k) {
        Eigen::VectorXd& to = k == 0 ? jac->power_position : jac->power_velocity;
        const Pack on_r = k == 0 ? g->power_position[kLr] : g->power_velocity[kLr];
        const Pack on_t = k == 0 ? g->power_position[kLt] : g->power_velocity[kLt];
        to[kRingY] -= sum(q.cosine * on_r - q.sine * on_t);
        to[kRingZ] -= sum(q.sine * on_r + q.cosine * on_t);
      }
      add_ring_block(*g, *jac);
      if constexpr (tilting) {
        const int slot = m.layout.ring_tilt_slot();
        const auto add = [&](const Pack(&power)[2], Eigen::VectorXd& to) {
          to[slot] += sum(q.cosine * power[0] - q.sine * power[1]);
          to[slot + 1] += sum(q.sine * power[0] + q.cosine * power[1]);
        };
        add(tilt.linear->power_position, jac->power_position);
        add(tilt.linear->power_velocity, jac->power_velocity);
        finish_tilt(q, *g, slot, *tilt.linear, *jac);
      }
      store(seen->inner_force.data() + group * kLanes, total);
      store(seen->inner_sliding.data() + group * kLanes,
            select(total > 0.0, sliding / max(total, splat(1e-300)), Pack{}));
      seen->ring_elastic_y -= sum(q.cosine * elastic_r - q.sine * elastic_t);
      seen->ring_elastic_z -= sum(q.sine * elastic_r + q.cosine * elastic_t);
      seen->drive_power += sum(drive);
      total = Pack{};
    }
    if constexpr (lubricated) {
      RaceTotals on;
      lubricated_race<linear, false>(m, m.outer_line, roller, q, outer, loads, g, seen, on);
      total = on.normal;
      by_vt += on.energy_by_vt;
      by_spin += on.energy_by_spin;
    } else {
      race_contacts<linear, false>(m, roller, q, outer, loads, g, seen, total, sliding, elastic_r,
                                   elastic_t, drive);
    }
    if constexpr (linear) {
      store(seen->outer_force.data() + group * kLanes, total);
      for (int i = 0; i < kLocalVelocities; ++i) turn_frame(q, g->position[i], g->velocity[i]);
    }
    if constexpr (!planar)  // who stands still in the middle touches no flange
      flange_contacts<linear>(m, roller, q, group, loads, jac, seen);
    if (lubricated && m.churning.on)
      roller_churning<linear>(m.churning, roller, q, b, loads, g, seen);
    PocketFrame pocket = pocket_places(roller, q, b);
    Pack bars_nearer = splat(modal.farthest), walls_nearer = bars_nearer;
    if (lubricated && m.oiled_bars) bars_nearer += m.bar_line.layer;
    if constexpr (lubricated) walls_nearer += m.wall_film.layer;
    const bool bars = bars_in_reach(m, roller, pocket, bars_nearer),
               walls = walls_in_reach(m, roller, pocket, walls_nearer);
    if (bars || walls) add_rates(q, b, pocket);
    if (lubricated && bars && m.oiled_bars)
      lubricated_pocket<linear>(m, roller, q, pocket, b, modal, group, loads, border, rows, jac,
                                seen);
    else if (bars)
      pocket_contacts<linear>(m, roller, q, pocket, b, modal, group, loads, border, rows, jac,
                              seen);
    if (walls)
      wall_contacts<linear>(m, roller, q, pocket, b, modal, group, loads, border, rows, jac, seen);
    if constexpr (linear) {
      if constexpr (lubricated) {
        const Pack a_t = loads.f[kLt] * roller.inverse_mass - m.gravity * q.cosine - q.vr * q.omega,
                   a_s = loads.f[kLs] * roller.inverse_polar;
        // Left out of net_power_rate: it would take the rate of these accelerations.
        seen->damp(kFilm, -sum(roller.exists * (by_vt * a_t + by_spin * a_s)));
      }
      add_inertial(m, roller, q, loads, *g);
      if constexpr (planar) jac->hold(group);
      seen->net_power_rate += roller_power_rate(roller, q, loads, m.gravity, *g);
    }
    store_rates<planar>(m, roller, q, loads, y, rate, group);
  }
  double on_modes[kMostModes];
  for (int k = 0; k < m.layout.modes; ++k) on_modes[k] = modal.pushed ? sum(modal_force[k]) : 0;
  land_contacts<linear>(m, b, modal, border, on_modes, rows, jac, seen);
  if (lubricated && m.churning.on) churn_cage<linear>(m.churning, b, border, jac, seen);
  store_border_rates(m, t, b, border, on_modes, y, rate);
  if constexpr (linear) {
    const RingLoad load = load_at(m, t);
    seen->load_power = -load.radial * b.ring_rate[1];
    jac->power_velocity[kRingZ] -= load.radial;
    if constexpr (tilting) {
      add_shaft_block(m, b, *jac);
      seen->load_power += load.moment_y * b.tilt_rate[0] + load.moment_z * b.tilt_rate[1];
      jac->power_velocity[m.layout.ring_tilt_slot()] += load.moment_y;
      jac->power_velocity[m.layout.ring_tilt_slot() + 1] += load.moment_z;
    }
    const double *border_v = y + m.layout.border_velocity(0),
                 *border_a = rate + m.layout.border_velocity(0);
    if constexpr (lubricated)
      seen->damp(kFilm, -on_ring[0] * border_a[kRingY] - on_ring[1] * border_a[kRingZ]);
    for (int i = 0; i < m.layout.border(); ++i)
      seen->net_power_rate +=
          jac->power_position[i] * border_v[i] + jac->power_velocity[i] * border_a[i];
  }
}

/// The one that suits a model; a dry bearing pays nothing for what oil would do.
template <bool linear, bool lubricated>
Evaluation evaluation_as(const BearingModel& m) {
  return m.planar                 ? evaluate<linear, true, false, lubricated>
         : m.layout.ring_tilt > 0 ? evaluate<linear, false, true, lubricated>
                                  : evaluate<linear, false, false, lubricated>;
}
}  // namespace
}  // namespace cagetol
