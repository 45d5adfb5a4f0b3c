// What contact and oil do between a roller's end and the wall or flange it faces, one point of the
// end at a time: the dry law of touch.hpp, and the film of src/lubrication/flat_film.hpp.
#pragma once

#include "src/contacts/touch.hpp"
#include "src/lubrication/flat_film.hpp"
#include "src/newton/linearisation.hpp"

namespace cagetol {

/// What the forces of a point depend on: as ContactSlopes, in place of the axis the speed at which
/// oil is drawn in.
enum EndVariable { kEndP, kEndRate, kEndV1, kEndV2, kEndDrawn, kEndVariables };
using EndSlopes = Dual<Pack, kEndVariables>;

/// T: Pack, or EndSlopes.
template <class T>
struct EndFilm {
  T normal{}, drag{};  ///< pushes apart [N]; times the sliding velocity, against it [N s/m]
  Pack wedge{};        ///< part of the push [N]
};
/// `drawn`: speed at which oil is drawn into the wedge [m/s]; of no effect without one.
template <class T>
EndFilm<T> end_film(const FlatFilm& law, Mask wet, const Touch<Pack>& touch, Pack drawn) {
  const Pack gap = select(wet, -touch.p, splat(0.5 * law.layer)),
             one = select(wet, splat(1.0), Pack{});
  using D = std::conditional_t<std::is_same_v<T, Pack>, Pack, Dual<Pack, 3>>;
  const D opening = -variable<D>(-gap, 0), rate = -variable<D>(touch.rate, 1);
  D pushed{};
  if (law.wedge > 0) pushed = flat_wedge(law, opening, variable<D>(drawn, 2));
  const FlatFilmForces<D> f = flat_film(law, opening, rate, pushed);
  const T by[] = {variable<T>(touch.p, kEndP), variable<T>(touch.rate, kEndRate),
                  variable<T>(drawn, kEndDrawn)};
  return {composed(f.normal * one, by), composed(f.drag * one, by), value_of(pushed) * one};
}

/// What contact and film of a point of an end do together.
template <class T>
struct EndForces {
  Answer<Pack> contact;
  EndFilm<T> film;
  ChannelForces<T> both;
};
/// `wet`: lanes within the layer of oil; without oil those in contact.
template <class T>
EndForces<T> end_forces(const NormalLaw& law, const FrictionLaw& rubbing, const FlatFilm& oil,
                        const Touch<Pack>& touch, Mask wet, Pack drawn = Pack{}) {
  EndForces<T> on{answer_to(touch, wet & (touch.p > 0.0), law, rubbing), {}, {}};
  if (oil.on) on.film = end_film<T>(oil, wet, touch, drawn);
  const auto [normal, elastic, ratio] = dry_forces<T>(touch, on.contact);
  on.both =
      channel_forces(touch, T(normal + on.film.normal), elastic, T(ratio * normal + on.film.drag));
  return on;
}

/// Force, powers and energy of a point into the observation; `force` by roller.
inline void observe_end(const EndForces<EndSlopes>& on, const NormalLaw& law, const FlatFilm& oil,
                        const Touch<Pack>& touch, Mechanism where, double* force,
                        Observation& seen) {
  store(force, load(force) + on.both.normal.value);
  account(touch, on.contact, law, where, seen);
  if (!oil.on) return;
  seen.rub(where, sum(on.film.drag.value * on.contact.squared));
  seen.damp(kSqueeze, sum((on.film.normal.value - on.film.wedge) * touch.rate));
  seen.damp(kFilm, sum(on.film.wedge * touch.rate));
}

}  // namespace cagetol
