// The Jacobian of the right-hand side as one dense matrix in the order of the state vector:
// assembled from a Linearisation, or from central differences of the rates. References for tests.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "src/dynamics/forces.hpp"
#include "src/numerics/pack_vector.hpp"

namespace cagetol {

/// Rows and columns of padding are zero.
Eigen::MatrixXd assembled_jacobian(const BearingModel& model, const std::vector<double>& y,
                                   const Linearisation& linear);

/// Central differences, `step` times `scale` wide in each component.
Eigen::MatrixXd differenced_jacobian(const BearingModel& model, double t,
                                     const std::vector<double>& y, const PackVector& scale,
                                     double step);

}  // namespace cagetol
