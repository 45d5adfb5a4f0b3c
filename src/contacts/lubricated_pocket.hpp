// Roller against the bars of its pocket through oil (src/lubrication/lubricated_line.hpp): the
// kinematics of pocket_contacts.hpp with another law. The bar is at rest in the cage, so over a
// flat face the contact travels with the roller's axis; over an arc of radius r, of which the axis
// stands R + r (edge, lip) or r - R (hollow) from the middle, in proportion:
//
//   v_c = speed of the roller's axis along e_R relative to the cage, times r/(R + r) or r/(r - R)
//   u   = v_1/2 - v_c                        entrainment along e_R, v_1 sliding speed
//   F_1 = -ratio v_1 - F_r on the roller's surface,   F_c = 2 F_r on its axis, both along e_R
//
// and the bar feels the opposite forces along the same lines.
#pragma once

#include "src/contacts/pocket_contacts.hpp"
#include "src/lubrication/lubricated_line.hpp"

namespace cagetol {

/// Slopes of one lane from the law's derivatives by (p, p', u, |v|^2). `f`: forces of a station;
/// `travel`: v_c over the speed of the axis.
template <class Forces>
FilmContactSlopes film_slopes_of(const Forces& f, Pack v1, Pack v2, Pack rate, Pack u,
                                 double travel, int lane) {
  const int i = lane;
  const double s1 = v1[i], s2 = v2[i], ratio = f.ratio.value[i], roll = f.rolling.value[i];
  const double squared = s1 * s1 + s2 * s2, bend = 2 * f.ratio.slope[3][i];
  FilmContactSlopes to;
  using F = FilmContactSlopes;
  enum { kN, k1, k2, kC };
  const auto& N = f.at.normal.slope;
  const auto& G = f.ratio.slope;
  const Dual<Pack, 4> rolling = f.rolling;
  const auto& R = rolling.slope;
  double by_u[ContactRows::kMostChannels], power_u = 0;
  for (int z = 0; z < 3; ++z) {  // p, p', u
    double* by = z < 2 ? to.force[z] : by_u;
    by[kN] = N[z][i];
    by[k1] = -G[z][i] * s1 - R[z][i];
    by[k2] = -G[z][i] * s2;
    by[kC] = travel * (2 * R[z][i]);
    (z < 2 ? to.power[z] : power_u) = -N[z][i] * rate[i] - G[z][i] * squared - 2 * R[z][i] * u[i];
  }
  to.power[F::kRate] -= f.at.normal.value[i];
  power_u -= 2 * roll;
  to.force[F::kV1][k1] = -ratio - bend * s1 * s1;
  to.force[F::kV1][k2] = to.force[F::kV2][k1] = -bend * s1 * s2;
  to.force[F::kV2][k2] = -ratio - bend * s2 * s2;
  to.power[F::kV1] = -(2 * ratio + bend * squared) * s1;
  to.power[F::kV2] = -(2 * ratio + bend * squared) * s2;
  for (int m = 0; m < ContactRows::kMostChannels; ++m) {  // u = v1/2 - v_c
    to.force[F::kV1][m] += 0.5 * by_u[m];
    to.force[F::kAxis][m] -= travel * by_u[m];
  }
  to.power[F::kV1] += 0.5 * power_u;
  to.power[F::kAxis] -= travel * power_u;
  return to;
}

/// Both bars at one station, as a pack of rollers meets them with oil.
struct OiledStation {
  int points[2];  ///< contact points of the cage at the bar ahead and at the one behind
  FaceMeeting bar[2];
  Mask oiled[2];
  bool near = false;  ///< a lane has oil at a bar
};
template <class Face>
OiledStation oiled_station(const BearingModel& model, const Face& face, const AxisPlace& at,
                           const ModalState& modal, int group, int k) {
  const double layer = face.line.layer;
  OiledStation station{{static_cast<int>(model.bar_stations.size()) + k, k}, {}, {}, false};
  station.bar[0] = face.meet(at, 1.0);
  station.bar[1] = face.meet(at, -1.0);
  const auto in_reach = [&](const FaceMeeting& bar) {
    return (bar.p > -Face::kMargin * modal.farthest - layer) & bar.here;
  };
  if (!any(in_reach(station.bar[0]) | in_reach(station.bar[1]))) return station;
  for (int side = 0; side < 2; ++side) {
    if (modal.flexible())
      face.bend(station.bar[side], at, side == 0 ? 1.0 : -1.0, modal, group, station.points[side]);
    station.oiled[side] = (station.bar[side].p > -layer) & station.bar[side].here;
  }
  station.near = any(station.oiled[0] | station.oiled[1]);
  return station;
}

/// The bar that each lane takes: rollers hardly ever have oil at both bars, so that one evaluation
/// serves all; else each bar is taken alone.
struct ChosenBar {
  bool apart;  ///< one bar, `side`, for all lanes
  int side;
  Mask wet, lead;  ///< lanes with oil; lanes that take the bar ahead
};
inline ChosenBar choose_bar(const OiledStation& station, bool apart, int side) {
  if (apart) return {true, side, station.oiled[side], side == 0 ? Mask{} == 0 : Mask{} != 0};
  return {false, 0, station.oiled[0] | station.oiled[1], ~station.oiled[1]};
}

/// Forces of the oil at the chosen bars, with derivatives by (p, p', u, |v|^2) or without.
template <bool linear>
auto oil_forces(const LubricatedLine& law, Mask wet, Pack p, Pack rate, Pack u, Pack squared) {
  // Lanes without oil take part with an open gap, whose forces are set to nothing.
  const Pack place = select(wet, p, splat(-0.5 * law.layer)), one = select(wet, splat(1.0), Pack{});
  const auto forces = [&](auto depth, auto rising, auto along, auto of_sliding) {
    auto f = line_forces(law, line_speed(law, along), -depth, -rising, of_sliding);
    f.at.normal = f.at.normal * one;
    f.at.film = f.at.film * one;
    f.at.steady = f.at.steady * one;
    f.ratio = f.ratio * one;
    f.rolling = f.rolling * one;
    return f;
  };
  if constexpr (linear)
    return forces(variable<0, 4>(place), variable<1, 4>(rate), variable<2, 4>(u),
                  variable<3, 4>(squared));
  else
    return forces(place, rate, u, squared);
}

template <bool linear, class Face>
void lubricated_pocket(const BearingModel& model, const Face& face, const RollerPack& q,
                       const BorderState& b, const ModalState& modal, int group, RollerLoads& loads,
                       BorderLoads& border, ContactRows* rows, Linearisation* jac,
                       Observation* seen) {
  const PocketFrame& f = face.f;
  const int stations = static_cast<int>(model.bar_stations.size());
  PocketLoads on;
  bool touched = false;
  for (int k = 0; k < stations; ++k) {
    const AxisPlace at = axis_place(f, model.bar_stations[static_cast<std::size_t>(k)]);
    const OiledStation station = oiled_station(model, face, at, modal, group, k);
    if (!station.near) continue;
    touched = true;
    const bool apart = any(station.oiled[0] & station.oiled[1]);
    for (int side = 0; side < (apart ? 2 : 1); ++side) {
      const ChosenBar bar = choose_bar(station, apart, side);
      if (!any(bar.wet)) continue;
      const Pack s = select(bar.lead, splat(1.0), splat(-1.0));
      const FaceMeeting meeting = face.choose(bar.lead, station.bar[0], station.bar[1]);
      const PocketLevers levers = face.levers(at, s, meeting);
      const auto bent = [&](int c) {
        const auto moved = [&](int which) {
          return bent_speed(levers, c, modal, group, station.points[which]);
        };
        if (!modal.flexible()) return Pack{};
        return apart ? moved(side) : select(bar.lead, moved(0), moved(1));
      };
      const Pack along = bent(1);  // of the surface as of the axis: what bends is the cage
      const auto speed = [&](int c, Pack moved) { return rigid_speed(levers, c, f, q, b) + moved; };
      const Pack rate = -speed(0, bent(0)), v1 = speed(1, along), v2 = speed(2, bent(2)),
                 u = 0.5 * v1 - face.travel * speed(3, along);
      const Pack squared = v1 * v1 + v2 * v2;
      const auto forces = oil_forces<linear>(face.line, bar.wet, meeting.p, rate, u, squared);
      const Pack normal = value_of(forces.at.normal), ratio = value_of(forces.ratio),
                 roll = value_of(forces.rolling);
      const Pack force[4] = {normal, -ratio * v1 - roll, -ratio * v2, face.travel * (2.0 * roll)};
      add_channel_forces(levers, force, on);
      if (modal.flexible())
        for (int which = 0; which < 2; ++which) {
          if (apart && which != side) continue;
          const Pack mine = select(which == 0 ? bar.lead : ~bar.lead, splat(1.0), Pack{});
          const Pack own[4] = {force[0] * mine, force[1] * mine, force[2] * mine, force[3] * mine};
          push_modes(levers, own, modal, group, station.points[which]);
        }
      if constexpr (linear) {
        const Pack film = value_of(forces.at.film), steady = value_of(forces.at.steady);
        seen->rub(kPocketFriction, sum(ratio * squared + 2.0 * roll * u));
        seen->damp(kSqueeze, sum((film - steady) * rate));
        seen->damp(kDamping, sum((normal - film) * rate));
        seen->damp(kFilm, sum(steady * rate));
        observe_bar<4>(levers, q, f, b, modal, group, stations, station.points, normal, bar.wet,
                       bar.lead, *rows, *seen, [&](int i) {
                         add_film_contact(*rows,
                                          film_slopes_of(forces, v1, v2, rate, u, face.travel, i),
                                          group * kLanes + i, *jac);
                         if constexpr (Face::kTurns)
                           add_turning_normal(normal, meeting, i, group * kLanes + i, *rows, *jac);
                       });
      }
    }
  }
  if (touched) add_pocket_loads(f, on, loads, border);
}

}  // namespace cagetol
