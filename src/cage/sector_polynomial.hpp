// Quantities of a sector as polynomials of its pocket's own deviations.
//
// The carried basis is linear in the deviations and the element matrices bend gently with the
// nodes, so a quadratic in all four deviations and a cubic in width and length follow them closely.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/cage_mesh.hpp"

namespace cagetol {

/// Deviations the table covers, each as +-: fractions of what bars and side rings have to give.
PocketDeviation table_range(const CageDimensions& cage);

bool inside_range(const PocketDeviation& deviation, const PocketDeviation& range);

/// Values of the polynomial's terms for one deviation.
Eigen::VectorXd polynomial_terms(const PocketDeviation& deviation, const PocketDeviation& range);

/// Deviations at which a sector is computed to fit the polynomial; the first is zero.
std::vector<PocketDeviation> polynomial_samples(const PocketDeviation& range);

/// Least-squares coefficients (quantities x terms) from values at the samples (quantities x
/// samples); the sample at zero deviation is met exactly.
Eigen::MatrixXd fit_polynomial(const Eigen::MatrixXd& values, const PocketDeviation& range);

}  // namespace cagetol
