// What the contact kernels share: the state unpacked into frames, and where their forces go.
#pragma once

#include "src/model/bearing_model.hpp"
#include "src/model/flexible_cage.hpp"
#include "src/model/observation.hpp"
#include "src/newton/linearisation.hpp"

namespace cagetol {

/// A pack of rollers in their own directions e_r, e_t (at the roller's angle) and e_x.
struct RollerPack {
  Pack r, cosine, sine, x;
  Pack a_r, a_t;           ///< lean of the axis: tilt and skew [rad]
  Pack vr, vt, vx, omega;  ///< centre: r', r theta', x', theta'
  Pack b_r, b_t;           ///< rate of the axis, projected [rad/s]
  Pack spin;               ///< w_s [rad/s]
};

/// Inner ring and cage. The cage is described at its geometric centre; `unbalance` points from
/// there to its mass centre.
struct BorderState {
  double ring[2], ring_rate[2];
  double ring_axial, ring_axial_rate;
  double tilt[2], tilt_rate[2];  ///< slopes B_y, B_z of the inner ring's centre line
  double cage[3], cage_rate[3];  ///< y, z, x
  double phi, phi_rate, phi_cos, phi_sin;
  double axis[2], axis_rate[2];  ///< A_y, A_z
  double unbalance[2];           ///< inertial directions [m]
  RingSpeeds speed;
  RingSpeeds speeding_up;  ///< its rate [rad/s^2]
  RingAngles turned;       ///< where raceways have waves
};

/// Generalised forces on the border: inner ring, and the moment on it conjugate to (B_y, B_z); cage
/// at its geometric centre, conjugate to (y, z, x, phi, A_y, A_z).
struct BorderLoads {
  double ring[2] = {0, 0}, tilt[2] = {0, 0}, ring_axial = 0;
  double cage[kCageRigid] = {0, 0, 0, 0, 0, 0};
};

/// Generalised forces on a pack of rollers, conjugate to the local velocities (enum Local).
struct RollerLoads {
  Pack f[kLocalVelocities] = {};
};

/// A unit direction rotated by the pack's roller angle: inertial (y, z) to local (r, t).
inline Pack along_r(const RollerPack& p, Pack y, Pack z) {
  return p.cosine * y + p.sine * z;
}
inline Pack along_t(const RollerPack& p, Pack y, Pack z) {
  return p.cosine * z - p.sine * y;
}

/// Border row of a cage contact from its row at the geometric centre (y, z, x, phi, A_y, A_z): the
/// spin entry is moved to the mass centre, which is what the state describes.
inline void fill_cage_row(const double at_centre[kCageRigid], const BorderState& b,
                          std::vector<double>& row) {
  for (int i = 0; i < kCageRigid; ++i) row[static_cast<std::size_t>(kCageY + i)] = at_centre[i];
  // V_C = V_G - phi' e_x x e with e = G - C and e_x x e = (-e_z, e_y).
  row[kCagePhi] += at_centre[0] * b.unbalance[1] - at_centre[1] * b.unbalance[0];
}

}  // namespace cagetol
