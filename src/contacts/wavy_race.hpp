// What the form of a raceway (raceway_form.hpp) adds to its contact with a pack of rollers, alike
// in all slices. d = r e_r - u from the race's centre to the roller's at mid-length, D = |d|,
// beta its angle, alpha the angle of the ring:
//   w = s form(beta - alpha)                 penetration on top of that of the circle
//   g = dw/dd = s form' t/D, H = dg/dd       t = e_x x d/D
//   w' = g . d' - s form' alpha'
// The force is the transpose: -Q g on the roller, at its middle, and the opposite on the ring; the
// ring's drive gives Q w_t, w_t = -s form' alpha'. Left out: surface speeds and entrainment of the
// changed radius (form over radius), and what a tilt of the ring does to beta.
#pragma once

#include "src/contacts/race_slice.hpp"
#include "src/model/raceway_form.hpp"

namespace cagetol {

inline WavyRace wavy_race(const RollerPack& q, const RaceSide& race) {
  WavyRace on{};
  if (is_round(*race.form)) return on;
  const Pack d[2] = {q.r - race.u_r, -race.u_t}, v[2] = {q.vr - race.du_r, q.vt - race.du_t};
  const Pack inverse = 1.0 / (d[0] * d[0] + d[1] * d[1]);
  // Angle of d: that of the roller, and the small one from there.
  Pack turned;
  for (int i = 0; i < kLanes; ++i)
    turned[i] = std::atan2(q.sine[i], q.cosine[i]) + std::atan2(d[1][i], d[0][i]);
  const FormAt at = form_at(*race.form, turned - race.turned);
  const double s = race.sign, speed = race.speed;
  const Pack by[2] = {-d[1] * inverse, d[0] * inverse};   // of beta
  const Pack away[2] = {d[0] * inverse, d[1] * inverse};  // of ln D
  on.w = s * at.height;
  on.w_t = -s * speed * at.slope;
  on.w_tt = s * speed * speed * at.bend;
  const Pack bend_t = -s * speed * at.bend;  // of s form' with time
  const Pack turning = by[0] * v[0] + by[1] * v[1];
  on.rate = s * at.slope * turning + on.w_t;
  on.rate_by_time = bend_t * turning + on.w_tt;
  for (int i = 0; i < 2; ++i) {
    on.g[i] = s * at.slope * by[i];
    on.w_t_by[i] = bend_t * by[i];
    for (int j = 0; j < 2; ++j)
      on.H[i][j] = s * (at.bend * by[i] * by[j] - at.slope * (away[i] * by[j] + by[i] * away[j]));
  }
  for (int i = 0; i < 2; ++i)
    on.rate_by_place[i] = on.H[i][0] * v[0] + on.H[i][1] * v[1] + on.w_t_by[i];
  return on;
}

/// Adds what the form makes of a slice's normal force.
inline void add_wavy_load(const WavyRace& form, const SliceForces& on, RollerLoads& loads) {
  for (int i = 0; i < 2; ++i) loads.f[i] -= on.normal * form.g[i];
}

/// And to the sums; `elastic`: part of the normal force.
inline void observe_wavy_load(const WavyRace& form, const SliceForces& on, Pack elastic,
                              RaceTotals& totals) {
  totals.normal_r -= elastic * form.g[0];
  totals.normal_t -= elastic * form.g[1];
  totals.drive += on.normal * form.w_t;
}

}  // namespace cagetol
