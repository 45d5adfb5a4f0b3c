// Roller against a raceway, sliced along the roller. n is the direction of the force on the roller,
// d from the axis of the race to the axis of the roller in the radial plane at the slice, s = +1
// inside (inner race), -1 outside:
//   n  = s d/|d|
//   p  = s (R_race - |d|) + R_slice
//   p' = -n . (velocity of the roller's axis - velocity of the race's axis)
// The inner race may be tilted: its axis passes the slice at u + B X, X the slice's axial place, so
// n has the axial part -n.B. Sliding speeds: v1 along t = e_x x n, v2 along e_x, of the roller's
// surface at -R_slice n relative to the race's surface: a tapered or profiled roller slides
// differentially along its length. Where the tilt is free it has its own row in each channel: the
// axis at the slice moves with B' X, the race's surface axially with -s R_race n.B'.
#pragma once

#include "src/contact/film_contact.hpp"
#include "src/dynamics/contact_frame.hpp"

namespace cagetol {

struct RaceSide {
  double sign;    ///< s
  double radius;  ///< R_race [m]
  double speed;   ///< of the race about its axis [rad/s]
  const FilmLaw& film;
  Pack u_r, u_t, du_r, du_t;  ///< its centre and its velocity in the rollers' directions
  Pack B_r, B_t;              ///< slope of its axis, likewise
};

/// Mean speed at which both surfaces carry oil into the contact, as seen from the contact, which
/// travels with the roller; the same along the whole roller.
struct Entrainment {
  Pack speed;           ///< u >= 0 [m/s]
  Pack by_vt, by_spin;  ///< its derivatives
};
inline Entrainment entrainment(const RaceSide& race, const RollerGroup& roller,
                               const RollerPack& q) {
  const Pack lever = race.sign * (0.5 - race.radius / (race.radius + race.sign * roller.radius));
  const Pack forward = 0.5 * (race.sign * race.speed * race.radius - roller.radius * q.spin) +
                       lever * (q.vt - race.du_t);
  const Pack way = select(forward < 0.0, splat(-1.0), splat(1.0));
  return {way * forward, way * lever, -0.5 * way * roller.radius};
}

/// The free tilt of the inner ring, as a pack of rollers sees it.
struct RingTilt {
  Pack rate_r, rate_t;  ///< B' in the rollers' directions
  Pack moment[2] = {};  ///< of the rollers on the ring, conjugate to (B_r, B_t)
  TiltLinear* linear = nullptr;
};

/// A slice's penetration, its normal, and s over the distance of the axes.
struct SliceGap {
  Pack p, n_r, n_t, inverse;
};
template <bool moving = true>
[[gnu::always_inline]] inline SliceGap slice_gap(const RollerGroup& roller, const RollerPack& q,
                                                 const RaceSide& race, const Slice& slice) {
  Pack d_r = q.r + slice.position * q.a_r, d_t = slice.position * q.a_t;
  if constexpr (moving) {
    const Pack place = q.x + slice.position;
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

// Whether a race's normal and its two sliding channels have an entry for a local direction: the
// normal none for the spin, and of a race that does not move none for the axial motion, v1 none for
// that, v2 none in the radial plane.
template <bool moving>
constexpr bool in_normal(int i) {
  return i != kLs && (moving || i != kLx);
}
constexpr bool in_v1(int i) {
  return i != kLx;
}
constexpr bool in_v2(int i) {
  return i != kLr && i != kLt;
}

/// `moving`: the race may turn, move and be tilted; else `race` stands still, straight and centred,
/// and nothing of what that would do is computed. `tilt`: where `tilting`.
template <bool linear, bool moving, bool tilting = false>
void race_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                   const RaceSide& race, RollerLoads& loads, GroupLinear* jac, Observation* seen,
                   Pack& total, Pack& sliding, Pack& elastic_r, Pack& elastic_t, Pack& drive,
                   RingTilt* tilt = nullptr, [[maybe_unused]] StepLimit<Pack>* limit = nullptr) {
  Entrainment oil;
  FilmAtSpeed<Pack> film;
  Pack thickest{};
  if (race.film.on) {
    oil = entrainment(race, roller, q);
    film = film_at_speed(race.film, oil.speed);
    thickest = thickest_film(race.film, film);
  }
  const FrictionLaw rubbing =
      model.friction[kRacePair];  // a copy, so that its constants are made once
  [[maybe_unused]] Pack friction_power{}, damping_power{}, energy{};
  // Where the slices are, before what they do: a slice's force waits for its root, and a processor
  // that sees several roots side by side does not wait.
  SliceGap gaps[kMostSlices];
  const int slices = static_cast<int>(model.race_slices.size());
  for (int n = 0; n < slices; ++n) {
    gaps[n] = slice_gap<moving>(roller, q, race, model.race_slices[static_cast<std::size_t>(n)]);
  }
  for (int n = 0; n < slices; ++n) {
    const Slice& slice = model.race_slices[static_cast<std::size_t>(n)];
    const double xi = slice.position;
    const auto& [p, n_r, n_t, inverse] = gaps[n];
    const Mask touching = (p + thickest > 0.0) & (roller.exists > 0.0);
    if constexpr (!linear)
      if (!any(touching)) continue;

    [[maybe_unused]] const Pack place = q.x + xi;
    const Pack radius = roller.radius + (xi * roller.taper_slope - slice.drop);
    Pack v_r = q.vr + xi * q.b_r, v_t = q.vt + xi * q.b_t;
    [[maybe_unused]] Pack n_x{};
    if constexpr (moving) {
      n_x = -(n_r * race.B_r + n_t * race.B_t);
      v_r -= race.du_r;
      v_t -= race.du_t;
    }
    if constexpr (tilting) {
      v_r -= place * tilt->rate_r;
      v_t -= place * tilt->rate_t;
    }
    Pack closing = n_r * v_r + n_t * v_t;
    if constexpr (moving) closing += n_x * q.vx;
    const Pack rate = -closing;
    if constexpr (linear) {
      if (limit) {
        limit->lay_around(p + thickest, rate, roller.exists > 0.0);
        // Leaving the load zone is foreseen, too; on the outer race rollers bounce all the time.
        if (race.sign > 0) limit->pass(-p - thickest, -rate, roller.exists > 0.0);
      }
      if (!any(touching)) continue;
    }
    const Pack along = n_r * v_t - n_t * v_r;  // velocity of the axes along t
    const Pack w_r = q.spin * q.a_r - q.b_t, w_t = q.spin * q.a_t + q.b_r;
    Pack v1 = along - radius * q.spin, v2 = q.vx + radius * (n_r * w_t - n_t * w_r);
    [[maybe_unused]] const double surface = race.sign * race.speed * race.radius;  // along t
    [[maybe_unused]] Pack askew{},
        swash{};  // the race's axis along t, and what it does as it turns
    if constexpr (moving) {
      askew = race.B_r * n_t - race.B_t * n_r;
      swash = surface * askew;
      v1 -= surface;
      v2 -= swash;
    }
    [[maybe_unused]] const double arm = race.sign * race.radius;  // of the race's surface along n
    if constexpr (tilting) v2 += arm * (n_r * tilt->rate_r + n_t * tilt->rate_t);

    const Pack reached = select(touching, p, splat(-1.0));
    FilmContact<Pack> contact;
    if (race.film.on) {
      contact = film_contact(model.race, race.film, film, reached, rate);
    } else {
      contact.normal = normal_force(model.race, reached, rate);
      contact.depth = max(p, Pack{});
    }
    const NormalForce<Pack>& normal = contact.normal;
    const Pack speed2 = v1 * v1 + v2 * v2;
    const auto fr = friction(rubbing, speed2);
    const Pack g = fr.ratio * normal.force;
    const Pack f1 = -g * v1, f2 = -g * v2;
    const Pack f_r = normal.force * n_r - f1 * n_t, f_t = normal.force * n_t + f1 * n_r;
    const Pack lean = n_r * q.a_t - n_t * q.a_r;
    loads.f[kLr] += f_r;
    loads.f[kLt] += f_t;
    if constexpr (moving) loads.f[kLx] += normal.force * n_x;
    loads.f[kLx] += f2;
    loads.f[kLar] += xi * f_r + radius * n_r * f2;
    loads.f[kLat] += xi * f_t + radius * n_t * f2;
    loads.f[kLs] += radius * (f2 * lean - f1);
    if constexpr (tilting) {
      tilt->moment[0] += arm * n_r * f2 - place * f_r;
      tilt->moment[1] += arm * n_t * f2 - place * f_t;
    }

    if constexpr (linear) {
      total += normal.force;
      sliding += normal.force * sqrt(speed2);
      elastic_r += normal.elastic * n_r;
      elastic_t += normal.elastic * n_t;
      if constexpr (moving) drive += f1 * surface + f2 * swash;
      friction_power += g * speed2;
      damping_power += (normal.force - normal.elastic) * rate;
      if (race.film.on) {
        energy += film_energy(model.race, race.film, film, contact);
        seen->thinnest_film = std::min(
            seen->thinnest_film, smallest(select(touching, contact.thickness, splat(kNoFilm))));
      } else {
        energy += normal.elastic * contact.depth * (1 / (model.race.exponent + 1));
      }

      const Pack zero{}, one = splat(1.0);
      // Rows over the roller's velocities, then the ring's tilt.
      constexpr int rows = kLocalVelocities + (tilting ? 2 : 0);
      Pack gn[rows] = {n_r, n_t, n_x, xi * n_r, xi * n_t, zero};
      Pack g1[rows] = {-n_t, n_r, zero, -xi * n_t, xi * n_r, -radius};
      Pack g2[rows] = {zero, zero, one, radius * n_r, radius * n_t, radius * lean};
      if constexpr (tilting)
        for (int k = 0; k < 2; ++k) {
          gn[kLocalVelocities + k] = -place * gn[k];
          g1[kLocalVelocities + k] = -place * g1[k];
          g2[kLocalVelocities + k] = arm * gn[k];
        }
      const Pack lean_r = -radius * q.spin * n_t, lean_t = radius * q.spin * n_r;
      const Pack q0 = normal.force;
      const Pack d11 = q0 * (fr.ratio + fr.bend * v1 * v1), d12 = q0 * fr.bend * v1 * v2;
      const Pack d22 = q0 * (fr.ratio + fr.bend * v2 * v2);
      const Pack m1 = fr.ratio * v1, m2 = fr.ratio * v2;
      const Pack turn = normal.damping * inverse * along;
      const Pack spread = q0 * inverse;
      const auto lost = dissipation_slopes(q0, normal.stiffness, normal.damping, fr.ratio, fr.bend,
                                           v1, v2, normal.elastic, normal.elastic_stiffness, rate);
      // Net power = drive - dissipation; the drive's F1 and F2 follow Q and the sliding speeds.
      Pack driven{}, by_p = lost.p, by_rate = lost.rate, by_v1 = lost.v1, by_v2 = lost.v2;
      // As the axis moves along t, n turns, and with it p', v1, v2 and the swash.
      const Pack v1_turn = inverse * rate;
      Pack v2_turn = -inverse * radius * (n_r * w_r + n_t * w_t), by_turn{};
      if constexpr (moving) {
        driven = m1 * surface + m2 * swash;
        by_p += driven * normal.stiffness;
        by_rate += driven * normal.damping;
        by_v1 += d11 * surface + d12 * swash;
        by_v2 += d12 * surface + d22 * swash;
        const Pack swash_turn = inverse * surface * (race.B_r * n_r + race.B_t * n_t);
        v2_turn -= swash_turn;
        by_turn = f2 * swash_turn;
      }
      by_turn += by_rate * inverse * along - by_v1 * v1_turn - by_v2 * v2_turn;
#pragma GCC unroll 6
      for (int i = 0; i < kLocalVelocities; ++i) {
        Pack& to = jac->power_velocity[i];
        if (in_normal<moving>(i)) to += by_rate * gn[i];
        if (in_v1(i)) to -= by_v1 * g1[i];
        if (in_v2(i)) to -= by_v2 * g2[i];
        if (i == kLocalPositions) break;
        if (in_normal<moving>(i)) jac->power_position[i] += by_p * gn[i];
        if (in_v1(i)) jac->power_position[i] += by_turn * g1[i];
      }
      if (race.film.on) {
        const Pack by_speed = contact.by_speed * (fr.ratio * speed2 + rate + driven) -
                              contact.elastic_by_speed * rate;
        jac->power_velocity[kLt] -= by_speed * oil.by_vt;
        jac->power_velocity[kLs] -= by_speed * oil.by_spin;
      }
      if constexpr (moving) jac->power_position[kLx] += by_turn * askew;
      jac->power_position[kLar] -= by_v2 * lean_r;
      jac->power_position[kLat] -= by_v2 * lean_t;
      // What v2 loses to the swash as the ring tilts.
      [[maybe_unused]] const Pack swashing[2] = {-arm * race.speed * n_t, arm * race.speed * n_r};
      if constexpr (tilting)
        for (int k = 0; k < 2; ++k) {
          const int i = kLocalVelocities + k;
          tilt->linear->power_velocity[k] += by_rate * gn[i] - by_v1 * g1[i] - by_v2 * g2[i];
          tilt->linear->power_position[k] +=
              by_p * gn[i] + by_turn * g1[i] - (by_v2 + f2) * swashing[k];
        }
      // What forces do, held fast, as n turns with t and with it the lever of F2.
      Pack turned[rows];
#pragma GCC unroll 8
      for (int i = 0; i < rows; ++i) {
        turned[i] = in_normal<moving>(i) ? m1 * gn[i] : Pack{};
        if (in_v1(i)) turned[i] += g1[i];
        turned[i] *= spread;
      }
      const Pack lever = inverse * f2;
      if constexpr (moving) turned[kLx] = spread * askew;
      turned[kLar] -= radius * n_t * lever;
      turned[kLat] += radius * n_r * lever;
      turned[kLs] = -radius * (n_r * q.a_r + n_t * q.a_t) * lever;
      if constexpr (tilting) {
        turned[kLocalVelocities] -= arm * n_t * lever;
        turned[kLocalVelocities + 1] += arm * n_r * lever;
      }
#pragma GCC unroll 8
      for (int i = 0; i < rows; ++i) {
        const LinearRow row = linear_row<tilting>(i, *jac, tilt);
        Pack e{}, w1{}, w2{};
        if (in_normal<moving>(i)) e = gn[i];
        if (in_v1(i)) e -= m1 * g1[i], w1 = d11 * g1[i], w2 = d12 * g1[i];
        if (in_v2(i)) e -= m2 * g2[i], w1 += d12 * g2[i], w2 += d22 * g2[i];
        const Pack ec = e * normal.damping, ek = e * normal.stiffness;
        const Pack et = turned[i] - e * turn - w1 * v1_turn - w2 * v2_turn;
#pragma GCC unroll 6
        for (int j = 0; j < kLocalVelocities; ++j) {
          if (in_normal<moving>(j)) row.velocity[j] -= ec * gn[j];
          if (in_v1(j)) row.velocity[j] -= w1 * g1[j];
          if (in_v2(j)) row.velocity[j] -= w2 * g2[j];
          if (j == kLocalPositions) break;
          if (in_normal<moving>(j)) row.position[j] -= ek * gn[j];
          if (in_v1(j)) row.position[j] += et * g1[j];
        }
        if (race.film.on) {
          row.velocity[kLt] += e * contact.by_speed * oil.by_vt;
          row.velocity[kLs] += e * contact.by_speed * oil.by_spin;
        }
        if constexpr (moving) row.position[kLx] += et * askew;
        row.position[kLar] -= w2 * lean_r;
        row.position[kLat] -= w2 * lean_t;
        if constexpr (tilting)
          for (int k = 0; k < 2; ++k) {
            const int j = kLocalVelocities + k;
            row.tilt_velocity[k] -= ec * gn[j] + w1 * g1[j] + w2 * g2[j];
            row.tilt_position[k] += et * g1[j] - ek * gn[j] - w2 * swashing[k];
          }
      }
      jac->position[kLs][kLar] -= radius * n_t * f2;
      jac->position[kLs][kLat] += radius * n_r * f2;
      if constexpr (tilting) {
        RingCoupling& coupling = tilt->linear->coupling;
        // n_x follows the tilt, and the force's lever on the ring the roller's axial place.
        coupling.position[kLx][0] -= q0 * n_r;
        coupling.position[kLx][1] -= q0 * n_t;
        coupling.to_position[0][kLx] -= f_r;
        coupling.to_position[1][kLx] -= f_t;
      }
    }
  }
  if constexpr (linear) {
    seen->rub(kRaceSliding, sum(friction_power));
    seen->damp(kDamping, sum(damping_power));
    seen->elastic_energy += sum(energy);
  }
}

}  // namespace cagetol
