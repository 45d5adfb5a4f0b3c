// Roller against a raceway with oil (src/lubrication/lubricated_line.hpp), sliced along the roller
// (race_slice.hpp). Beside normal force and traction there is rolling resistance, whose pressure
// pulls on the roller's axis; the power that the contact takes is
//   P = Q p' + ratio |v|^2 + 2 F_r u
#pragma once

#include "src/contacts/wavy_race.hpp"
#include "src/lubrication/lubricated_line.hpp"

namespace cagetol {

/// Forces of the oil at one slice, with derivatives by z or without; nothing in lanes without oil.
template <bool linear, class U>
auto oil_forces(const LubricatedLine& law, const LineSpeed<U>& speed, Mask wet,
                const SliceMotion& m) {
  // Lanes without a contact take part with an open gap.
  const Pack p = select(wet, m.p, splat(law.starved ? -0.5 * law.layer : -1e-5));
  const Pack squared = m.v1 * m.v1 + m.v2 * m.v2, one = select(wet, splat(1.0), Pack{});
  const auto forces = [&](auto depth, auto rate, auto of_sliding) {
    auto f = line_forces(law, speed, -depth, -rate, of_sliding);
    f.at.normal = f.at.normal * one;
    f.ratio = f.ratio * one;
    f.rolling = f.rolling * one;
    return f;
  };
  if constexpr (linear)
    return forces(variable<0, 4>(p), variable<1, 4>(m.rate), variable<3, 4>(squared));
  else
    return forces(p, m.rate, squared);
}

/// Powers, energy and sums of one slice, and its derivatives.
template <bool moving, bool tilting, bool wavy, class Forces>
void linearise_oiled_slice(const BearingModel& model, const LubricatedLine& law,
                           const RollerPack& q, const RaceSide& race, const SliceMotion& m,
                           const SliceForces& on, const Forces& f, const Entrainment& u,
                           Pack axis_share, Mask wet, GroupLinear& jac, Observation& seen,
                           RaceTotals& totals, RingTilt* tilt, WavyRace* form) {
  const Pack p = select(wet, m.p, splat(law.starved ? -0.5 * law.layer : -1e-5));
  const Pack squared = m.v1 * m.v1 + m.v2 * m.v2, one = select(wet, splat(1.0), Pack{});
  totals.normal += on.normal;
  totals.heaviest = max(totals.heaviest, on.normal);
  totals.sliding += on.normal * sqrt(squared);
  totals.normal_r += on.normal * m.n_r;
  totals.normal_t += on.normal * m.n_t;
  totals.drive += (on.rolling - on.ratio * m.v1) * race.surface() + on.f2 * m.drift;
  const Pack film = value_of(f.at.film) * one, steady = value_of(f.at.steady) * one;
  totals.rubbing += on.ratio * squared;
  seen.rub(kRaceSliding, sum(on.ratio * squared));
  seen.rub(kRollingResistance, sum(2.0 * on.rolling * u.speed));
  seen.damp(kSqueeze, sum((film - steady) * m.rate));
  seen.damp(kDamping, sum((on.normal - film) * m.rate));
  const auto [energy, pushing] = elastic_store(law, f.at, variable<0, 4>(p));
  const auto storing = pushing * one;
  seen.elastic_energy += sum(energy.value * one);
  totals.energy_by_vt += energy.slope[2] * one * u.by_vt;
  totals.energy_by_spin += energy.slope[2] * one * u.by_spin;
  seen.damp(kFilm, sum((steady - storing.value) * m.rate));
  const Pack thickness =
      select(on.normal > model.film_watch, value_of(f.at.oil.thickness), splat(kNoFilm));
  seen.thinnest_film = std::min(seen.thinnest_film, smallest(thickness));
  if constexpr (wavy) observe_wavy_load(*form, on, on.normal, totals);
  add_slice_slopes<moving, tilting, wavy>(
      q, race, m, on, {f.at.normal, f.ratio, f.rolling, storing}, u, axis_share, jac, tilt, form);
}

/// `moving`, `tilting`, `wavy` as of race_contacts. `law`: of one slice.
template <bool linear, bool moving, bool tilting = false, bool wavy = false>
void lubricated_race(const BearingModel& model, const LubricatedLine& law,
                     const RollerGroup& roller, const RollerPack& q, const RaceSide& race,
                     RollerLoads& loads, GroupLinear* jac, Observation* seen, RaceTotals& totals,
                     RingTilt* tilt = nullptr) {
  const Entrainment u = entrainment(race, roller, q);
  // 2 R/R_roller: with that of the race it adds up to two, so that the forces of a pair vanish.
  const Pack axis_share = 2.0 * race.radius / (race.radius + race.sign * roller.radius);
  const auto speed = [&] {
    if constexpr (linear)
      return line_speed(law, variable<2, 4>(u.speed));
    else
      return line_speed(law, u.speed);
  }();
  [[maybe_unused]] WavyRace form;
  if constexpr (wavy) form = wavy_race(q, race);
  for (const Slice& slice : model.race_slices) {
    SliceGap gap = slice_gap<moving>(roller, q, race, slice);
    if constexpr (wavy) gap.p += form.w;
    Mask wet = roller.exists > 0.0;
    if (law.starved) wet &= -gap.p < law.layer;
    if (!any(wet)) continue;
    SliceMotion m = slice_motion<moving, tilting>(slice, gap, roller, q, race, tilt);
    if constexpr (wavy) m.rate += form.rate;
    const auto f = oil_forces<linear>(law, speed, wet, m);
    const SliceForces on =
        slice_forces(m, value_of(f.at.normal), value_of(f.ratio), value_of(f.rolling), axis_share);
    add_slice_loads<moving, tilting>(q, race, m, on, loads, tilt);
    if constexpr (wavy) add_wavy_load(form, on, loads);
    if constexpr (linear)
      linearise_oiled_slice<moving, tilting, wavy>(model, law, q, race, m, on, f, u, axis_share,
                                                   wet, *jac, *seen, totals, tilt, &form);
  }
  if constexpr (linear && wavy) seen->net_power_rate += sum(roller.exists * form.power_by_time);
}

}  // namespace cagetol
