#include "distributions/dependence.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_matrix.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "distributions/basics/require.hpp"

namespace cagetol {

namespace {

// Coefficients c_k, k = 1, 2, ..., of the standardised quantile in normalised Hermite polynomials,
//   (F^-1(Phi(z)) - mean) / sigma = sum_k c_k He_k(z) / sqrt(k!),
// by the trapezoidal rule, whose error falls faster than any power of the step for smooth laws.
// Mehler's formula then makes the Nataf integral a power series: Pearson(r) = sum_k c_k d_k r^k.
std::vector<double> hermite_coefficients(const Law& law) {
  constexpr std::size_t terms = 128;
  constexpr double reach = 8.2, step = 1.0 / 256;
  const double centre = mean(law), sigma = standard_deviation(law);
  std::vector<double> coefficients(terms, 0.0);
  for (double z = -reach; z <= reach; z += step) {
    const double x = quantile(law, gsl_cdf_ugaussian_P(z));
    const double weight = step * std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
    double before = 0, polynomial = 1;
    for (std::size_t k = 0; k < terms; ++k) {
      const double next = (z * polynomial - std::sqrt(static_cast<double>(k)) * before) /
                          std::sqrt(static_cast<double>(k + 1));
      before = polynomial;
      polynomial = next;
      coefficients[k] += weight * (x - centre) / sigma * polynomial;
    }
  }
  return coefficients;
}

double pearson(const std::vector<double>& first, const std::vector<double>& second, double r) {
  double sum = 0;
  for (std::size_t k = first.size(); k-- > 0;) sum = r * (sum + first[k] * second[k]);
  return sum;
}

using Matrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;

Matrix correlation_matrix(std::size_t dimensions, std::span<const CorrelatedPair> pairs) {
  Matrix matrix(gsl_matrix_alloc(dimensions, dimensions), &gsl_matrix_free);
  gsl_matrix_set_identity(matrix.get());
  for (const auto& [first, second, rho] : pairs) {
    require(first < dimensions && second < dimensions && first != second,
            "a correlation between coordinates ", first, " and ", second, " of ", dimensions,
            "; name two different inputs");
    require(
        std::abs(rho) < 1, "rho = ", rho,
        " is not within -1 < rho < 1; give 0.999 at most: inputs that move as one are one input");
    require(gsl_matrix_get(matrix.get(), first, second) == 0, "the correlation of coordinates ",
            first, " and ", second, " is given twice; keep one");
    gsl_matrix_set(matrix.get(), first, second, rho);
    gsl_matrix_set(matrix.get(), second, first, rho);
  }
  return matrix;
}

double smallest_eigenvalue(const gsl_matrix* matrix) {
  const std::size_t n = matrix->size1;
  const Matrix copy(gsl_matrix_alloc(n, n), &gsl_matrix_free);
  gsl_matrix_memcpy(copy.get(), matrix);
  const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> values(gsl_vector_alloc(n),
                                                                       &gsl_vector_free);
  const std::unique_ptr<gsl_eigen_symm_workspace, decltype(&gsl_eigen_symm_free)> workspace(
      gsl_eigen_symm_alloc(n), &gsl_eigen_symm_free);
  gsl_eigen_symm(copy.get(), values.get(), workspace.get());
  return gsl_vector_min(values.get());
}

}  // namespace

double normal_correlation(const Law& first, const Law& second, double rho) {
  require(std::abs(rho) < 1, "rho = ", rho,
          " is not within -1 < rho < 1; give 0.999 at most: inputs that move as one are one input");
  if (rho == 0 || standard_deviation(first) == 0 || standard_deviation(second) == 0) return rho;
  const bool both_normal =
      (std::holds_alternative<Normal>(first) || std::holds_alternative<Capability>(first)) &&
      (std::holds_alternative<Normal>(second) || std::holds_alternative<Capability>(second));
  if (both_normal) return rho;

  const std::vector<double> c = hermite_coefficients(first), d = hermite_coefficients(second);
  // Just inside +-1: a normal correlation there could not be told from identity.
  constexpr double end = 0.9999;
  double below = -end, above = end;
  require(pearson(c, d, below) <= rho && rho <= pearson(c, d, above), "rho = ", rho,
          " cannot be reached between a ", law_name(first), " and a ", law_name(second),
          " law of these parameters: the range is ", pearson(c, d, below), " .. ",
          pearson(c, d, above), "; choose rho inside it");
  while (above - below > 1e-13) {
    const double middle = (below + above) / 2;
    (pearson(c, d, middle) < rho ? below : above) = middle;
  }
  return (below + above) / 2;
}

GaussianCopula::GaussianCopula(std::size_t dimensions, std::span<const CorrelatedPair> pairs)
    : dimensions_(dimensions) {
  if (pairs.empty()) return;
  const Matrix matrix = correlation_matrix(dimensions, pairs);
  const double smallest = smallest_eigenvalue(matrix.get());
  constexpr double margin = 1e-10;
  require(smallest > margin, "the correlations contradict each other: the smallest eigenvalue of ",
          "their matrix is ", smallest, ", not positive; all of them multiplied by less than ",
          (1 - margin) / (1 - smallest), " would be possible");
  gsl_linalg_cholesky_decomp1(matrix.get());
  factor_.resize(dimensions * dimensions);
  for (std::size_t i = 0; i < dimensions; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      factor_[i * dimensions + j] = gsl_matrix_get(matrix.get(), i, j);
    }
  }
}

std::size_t GaussianCopula::dimensions() const {
  return dimensions_;
}

void GaussianCopula::correlate(std::span<double> u) const {
  require(u.size() == dimensions_, "a copula of ", dimensions_, " coordinates cannot correlate ",
          u.size());
  if (factor_.empty()) return;
  std::vector<double> z(dimensions_);
  for (std::size_t i = 0; i < dimensions_; ++i) z[i] = gsl_cdf_ugaussian_Pinv(u[i]);
  for (std::size_t i = 0; i < dimensions_; ++i) {
    const double* row = factor_.data() + i * dimensions_;
    double sum = row[i] * z[i];
    bool independent = true;
    for (std::size_t j = 0; j < i; ++j) {
      if (row[j] == 0) continue;
      independent = false;
      sum += row[j] * z[j];
    }
    if (independent) continue;
    require(!std::isnan(sum), "coordinate ", i, " depends on coordinates 0 and 1, whose normal ",
            "numbers are infinite; they must lie inside (0, 1)");
    u[i] = gsl_cdf_ugaussian_P(sum);
    if (std::isfinite(sum)) u[i] = std::clamp(u[i], 0x1p-53, 1 - 0x1p-53);
  }
}

}  // namespace cagetol
