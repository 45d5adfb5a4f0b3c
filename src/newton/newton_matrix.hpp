// The matrix (1/beta - J) of every implicit method here, beta = gamma h, factored along the arrow
// that a bearing is: each roller couples to the border (inner ring, cage, modes) only. Positions
// are eliminated (q' = v), which leaves 6 unknowns a roller:
//   A_j = M_j/beta - dF/dV - beta dF/dP
//   S   = B - sum_j T_j A_j^-1 N_j         Schur complement on the border
// Roller blocks are inverted side by side across the lanes, then the border, all without pivoting:
// mass, damping and stiffness keep the symmetric part positive definite as long as beta is not
// absurdly large; a vanishing pivot is reported, not divided by.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/model/bearing_model.hpp"
#include "src/newton/free_cage.hpp"
#include "src/newton/linearisation.hpp"
#include "src/numerics/kernel.hpp"
#include "src/numerics/small_inverse.hpp"

namespace cagetol {

class NewtonMatrix {
 public:
  CAGETOL_KERNEL explicit NewtonMatrix(const BearingModel& model);

  /// Factors for `beta` > 0 [s]. False where a pivot vanished or is not a number. Keeps a reference
  /// to `linear` for solve().
  CAGETOL_KERNEL bool factor(const Linearisation& linear, double beta);

  /// Solves (1/beta - J) x = rhs, both in the order of the state vector; x may be rhs. No
  /// allocation.
  CAGETOL_KERNEL void solve(const double* rhs, double* x);

  double beta() const { return beta_; }

 private:
  // `vectors` of the inner ring couple to rollers: its displacement, and its tilt where it is free.
  template <int vectors>
  bool factor_as(const Linearisation& linear, double beta);
  template <int vectors>
  bool factor_rollers(double beta);
  template <int vectors>
  void solve_as(const double* rhs, double* x);
  template <int vectors, int packs>
  void solve_with(const double* rhs, double* x);
  // Its steps, in order.
  struct RollerSide {
    Pack position[kLocalPositions], force[kLocalVelocities];
  };
  template <int vectors>
  void start_border(const double* rhs);
  template <int vectors>
  RollerSide roller_side(int group, const double* rhs) const;
  template <int vectors, int packs>
  void eliminate_rollers(const double* rhs);
  template <int vectors, int packs>
  void substitute_rollers(const double* rhs, double* x);
  /// Coupling of a pack of rollers with a vector of the ring, and where the vector stands in the
  /// border.
  const RingCoupling& coupling(int group, int vector) const;
  int ring_slot(int vector) const { return vector == 0 ? kRingY : model_.layout.ring_tilt_slot(); }

  static constexpr int kMostVectors = 2;
  struct Group {
    Pack inverse[kLocalVelocities][kLocalVelocities];   ///< A^-1
    Pack to_ring[kMostVectors][2][kLocalVelocities];    ///< T A^-1, ring part, in their directions
    Pack from_ring[kMostVectors][kLocalVelocities][2];  ///< A^-1 N, ring part
    Pack rhs[kLocalVelocities];  ///< A^-1 of the right-hand side being solved for
  };
  struct Cage {
    std::vector<Eight> from;  ///< A^-1 N, cage part: over local directions, for each of the cage's
    std::vector<Pack> to;     ///< T, cage part: packs over the cage's, for each local direction
  };
  /// Calls `then` with lane and index into `couplings` of the rollers of a pack that touch the
  /// cage.
  template <class Then>
  void for_coupled(int group, const Then& then) const;
  template <class OfLane>
  void add_to_lanes(int group, Pack (&to)[kLocalVelocities], const OfLane& of_lane) const;
  /// Couplings with the cage, `packs` of them to a vector over the cage's directions.
  template <int vectors, int packs>
  void factor_cage();

  // Where nothing touches the cage: the ring's part of the border, the cage's is FreeCage's.
  template <int vectors>
  void start_free_ring();
  template <int vectors>
  bool finish_free_ring();
  template <int vectors>
  void solve_free_border();

  const BearingModel& model_;
  const Linearisation* linear_ = nullptr;
  double beta_ = 0;
  std::vector<Group> groups_;
  std::vector<Cage> cages_;
  SmallInverse schur_;  ///< Schur complement on the border, then its inverse
  SmallInverse free_ring_;
  FreeCage free_cage_;
  // Over the border, zeros behind it up to whole packs.
  Eigen::VectorXd border_mass_, border_rhs_, border_positions_, border_solution_;
};

/// Mass of each border direction [kg] or [kg m^2] (1 for mass-normalised modes).
CAGETOL_KERNEL Eigen::VectorXd border_mass(const BearingModel& model);

}  // namespace cagetol
