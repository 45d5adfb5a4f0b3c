// Cage lands against the guiding ring, one at each side ring of the cage (x = +-land_offset). delta
// is the land's offset from the guiding ring's axis, n = delta/|delta|, p = |delta| - clearance
// (less the height at which roughness ends a guide film, where there is one: guide_film.hpp);
// the force on the cage is -Q n. Sliding: v1 along t = e_x x n, v2 along e_x, of the cage's surface
// at land_radius n relative to the ring's. Inner guidance rubs on the inner ring, which answers.
// A flexible cage's guiding surface bends: its displacement, interpolated around between the
// corners of FlexibleCage, adds to p and to the sliding speeds; the surface's slope turns the
// normal a little.
#pragma once

#include <numbers>

#include "src/dynamics/guide_film.hpp"

namespace cagetol {

/// The bent guiding surface at an angle in the cage: displacement and speed along e_r, e_t, e_x,
/// their rows, and how the radial displacement changes with the angle [m/rad].
struct BentLand {
  double moved = 0, slope = 0, rate[3] = {0, 0, 0};
  double row[3][kMostModes];
};
inline void bend_land(const ModalState& modal, int land, double angle, BentLand& bent) {
  const FlexibleCage& cage = *modal.cage;
  const double per_radian = cage.corners / (2 * std::numbers::pi);
  const double place = angle * per_radian, below = __builtin_floor(place), share = place - below;
  const int from = ((static_cast<int>(below) % cage.corners) + cage.corners) % cage.corners;
  const int to = (from + 1) % cage.corners;
  with_packs(packs_for(cage.modes), [&]<int packs>() {
    Pack q[packs], rate[packs];
    load_padded(modal.q, cage.modes, q);
    load_padded(modal.rate, cage.modes, rate);
    for (int d = 0; d < 3; ++d) {
      Pack first[packs], change[packs], moved{}, slope{}, speed{};
      load_padded(cage.land_row(land, from, d), cage.modes, first);
      load_padded(cage.land_row(land, to, d), cage.modes, change);
      for (int p = 0; p < packs; ++p) {
        change[p] -= first[p];
        const Pack row = first[p] + share * change[p];
        store_first(bent.row[d] + p * kLanes, row, cage.modes - p * kLanes);
        speed += row * rate[p];
        if (d > 0) continue;
        moved += row * q[p];
        slope += change[p] * q[p];
      }
      bent.rate[d] = sum(speed);
      if (d > 0) continue;
      bent.moved = sum(moved);
      bent.slope = per_radian * sum(slope);
    }
  });
}

template <bool linear>
void land_contacts(const BearingModel& model, const BorderState& b, const ModalState& modal,
                   BorderLoads& border, double* modal_force, ContactRows* rows, Linearisation* jac,
                   Observation* seen) {
  if (model.guidance == Guidance::roller) return;
  const bool inner = model.guidance == Guidance::inner;
  // The cage's outside surface meets the outer ring where delta points; its bore meets the inner
  // ring on the opposite side.
  const double side = inner ? -1.0 : 1.0, R = side * model.land_radius;
  for (int land = 0; land < 2; ++land) {
    const double X = land == 0 ? -model.land_offset : model.land_offset;
    double y = b.cage[0] + X * b.axis[0], z = b.cage[1] + X * b.axis[1];
    double vy = b.cage_rate[0] + X * b.axis_rate[0], vz = b.cage_rate[1] + X * b.axis_rate[1];
    if (inner) {
      y -= b.ring[0] + model.misalignment_y * X;
      z -= b.ring[1] + model.misalignment_z * X;
      vy -= b.ring_rate[0];
      vz -= b.ring_rate[1];
    }
    const double squared = y * y + z * z;
    // Most lands are apart: a root and a division less.
    const double reach = model.land_clearance - modal.farthest;
    if (!model.guide_film.on && reach > 0 && squared < reach * reach) continue;
    const double distance = __builtin_sqrt(squared);
    double p = distance - model.land_clearance;
    const double inverse = distance > 0 ? 1 / distance : 0;
    const double ny = y * inverse, nz = z * inverse;
    const double along = ny * vz - nz * vy;
    double rate = ny * vy + nz * vz;
    double oil[2] = {0, 0};
    if (model.guide_film.on) {
      const double delta[2] = {y, z}, moving[2] = {vy, vz};
      guide_film<linear>(model, b, X, delta, moving, border, oil, rows, jac, seen);
      if constexpr (linear) seen->land_force[land] = std::hypot(oil[0], oil[1]);
    }
    if (!(p > -modal.farthest)) continue;
    BentLand bent;
    if (modal.flexible()) {
      bend_land(modal, land, std::atan2(side * nz, side * ny) - b.phi, bent);
      p += side * bent.moved;
      rate += side * (bent.rate[0] + bent.slope * (along * inverse - b.phi_rate));
    }
    if (!(p > 0)) continue;
    const double ring_surface = inner ? b.inner_speed * side * model.guide_ring_radius : 0;
    const double swash = ring_surface * (model.misalignment_y * nz - model.misalignment_z * ny);
    const double n_A = b.axis[0] * nz - b.axis[1] * ny;  // (A x n)_x
    const double v1 = along + b.phi_rate * R - ring_surface + side * bent.rate[1];
    const double v2 = b.cage_rate[2] + bent.rate[2] +
                      R * (b.phi_rate * n_A - (b.axis_rate[0] * ny + b.axis_rate[1] * nz)) - swash;
    const auto normal = normal_force(model.land, p, rate);
    const double speed2 = v1 * v1 + v2 * v2;
    const auto fr = friction(model.friction[kLandPair], speed2);
    const double g = fr.ratio * normal.force, f1 = -g * v1, f2 = -g * v2;
    // dp/d(place of the land): the normal, turned by the surface's slope.
    const double lean = side * bent.slope * inverse;
    const double py = ny - lean * nz, pz = nz + lean * ny;
    const double fy = -normal.force * py - f1 * nz, fz = -normal.force * pz + f1 * ny;
    for (int k = 0; k < modal.cage->modes; ++k)
      modal_force[k] +=
          side * (f1 * bent.row[1][k] - normal.force * bent.row[0][k]) + f2 * bent.row[2][k];
    border.cage[0] += fy;
    border.cage[1] += fz;
    border.cage[2] += f2;
    border.cage[3] += R * (f1 + f2 * n_A) + normal.force * side * bent.slope;
    border.cage[4] += X * fy - R * ny * f2;
    border.cage[5] += X * fz - R * nz * f2;
    if (inner) {
      border.ring[0] -= fy;
      border.ring[1] -= fz;
    }
    if constexpr (linear) {
      seen->land_force[land] =
          model.guide_film.on ? std::hypot(oil[0] - normal.force * py, oil[1] - normal.force * pz)
                              : normal.force;
      seen->land_touching[land] = normal.force > 0;
      seen->rub(kLandFriction, g * speed2);
      seen->damp(kDamping, (normal.force - normal.elastic) * rate);
      seen->elastic_energy += normal.elastic * p / (model.land.exponent + 1);
      if (inner) seen->drive_power += f1 * ring_surface + f2 * swash;
      const double channels[3][kCageRigid] = {{-py, -pz, 0, side * bent.slope, -X * py, -X * pz},
                                              {-nz, ny, 0, R, -X * nz, X * ny},
                                              {0, 0, 1, R * n_A, -R * ny, -R * nz}};
      for (int k = 0; k < 3; ++k) {
        fill_cage_row(channels[k], b, rows->border[k]);
        for (int m = 0; m < modal.cage->modes; ++m)
          rows->border[k][static_cast<std::size_t>(kModes + m)] = k == 0   ? -side * bent.row[0][m]
                                                                  : k == 1 ? side * bent.row[1][m]
                                                                           : bent.row[2][m];
        if (inner) {
          rows->border[k][kRingY] = -channels[k][0];
          rows->border[k][kRingZ] = -channels[k][1];
        }
      }
      add_contact(*rows,
                  {normal.force, normal.stiffness, normal.damping, fr.ratio, fr.bend, v1, v2,
                   normal.elastic, normal.elastic_stiffness, rate},
                  -1, *jac);
      // n and t turn as the cage moves along t: with them the force, and p'.
      const std::vector<double>&gn = rows->border[0], &g1 = rows->border[1], &g2 = rows->border[2];
      double turn[kRigidBorder] = {inner ? nz : 0, inner ? -ny : 0, -nz, ny, 0, 0, -X * nz, X * ny};
      for (int i = 0; i < kRigidBorder; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double e = gn[k] - fr.ratio * (v1 * g1[k] + v2 * g2[k]);
        const double row =
            (f1 * gn[k] - normal.force * turn[i] + e * normal.damping * along) * inverse;
        for (int j = 0; j < kRigidBorder; ++j) jac->border_position(i, j) += row * turn[j];
      }
      for (auto& row : rows->border) row[kRingY] = row[kRingZ] = 0;
    }
  }
}

}  // namespace cagetol
