#include "analysis/sensitivity/rank_shares.hpp"

#include <cmath>

#include "analysis/statistics/order_statistics.hpp"
#include "analysis/study/estimate.hpp"
#include "analysis/study/refused.hpp"

namespace cagetol {

double rank_share(const StudyDesign& design, std::span<const double> feature,
                  std::span<const double> output) {
  if (design.kind != "random")
    throw Refused("the rank estimator is refused on a `" + design.kind +
                  "` design: it needs independent rows, and fails on scrambled Sobol' points at "
                  "any number of runs");
  std::vector<double> in_order;
  for (const std::size_t i : ascending_order(feature))
    if (!std::isnan(output[i])) in_order.push_back(output[i]);
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
