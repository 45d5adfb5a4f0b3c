// Dependent inputs by a Gaussian copula (Nataf's model; Liu & Der Kiureghian 1986,
// doi:10.1016/0266-8920(86)90033-0):
//   z = Phi^-1(u)    each coordinate becomes a standard normal number
//   z -> L z         L the Cholesky factor of the correlation matrix
//   u = Phi(z)       back to uniform coordinates
// Every law keeps its marginal exactly.
//
// Do not confuse two correlations. The copula takes the correlation of z. A study states the
// Pearson correlation of the deviations themselves, which normal_correlation() converts. Between
// normal laws both are equal.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "distributions/law.hpp"

namespace cagetol {

/// Correlation of the normal numbers for which the two laws have the Pearson correlation rho. If no
/// Gaussian copula has it, throws std::invalid_argument with the possible range.
double normal_correlation(const Law& first, const Law& second, double rho);

/// One correlated pair of coordinates.
struct CorrelatedPair {
  std::size_t first = 0, second = 0;
  double rho = 0;  ///< of the normal numbers
};

class GaussianCopula {
 public:
  /// Coordinates without a pair are independent. Throws std::invalid_argument if the matrix is not
  /// positive definite.
  GaussianCopula(std::size_t dimensions, std::span<const CorrelatedPair> pairs);

  std::size_t dimensions() const;

  /// Makes independent uniform coordinates dependent, in place. Coordinate i depends on coordinates
  /// 0 .. i only. Coordinates without a partner keep their bits.
  void correlate(std::span<double> u) const;

 private:
  std::size_t dimensions_ = 0;
  std::vector<double> factor_;  ///< lower triangle, by rows
};

}  // namespace cagetol
