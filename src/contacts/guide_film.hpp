// Oil film between the cage's lands and their guiding ring (src/contact_laws/short_bearing.hpp),
// one bearing a land. Guided outside, the cage is the journal in the ring; guided inside, the
// ring in the cage. With delta the land's offset from the ring's axis and s = +1 outside,
// -1 inside,
//   D = s delta,   V = s delta' - (phi' + w_ring)/2 e_x x D,
// are linear in the velocities: forces follow as the transposes of V, of the spins' difference and
// of the axial speed. Lands stay parallel to their ring: the lean of cage or ring within the width
// of a land, and the bending of a flexible cage's land, change nothing of the film.
#pragma once

#include "src/contacts/contact_frame.hpp"

namespace cagetol {

/// Adds the film of one land, at `delta` from the ring's axis and moving with `rate`; X its axial
/// place. `on_cage`: force of the pressure [N]. One function: the derivatives read nearly
/// all that the forces are made of.
template <bool linear>
void guide_film(const CageGuide& guide, const BorderState& b, double X, const double delta[2],
                const double rate[2], BorderLoads& border, double on_cage[2], ContactRows* rows,
                Linearisation* jac, Observation* seen) {
  const bool inner = guide.inner;
  const double s = inner ? -1 : 1, ring_spin = inner ? b.speed.inner : b.speed.outer;
  const double mean = 0.5 * (b.phi_rate + ring_spin), apart = b.phi_rate - ring_spin,
               sliding = b.cage_rate[2] - (inner ? b.ring_axial_rate : 0);
  const double D[2] = {s * delta[0], s * delta[1]};
  const double V[2] = {s * rate[0] + mean * D[1], s * rate[1] - mean * D[0]};
  const ShortBearingFilm film = short_bearing_film(guide.film, D, V);
  const double *F = film.force, torque = -film.torque * apart, axial = -film.axial * sliding;
  const double spinning = 0.5 * (F[0] * D[1] - F[1] * D[0]);  // conjugate to each spin
  for (int k = 0; k < 2; ++k) {
    on_cage[k] = s * F[k];
    border.cage[k] += on_cage[k];
    border.cage[4 + k] += X * on_cage[k];
    if (inner) border.ring[k] -= on_cage[k];
  }
  border.cage[2] += axial;
  if (inner) border.ring_axial -= axial;
  border.cage[3] += spinning + torque;
  if constexpr (linear) {
    jac->cage_touched = true;
    seen->rub(kLandFriction, -(F[0] * V[0] + F[1] * V[1] + torque * apart + axial * sliding));
    seen->drive_power -= ring_spin * (spinning - torque);
    // Rows over the border: of V, of the difference of spins, of the axial speed; and of D.
    double row[4][kRigidBorder] = {}, place[2][kRigidBorder] = {};
    for (int k = 0; k < 2; ++k) {
      double at_centre[kCageRigid] = {};
      at_centre[k] = s;
      at_centre[4 + k] = s * X;
      fill_cage_row(at_centre, b, rows->border[0]);
      for (int i = kCageY; i < kRigidBorder; ++i)
        row[k][i] = place[k][i] = rows->border[0][static_cast<std::size_t>(i)];
      if (inner) row[k][kRingY + k] = place[k][kRingY + k] = -s;
    }
    row[0][kCagePhi] += 0.5 * D[1];
    row[1][kCagePhi] -= 0.5 * D[0];
    row[2][kCagePhi] = 1;
    row[3][kCageX] = 1;
    const double level[4] = {0, 0, film.torque, film.axial};
    const double lost_twice[4] = {-2 * F[0], -2 * F[1], -2 * torque, -2 * axial};
    for (int j = 0; j < kRigidBorder; ++j) {
      // Change of the four channels' forces with the velocity, then with the position j.
      double by_velocity[4], by_position[4];
      const double dD[2] = {place[0][j], place[1][j]};
      const double dV[2] = {mean * dD[1], -mean * dD[0]};
      const double de = film.direction[0] * dD[0] + film.direction[1] * dD[1];
      for (int a = 0; a < 2; ++a) {
        by_velocity[a] = -film.damping[a][0] * row[0][j] - film.damping[a][1] * row[1][j];
        by_position[a] = -film.damping[a][0] * dV[0] - film.damping[a][1] * dV[1] -
                         film.stiffness[a][0] * dD[0] - film.stiffness[a][1] * dD[1];
      }
      by_velocity[2] = -level[2] * row[2][j];
      by_velocity[3] = -level[3] * row[3][j];
      by_position[2] = -film.torque_slope * apart * de;
      by_position[3] = -film.axial_slope * sliding * de;
      const double lever = 0.5 * (F[0] * dD[1] - F[1] * dD[0]);
      for (int i = 0; i < kRigidBorder; ++i) {
        double velocity = 0, position = i == kCagePhi ? lever : 0;
        for (int a = 0; a < 4; ++a) {
          velocity += row[a][i] * by_velocity[a];
          position += row[a][i] * by_position[a];
        }
        jac->border_velocity(i, j) += velocity;
        jac->border_position(i, j) += position;
      }
      // Net power = drive - dissipation; the drive is what the ring's spin takes.
      const auto drive = [&](const double change[4], double turned) {
        return -ring_spin * (0.5 * (change[0] * D[1] - change[1] * D[0]) + turned - change[2]);
      };
      double lost_by_velocity = 0, lost_by_position = 0;
      for (int a = 0; a < 4; ++a) lost_by_velocity += lost_twice[a] * row[a][j];
      for (int a = 0; a < 2; ++a) lost_by_position -= F[a] * dV[a] + by_position[a] * V[a];
      lost_by_position -= by_position[2] * apart + by_position[3] * sliding;
      jac->power_velocity[j] += drive(by_velocity, 0) - lost_by_velocity;
      jac->power_position[j] += drive(by_position, lever) - lost_by_position;
    }
  }
}

}  // namespace cagetol
