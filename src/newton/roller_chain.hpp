// The matrix of newton_matrix.hpp where rollers touch each other, as in a full complement: each
// couples to both its neighbours around the bearing and to the border. Rollers are eliminated one
// after the other, but for the last one, which closes the circle and stays with the border:
//   D_j u_j + L_j u_(j-1) + U_j u_(j+1) + C_j w = f_j,  w = (u_(Z-1), ring)
//   u_j = y_j - G_j u_(j+1) - H_j w                      S w = f_w - sum of R_j y_j
// Exact, as block elimination is; with pivots within blocks alone, as the symmetric part of the
// whole is positive definite.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "src/model/bearing_model.hpp"
#include "src/newton/linearisation.hpp"

namespace cagetol {

class RollerChain {
 public:
  explicit RollerChain(const BearingModel& model);

  /// Factors for `beta` [s]. False where something is not a number. Keeps references.
  bool factor(const Linearisation& linear, const Eigen::VectorXd& border_mass, double beta);
  /// As NewtonMatrix::solve.
  void solve(const double* rhs, double* x);

 private:
  static constexpr int kMostRing = 4;  ///< y, z; axial place or both tilts
  static constexpr int kCorner = kLocalVelocities + kMostRing;
  using Block = Eigen::Matrix<double, kLocalVelocities, kLocalVelocities>;
  using Vector = Eigen::Matrix<double, kLocalVelocities, 1>;
  using ToCorner = Eigen::Matrix<double, kLocalVelocities, kCorner>;
  using FromCorner = Eigen::Matrix<double, kCorner, kLocalVelocities>;
  using Corner = Eigen::Matrix<double, kCorner, kCorner>;
  using CornerVector = Eigen::Matrix<double, kCorner, 1>;
  using Ring = Eigen::Matrix<double, kMostRing, 1>;
  /// Derivatives by position and velocity of one roller, or of roller and ring.
  struct Pair {
    Block position, velocity;
  };
  struct Link {
    Block inverse, behind;  ///< D'^-1, L
    Block ahead_solved;     ///< G
    ToCorner solved;        ///< H
    FromCorner to_corner;   ///< R'
    Vector y;
  };
  Pair block(const RollerOnRoller& of, int lane) const;
  Pair own(int roller) const;
  /// Derivatives of forces on `roller` by the ring, and on the ring by the roller.
  struct RingPair {
    Eigen::Matrix<double, kLocalVelocities, kMostRing> position, velocity;
    Eigen::Matrix<double, kMostRing, kLocalVelocities> to_position, to_velocity;
  };
  RingPair with_ring(int roller) const;
  Vector local_mass(int roller) const;
  /// Positions and forces of the right-hand side in the rollers' directions.
  void start(const double* rhs);
  void finish(const double* rhs, double* x);
  const GroupLinear& group(int roller) const {
    return linear_->groups[static_cast<std::size_t>(roller / kLanes)];
  }

  const BearingModel& model_;
  const Linearisation* linear_ = nullptr;
  const Eigen::VectorXd* mass_ = nullptr;
  double beta_ = 0;
  int count_;               ///< Z
  std::vector<int> slots_;  ///< of the ring in the border
  std::vector<Link> links_;
  Eigen::PartialPivLU<Corner> corner_;
  std::vector<Vector> positions_, forces_, solution_;
  Ring ring_positions_, ring_forces_, ring_solution_;
};

}  // namespace cagetol
