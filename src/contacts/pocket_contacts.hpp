// Roller against the two bars of its pocket, in the pocket's directions e_R, e_T (at the pocket
// centre's angle) and e_x, at stations xi along the roller. D and X are the radial-plane and axial
// place of the roller's axis relative to the cage's geometric centre, kappa = A_T + dgamma the lean
// of the bar faces, w_T how far the bar has bent along e_T:
//   u = D_T - kappa X - w_T
//   p = s u + R - S_j/2,   s = +1 at the leading bar (ahead in +T), -1 at the trailing bar
// Friction acts along e_R (the roller's spin rubs) and along e_x.
#pragma once

#include "src/contacts/pocket_touch.hpp"
#include "src/contacts/touch.hpp"

namespace cagetol {

/// Distance of the farthest station from the roller's middle [m].
inline double farthest_station(const BearingModel& model) {
  return std::max(-model.bar_stations.front(), model.bar_stations.back());
}

/// False where no station of a bar can touch, were bars `margin` [m] nearer: along the roller u
/// goes in proportion to the place.
inline bool bars_in_reach(const BearingModel& model, const RollerGroup& roller,
                          const PocketFrame& f, Pack margin) {
  const double farthest = farthest_station(model);
  const Pack kappa = f.A_T + roller.squareness;
  const Pack u = abs(f.D_T - kappa * f.X) + farthest * abs(f.a_T - kappa);
  return any((u + roller.radius - roller.half_width > -margin) & (roller.exists > 0.0));
}

/// One touch of a bar: what it adds to observation and derivatives. `force`: of the bar on the
/// roller along -s e_T.
template <int channels, class AddLane>
void observe_bar(const PocketLevers& levers, const RollerPack& q, const PocketFrame& f,
                 const BorderState& b, const ModalState& modal, const RollerGroup& roller,
                 int group, int stations, const int (&points)[2], Pack force, Mask wet, Mask lead,
                 ContactRows& rows, Observation& seen, const AddLane& add_lane) {
  const auto add = [&](PackVector& sums, Mask mine) {
    double* const at = sums.data() + group * kLanes;
    store(at, load(at) + select(mine, force, Pack{}));
  };
  add(seen.leading_force, lead);
  add(seen.trailing_force, ~lead);
  for (int i = 0; i < kLanes; ++i) {
    if (!wet[i]) continue;
    const double s = levers.sign[0][i];
    const int point = points[s > 0 ? 0 : 1];
    if (modal.cage->model)
      seen.bar_force[2 * stations * (group * kLanes + i) + point] = s * force[i];
    fill_rows<channels>(levers, f, b, modal, group, point, i, rows);
    set_bar_lean(f, q, levers.sign[0], roller.radius, i, rows);
    add_lane(i);
    clear_bar_lean(rows);
  }
}

template <bool linear>
void pocket_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                     const PocketFrame& f, const BorderState& b, const ModalState& modal, int group,
                     RollerLoads& loads, BorderLoads& border, ContactRows* rows, Linearisation* jac,
                     Observation* seen) {
  const Pack kappa = f.A_T + roller.squareness, least = roller.radius - roller.half_width;
  const int stations = static_cast<int>(model.bar_stations.size());
  PocketLoads on;
  bool touched = false;
  for (int k = 0; k < stations; ++k) {
    const AxisPlace at = axis_place(f, model.bar_stations[static_cast<std::size_t>(k)]);
    const int points[2] = {stations + k, k};
    for (int side = 0; side < 2; ++side) {
      const double s = side == 0 ? 1.0 : -1.0;
      const int point = points[side];
      Touch<Pack> touch;
      touch.p = s * (at.D_T - kappa * at.X) + least;
      if (!any((touch.p > -modal.farthest) & (roller.exists > 0.0))) continue;
      if (modal.flexible()) touch.p -= s * modal.along(group, point, 1, modal.q);
      const Mask touching = (touch.p > 0.0) & (roller.exists > 0.0);
      if (!any(touching)) continue;
      touched = true;
      const PocketLevers levers = bar_levers(f, at, kappa, splat(s), roller.radius);
      const auto speed = [&](int c) {
        return channel_speed(levers, c, f, q, b, modal, group, point);
      };
      touch.rate = -speed(0), touch.v1 = speed(1), touch.v2 = speed(2);
      const Answer<Pack> contact = answer_to(touch, touching, model.bar, model.friction[kBarPair]);
      const Pack force[3] = {contact.normal.force, -contact.drag * touch.v1,
                             -contact.drag * touch.v2};
      add_channel_forces(levers, force, on);
      if (modal.flexible()) push_modes(levers, force, modal, group, point);
      if constexpr (linear) {
        account(touch, contact, model.bar, kPocketFriction, *seen);
        const Mask lead = side == 0 ? Mask{} == 0 : Mask{} != 0;
        observe_bar<3>(levers, q, f, b, modal, roller, group, stations, points,
                       contact.normal.force, touching, lead, *rows, *seen, [&](int i) {
                         add_contact(*rows, slopes_of(touch, contact, i), group * kLanes + i, *jac);
                       });
      }
    }
  }
  if (touched) add_pocket_loads(f, on, loads, border);
}

}  // namespace cagetol
