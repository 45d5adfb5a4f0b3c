#include "analysis/sensitivity/rank_shares.hpp"

#include <cmath>

#include "analysis/statistics/order_statistics.hpp"
#include "analysis/statistics/resampling.hpp"
#include "analysis/study/estimate.hpp"
#include "analysis/study/refused.hpp"

namespace cagetol {

double rank_share(const StudyData& runs, std::span<const double> feature,
                  std::span<const double> output) {
  require_independent_runs(runs, "the rank estimator");
  std::vector<double> in_order;
  double before = kUndefined;
  for (const std::size_t i : ascending_order(feature)) {
    if (std::isnan(output[i])) continue;
    if (feature[i] == before) throw Refused("the rank estimator refused: equal values");
    before = feature[i];
    in_order.push_back(output[i]);
  }
  const auto count = static_cast<double>(in_order.size());
  if (in_order.size() < 2) return kUndefined;
  double mean = 0;
  for (const double y : in_order) mean += y / count;
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < in_order.size(); ++i) {
    const double y = in_order[i] - mean;
    products += y * (in_order[(i + 1) % in_order.size()] - mean);
    squares += y * y;
  }
  return squares > 0 ? products / squares : kUndefined;
}

}  // namespace cagetol
