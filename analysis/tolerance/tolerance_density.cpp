#include "analysis/tolerance/tolerance_density.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>

#include "analysis/study/refused.hpp"
#include "distributions/dependence.hpp"
#include "mc/study_file/named_law.hpp"

namespace cagetol {
namespace {

int dimension_of(const StudyPlan& plan, const std::string& key) {
  for (std::size_t d = 0; d < plan.dimensions.size(); ++d)
    if (plan.dimensions[d].key == key) return static_cast<int>(d);
  return -1;
}

double standard_normal(const Law& law, double x) {
  constexpr double kSmallest = 1e-300, kLargest = 1 - 1e-16;
  return gsl_cdf_ugaussian_Pinv(std::clamp(cdf(law, x), kSmallest, kLargest));
}

/// Inverts the correlation matrix in place and gives the logarithm of its determinant.
double invert(std::vector<double>& matrix, std::size_t size) {
  gsl_matrix_view view = gsl_matrix_view_array(matrix.data(), size, size);
  gsl_linalg_cholesky_decomp1(&view.matrix);
  double log_determinant = 0;
  for (std::size_t i = 0; i < size; ++i)
    log_determinant += 2 * std::log(gsl_matrix_get(&view.matrix, i, i));
  gsl_linalg_cholesky_invert(&view.matrix);
  return log_determinant;
}

}  // namespace

ToleranceDensity::ToleranceDensity(const StudyData& runs) {
  add_parts(runs, true);
  add_parts(runs, false);
}

void ToleranceDensity::add_parts(const StudyData& runs, bool lot_scope) {
  const std::string scope = lot_scope ? ":lot" : ":pocket";
  std::vector<std::string> names;
  std::vector<std::size_t> added;
  const auto tied = [&](const std::string& name) {
    return std::any_of(runs.plan.correlations.begin(), runs.plan.correlations.end(),
                       [&](const auto& pair) {
                         return pair.rho != 0 && (pair.first == name || pair.second == name);
                       });
  };
  for (const InputPlan& input : runs.plan.inputs) {
    const nlohmann::json& stated = lot_scope ? input.lot : input.pocket;
    const bool scaled = !lot_scope || runs.plan.scale_lots;
    const int dimension = scaled ? dimension_of(runs.plan, input.key) : -1;
    const InputColumns* columns = find_input(runs, input.key);
    if (stated.is_null() || columns == nullptr) continue;
    if (dimension < 0 && !tied(input.key + scope)) continue;
    const auto& values = lot_scope ? columns->lot : columns->pocket;
    if (!knows_law(stated))
      throw Refused("weights refused: " + input.key + scope +
                    " has a law that this version of the program does not know");
    const Law law = read_law(stated, input.key + scope);
    if (values.empty() || standard_deviation(law) == 0) continue;
    if (dimension >= 0 && std::holds_alternative<Empirical>(law))
      throw Refused("weights refused: " + input.key + scope +
                    " is a list of measured values, which has no density; state it "
                    "as a histogram, or with fitted = true as normal laws");
    names.push_back(input.key + scope);
    added.push_back(parts_.size());
    const bool has_lot = !columns->lot.empty() && !input.lot.is_null();
    parts_.push_back({law, dimension, values, values.size() / std::max<std::size_t>(runs.size(), 1),
                      lot_scope || !has_lot});
  }
  std::vector<double> matrix(names.size() * names.size(), 0.0);
  for (std::size_t i = 0; i < names.size(); ++i) matrix[i * names.size() + i] = 1;
  bool any = false;
  for (const Correlation& pair : runs.plan.correlations) {
    const auto first = std::find(names.begin(), names.end(), pair.first) - names.begin();
    const auto second = std::find(names.begin(), names.end(), pair.second) - names.begin();
    const auto count = static_cast<std::ptrdiff_t>(names.size());
    if (first == count || second == count || pair.rho == 0) continue;
    const double rho =
        normal_correlation(parts_[added[static_cast<std::size_t>(first)]].law,
                           parts_[added[static_cast<std::size_t>(second)]].law, pair.rho);
    matrix[static_cast<std::size_t>(first * count + second)] = rho;
    matrix[static_cast<std::size_t>(second * count + first)] = rho;
    any = true;
  }
  if (!any) return;
  Copula copula{added, std::move(matrix), 0};
  copula.log_determinant = invert(copula.inverse_minus_one, names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    copula.inverse_minus_one[i * names.size() + i] -= 1;
  copulas_.push_back(std::move(copula));
}

double ToleranceDensity::Part::standard(double value, std::span<const double> scales,
                                        std::span<const double> shifts) const {
  if (dimension < 0) return value;
  const auto d = static_cast<std::size_t>(dimension);
  return (value - (moves && !shifts.empty() ? shifts[d] : 0)) / scales[d];
}

double ToleranceDensity::log_density(std::size_t sample, std::span<const double> scales,
                                     std::span<const double> shifts) const {
  double sum = 0;
  for (const Part& part : parts_) {
    if (part.dimension < 0) continue;
    const double scale = scales[static_cast<std::size_t>(part.dimension)];
    for (std::size_t j = 0; j < part.width; ++j) {
      const double x = part.standard(part.values[sample * part.width + j], scales, shifts);
      const double density = pdf(part.law, x) / scale;
      if (!(density > 0)) return -std::numeric_limits<double>::infinity();
      sum += std::log(density);
    }
  }
  for (const Copula& copula : copulas_) sum += log_copula(copula, sample, scales, shifts);
  return sum;
}

double ToleranceDensity::log_copula(const Copula& copula, std::size_t sample,
                                    std::span<const double> scales,
                                    std::span<const double> shifts) const {
  const std::size_t count = copula.parts.size(), width = parts_[copula.parts.front()].width;
  std::vector<double> z(count);
  double sum = 0;
  for (std::size_t j = 0; j < width; ++j) {
    for (std::size_t i = 0; i < count; ++i) {
      const Part& part = parts_[copula.parts[i]];
      z[i] =
          standard_normal(part.law, part.standard(part.values[sample * width + j], scales, shifts));
    }
    sum -= 0.5 * copula.log_determinant;
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b)
        sum -= 0.5 * z[a] * copula.inverse_minus_one[a * count + b] * z[b];
  }
  return sum;
}

}  // namespace cagetol
