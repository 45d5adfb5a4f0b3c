// Polynomials of a sector's quantities in the deviations of its pocket.
//
// The carried basis is linear in the deviations, and the element matrices vary smoothly with
// the nodes. A quadratic in all four deviations, cubic in width and length, fits them closely.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/mesh/cage_mesh.hpp"

namespace cagetol {

/// Range of deviations that the table covers, each +-: fractions of the width of bars and side
/// rings.
PocketDeviation table_range(const CageDimensions& cage);

bool inside_range(const PocketDeviation& deviation, const PocketDeviation& range);

/// Values of the polynomial's terms for one deviation.
Eigen::VectorXd polynomial_terms(const PocketDeviation& deviation, const PocketDeviation& range);

/// Deviations at which a sector is computed for the fit; the first is zero.
std::vector<PocketDeviation> polynomial_samples(const PocketDeviation& range);

/// Least-squares coefficients (quantities x terms) from values at the samples (quantities x
/// samples). Exact at zero deviation.
Eigen::MatrixXd fit_polynomial(const Eigen::MatrixXd& values, const PocketDeviation& range);

}  // namespace cagetol
