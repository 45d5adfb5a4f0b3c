// A roller's spherical roller end against an inclined flange, a cone about the axis of its ring:
// one point. s, c sine and cosine of the flange's angle, z = 1 for the outer ring, -1 for the inner
// one, e the side, k = e (L/2 - R_e) the place of the sphere's centre on the roller's axis.
//
//   l = a - B,   D = (x - x_u, rho - u)                roller against ring: lean, place
//   X = D_x + B . D - k l^2/2,   Y = D_rt - D_x B + k l        the sphere's centre, less k, in the
//                                                      ring's frame: along its axis, and off it
//   p = c (e X - clearance) + z s (|Y| - rest)
//   n = (e c, z s Y/|Y|), leaning with B               from the roller into the flange
//
// p is the depth of the sphere in the cone along n, to the second order of leans: a roller that
// tilts moves the centre of a large sphere. Rollers without lean, `rest` from the bearing's axis,
// touch where flat ends would. The point R_e n from the centre is R_e s from the roller's axis. Its
// velocities are those of rigid bodies, the force map is the transpose:
//
//   v = V + w x R_e n - w_r (1, B) x (D + ...)         w = w_s a + e_x x a'
//   u = half the sum of both surfaces' speeds around the ring, as seen from the point
//
// Dry by Hertz and Coulomb with the damping of contact.flange, K p^1.5 + c_max S(p/d) p'; oiled by
// src/lubrication/point_film.hpp with that damping at the bodies' approach. The face counts as
// unbounded: how far the point goes on it (R_e times the tilt) is not limited.
#pragma once

#include "src/contacts/contact_frame.hpp"
#include "src/numerics/kernel.hpp"

namespace cagetol {

/// Adds forces; with `jac` and `seen` derivatives and what is seen too.
CAGETOL_KERNEL void sphere_flange(const BearingModel& model, const Flange& flange,
                                  const RollerGroup& roller, const RollerPack& q,
                                  const BorderState& b, int group, RollerLoads& loads,
                                  BorderLoads& border, Linearisation* jac, Observation* seen);

}  // namespace cagetol
