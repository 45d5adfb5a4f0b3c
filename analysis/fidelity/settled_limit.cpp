#include "analysis/fidelity/settled_limit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/statistics/tail_bounds.hpp"

namespace cagetol {
namespace {

LimitSide side_of(double value, const Limit& limit) {
  if (limit.maximum && value > *limit.maximum) return LimitSide::above;
  if (limit.minimum && value < *limit.minimum) return LimitSide::below;
  return LimitSide::within;
}

/// Share of the law of `values` below `limit`.
double lower_tail_bound(std::vector<double> values, double limit, double confidence) {
  for (double& value : values) value = -value;
  return tail_bound(values, -limit, confidence);
}

/// `error` is the chance that this bound may fail.
double wrong_share(const std::vector<double>& values, LimitSide side, const Limit& limit,
                   double error) {
  if (side == LimitSide::above) return lower_tail_bound(values, *limit.maximum, 1 - error);
  if (side == LimitSide::below) return tail_bound(values, *limit.minimum, 1 - error);
  const double part = limit.maximum && limit.minimum ? 0.5 * error : error;
  double share = 0;
  if (limit.maximum) share += tail_bound(values, *limit.maximum, 1 - part);
  if (limit.minimum) share += lower_tail_bound(values, *limit.minimum, 1 - part);
  return share;
}

}  // namespace

SettledLimit settled_limit(std::span<const double> values, std::span<const double> reference,
                           const Limit& limit, double confidence) {
  std::vector<double> own, others;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isnan(values[k]) || std::isnan(reference[k])) continue;
    own.push_back(values[k]);
    others.push_back(reference[k]);
  }
  if (own.size() < kFewestSettledPairs) return {};
  const LimitSide side = side_of(own.front(), limit);
  const auto is_there = [&](double value) { return side_of(value, limit) == side; };
  if (!std::all_of(own.begin(), own.end(), is_there) ||
      !std::all_of(others.begin(), others.end(), is_there))
    return {};
  const double error = 0.5 * (1 - confidence);
  return {side, std::min(1.0, std::max(wrong_share(own, side, limit, error),
                                       wrong_share(others, side, limit, error)))};
}

double allowed_wrong_share(double budget_share, double target_yield, double study_samples,
                           double candidates) {
  return budget_share *
         std::sqrt(target_yield * (1 - target_yield) / (study_samples * std::max(candidates, 1.0)));
}

}  // namespace cagetol
