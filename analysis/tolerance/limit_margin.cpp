#include "analysis/tolerance/limit_margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/statistics/binomial_bounds.hpp"
#include "analysis/statistics/order_statistics.hpp"
#include "analysis/study/estimate.hpp"
#include "analysis/study/judgement.hpp"

namespace cagetol {
namespace {

/// The limit with more room, or less where `by` is negative.
Limit moved(Limit limit, double by) {
  if (limit.maximum) *limit.maximum += by;
  if (limit.minimum) *limit.minimum -= by;
  return limit;
}

double missed_share(const StudyData& runs, const Limit& limit, std::size_t judged) {
  const auto judgements = judge(runs, limit);
  double missed = 0;
  for (std::size_t i = 0; i < runs.size(); ++i)
    missed += runs.status[i] == RunStatus::ok && judgements[i] == Judgement::misses;
  return missed / static_cast<double>(judged);
}

LimitRole role_of(const StudyData& runs, const LimitMargin& m) {
  const bool biased = m.judged > 0 && m.model_error > 0;
  for (const double by : {-m.model_error, m.model_error}) {
    if (!biased) break;
    const double share = missed_share(runs, moved(m.limit, by), m.judged);
    if (share < m.missed_lower || share > m.missed_upper) return LimitRole::within_model_error;
  }
  if (m.missed > 0) return m.alone > 0 ? LimitRole::decides : LimitRole::follows;
  return m.judged >= m.runs_needed ? LimitRole::met : LimitRole::open;
}

/// Values of the limited quantity: median and extreme with their margins.
void measure(const StudyData& runs, LimitMargin& m) {
  m.median = m.median_margin = m.extreme = m.extreme_margin = kUndefined;
  const Column* column = find_quantity(runs, m.limit.quantity);
  if (column == nullptr) return;
  const std::vector<double> values = ok_values(runs, column->values);
  const auto order = ascending_order(values);
  if (order.empty()) return;
  m.median = weighted_quantile(values, order, std::vector<double>(values.size(), 1), 0.5);
  m.median_margin = margin_of(m.limit, m.median);
  m.extreme = values[*std::min_element(order.begin(), order.end(), [&](auto a, auto b) {
    return margin_of(m.limit, values[a]) < margin_of(m.limit, values[b]);
  })];
  m.extreme_margin = margin_of(m.limit, m.extreme);
}

}  // namespace

double margin_of(const Limit& limit, double value) {
  const auto scaled = [](double room, double bound) {
    return bound == 0 ? room : room / std::abs(bound);
  };
  double margin = std::numeric_limits<double>::infinity();
  if (limit.maximum) margin = std::min(margin, scaled(*limit.maximum - value, *limit.maximum));
  if (limit.minimum) margin = std::min(margin, scaled(value - *limit.minimum, *limit.minimum));
  return margin;
}

std::size_t runs_without_miss(double confidence, double target_yield) {
  return static_cast<std::size_t>(
      std::ceil(std::log(1 - confidence) / std::log(target_yield) - 1e-9));
}

const char* limit_role_name(LimitRole role) {
  constexpr const char* kNames[] = {"decides", "follows other limits", "met by enough runs", "open",
                                    "within the model's error"};
  return kNames[static_cast<int>(role)];
}

std::vector<LimitMargin> limit_margins(const StudyData& runs,
                                       const std::vector<double>& model_errors) {
  const StudyPlan& plan = runs.plan;
  std::vector<std::vector<Judgement>> judgements;
  std::vector<int> misses(runs.size(), 0);  // limits that a run misses
  for (const Limit& limit : plan.limits) {
    judgements.push_back(judge(runs, limit));
    for (std::size_t i = 0; i < runs.size(); ++i)
      misses[i] += judgements.back()[i] == Judgement::misses;
  }
  std::vector<LimitMargin> margins;
  const double tail = (1 - plan.confidence) / 2;
  for (std::size_t k = 0; k < plan.limits.size(); ++k) {
    LimitMargin m{.limit = plan.limits[k]};
    measure(runs, m);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (runs.status[i] == RunStatus::jammed) continue;
      const Judgement judged = judgements[k][i];
      m.unknown += judged == Judgement::unknown;
      m.judged += judged != Judgement::unknown;
      m.missed += judged == Judgement::misses;
      m.alone += judged == Judgement::misses && misses[i] == 1;
    }
    const auto missed = static_cast<double>(m.missed), judged = static_cast<double>(m.judged);
    m.missed_lower = clopper_pearson_lower(missed, judged, 1 - tail);
    m.missed_upper = clopper_pearson_upper(missed, judged, 1 - tail);
    m.model_error = k < model_errors.size() ? model_errors[k] : kUndefined;
    m.runs_needed = runs_without_miss(plan.confidence, plan.target_yield);
    m.role = role_of(runs, m);
    margins.push_back(m);
  }
  return margins;
}

}  // namespace cagetol
