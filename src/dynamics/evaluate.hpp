// The right-hand side of the whole bearing at one state: state unpacked (unpack.hpp), contacts in
// their order, accelerations (accelerations.hpp). Dry and lubricated bearings are compiled apart
// (forces.cpp, lubricated_forces.cpp): what one holds must not change how the compiler lays out the
// other.
#pragma once

#include <algorithm>

#include "src/contacts/churning_loads.hpp"
#include "src/contacts/flange_contacts.hpp"
#include "src/contacts/land_contacts.hpp"
#include "src/contacts/lubricated_pocket.hpp"
#include "src/contacts/lubricated_race.hpp"
#include "src/contacts/pocket_contacts.hpp"
#include "src/contacts/race_contacts.hpp"
#include "src/contacts/wall_contacts.hpp"
#include "src/dynamics/accelerations.hpp"
#include "src/dynamics/finish_derivatives.hpp"
#include "src/dynamics/unpack.hpp"
#include "src/numerics/kernel.hpp"

namespace cagetol {

using Evaluation = void (*)(const BearingModel&, double t, const double* y, double* rate,
                            Linearisation*, Observation*);
/// Of a lubricated model: its rates alone, or with derivatives and what is seen.
CAGETOL_KERNEL Evaluation lubricated_rates(const BearingModel& model);
CAGETOL_KERNEL Evaluation lubricated_linearisation(const BearingModel& model);
/// The same of a model whose raceways have waves, dry or lubricated.
CAGETOL_KERNEL Evaluation wavy_rates(const BearingModel& model);
CAGETOL_KERNEL Evaluation wavy_linearisation(const BearingModel& model);

namespace {  // each source compiles its own

/// What the rollers of one evaluation share.
struct Shared {
  const BearingModel& model;
  const BorderState& border;
  const ModalState& modal;
  BorderLoads& loads;
  Linearisation* jac;  ///< with derivatives only, as `seen`
  Observation* seen;
  double ring_energy[2] = {0, 0};  ///< elastic energy by the ring's velocity [J s/m]
};

/// One pack of rollers on its way through the contacts.
struct Pass {
  int group;
  const RollerGroup& roller;
  RollerPack q;
  RollerLoads loads{};
  GroupLinear* linear = nullptr;
  Pack energy_by_vt{}, energy_by_spin{};  ///< elastic energy by the speeds that make films
};

/// What a race that turns faster puts into the bodies' elastic energy, by way of the films [W].
inline double film_power(const RaceTotals& on, const RaceSide& race, const RollerGroup& roller,
                         double speeding_up) {
  if (speeding_up == 0) return 0;
  return -sum(on.energy_by_spin / roller.radius) * race.arm() * speeding_up;
}

/// The ring's share of the derivatives of the inner race, and its sums.
template <bool tilting>
void finish_inner_race(Pass& pass, const RaceTotals& on, RingTilt& tilt, Shared& all) {
  const RollerPack& q = pass.q;
  GroupLinear& g = *pass.linear;
  Linearisation& jac = *all.jac;
  Observation& seen = *all.seen;
  finish_inner(q, g);
  const auto add_power = [&](const Pack* on_roller, Eigen::VectorXd& to) {
    to[kRingY] -= sum(q.cosine * on_roller[kLr] - q.sine * on_roller[kLt]);
    to[kRingZ] -= sum(q.sine * on_roller[kLr] + q.cosine * on_roller[kLt]);
  };
  add_power(g.power_position, jac.power_position);
  add_power(g.power_velocity, jac.power_velocity);
  add_ring_block(g, jac);
  if (all.model.layout.ring_axial > 0)
    finish_axial(q, g, pass.roller.exists, pass.group, all.model.layout.ring_axial_slot(), jac);
  if constexpr (tilting) {
    const int slot = all.model.layout.ring_tilt_slot();
    const auto add = [&](const Pack(&power)[2], Eigen::VectorXd& to) {
      to[slot] += sum(q.cosine * power[0] - q.sine * power[1]);
      to[slot + 1] += sum(q.sine * power[0] + q.cosine * power[1]);
    };
    add(tilt.linear->power_position, jac.power_position);
    add(tilt.linear->power_velocity, jac.power_velocity);
    finish_tilt(q, g, slot, *tilt.linear, jac);
  }
  store(seen.inner_force.data() + pass.group * kLanes, on.normal);
  seen.inner_slice = std::max(seen.inner_slice, largest(on.heaviest));
  store(seen.inner_sliding.data() + pass.group * kLanes,
        select(on.normal > 0.0, on.sliding / max(on.normal, splat(1e-300)), Pack{}));
  store(seen.inner_rubbing.data() + pass.group * kLanes, on.rubbing);
  seen.ring_elastic_y -= sum(q.cosine * on.normal_r - q.sine * on.normal_t);
  seen.ring_elastic_z -= sum(q.sine * on.normal_r + q.cosine * on.normal_t);
  seen.drive_power += sum(on.drive);
}

template <bool linear, bool tilting, bool lubricated, bool wavy>
void inner_race(Pass& pass, Shared& all) {
  const BearingModel& m = all.model;
  const BorderState& b = all.border;
  const RollerPack& q = pass.q;
  const auto r = [&](const double v[2]) { return along_r(q, splat(v[0]), splat(v[1])); };
  const auto t = [&](const double v[2]) { return along_t(q, splat(v[0]), splat(v[1])); };
  const RaceSide race{1,
                      m.inner_radius,
                      b.speed.inner,
                      r(b.ring),
                      t(b.ring),
                      r(b.ring_rate),
                      t(b.ring_rate),
                      r(b.tilt),
                      t(b.tilt),
                      b.ring_axial,
                      b.ring_axial_rate,
                      &m.forms.inner,
                      b.turned.inner};
  [[maybe_unused]] RingTilt tilt;
  if constexpr (tilting) {
    tilt.rate_r = r(b.tilt_rate);
    tilt.rate_t = t(b.tilt_rate);
    if constexpr (linear) tilt.linear = &all.jac->tilts[static_cast<std::size_t>(pass.group)];
  }
  RaceTotals on;
  RingTilt* const free_tilt = tilting ? &tilt : nullptr;
  if constexpr (lubricated)
    lubricated_race<linear, true, tilting, wavy>(m, m.inner_line, pass.roller, q, race, pass.loads,
                                                 pass.linear, all.seen, on, free_tilt);
  else
    race_contacts<linear, true, tilting, wavy>(m, pass.roller, q, race, pass.loads, pass.linear,
                                               all.seen, on, free_tilt);
  const RollerLoads& loads = pass.loads;
  all.loads.ring[0] -= sum(q.cosine * loads.f[kLr] - q.sine * loads.f[kLt]);
  all.loads.ring[1] -= sum(q.sine * loads.f[kLr] + q.cosine * loads.f[kLt]);
  all.loads.ring_axial -= sum(loads.f[kLx]);
  if constexpr (tilting) {
    all.loads.tilt[0] += sum(q.cosine * tilt.moment[0] - q.sine * tilt.moment[1]);
    all.loads.tilt[1] += sum(q.sine * tilt.moment[0] + q.cosine * tilt.moment[1]);
  }
  if constexpr (linear) {
    if constexpr (lubricated) {
      pass.energy_by_vt = on.energy_by_vt, pass.energy_by_spin = on.energy_by_spin;
      all.ring_energy[0] += sum(on.energy_by_vt * q.sine);
      all.ring_energy[1] -= sum(on.energy_by_vt * q.cosine);
      all.seen->damp(kFilm, -sum(on.energy_by_vt * q.omega * race.du_r));
      all.seen->damp(kFilm, -film_power(on, race, pass.roller, b.speeding_up.inner));
    }
    finish_inner_race<tilting>(pass, on, tilt, all);
  }
}

template <bool linear, bool lubricated, bool wavy>
void outer_race(Pass& pass, Shared& all) {
  const BearingModel& m = all.model;
  const RaceSide race{-1, m.outer_radius, all.border.speed.outer, {}, {}, {}, {}, {}, {}, 0,
                      0,  &m.forms.outer, all.border.turned.outer};
  RaceTotals on;
  if constexpr (lubricated)
    lubricated_race<linear, false, false, wavy>(m, m.outer_line, pass.roller, pass.q, race,
                                                pass.loads, pass.linear, all.seen, on);
  else
    race_contacts<linear, false, false, wavy>(m, pass.roller, pass.q, race, pass.loads, pass.linear,
                                              all.seen, on);
  if constexpr (linear) {
    pass.energy_by_vt += on.energy_by_vt;
    pass.energy_by_spin += on.energy_by_spin;
    if constexpr (lubricated)
      all.seen->damp(kFilm, -film_power(on, race, pass.roller, all.border.speeding_up.outer));
    all.seen->drive_power += sum(on.drive);
    store(all.seen->outer_force.data() + pass.group * kLanes, on.normal);
    all.seen->outer_slice = std::max(all.seen->outer_slice, largest(on.heaviest));
    for (int i = 0; i < kLocalVelocities; ++i)
      turn_frame(pass.q, pass.linear->position[i], pass.linear->velocity[i]);
  }
}

template <bool linear, bool lubricated>
void pocket(Pass& pass, Shared& all) {
  const BearingModel& m = all.model;
  const BorderState& b = all.border;
  const ModalState& modal = all.modal;
  PocketFrame f = pocket_places(pass.roller, pass.q, b);
  const bool oiled_bars = lubricated && m.oiled_bars;
  const double bar_layer = oiled_bars ? m.bar_line.layer : 0,
               wall_layer = lubricated ? m.wall_film.layer : 0;
  const Pack bar_margin = splat(modal.farthest + bar_layer);
  const bool bars = bars_in_reach(m, pass.roller, f, bar_margin),
             beyond = beyond_edges(m, pass.roller, f),
             walls = walls_in_reach(m, pass.roller, f, splat(modal.farthest + wall_layer));
  const bool arcs = m.shaped_pockets || beyond;
  if (!bars && !arcs && !walls) return;
  add_rates(pass.q, b, f);
  ContactRows* const rows = linear ? &all.jac->scratch : nullptr;
  const auto touch = [&](const auto& face) {
    if (oiled_bars)
      lubricated_pocket<linear>(m, face, pass.q, b, modal, pass.group, pass.loads, all.loads, rows,
                                all.jac, all.seen);
    else
      pocket_contacts<linear>(m, face, pass.q, b, modal, pass.group, pass.loads, all.loads, rows,
                              all.jac, all.seen);
  };
  if (bars && !m.curved_faces) touch(FlatFace(m, pass.roller, f, beyond));
  if (arcs) touch_arcs(m, pass.roller, f, ArcFace::kMargin * bar_margin, touch);
  if (walls)
    wall_contacts<linear>(m, pass.roller, pass.q, f, b, modal, pass.group, pass.loads, all.loads,
                          rows, all.jac, all.seen);
}

/// Derivatives of what is not a contact, once all contacts are there.
template <bool lubricated>
void finish_rollers(Pass& pass, Shared& all) {
  const BearingModel& m = all.model;
  const RollerPack& q = pass.q;
  const RollerGroup& roller = pass.roller;
  const RollerLoads& loads = pass.loads;
  if constexpr (lubricated) {
    const Pack a_t = loads.f[kLt] * roller.inverse_mass - m.gravity * q.cosine - q.vr * q.omega,
               a_s = loads.f[kLs] * roller.inverse_polar;
    // Left out of net_power_rate: it would take the rate of these accelerations.
    all.seen->damp(kFilm,
                   -sum(roller.exists * (pass.energy_by_vt * a_t + pass.energy_by_spin * a_s)));
  }
  add_inertial(m, roller, q, loads, *pass.linear);
  all.seen->net_power_rate += roller_power_rate(roller, q, loads, m, *pass.linear);
}

/// Power of the load and rate of the net power, from the border's rates.
template <bool tilting, bool lubricated>
void finish_border(double t, const double* y, const double* rate, const Shared& all) {
  const BearingModel& m = all.model;
  const BorderState& b = all.border;
  Linearisation& jac = *all.jac;
  Observation& seen = *all.seen;
  const RingLoad load = load_at(m.duty, t);
  seen.load_power = load.y * b.ring_rate[0] + load.z * b.ring_rate[1];
  jac.power_velocity[kRingY] += load.y;
  jac.power_velocity[kRingZ] += load.z;
  if (m.layout.ring_axial > 0) {
    seen.load_power += load.axial * b.ring_axial_rate;
    jac.power_velocity[m.layout.ring_axial_slot()] += load.axial;
  }
  if constexpr (tilting) {
    add_shaft_block(m, b, jac);
    seen.load_power += load.moment_y * b.tilt_rate[0] + load.moment_z * b.tilt_rate[1];
    jac.power_velocity[m.layout.ring_tilt_slot()] += load.moment_y;
    jac.power_velocity[m.layout.ring_tilt_slot() + 1] += load.moment_z;
  }
  const double *border_v = y + m.layout.border_velocity(0),
               *border_a = rate + m.layout.border_velocity(0);
  if constexpr (lubricated)
    seen.damp(kFilm,
              -all.ring_energy[0] * border_a[kRingY] - all.ring_energy[1] * border_a[kRingZ]);
  for (int i = 0; i < m.layout.border(); ++i)
    seen.net_power_rate +=
        jac.power_position[i] * border_v[i] + jac.power_velocity[i] * border_a[i];
}

/// `tilting`: the inner ring's tilt is free. `lubricated`: there is oil by src/lubrication.
/// `wavy`: raceways may be no circles.
template <bool linear, bool tilting, bool lubricated, bool wavy>
void evaluate(const BearingModel& m, double t, const double* y, double* rate, Linearisation* jac,
              Observation* seen) {
  const BorderState b = unpack_border(m, t, y);
  BorderLoads border;
  Pack modal_force[kMostModes];
  const double* modes = y + m.layout.border_position(kModes);
  const ModalState modal{&m.flexible, modes, y + m.layout.border_velocity(kModes), modal_force,
                         farthest_displacement(m.flexible, modes)};
  if constexpr (linear) {
    jac->clear();
    seen->clear();
    set_cage_block(m, b, y, *jac, *seen);
  }
  Shared all{m, b, modal, border, jac, seen};
  for (int group = 0; group < m.layout.groups; ++group) {
    Pass pass{group, m.groups[static_cast<std::size_t>(group)], unpack_rollers(m.layout, y, group)};
    if constexpr (linear) pass.linear = start_group(pass.q, group, *jac);
    inner_race<linear, tilting, lubricated, wavy>(pass, all);
    outer_race<linear, lubricated, wavy>(pass, all);
    flange_contacts<linear>(m, pass.roller, pass.q, b, group, pass.loads, border, jac, seen);
    if (lubricated && m.churning.on)
      roller_churning<linear>(m.churning, pass.roller, pass.q, b, pass.loads, pass.linear, seen);
    pocket<linear, lubricated>(pass, all);
    if constexpr (linear) finish_rollers<lubricated>(pass, all);
    store_rates(m, pass.roller, pass.q, pass.loads, y, rate, group);
  }
  double on_modes[kMostModes];
  for (int k = 0; k < m.layout.modes; ++k) on_modes[k] = modal.pushed ? sum(modal_force[k]) : 0;
  land_contacts<linear>(m, b, modal, border, on_modes, linear ? &jac->scratch : nullptr, jac, seen);
  if (lubricated && m.churning.on) churn_cage<linear>(m.churning, b, border, jac, seen);
  store_border_rates(m, t, b, border, on_modes, y, rate);
  if constexpr (linear) {
    jac->add_films();
    finish_border<tilting, lubricated>(t, y, rate, all);
  }
}

/// The one that suits a model; a dry bearing pays nothing for what oil would do.
template <bool linear, bool lubricated, bool wavy = false>
Evaluation evaluation_as(const BearingModel& m) {
  return m.layout.ring_tilt > 0 ? evaluate<linear, true, lubricated, wavy>
                                : evaluate<linear, false, lubricated, wavy>;
}
}  // namespace
}  // namespace cagetol
