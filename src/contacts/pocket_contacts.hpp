// Roller against the two bars of its pocket, in the pocket's directions e_R, e_T (at the pocket
// centre's angle) and e_x, at stations xi along the roller. D and X are the radial-plane and axial
// place of the roller's axis relative to the cage's geometric centre, kappa = A_T + dgamma the lean
// of the bar faces. Which piece of a bar's outline meets the roller, how deep and in which
// direction: pocket_face.hpp. On a flat face, with w_T how far the bar has bent along e_T,
//   u = D_T - kappa X - w_T
//   p = s u + R - S_j/2,   s = +1 at the leading bar (ahead in +T), -1 at the trailing bar
// Friction acts along the face (the roller's spin rubs) and along e_x.
#pragma once

#include "src/contacts/pocket_face.hpp"
#include "src/contacts/touch.hpp"

namespace cagetol {

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
/// roller along the normal.
template <int channels, class AddLane>
void observe_bar(const PocketLevers& levers, const RollerPack& q, const PocketFrame& f,
                 const BorderState& b, const ModalState& modal, int group, int stations,
                 const int (&points)[2], Pack force, Mask wet, Mask lead, ContactRows& rows,
                 Observation& seen, const AddLane& add_lane) {
  const auto add = [&](PackVector& sums, Mask mine) {
    double* const at = sums.data() + group * kLanes;
    store(at, load(at) + select(mine, force, Pack{}));
  };
  add(seen.leading_force, lead);
  add(seen.trailing_force, ~lead);
  for (int i = 0; i < kLanes; ++i) {
    if (!wet[i]) continue;
    const int point = points[lead[i] ? 0 : 1];
    if (modal.cage->model)
      seen.bar_force[2 * stations * (group * kLanes + i) + point] -=
          levers.roller[0][1][i] * force[i];
    fill_rows<channels>(levers, f, b, modal, group, point, i, rows);
    set_bar_lean(f, q, levers, i, rows);
    add_lane(i);
    clear_bar_lean(rows);
  }
}

/// The normal of an arc turns as the roller's axis goes along it: so does the force.
inline void add_turning_normal(Pack force, const FaceMeeting& meeting, int lane, int roller,
                               ContactRows& rows, Linearisation& jac) {
  // Channel 3 is the axis along the face: a force opposite to -stiffness times that way.
  std::swap(rows.roller[0], rows.roller[3]);
  std::swap(rows.border[0], rows.border[3]);
  ContactSlopes turning{};
  turning.stiffness = -force[lane] * meeting.curvature[lane];
  add_contact(rows, turning, roller, jac);
  std::swap(rows.roller[0], rows.roller[3]);
  std::swap(rows.border[0], rows.border[3]);
}

template <bool linear, class Face>
void pocket_contacts(const BearingModel& model, const Face& face, const RollerPack& q,
                     const BorderState& b, const ModalState& modal, int group, RollerLoads& loads,
                     BorderLoads& border, ContactRows* rows, Linearisation* jac,
                     Observation* seen) {
  const PocketFrame& f = face.f;
  const int stations = static_cast<int>(model.bar_stations.size());
  PocketLoads on;
  bool touched = false;
  for (int k = 0; k < stations; ++k) {
    const AxisPlace at = axis_place(f, model.bar_stations[static_cast<std::size_t>(k)]);
    const int points[2] = {stations + k, k};
    for (int side = 0; side < 2; ++side) {
      const double s = side == 0 ? 1.0 : -1.0;
      const int point = points[side];
      FaceMeeting meeting = face.meet(at, s);
      if (!any((meeting.p > -Face::kMargin * modal.farthest) & meeting.here)) continue;
      if (modal.flexible()) face.bend(meeting, at, s, modal, group, point);
      Touch<Pack> touch;
      touch.p = meeting.p;
      const Mask touching = (touch.p > 0.0) & meeting.here;
      if (!any(touching)) continue;
      touched = true;
      const PocketLevers levers = face.levers(at, splat(s), meeting);
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
        observe_bar<Face::kTurns ? 4 : 3>(
            levers, q, f, b, modal, group, stations, points, contact.normal.force, touching, lead,
            *rows, *seen, [&](int i) {
              add_contact(*rows, slopes_of(touch, contact, i), group * kLanes + i, *jac);
              if constexpr (Face::kTurns)
                add_turning_normal(contact.normal.force, meeting, i, group * kLanes + i, *rows,
                                   *jac);
            });
      }
    }
  }
  if (touched) add_pocket_loads(f, on, loads, border);
}

}  // namespace cagetol
