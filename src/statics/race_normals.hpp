// Normal forces of a raceway on rollers, without friction: what a balance at rest needs of
// race_contacts.hpp, in a fraction of its time. Axes of rollers keep their direction, and x = 0;
// where rollers travel, the law damps.
//
// A slice at X sees F = Q n, a function of d = (roller's axis) - (race's axis) in the radial plane:
//   dF/dd = -k n n^T - c (t.d')/h n t^T + (Q/h) t t^T,  h = s |d|, t = e_x x n
// and d = r e_r + X alpha_r e_r - u - X B: everything follows from moments over X.
#pragma once

#include "src/contacts/wavy_race.hpp"
#include "src/lubrication/lubricated_line.hpp"

namespace cagetol {

struct RaceNormals {
  Pack force[2][2]{};     ///< sums of X^m F; r, t [N], [N m]
  Pack slope[3][2][2]{};  ///< sums of X^m dF/dd [N/m], [N], [N m]
  Pack total{};           ///< of Q [N]
  Pack heaviest{};        ///< largest Q of a slice [N]
  Pack elastic[2]{};      ///< sums of the elastic part of F; r, t [N]
  Pack by_time[2]{};      ///< sums of dF/dt where nothing but the race turns; r, t [N/s]
};

/// Adds the normal force of one slice, its slopes by penetration and by its rate, and its elastic
/// part.
inline void add_normal(const Slice& slice, const NormalForce<Pack>& normal, const SliceGap& gap,
                       Pack along, RaceNormals& sums) {
  const auto& [p, n_r, n_t, inverse] = gap;
  const Pack n[2] = {n_r, n_t}, t[2] = {-n_t, n_r};
  const Pack turn = inverse * along * normal.damping, spread = inverse * normal.force;
  Pack force[2], slope[2][2];
  for (int i = 0; i < 2; ++i) {
    force[i] = normal.force * n[i];
    for (int j = 0; j < 2; ++j)
      slope[i][j] = spread * t[i] * t[j] - n[i] * (normal.stiffness * n[j] + turn * t[j]);
    sums.elastic[i] += normal.elastic * n[i];
  }
  sums.total += normal.force;
  sums.heaviest = max(sums.heaviest, normal.force);
  double lever = 1;
  for (int m = 0; m < 3; ++m, lever *= slice.position)
    for (int i = 0; i < 2; ++i) {
      if (m < 2) sums.force[m][i] += lever * force[i];
      for (int j = 0; j < 2; ++j) sums.slope[m][i][j] += lever * slope[i][j];
    }
}

/// Adds what the form of the race makes of that slice: F = Q (n - g). Left out of the slopes: what
/// the form does to p'.
inline void add_normal_of_form(const WavyRace& form, const NormalForce<Pack>& normal,
                               const SliceGap& gap, RaceNormals& sums) {
  const Pack n[2] = {gap.n_r, gap.n_t};
  for (int i = 0; i < 2; ++i) {
    sums.force[0][i] -= normal.force * form.g[i];
    sums.elastic[i] -= normal.elastic * form.g[i];
    sums.by_time[i] += normal.stiffness * form.w_t * (n[i] - form.g[i]);
    for (int j = 0; j < 2; ++j)
      sums.slope[0][i][j] +=
          normal.stiffness * (n[i] * form.g[j] + form.g[i] * n[j] - form.g[i] * form.g[j]) -
          normal.force * form.H[i][j];
  }
}

/// The same with an oil film. `share` of the speed of approach damps and squeezes.
inline RaceNormals lubricated_normals(const BearingModel& model, const LubricatedLine& line,
                                      const RollerGroup& roller, const RollerPack& q,
                                      const RaceSide& race, double share) {
  using D = Dual<Pack, 2>;
  RaceNormals sums;
  const LineSpeed<D> speed = line_speed(line, D{entrainment(race, roller, q).speed, {}});
  const WavyRace form = race.form ? wavy_race(q, race) : WavyRace{};
  for (const Slice& slice : model.race_slices) {
    SliceGap gap = slice_gap(roller, q, race, slice);
    if (race.form) gap.p += form.w;
    const auto& [p, n_r, n_t, inverse] = gap;
    Mask wet = roller.exists > 0.0;
    if (line.starved) wet &= -p < line.layer;
    if (!any(wet)) continue;
    Pack rate = -share * (n_r * q.vr + n_t * q.vt), along = share * (n_r * q.vt - n_t * q.vr);
    if (race.form) rate += share * form.rate;
    const Pack inside = select(wet, p, splat(line.starved ? -0.5 * line.layer : -1e-5));
    const D normal =
        line_normal(line, speed, -variable<D>(inside, 0), -variable<D>(rate, 1)).normal;
    const Pack force = select(wet, normal.value, Pack{}),
               stiffness = select(wet, normal.slope[0], Pack{});
    const NormalForce<Pack> on{force, force, stiffness, select(wet, normal.slope[1], Pack{}),
                               stiffness};
    add_normal(slice, on, gap, along, sums);
    if (race.form) add_normal_of_form(form, on, gap, sums);
  }
  return sums;
}

/// `law`: of one slice.
inline RaceNormals race_normals(const BearingModel& model, const NormalLaw& law,
                                const RollerGroup& roller, const RollerPack& q,
                                const RaceSide& race) {
  RaceNormals sums;
  const WavyRace form = race.form ? wavy_race(q, race) : WavyRace{};
  for (const Slice& slice : model.race_slices) {
    SliceGap gap = slice_gap(roller, q, race, slice);
    if (race.form) gap.p += form.w;
    const auto& [p, n_r, n_t, inverse] = gap;
    const Mask touching = (p > 0.0) & (roller.exists > 0.0);
    if (!any(touching)) continue;
    const Pack reached = select(touching, p, splat(-1.0));
    Pack rate = -(n_r * q.vr + n_t * q.vt), along = n_r * q.vt - n_t * q.vr;
    if (race.form) rate += form.rate;
    const NormalForce<Pack> normal = normal_force(law, reached, rate);
    add_normal(slice, normal, gap, along, sums);
    if (race.form) add_normal_of_form(form, normal, gap, sums);
  }
  return sums;
}

}  // namespace cagetol
