// Statistics of every quantity, capability, convergence, run health.

#include <algorithm>
#include <cmath>

#include "analysis/report/json_parts.hpp"
#include "analysis/sensitivity/noise_share.hpp"
#include "analysis/statistics/capability.hpp"
#include "analysis/statistics/order_statistics.hpp"
#include "analysis/statistics/summary.hpp"
#include "analysis/statistics/value_histogram.hpp"

namespace cagetol {
namespace {

/// Precision asked for: half width of the interval relative to the value.
constexpr double kMeanPrecision = 0.02, kQuantilePrecision = 0.05;
constexpr std::size_t kFewestForLook = 32;
constexpr std::size_t kResamplesOfLook = 300;

const Limit* limit_of(const StudyPlan& plan, const std::string& quantity) {
  for (const Limit& limit : plan.limits)
    if (limit.quantity == quantity) return &limit;
  return nullptr;
}

/// Scatter that is none.
constexpr double kRounding = 1e-9;

/// Labels and checks of a run, no amounts that anything contributes to.
bool is_bookkeeping(const std::string& quantity) {
  for (const char* end : {"_station", "_pocket", "_class"})
    if (quantity.ends_with(end)) return true;
  return quantity == "static_consistency_error";
}

Json histogram_json(std::span<const double> values) {
  const ValueHistogram histogram = value_histogram(values);
  return {{"edges", histogram.edges}, {"counts", histogram.counts}};
}

Json summary_json(const Summary& summary) {
  Json quantiles = Json::array();
  for (std::size_t q = 0; q < summary.quantiles.size(); ++q) {
    Json entry = to_json(summary.quantiles[q]);
    entry["level"] = kQuantileLevels[q];
    quantiles.push_back(std::move(entry));
  }
  return {{"runs_with_value", summary.defined},
          {"smallest", number(summary.smallest)},
          {"largest", number(summary.largest)},
          {"mean", to_json(summary.mean)},
          {"standard_error_of_mean", number(summary.standard_error)},
          {"standard_deviation", to_json(summary.standard_deviation)},
          {"quantiles", quantiles},
          {"bound_of_95_quantile", number(summary.bound_95)},
          {"bound_refused", summary.bound_95_refused}};
}

double half_width(const Estimate& estimate) {
  return 0.5 * (estimate.upper - estimate.lower);
}

/// Runs until the half width has shrunk to `target`, which it does with the square root of the
/// runs.
double runs_needed(double runs, double half, double target) {
  if (!(target > 0) || std::isnan(half)) return kUndefined;
  return std::max(std::ceil(runs * (half / target) * (half / target)), runs);
}

Json look_json(const ReportBasis& basis, const StudyData& results, std::size_t count) {
  std::vector<std::size_t> keep(count);
  for (std::size_t i = 0; i < count; ++i) keep[i] = i;
  const StudyData part = select_samples(results, keep);
  const Resampling resampling(part, kResamplesOfLook);
  const std::vector<double> equal(count, 1.0);
  Json look{{"runs", count}};
  look["yield"] =
      to_json(estimate_yield(part, judge_all(part), equal, resampling, basis.confidence));
  Json quantiles = Json::object();
  for (const Limit& limit : part.plan.limits) {
    const Column* column = find_quantity(part, limit.quantity);
    if (column == nullptr) continue;
    const auto order = ascending_order(column->values);
    quantiles[limit.quantity] = to_json(resampling.estimate(
        [&](std::span<const double> w) {
          return weighted_quantile(column->values, order, w, 0.95);
        },
        basis.confidence));
  }
  look["quantile_95"] = quantiles;
  return look;
}

}  // namespace

Json quantities_json(const ReportBasis& basis) {
  Json list = Json::array();
  for (const Column& column : basis.runs.quantities) {
    const Summary summary =
        summarise(basis.runs, column.values, basis.resampling, basis.confidence);
    const NoiseShare noise =
        noise_share(basis.study, find_quantity(basis.study, column.name)->values, basis.confidence);
    const Limit* limit = limit_of(basis.study.plan, column.name);
    Json entry{
        {"quantity", column.name}, {"unit", column.unit}, {"definition", column.description}};
    entry["limit"] = limit == nullptr
                         ? Json()
                         : Json{{"minimum", limit->minimum ? Json(*limit->minimum) : Json()},
                                {"maximum", limit->maximum ? Json(*limit->maximum) : Json()}};
    entry["bookkeeping"] = is_bookkeeping(column.name);
    entry["constant"] = summary.largest - summary.smallest <=
                        kRounding * std::max(std::abs(summary.largest), std::abs(summary.smallest));
    entry["statistics"] = summary_json(summary);
    entry["noise"] = {{"share", to_json(noise.share)},
                      {"standard_deviation", number(noise.standard_deviation)}};
    entry["histogram"] = histogram_json(column.values);
    list.push_back(std::move(entry));
  }
  return list;
}

Json capability_json(const ReportBasis& basis) {
  Json list = Json::array();
  if (!rows_follow_laws(basis.runs)) return list;
  for (const Limit& limit : basis.study.plan.limits) {
    const Column* column = find_quantity(basis.runs, limit.quantity);
    if (column == nullptr) continue;
    const ProcessCapability result = process_capability(
        column->values, limit.minimum, limit.maximum, basis.resampling, basis.confidence);
    double outside = 0;
    for (const Judgement judgement : judge(basis.runs, limit))
      outside += judgement == Judgement::misses;
    const std::vector<double> equal(basis.runs.size(), 1.0);
    const Yield yield = estimate_yield(basis.runs, judge(basis.runs, limit), equal,
                                       basis.resampling, basis.confidence);
    list.push_back({{"quantity", limit.quantity},
                    {"runs_with_value", result.defined},
                    {"cp", to_json(result.cp)},
                    {"cpk", to_json(result.cpk)},
                    {"pp", to_json(result.pp)},
                    {"ppk", to_json(result.ppk)},
                    {"percentile_refused", result.percentile_refused},
                    {"outside_ppm", 1e6 * outside / std::max(yield.runs, 1.0)},
                    {"outside_ppm_lower", 1e6 * (1 - yield.upper_bound)},
                    {"outside_ppm_upper", 1e6 * (1 - yield.lower_bound)}});
  }
  return list;
}

Json convergence_json(const ReportBasis& basis) {
  const auto runs = static_cast<double>(basis.runs.size());
  Json rows = Json::array();
  const auto add = [&](const std::string& name, const std::string& statistic, double value,
                       double half, double target) {
    rows.push_back({{"quantity", name},
                    {"statistic", statistic},
                    {"value", number(value)},
                    {"half_width", number(half)},
                    {"target_half_width", number(target)},
                    {"runs_needed", number(runs_needed(runs, half, target))},
                    {"runs_still_needed", number(runs_needed(runs, half, target) - runs)}});
  };
  const std::vector<double> equal(basis.runs.size(), 1.0);
  if (!basis.study.plan.limits.empty() && rows_follow_laws(basis.runs)) {
    const Yield joint =
        estimate_yield(basis.runs, basis.joint, equal, basis.resampling, basis.confidence);
    const double half = std::max(joint.if_unknown_fail - joint.lower_bound,
                                 joint.upper_bound - joint.if_unknown_pass);
    add("joint yield", "yield", joint.if_unknown_fail, half,
        0.5 * (1 - basis.study.plan.target_yield));
  }
  for (const Column& column : basis.runs.quantities) {
    const bool limited = limit_of(basis.study.plan, column.name) != nullptr;
    if (!limited && !basis.study.plan.limits.empty()) continue;
    const Summary summary =
        summarise(basis.runs, column.values, basis.resampling, basis.confidence);
    if (summary.defined < 2) continue;
    add(column.name, "mean", summary.mean.value, half_width(summary.mean),
        kMeanPrecision * std::abs(summary.mean.value));
    const Estimate& high = summary.quantiles[5];
    add(column.name, "95 % quantile", high.value, half_width(high),
        kQuantilePrecision * std::abs(high.value));
  }
  Json limiting;
  for (const Json& row : rows)
    if (row["runs_needed"].is_number() &&
        (limiting.is_null() || row["runs_needed"] > limiting["runs_needed"]))
      limiting = row;
  Json looks = Json::array();
  std::vector<std::size_t> counts;
  for (std::size_t count = basis.runs.size(); count >= kFewestForLook; count /= 2)
    counts.push_back(count);
  std::reverse(counts.begin(), counts.end());
  const StudyData results = results_of(basis.runs);
  for (const std::size_t count : counts) looks.push_back(look_json(basis, results, count));
  return {{"rows", rows},
          {"limiting", limiting},
          {"mean_precision", kMeanPrecision},
          {"quantile_precision", kQuantilePrecision},
          {"looks", looks}};
}

Json health_json(const ReportBasis& basis) {
  Json list = Json::array();
  const auto add = [&](const Column& column) {
    const auto order = ascending_order(column.values);
    if (order.empty()) return;
    const std::vector<double> equal(column.values.size(), 1.0);
    const auto at = [&](double p) {
      return number(weighted_quantile(column.values, order, equal, p));
    };
    list.push_back({{"field", column.name},
                    {"unit", column.unit},
                    {"definition", column.description},
                    {"runs_with_value", order.size()},
                    {"smallest", number(column.values[order.front()])},
                    {"median", at(0.5)},
                    {"quantile_95", at(0.95)},
                    {"largest", number(column.values[order.back()])},
                    {"histogram", histogram_json(column.values)}});
  };
  for (const Column& column : basis.runs.run) add(column);
  return list;
}

}  // namespace cagetol
