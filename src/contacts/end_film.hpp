// Oil between a roller's end and the wall or flange it faces (src/lubrication/flat_film.hpp), one
// point of the end at a time.
#pragma once

#include "src/contacts/touch.hpp"
#include "src/lubrication/flat_film.hpp"
#include "src/newton/linearisation.hpp"

namespace cagetol {

/// Oil of one point of an end (src/lubrication/flat_film.hpp): its forces at penetration p, and
/// their slopes by p, p' and the speed at which oil is drawn in.
struct EndFilm {
  Pack normal{}, normal_p{}, normal_rate{}, normal_speed{};  ///< pushes apart [N]
  Pack wedge{};                                              ///< of that [N]
  Pack drag{}, drag_p{};  ///< times the sliding velocity, against it [N s/m]
};
/// `drawn`: speed at which oil is drawn in [m/s]; of no effect without a wedge.
template <bool linear, bool wedge>
EndFilm end_film(const FlatFilm& law, Mask wet, Pack p, Pack rate, [[maybe_unused]] Pack drawn) {
  EndFilm film;
  const Pack gap = select(wet, -p, splat(0.5 * law.layer)), one = select(wet, splat(1.0), Pack{});
  if constexpr (linear) {
    using D = Dual<Pack, wedge ? 3 : 2>;
    const D opening = -variable<D>(-gap, 0);
    D pushed{};
    if constexpr (wedge) pushed = flat_wedge(law, opening, variable<D>(drawn, 2));
    const FlatFilmForces<D> f = flat_film(law, opening, -variable<D>(rate, 1), pushed);
    film.normal = f.normal.value * one;
    film.normal_p = f.normal.slope[0] * one;
    film.normal_rate = f.normal.slope[1] * one;
    if constexpr (wedge) film.normal_speed = f.normal.slope[2] * one;
    film.wedge = pushed.value * one;
    film.drag = f.drag.value * one;
    film.drag_p = f.drag.slope[0] * one;
  } else {
    const Pack pushed = wedge ? flat_wedge(law, gap, drawn) : Pack{};
    const FlatFilmForces<Pack> f = flat_film(law, gap, -rate, pushed);
    film.normal = f.normal * one;
    film.drag = f.drag * one;
  }
  return film;
}

/// Slopes of one lane's film.
inline FilmContactSlopes end_film_slopes(const EndFilm& film, const Touch<Pack>& touch, int lane) {
  using F = FilmContactSlopes;
  const double v1 = touch.v1[lane], v2 = touch.v2[lane], rate = touch.rate[lane];
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

/// What contact and film of a point of an end do together.
struct EndForces {
  Answer<Pack> contact;
  EndFilm film;
  Pack normal;  ///< [N]
  Pack drag;    ///< friction force over sliding speed [N s/m]
};
/// `wet`: lanes within the layer of oil; without oil those in contact. `drawn`: speed at which oil
/// is drawn into the wedge [m/s].
template <bool linear>
EndForces end_forces(const NormalLaw& law, const FrictionLaw& rubbing, const FlatFilm& oil,
                     const Touch<Pack>& touch, Mask wet, Pack drawn = Pack{}) {
  EndForces on;
  on.contact = answer_to(touch, wet & (touch.p > 0.0), law, rubbing);
  if (oil.wedge > 0)
    on.film = end_film<linear, true>(oil, wet, touch.p, touch.rate, drawn);
  else if (oil.on)
    on.film = end_film<linear, false>(oil, wet, touch.p, touch.rate, drawn);
  on.normal = on.contact.normal.force + on.film.normal;
  on.drag = on.contact.drag + on.film.drag;
  return on;
}

/// Force, powers and energy of a point into the observation; `force` by roller.
inline void observe_end(const EndForces& on, const NormalLaw& law, const FlatFilm& oil,
                        const Touch<Pack>& touch, Mechanism where, double* force,
                        Observation& seen) {
  store(force, load(force) + on.normal);
  account(touch, on.contact, law, where, seen);
  if (!oil.on) return;
  seen.rub(where, sum(on.film.drag * on.contact.squared));
  seen.damp(kSqueeze, sum((on.film.normal - on.film.wedge) * touch.rate));
  seen.damp(kFilm, sum(on.film.wedge * touch.rate));
}

}  // namespace cagetol
