// Roller ends against the side ring faces of their pocket. Each end e = +-1 carries two points off
// the axis, at radial h and tangential tau from the centre of the end face, so that the force
// rights a skewed roller and the spin enters the sliding speed. The wall is normal to the cage's
// axis A:
//   p = e (x - x_c + A . D - w_x) + L_w/2 - L_j/2
// with D the point's radial-plane place relative to the cage's geometric centre, x at the point
// less h a_r + tau a_t, w_x how far the wall has bent along e_x. The points do not spin with the
// roller; they keep their place beside the pocket and turn with phi' (so that moving roller and
// cage together changes nothing); p depends on that angle through `turn` = e dp/d(angle) at a
// centre held still.
#pragma once

#include "src/contacts/end_film.hpp"
#include "src/contacts/pocket_touch.hpp"

namespace cagetol {

/// False where no point of an end can touch its wall, were walls `margin` [m] nearer: all lie below
/// what the whole face reaches.
inline bool walls_in_reach(const BearingModel& model, const RollerGroup& roller,
                           const PocketFrame& f, Pack margin) {
  const double half = model.roller_half_length;
  const Pack reach = roller.radius * (abs(f.a_R - f.A_R) + abs(f.a_T - f.A_T)) +
                     half * abs(f.A_R * f.a_R + f.A_T * f.a_T);
  const Pack offset = abs(f.X + f.A_R * f.D_R + f.A_T * f.D_T);
  return any(offset + reach > roller.half_length - half - margin);
}

/// Where one point of an end meets its wall.
struct WallPoint {
  Pack p;
  PocketLevers levers;  ///< normal, along e_R, along e_T
};
inline WallPoint wall_point(const PocketFrame& f, const RollerGroup& roller, double e, double xi,
                            const EndPoint& point) {
  const double h = point.radial, tau = point.tangential;
  const Pack zero{}, one = splat(1.0), place = splat(xi);
  const Pack D_R = f.D_R + xi * f.a_R + h, D_T = f.D_T + xi * f.a_T + tau;
  const Pack X = f.X + xi - h * f.a_R - tau * f.a_T;
  const Pack turn = h * (f.A_T - f.a_T) - tau * (f.A_R - f.a_R);
  const Pack lever_R = D_R - X * f.A_R, lever_T = D_T - X * f.A_T;
  return {e * (X + f.A_R * D_R + f.A_T * D_T) - roller.half_length,
          {{{-e * f.A_R, -e * f.A_T, -e * one, e * (h - xi * f.A_R), e * (tau - xi * f.A_T), zero},
            {one, zero, zero, place, zero, splat(-tau)},
            {zero, one, zero, zero, place, splat(h)}},
           {{-e * turn, -e * D_R, -e * D_T}, {lever_T, -X, zero}, {-lever_R, zero, -X}},
           {2, 0, 1},
           {splat(e), -one, -one},
           false,
           {}}};
}

template <bool linear>
void wall_contacts(const BearingModel& model, const RollerGroup& roller, const RollerPack& q,
                   const PocketFrame& f, const BorderState& b, const ModalState& modal, int group,
                   RollerLoads& loads, BorderLoads& border, ContactRows* rows, Linearisation* jac,
                   Observation* seen) {
  PocketLoads on;
  bool touched = false;
  for (int end = 0; end < 2; ++end) {
    const double e = 2 * end - 1, xi = e * model.roller_half_length;
    for (int side = 0; side < 2; ++side) {
      const auto [p, levers] =
          wall_point(f, roller, e, xi, model.wall_points[static_cast<std::size_t>(side)]);
      const int point = 2 * static_cast<int>(model.bar_stations.size()) + 2 * end + side;
      const Mask here = roller.exists > 0.0;
      const double layer = model.wall_film.layer;
      if (!any((p > -layer - modal.farthest) & here)) continue;
      Touch<Pack> touch;
      touch.p = p;
      if (modal.flexible()) touch.p -= e * modal.along(group, point, 2, modal.q);
      const Mask wet = (touch.p > -layer) & here;
      if (!any(wet)) continue;
      touched = true;
      const auto speed = [&, &levers = levers](int c) {
        return channel_speed(levers, c, f, q, b, modal, group, point);
      };
      touch.rate = -speed(0), touch.v1 = speed(1), touch.v2 = speed(2);
      const EndForces forces =
          end_forces<linear>(model.wall, model.friction[kEndPair], model.wall_film, touch, wet);
      const Pack force[3] = {forces.normal, -forces.drag * touch.v1, -forces.drag * touch.v2};
      add_channel_forces(levers, force, on);
      if (modal.flexible()) push_modes(levers, force, modal, group, point);
      if constexpr (linear) {
        observe_end(forces, model.wall, model.wall_film, touch, kEndFriction,
                    seen->wall_force.data() + group * kLanes, *seen);
        for (int i = 0; i < kLanes; ++i) {
          if (!wet[i]) continue;
          fill_rows<3>(levers, f, b, modal, group, point, i, *rows);
          if (touch.p[i] > 0)
            add_contact(*rows, slopes_of(touch, forces.contact, i), group * kLanes + i, *jac);
          if (model.wall_film.on)
            add_film_contact(*rows, end_film_slopes(forces.film, touch, i), group * kLanes + i,
                             *jac);
        }
      }
    }
  }
  if (touched) add_pocket_loads(f, on, loads, border);
}

}  // namespace cagetol
