#include "analysis/sensitivity/unexplained_share.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/statistics/lot_variance.hpp"

namespace cagetol {
namespace {

using Values = std::vector<double>;

/// Share of the runs that a fit must leave to judge its scatter by.
constexpr double kLeast = 0.3;
constexpr std::size_t kLotsForParabolas = 8;  // a feature

double product(const Values& a, const Values& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void subtract(Values& from, const Values& direction) {
  const double along = product(from, direction);
  for (std::size_t i = 0; i < from.size(); ++i) from[i] -= along * direction[i];
}

/// Adds a column to an orthonormal basis unless it lies within it (modified Gram-Schmidt).
void add(std::vector<Values>& basis, Values column) {
  const double size = product(column, column);
  for (const Values& direction : basis) subtract(column, direction);
  const double left = product(column, column);
  if (!(left > 1e-12 * size)) return;
  for (double& value : column) value /= std::sqrt(left);
  basis.push_back(std::move(column));
}

}  // namespace

Estimate unexplained_share(const std::vector<Feature>& features, std::span<const double> output,
                           const Resampling& resampling, double confidence) {
  Values defined;  // 0 for runs without a value, in all columns
  for (const double y : output) defined.push_back(std::isnan(y) ? 0 : 1);
  std::vector<Values> basis;
  add(basis, defined);
  if (basis.empty() || features.empty()) return {};
  const auto centred = [&](std::span<const double> values) {
    Values column(values.begin(), values.end());
    for (std::size_t i = 0; i < column.size(); ++i)
      if (defined[i] == 0) column[i] = 0;
    subtract(column, basis.front());
    return column;
  };
  const std::vector<std::size_t>& lot_of = resampling.lot_of();
  const bool parabolas = resampling.lots() >= kLotsForParabolas * features.size();
  for (const Feature& feature : features) {
    Values column = centred(feature.values);
    add(basis, column);
    for (double& value : column) value *= value;
    if (parabolas) add(basis, column);
  }
  const Values deviations = centred(output);
  Values residuals = deviations;
  double in_lots = 0;
  for (const Values& direction : basis) {
    subtract(residuals, direction);
    Values sums(output.size());
    for (std::size_t i = 0; i < output.size(); ++i) sums[lot_of[i]] += direction[i];
    in_lots += product(sums, sums);
  }
  const double runs = product(defined, defined), fitted = static_cast<double>(basis.size());
  const double share = residual_variance(residuals, defined, lot_of, fitted, in_lots).whole() /
                       lot_variance(deviations, defined, lot_of).whole();
  if (runs - in_lots < kLeast * runs || !(share > 0)) return {};
  Values influence(output.size());
  const double of_fit = product(residuals, residuals), of_all = product(deviations, deviations);
  for (std::size_t i = 0; i < output.size(); ++i)
    influence[lot_of[i]] +=
        residuals[i] * residuals[i] / of_fit - deviations[i] * deviations[i] / of_all;
  const auto lots = static_cast<double>(resampling.lots());
  const double freedom = std::max(lots * (1 - in_lots / runs), 1.0);
  const double error = std::sqrt(product(influence, influence) * lots / freedom);
  const double factor = std::exp(gsl_cdf_tdist_Qinv(0.5 * (1 - confidence), freedom) * error);
  const Estimate estimate{std::min(share, 1.0), share / factor, std::min(share * factor, 1.0)};
  return resampling.kind() == IntervalKind::lots ? estimate : Estimate{estimate.value};
}

}  // namespace cagetol
