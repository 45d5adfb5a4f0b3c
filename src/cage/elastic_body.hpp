// An unsupported linear elastic body: matrices, rigid motions, mass properties, and static response
// with inertia relief.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

#include "src/cage/cage_mesh.hpp"

namespace cagetol {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Unknown 3 n + d: node n, direction d. Lower triangles only.
struct BodyMatrices {
  SparseMatrix stiffness;  ///< K [N/m]
  SparseMatrix mass;       ///< M, consistent [kg]
};
BodyMatrices assemble_body(const HexMesh& mesh, const Material& material);

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
RigidMotions mass_orthonormal(const RigidMotions& motions, const SparseMatrix& mass);

/// Cholesky factor of K + s M, s > 0: positive definite although K alone is singular. Supernodal
/// (CHOLMOD).
class ShiftedFactor {
 public:
  ShiftedFactor(const BodyMatrices& body, double shift);
  ~ShiftedFactor();
  ShiftedFactor(const ShiftedFactor&) = delete;
  ShiftedFactor& operator=(const ShiftedFactor&) = delete;

  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& right) const;
  double shift() const { return shift_; }

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
  double shift_;
};

/// A shift well below the first elastic eigenvalue [rad^2/s^2]: a fraction of the Rayleigh quotient
/// of the oval (n = 2) deformation of a ring about the x axis, which bounds that eigenvalue from
/// above.
double ring_shift(const HexMesh& mesh, const BodyMatrices& body);

/// Static elastic displacement under each column of `loads` with inertia relief: rigid-body
/// acceleration balances the load, and the displacement is mass-orthogonal to all six rigid
/// motions. Iterates with the shifted factor; each iteration reduces the error by
///   shift / (shift + first eigenvalue)
Eigen::MatrixXd free_static_response(const BodyMatrices& body, const ShiftedFactor& factor,
                                     const RigidMotions& rigid_orthonormal,
                                     const Eigen::MatrixXd& loads);

}  // namespace cagetol
