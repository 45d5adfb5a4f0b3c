// Roller against a dry raceway, sliced along the roller (race_slice.hpp): a penalty force or a
// Hertzian contact, and friction.
#pragma once

#include "src/contacts/wavy_race.hpp"

namespace cagetol {

/// The law of race_slice.hpp for a dry contact: no rolling resistance, and friction in proportion
/// to the normal force.
inline SliceLaw dry_law(const NormalForce<Pack>& n, const Friction<Pack>& rubbing) {
  const Pack zero{}, ratio = rubbing.ratio;
  return {{n.force, {n.stiffness, n.damping, zero, zero}},
          {ratio * n.force,
           {ratio * n.stiffness, ratio * n.damping, zero, 0.5 * rubbing.bend * n.force}},
          {zero, {zero, zero, zero, zero}},
          {n.elastic, {n.elastic_stiffness, zero, zero, zero}}};
}

/// Powers, energy and sums of one slice.
inline void observe_slice(const BearingModel& model, const RaceSide& race, const SliceMotion& m,
                          const SliceForces& on, const NormalForce<Pack>& normal, Observation& seen,
                          RaceTotals& totals) {
  const Pack squared = m.v1 * m.v1 + m.v2 * m.v2;
  totals.normal += normal.force;
  totals.heaviest = max(totals.heaviest, normal.force);
  totals.sliding += normal.force * sqrt(squared);
  totals.normal_r += normal.elastic * m.n_r;
  totals.normal_t += normal.elastic * m.n_t;
  totals.drive += on.f1 * race.surface() + on.f2 * m.drift;
  totals.rubbing += on.ratio * squared;
  seen.rub(kRaceSliding, sum(on.ratio * squared));
  seen.damp(kDamping, sum((normal.force - normal.elastic) * m.rate));
  seen.elastic_energy += sum(normal.elastic * max(m.p, Pack{}) * (1 / (model.race.exponent + 1)));
}

/// `moving`, `tilting` as of slice_gap; `tilt`: where `tilting`; `wavy`: the race is no circle.
template <bool linear, bool moving, bool tilting = false, bool wavy = false>
void race_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                   const RaceSide& race, RollerLoads& loads, GroupLinear* jac, Observation* seen,
                   RaceTotals& totals, RingTilt* tilt = nullptr) {
  const FrictionLaw rubbing =
      model.friction[kRacePair];  // a copy, so that its constants are made once
  // Where the slices are, before what they do: a slice's force waits for its root, and a processor
  // that sees several roots side by side does not wait.
  [[maybe_unused]] WavyRace form;
  if constexpr (wavy) form = wavy_race(q, race);
  SliceGap gaps[kMostSlices];
  const int slices = static_cast<int>(model.race_slices.size());
  for (int n = 0; n < slices; ++n)
    gaps[n] = slice_gap<moving>(roller, q, race, model.race_slices[static_cast<std::size_t>(n)]);
  if constexpr (wavy)
    for (int n = 0; n < slices; ++n) gaps[n].p += form.w;
  for (int n = 0; n < slices; ++n) {
    const Mask touching = (gaps[n].p > 0.0) & (roller.exists > 0.0);
    if (!any(touching)) continue;
    const Slice& slice = model.race_slices[static_cast<std::size_t>(n)];
    SliceMotion m = slice_motion<moving, tilting>(slice, gaps[n], roller, q, race, tilt);
    if constexpr (wavy) m.rate += form.rate;
    const Pack reached = select(touching, m.p, splat(-1.0));
    const NormalForce<Pack> contact = normal_force(model.race, reached, m.rate);
    const auto fr = friction(rubbing, m.v1 * m.v1 + m.v2 * m.v2);
    const Pack normal = contact.force;
    const SliceForces on = slice_forces(m, normal, fr.ratio * normal, Pack{}, Pack{});
    add_slice_loads<moving, tilting>(q, race, m, on, loads, tilt);
    if constexpr (wavy) add_wavy_load(form, on, loads);
    if constexpr (linear) {
      observe_slice(model, race, m, on, contact, *seen, totals);
      if constexpr (wavy) observe_wavy_load(form, on, contact.elastic, totals);
      add_slice_slopes<moving, tilting, wavy>(q, race, m, on, dry_law(contact, fr), Entrainment{},
                                              Pack{}, *jac, tilt, &form);
    }
  }
  if constexpr (linear && wavy) seen->net_power_rate += sum(roller.exists * form.power_by_time);
}

}  // namespace cagetol
