// Contacts of a pack of rollers with their pockets, each described by its levers: how each channel
// of the contact (separation -p', sliding v1 and v2, with oil also the speed of the roller's axis)
// follows from the velocities of roller and cage. Everything else comes of the levers: speeds are
// levers times velocities, forces on the bodies are their transposes times the channels' forces,
// and derivatives are levers times slopes times levers.
//
// Directions are the pocket's: e_R, e_T, e_x, the lean (a_R, a_T) of the roller's axis and its
// spin; of the cage spin phi and lean (A_R, A_T). Over the cage's place a lever is the opposite of
// the roller's, and left out.
#pragma once

#include "src/contacts/pocket_frame.hpp"

namespace cagetol {

struct PocketLevers {
  static constexpr int kChannels = ContactRows::kMostChannels;
  Pack roller[kChannels][kLocalVelocities];  ///< over (R, T, x, a_R, a_T, spin)
  Pack cage[kChannels][3];                   ///< over (phi, A_R, A_T)
  int elastic[kChannels];   ///< direction (0 R, 1 T, 2 x) in which the cage's point counts, ...
  Pack sign[kChannels];     ///< ... and how
  bool inclined = false;    ///< it counts along R and T, with ...
  Pack along_T[kChannels];  ///< ... this along T; `elastic` is R then, but for the axial channel
};

/// A place on the roller's axis relative to the cage's geometric centre.
struct AxisPlace {
  double xi;  ///< along the roller [m]
  Pack X, D_R, D_T;
};
inline AxisPlace axis_place(const PocketFrame& f, double xi) {
  return {xi, f.X + xi, f.D_R + xi * f.a_R, f.D_T + xi * f.a_T};
}

/// Speed of channel c between rigid bodies.
inline Pack rigid_speed(const PocketLevers& levers, int c, const PocketFrame& f,
                        const RollerPack& q, const BorderState& b) {
  const Pack* g = levers.roller[c];
  const Pack* k = levers.cage[c];
  return g[0] * f.v_R + g[1] * f.v_T + g[2] * f.v_x + g[3] * f.b_R + g[4] * f.b_T + g[5] * q.spin +
         k[0] * b.phi_rate + k[1] * f.dA_R + k[2] * f.dA_T;
}

/// What the motion of the bent cage at contact point `point` adds.
inline Pack bent_speed(const PocketLevers& levers, int c, const ModalState& modal, int group,
                       int point) {
  Pack speed = levers.sign[c] * modal.along(group, point, levers.elastic[c], modal.rate);
  if (levers.inclined && levers.elastic[c] == 0)
    speed += levers.along_T[c] * modal.along(group, point, 1, modal.rate);
  return speed;
}

/// Of rigid bodies and the bent cage.
inline Pack channel_speed(const PocketLevers& levers, int c, const PocketFrame& f,
                          const RollerPack& q, const BorderState& b, const ModalState& modal,
                          int group, int point) {
  const Pack speed = rigid_speed(levers, c, f, q, b);
  if (!modal.flexible()) return speed;
  return speed + bent_speed(levers, c, modal, group, point);
}

/// Adds the channels' forces [N] on roller and cage.
template <int channels>
void add_channel_forces(const PocketLevers& levers, const Pack (&force)[channels],
                        PocketLoads& on) {
  Pack* const roller[] = {&on.f_R, &on.f_T, &on.f_x, &on.t_R, &on.t_T, &on.t_s};
  Pack* const cage[] = {&on.c_phi, &on.c_AR, &on.c_AT};
  for (int c = 0; c < channels; ++c) {
    for (int i = 0; i < kLocalVelocities; ++i) *roller[i] += force[c] * levers.roller[c][i];
    for (int i = 0; i < 3; ++i) *cage[i] += force[c] * levers.cage[c][i];
  }
}

/// And on the elastic modes, at contact point `point`.
template <int channels>
void push_modes(const PocketLevers& levers, const Pack (&force)[channels], const ModalState& modal,
                int group, int point) {
  Pack along[3] = {};
  for (int c = 0; c < channels; ++c) {
    along[levers.elastic[c]] += levers.sign[c] * force[c];
    if (levers.inclined && levers.elastic[c] == 0) along[1] += levers.along_T[c] * force[c];
  }
  modal.push(group, point, along[0], along[1], along[2]);
}

/// Rows of one lane's contact over the directions of roller, cage and modes.
template <int channels>
void fill_rows(const PocketLevers& levers, const PocketFrame& f, const BorderState& b,
               const ModalState& modal, int group, int point, int lane, ContactRows& rows) {
  const double cb = f.cos_b[lane], sb = f.sin_b[lane], cp = f.cos_p[lane], sp = f.sin_p[lane];
  for (int c = 0; c < channels; ++c) {
    const auto g = [&](int i) { return levers.roller[c][i][lane]; };
    const auto k = [&](int i) { return levers.cage[c][i][lane]; };
    double* to = rows.roller[c];
    to[kLr] = cb * g(0) + sb * g(1);
    to[kLt] = cb * g(1) - sb * g(0);
    to[kLx] = g(2);
    to[kLar] = cb * g(3) + sb * g(4);
    to[kLat] = cb * g(4) - sb * g(3);
    to[kLs] = g(5);
    const double at_centre[kCageRigid] = {
        sp * g(1) - cp * g(0), -sp * g(0) - cp * g(1), -g(2), k(0),
        cp * k(1) - sp * k(2), sp * k(1) + cp * k(2)};
    fill_cage_row(at_centre, b, rows.border[c]);
    const double sign = levers.sign[c][lane];
    const Pack* moved =
        modal.flexible() ? modal.cage->row(group, point, levers.elastic[c]) : nullptr;
    for (int m = 0; m < modal.cage->modes; ++m)
      rows.border[c][static_cast<std::size_t>(kModes + m)] = sign * moved[m][lane];
    if (!levers.inclined || !modal.flexible() || levers.elastic[c] != 0) continue;
    const Pack* across = modal.cage->row(group, point, 1);
    for (int m = 0; m < modal.cage->modes; ++m)
      rows.border[c][static_cast<std::size_t>(kModes + m)] +=
          levers.along_T[c][lane] * across[m][lane];
  }
}

/// Levers of a bar at `at`. `s`: +1 for the bar ahead of the roller, -1 for the one behind; `kappa`
/// slope of its face; `R` of the roller. Channels: normal, along e_R, along e_x, axis along e_R.
inline PocketLevers bar_levers(const PocketFrame& f, const AxisPlace& at, Pack kappa, Pack s,
                               Pack R) {
  const Pack zero{}, one = splat(1.0), xi = splat(at.xi), arm = s * R, reach = at.D_T + arm;
  return {{{zero, -s, s * kappa, zero, -s * xi, zero},
           {one, zero, zero, xi, zero, -arm},
           {zero, zero, one, zero, -arm, arm * f.a_R},
           {one, zero, zero, xi, zero, zero}},
          {{s * (at.D_R - at.X * f.A_R), zero, s * at.X},
           {reach - f.A_T * at.X, -at.X, zero},
           {f.A_T * at.D_R - f.A_R * reach, at.D_R, reach},
           {at.D_T - f.A_T * at.X, -at.X, zero}},
          {1, 0, 2, 0},
          {s, -one, -one, -one},
          false,
          {}};
}

/// Levers of an arc at `at`. (m_R, m_T): direction of the force on the roller. Channels as of a
/// bar, with the direction t = (-m_T, m_R) along the face in place of e_R.
inline PocketLevers arc_levers(const PocketFrame& f, const AxisPlace& at, Pack kappa, Pack m_R,
                               Pack m_T, Pack R) {
  const Pack zero{}, one = splat(1.0), xi = splat(at.xi), t_R = -m_T, t_T = m_R;
  const Pack axis_R = at.D_R - f.A_R * at.X, axis_T = at.D_T - f.A_T * at.X;
  const Pack arm_R = -R * m_R, arm_T = -R * m_T;  // of the contact from the roller's axis
  const Pack place_R = at.D_R + arm_R, place_T = at.D_T + arm_T;
  const Pack around = axis_T * t_R - axis_R * t_T;
  PocketLevers levers{{{m_R, m_T, -(f.A_R * m_R + kappa * m_T), xi * m_R, xi * m_T, zero},
                       {t_R, t_T, zero, xi * t_R, xi * t_T, -R},
                       {zero, zero, one, -arm_R, -arm_T, arm_T * f.a_R - arm_R * f.a_T},
                       {t_R, t_T, zero, xi * t_R, xi * t_T, zero}},
                      {{m_R * axis_T - m_T * axis_R, -at.X * m_R, -at.X * m_T},
                       {around + arm_T * t_R - arm_R * t_T, -at.X * t_R, -at.X * t_T},
                       {f.A_T * place_R - f.A_R * place_T, place_R, place_T},
                       {around, -at.X * t_R, -at.X * t_T}},
                      {0, 0, 2, 0},
                      {-m_R, -t_R, -one, -t_R},
                      true,
                      {-m_T, -t_T, zero, -t_T}};
  return levers;
}

/// How the second sliding speed of a bar follows the lean of the roller's axis, one lane's: as the
/// surface's direction of motion turns with it.
inline void set_bar_lean(const PocketFrame& f, const RollerPack& q, const PocketLevers& levers,
                         int lane, ContactRows& rows) {
  // The contact's place on the roller, times its spin.
  const double along_R = -levers.roller[2][3][lane] * q.spin[lane],
               along_T = -levers.roller[2][4][lane] * q.spin[lane];
  rows.lean[kLar] = along_T * f.cos_b[lane] - along_R * f.sin_b[lane];
  rows.lean[kLat] = -along_T * f.sin_b[lane] - along_R * f.cos_b[lane];
}
inline void clear_bar_lean(ContactRows& rows) {
  rows.lean[kLar] = rows.lean[kLat] = 0;
}

}  // namespace cagetol
