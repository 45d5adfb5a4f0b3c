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
#include "src/numerics/dual.hpp"

namespace cagetol {

/// Adds the film of one land, at `delta` from the ring's axis and moving with `rate`; X its axial
/// place. `on_cage`: force of the pressure [N].
template <bool linear>
void guide_film(const CageGuide& guide, const BorderState& b, double X, const double delta[2],
                const double rate[2], BorderLoads& border, double on_cage[2], Linearisation* jac,
                Observation* seen) {
  // With slopes by the border's positions, then by its velocities.
  using T = std::conditional_t<linear, Dual<double, 2 * kRigidBorder>, double>;
  const bool inner = guide.inner;
  const double s = inner ? -1 : 1, ring_spin = inner ? b.speed.inner : b.speed.outer;
  const double by_spin[2] = {b.unbalance[1], -b.unbalance[0]};  // of the geometric centre
  const auto of_land = [&](double value, int k, int first) {
    T x = variable<T>(value, first + kCageY + k);
    if constexpr (linear) {
      x.slope[first + kCagePhi] = by_spin[k];
      x.slope[first + kCageAxisY + k] = X;
      if (inner) x.slope[first + kRingY + k] = -1;
    }
    return s * x;
  };
  const T D[2] = {of_land(delta[0], 0, 0), of_land(delta[1], 1, 0)};
  const T spin = variable<T>(b.phi_rate, kRigidBorder + kCagePhi), apart = spin - ring_spin,
          mean = 0.5 * (spin + ring_spin),
          sliding =
              variable<T>(b.cage_rate[2] - (inner ? b.ring_axial_rate : 0), kRigidBorder + kCageX);
  const T V[2] = {of_land(rate[0], 0, kRigidBorder) + mean * D[1],
                  of_land(rate[1], 1, kRigidBorder) - mean * D[0]};
  const double at[2] = {value_of(D[0]), value_of(D[1])}, with[2] = {value_of(V[0]), value_of(V[1])};
  const ShortBearingFilm film = short_bearing_film(guide.film, at, with);
  // The law's own slopes, times changes that are zero here.
  const T dD[2] = {D[0] - at[0], D[1] - at[1]}, dV[2] = {V[0] - with[0], V[1] - with[1]},
          away = film.direction[0] * dD[0] + film.direction[1] * dD[1];
  const auto force = [&](int a) {
    return film.force[a] - film.damping[a][0] * dV[0] - film.damping[a][1] * dV[1] -
           film.stiffness[a][0] * dD[0] - film.stiffness[a][1] * dD[1];
  };
  const T F[2] = {force(0), force(1)}, torque = -(film.torque + film.torque_slope * away) * apart,
          axial = -(film.axial + film.axial_slope * away) * sliding;
  const T spinning = 0.5 * (F[0] * D[1] - F[1] * D[0]);  // conjugate to each spin
  T load[kRigidBorder] = {};
  for (int k = 0; k < 2; ++k) {
    load[kCageY + k] = s * F[k];
    load[kCageAxisY + k] = X * load[kCageY + k];
    if (inner) load[kRingY + k] = -load[kCageY + k];
    on_cage[k] = value_of(load[kCageY + k]);
    border.ring[k] += value_of(load[kRingY + k]);
  }
  load[kCageX] = axial;
  load[kCagePhi] = spinning + torque;
  for (int i = 0; i < kCageRigid; ++i) border.cage[i] += value_of(load[kCageY + i]);
  if (inner) border.ring_axial -= value_of(axial);
  if constexpr (linear) {
    jac->cage_touched = true;
    const T lost = -(F[0] * V[0] + F[1] * V[1] + torque * apart + axial * sliding),
            drive = -ring_spin * (spinning - torque), power = drive - lost;
    seen->rub(kLandFriction, lost.value);
    seen->drive_power += drive.value;
    load[kCagePhi] += by_spin[0] * load[kCageY] + by_spin[1] * load[kCageZ];
    for (int j = 0; j < kRigidBorder; ++j) {
      for (int i = 0; i < kRigidBorder; ++i) {
        jac->border_position(i, j) += load[i].slope[j];
        jac->border_velocity(i, j) += load[i].slope[kRigidBorder + j];
      }
      jac->power_position[j] += power.slope[j];
      jac->power_velocity[j] += power.slope[kRigidBorder + j];
    }
  }
}

}  // namespace cagetol
