// A pack of rollers seen from their pockets: everything in the pocket's directions e_R, e_T (at the
// angle of the pocket's centre) and e_x, relative to the cage's geometric centre.
#pragma once

#include "src/contacts/contact_frame.hpp"

namespace cagetol {

struct PocketFrame {
  Pack cos_p, sin_p;          ///< of the pocket's angle
  Pack cos_b, sin_b;          ///< from the roller's directions to the pocket's
  Pack D_R, D_T, X;           ///< place of the roller's centre
  Pack v_R, v_T, v_x;         ///< its velocity less that of the cage's geometric centre
  Pack a_R, a_T, b_R, b_T;    ///< lean of the roller's axis and its rate
  Pack A_R, A_T, dA_R, dA_T;  ///< lean of the cage's axis and its rate
};

/// Places and directions; the rates are left for add_rates.
inline PocketFrame pocket_places(const RollerGroup& roller, const RollerPack& q,
                                 const BorderState& b) {
  PocketFrame f;
  f.cos_p = b.phi_cos * roller.pocket_cos - b.phi_sin * roller.pocket_sin;
  f.sin_p = b.phi_sin * roller.pocket_cos + b.phi_cos * roller.pocket_sin;
  f.cos_b = q.cosine * f.cos_p + q.sine * f.sin_p;
  f.sin_b = q.sine * f.cos_p - q.cosine * f.sin_p;
  const auto along_R = [&](const auto& y, const auto& z) { return f.cos_p * y + f.sin_p * z; };
  const auto along_T = [&](const auto& y, const auto& z) { return f.cos_p * z - f.sin_p * y; };
  const Pack D_y = q.r * q.cosine - b.cage[0], D_z = q.r * q.sine - b.cage[1];
  f.D_R = along_R(D_y, D_z);
  f.D_T = along_T(D_y, D_z);
  f.X = q.x - b.cage[2];
  f.a_R = f.cos_b * q.a_r - f.sin_b * q.a_t;
  f.a_T = f.sin_b * q.a_r + f.cos_b * q.a_t;
  f.A_R = along_R(b.axis[0], b.axis[1]);
  f.A_T = along_T(b.axis[0], b.axis[1]);
  return f;
}

inline void add_rates(const RollerPack& q, const BorderState& b, PocketFrame& f) {
  const auto along_R = [&](double y, double z) { return f.cos_p * y + f.sin_p * z; };
  const auto along_T = [&](double y, double z) { return f.cos_p * z - f.sin_p * y; };
  f.v_R = f.cos_b * q.vr - f.sin_b * q.vt - along_R(b.cage_rate[0], b.cage_rate[1]);
  f.v_T = f.sin_b * q.vr + f.cos_b * q.vt - along_T(b.cage_rate[0], b.cage_rate[1]);
  f.v_x = q.vx - b.cage_rate[2];
  f.b_R = f.cos_b * q.b_r - f.sin_b * q.b_t;
  f.b_T = f.sin_b * q.b_r + f.cos_b * q.b_t;
  f.dA_R = along_R(b.axis_rate[0], b.axis_rate[1]);
  f.dA_T = along_T(b.axis_rate[0], b.axis_rate[1]);
}

/// Forces and moments of a pocket's contacts in the pocket's directions: on the roller, and on the
/// cage about its geometric centre, where the opposite of the roller's force acts.
struct PocketLoads {
  Pack f_R{}, f_T{}, f_x{}, t_R{}, t_T{}, t_s{};  ///< on the roller
  Pack c_phi{}, c_AR{}, c_AT{};                   ///< on the cage
};

inline void add_pocket_loads(const PocketFrame& f, const PocketLoads& from, RollerLoads& loads,
                             BorderLoads& border) {
  loads.f[kLr] += f.cos_b * from.f_R + f.sin_b * from.f_T;
  loads.f[kLt] += f.cos_b * from.f_T - f.sin_b * from.f_R;
  loads.f[kLx] += from.f_x;
  loads.f[kLar] += f.cos_b * from.t_R + f.sin_b * from.t_T;
  loads.f[kLat] += f.cos_b * from.t_T - f.sin_b * from.t_R;
  loads.f[kLs] += from.t_s;
  border.cage[0] -= sum(f.cos_p * from.f_R - f.sin_p * from.f_T);
  border.cage[1] -= sum(f.sin_p * from.f_R + f.cos_p * from.f_T);
  border.cage[2] -= sum(from.f_x);
  border.cage[3] += sum(from.c_phi);
  border.cage[4] += sum(f.cos_p * from.c_AR - f.sin_p * from.c_AT);
  border.cage[5] += sum(f.sin_p * from.c_AR + f.cos_p * from.c_AT);
}

}  // namespace cagetol
