// Roller against a dry raceway, or one with the films of src/contact_laws/oil_film.hpp, sliced
// along the roller (race_slice.hpp): a penalty force or a Hertzian contact in series with the
// film, and friction.
#pragma once

#include "src/contacts/wavy_race.hpp"

namespace cagetol {

/// The law of race_slice.hpp for a dry contact: no rolling resistance, and friction in proportion
/// to the normal force.
inline SliceLaw dry_law(const FilmContact<Pack>& contact, const Friction<Pack>& rubbing) {
  const NormalForce<Pack>& n = contact.normal;
  const Pack zero{}, ratio = rubbing.ratio;
  return {{n.force, {n.stiffness, n.damping, contact.by_speed, zero}},
          {ratio * n.force,
           {ratio * n.stiffness, ratio * n.damping, ratio * contact.by_speed,
            0.5 * rubbing.bend * n.force}},
          {zero, {zero, zero, zero, zero}},
          {n.elastic, {n.elastic_stiffness, zero, contact.elastic_by_speed, zero}}};
}

/// The film's speed where there is a film.
struct RaceFilm {
  Entrainment speed{};
  FilmAtSpeed<Pack> at{};
  Pack thickest{};  ///< height above which nothing is carried [m]
};
inline RaceFilm race_film(const RaceSide& race, const RollerGroup& roller, const RollerPack& q) {
  RaceFilm film;
  if (!race.film.on) return film;
  film.speed = absolute(entrainment(race, roller, q));
  film.at = film_at_speed(race.film, film.speed.speed);
  film.thickest = thickest_film(race.film, film.at);
  return film;
}

/// Powers, energy and sums of one slice.
inline void observe_slice(const BearingModel& model, const RaceSide& race, const SliceMotion& m,
                          const SliceForces& on, const FilmContact<Pack>& contact,
                          const RaceFilm& film, Mask touching, Observation& seen,
                          RaceTotals& totals) {
  const NormalForce<Pack>& normal = contact.normal;
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
  if (race.film.on) {
    seen.elastic_energy += sum(film_energy(model.race, race.film, film.at, contact));
    seen.thinnest_film =
        std::min(seen.thinnest_film, smallest(select(touching, contact.thickness, splat(kNoFilm))));
  } else {
    seen.elastic_energy += sum(normal.elastic * contact.depth * (1 / (model.race.exponent + 1)));
  }
}

/// `moving`, `tilting` as of slice_gap; `tilt`: where `tilting`; `wavy`: the race is no circle.
template <bool linear, bool moving, bool tilting = false, bool wavy = false>
void race_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                   const RaceSide& race, RollerLoads& loads, GroupLinear* jac, Observation* seen,
                   RaceTotals& totals, RingTilt* tilt = nullptr) {
  const RaceFilm film = race_film(race, roller, q);
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
    const Mask touching = (gaps[n].p + film.thickest > 0.0) & (roller.exists > 0.0);
    if (!any(touching)) continue;
    const Slice& slice = model.race_slices[static_cast<std::size_t>(n)];
    SliceMotion m = slice_motion<moving, tilting>(slice, gaps[n], roller, q, race, tilt);
    if constexpr (wavy) m.rate += form.rate;
    const Pack reached = select(touching, m.p, splat(-1.0));
    FilmContact<Pack> contact{};
    if (race.film.on) {
      contact = film_contact(model.race, race.film, film.at, reached, m.rate);
    } else {
      contact.normal = normal_force(model.race, reached, m.rate);
      contact.depth = max(m.p, Pack{});
    }
    const auto fr = friction(rubbing, m.v1 * m.v1 + m.v2 * m.v2);
    const Pack normal = contact.normal.force;
    const SliceForces on = slice_forces(m, normal, fr.ratio * normal, Pack{}, Pack{});
    add_slice_loads<moving, tilting>(q, race, m, on, loads, tilt);
    if constexpr (wavy) add_wavy_load(form, on, loads);
    if constexpr (linear) {
      observe_slice(model, race, m, on, contact, film, touching, *seen, totals);
      if constexpr (wavy) observe_wavy_load(form, on, contact.normal.elastic, totals);
      add_slice_slopes<moving, tilting, wavy>(q, race, m, on, dry_law(contact, fr), film.speed,
                                              Pack{}, *jac, tilt, &form);
    }
  }
  if constexpr (linear && wavy) seen->net_power_rate += sum(roller.exists * form.power_by_time);
}

}  // namespace cagetol
