// Elastic modes of a flexible cage as the contact kernels read them: displacement of every contact
// point per modal coordinate, eight pockets side by side. Floating frame of reference: the frame is
// the rigid cage of the state (mass centre, spin angle, axis), modes are mean-axes modes, so they
// couple to the rigid motion through the spin alone. Displacements are small and in the directions
// e_R, e_T, e_x of the point's own pocket (src/cage/table/cage_model.hpp).
#pragma once

#include <memory>
#include <vector>

#include "src/cage/table/cage_model.hpp"
#include "src/numerics/pack_matrix.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct FlexibleCage {
  std::shared_ptr<const CageModel> model;  ///< null: rigid
  int modes = 0;
  int points = 0;    ///< contact points per pocket that `rows` holds: bars, then side ring faces
  int stations = 0;  ///< per bar face
  /// Displacement per modal coordinate: [((group points + point) 3 + direction) modes + mode].
  std::vector<Pack> rows;
  /// Guiding surface: [((land corners + corner) 3 + direction) modes + mode]; corners alternate
  /// middles of pockets and of the bars after them, evenly around.
  std::vector<double> land_rows;
  int corners = 0;
  std::vector<double> stiffness, damping;  ///< omega^2 [1/s^2], 2 zeta omega [1/s] of each mode
  std::vector<double> scale;               ///< largest contact displacement per modal coordinate
  bool centrifugal = false, coriolis = false;
  PackMatrix gyroscopic, centrifugal_force;  ///< of the model; the latter one column

  const Pack* row(int group, int point, int direction) const {
    return rows.data() +
           static_cast<std::size_t>(((group * points + point) * 3 + direction) * modes);
  }
  const double* land_row(int land, int corner, int direction) const {
    return land_rows.data() +
           static_cast<std::size_t>(((land * corners + corner) * 3 + direction) * modes);
  }
};

/// Prepares `model` for `groups` packs of pockets.
FlexibleCage make_flexible_cage(const std::shared_ptr<const CageModel>& model,
                                const CageGeometry& geometry, int groups);

/// Modal coordinates and rates at a state, and the forces on them that contacts collect.
struct ModalState {
  const FlexibleCage* cage;
  const double *q, *rate;
  Pack* force;          ///< modes packs, to be summed over lanes where `pushed`
  double farthest = 0;  ///< no contact point has moved farther along one of its directions [m]

  mutable bool pushed = false;

  bool flexible() const { return cage->modes > 0; }
  /// Displacement or speed of a contact point of a pack of pockets.
  Pack along(int group, int point, int direction, const double* coordinate) const {
    const Pack* row = cage->row(group, point, direction);
    Pack even{}, odd{};  // neither sum waits for the other
    int k = 0;
    for (; k + 1 < cage->modes; k += 2) {
      even += row[k] * coordinate[k];
      odd += row[k + 1] * coordinate[k + 1];
    }
    if (k < cage->modes) even += row[k] * coordinate[k];
    return even + odd;
  }
  /// A force on the cage at that point along e_R, e_T, e_x.
  void push(int group, int point, Pack f_R, Pack f_T, Pack f_x) const {
    for (int k = 0; !pushed && k < cage->modes; ++k) force[k] = Pack{};
    pushed = true;
    const Pack *R = cage->row(group, point, 0), *T = cage->row(group, point, 1),
               *x = cage->row(group, point, 2);
    for (int k = 0; k < cage->modes; ++k) force[k] += R[k] * f_R + T[k] * f_T + x[k] * f_x;
  }
};

/// Bound of any displacement at these modal coordinates.
double farthest_displacement(const FlexibleCage& cage, const double* q);

/// What the spin does to the modes, and they to it (Lagrange's equations of
///   T = (I_p + 2 c.q) w^2/2 + q'.q'/2 + w q'.G q;
/// spin softening is left out with the stress stiffening that outweighs it):
///   q'' + 2 w G q' + w' G q - w^2 c = F,   (I_p + 2 c.q) w' + 2 w c.q' + q''.G q = torque.
/// In: accelerations F and torque/I_p of free modes and cage. Out: both coupled.
void couple_spin(const FlexibleCage& cage, double polar, double spin, const double* q,
                 const double* rate, double* acceleration, double& spin_acceleration);

/// Kinetic energy beyond I_p w^2/2 and strain energy of the modes [J].
double modal_energy(const FlexibleCage& cage, double spin, const double* q, const double* rate);

}  // namespace cagetol
