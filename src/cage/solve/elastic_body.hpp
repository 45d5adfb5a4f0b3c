// An unsupported linear elastic body: matrices, rigid motions, mass properties, and static response
// with inertia relief.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

#include "src/cage/mesh/cage_mesh.hpp"

namespace cagetol {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Unknown 3 n + d: node n, direction d. Lower triangles only.
struct BodyMatrices {
  SparseMatrix stiffness;  ///< K [N/m]
  SparseMatrix mass;       ///< M, consistent [kg]
};
BodyMatrices assemble_body(const HexMesh& mesh, const Material& material);

/// Product of the symmetric matrix with this lower triangle and many columns at once.
Eigen::MatrixXd symmetric_product(const SparseMatrix& lower, const Eigen::MatrixXd& columns);

/// Columns: unit translation along x, y, z and unit rotation about x, y, z through the origin
/// (linear displacement omega x X). These six are exact for any mesh.
using RigidMotions = Eigen::Matrix<double, Eigen::Dynamic, 6>;
RigidMotions rigid_motions(const Eigen::Matrix3Xd& nodes);

struct MassProperties {
  double mass = 0;                                    ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the mass centre [kg m^2]
};
/// From the 6 x 6 mass matrix of the rigid motions above.
MassProperties mass_properties(const Eigen::Matrix<double, 6, 6>& rigid_mass);

/// Rigid motions combined to be mass-orthonormal.
Eigen::MatrixXd mass_orthonormal(const Eigen::MatrixXd& motions, const SparseMatrix& mass);

/// Cholesky factor of K held by springs to the ground, one for each rigid motion. K alone is
/// singular. A balanced load puts no force into such springs, so that the solution for it is exact
/// but for a rigid motion. Supernodal (CHOLMOD).
class HeldFactor {
 public:
  /// `rigid`: the rigid motions that `stiffness` leaves free; may have no columns.
  HeldFactor(const SparseMatrix& stiffness, const Eigen::MatrixXd& rigid);
  ~HeldFactor();
  HeldFactor(const HeldFactor&) = delete;
  HeldFactor& operator=(const HeldFactor&) = delete;

  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& right) const;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

/// Static elastic displacement under each column of `loads` with inertia relief: rigid-body
/// acceleration balances the load, and the displacement is mass-orthogonal to all rigid motions.
Eigen::MatrixXd free_static_response(const BodyMatrices& body, const HeldFactor& factor,
                                     const Eigen::MatrixXd& rigid_orthonormal,
                                     const Eigen::MatrixXd& loads);

}  // namespace cagetol
