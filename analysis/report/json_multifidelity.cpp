// What the runs of a cheap companion add to the study's means, deviations and yields.
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "analysis/fidelity/control_variate.hpp"
#include "analysis/fidelity/multifidelity.hpp"
#include "analysis/report/companion.hpp"
#include "analysis/report/json_parts.hpp"

namespace cagetol {
namespace {

/// A ratio of variances is known to 4 % from 2000 resamples; very many cheap runs take some
/// seconds.
int gain_resamples(std::size_t cheap_runs) {
  return static_cast<int>(std::clamp(1e8 / static_cast<double>(cheap_runs), 400.0, 2000.0));
}

double mean_wall_time(const StudyData& runs) {
  for (const Column& column : runs.timing)
    if (column.name == "wall_s" && !column.values.empty())
      return gsl_stats_mean(column.values.data(), 1, column.values.size());
  return kUndefined;
}

std::size_t pilot_pairs(const StudyData& runs) {
  const auto wanted = runs.plan.whole.value("fidelity_samples", 24.0);
  return std::min(runs.size(), static_cast<std::size_t>(std::max(wanted, 0.0)));
}

struct Helped {
  const std::vector<double>&expensive, &cheap;
  const std::vector<Limit>& limits;
  std::size_t pilot = 0;
  double cost = 0;  ///< of a cheap run over that of an expensive one
  std::uint64_t seed = 0;
};

/// Null where nothing can be said.
Json statistic_json(HelpedStatistic statistic, const Helped& helped) {
  const PairedRuns runs{helped.expensive, helped.cheap};
  const HelpedEstimate estimate = helped_estimate(statistic, runs, helped.limits);
  if (std::isnan(estimate.value)) return {};
  const std::vector<double> expensive(helped.expensive.begin(),
                                      helped.expensive.begin() + helped.pilot),
      cheap(helped.cheap.begin(), helped.cheap.begin() + helped.pilot);
  const double seen = helped_estimate(statistic, {expensive, cheap}, helped.limits).correlation;
  const double predicted = gain_at_cost(seen, static_cast<double>(runs.expensive.size()),
                                        static_cast<double>(runs.cheap.size()), helped.cost);
  const bool pays = predicted >= kLeastMultifidelityGain;
  const double achieved = pays ? resampled_gain(statistic, runs, helped.limits, helped.cost,
                                                helped.seed, gain_resamples(runs.cheap.size()))
                               : kUndefined;
  return {
      {"statistic", helped_statistic_name(statistic)},
      {"plain",
       {{"value", number(estimate.plain)}, {"standard_error", number(estimate.plain_error)}}},
      {"helped",
       {{"value", number(estimate.value)}, {"standard_error", number(estimate.standard_error)}}},
      {"correlation", number(estimate.correlation)},
      {"predicted_gain", number(predicted)},
      {"achieved_gain", number(achieved)},
      {"lost", estimate.lost}};
}

Json quantity_json(const ReportBasis& basis, const StudyData& companion, const Column& column,
                   double cost) {
  std::vector<Limit> limits;
  for (const Limit& limit : basis.runs.plan.limits)
    if (limit.quantity == column.name) limits.push_back(limit);
  const auto expensive = ok_values(basis.runs, column.values),
             cheap = ok_values(companion, find_quantity(companion, column.name)->values);
  const Helped helped{expensive, cheap,
                      limits,    pilot_pairs(basis.runs),
                      cost,      static_cast<std::uint64_t>(basis.runs.provenance.seed)};
  Json list = Json::array();
  for (const HelpedStatistic statistic :
       {HelpedStatistic::mean, HelpedStatistic::deviation, HelpedStatistic::yield}) {
    if (statistic == HelpedStatistic::yield && limits.empty()) continue;
    if (Json entry = statistic_json(statistic, helped); !entry.is_null())
      list.push_back(std::move(entry));
  }
  return {{"quantity", column.name},
          {"unit", column.unit},
          {"limited", !limits.empty()},
          {"statistics", std::move(list)}};
}

}  // namespace

Json multifidelity_json(const ReportBasis& basis, const StudyData* companion) {
  if (companion == nullptr) return {};
  Json json{{"companion", companion->provenance.study_name}};
  if (const std::string problem = companion_problem(basis.runs, *companion); !problem.empty()) {
    json["problem"] = problem;
    return json;
  }
  const double cost = mean_wall_time(*companion) / mean_wall_time(basis.runs);
  json["problem"] = Json();
  json["runs"] = basis.runs.size();
  json["companion_runs"] = companion->size();
  json["cost_ratio"] = number(cost);
  json["time_ratio"] = number(cost * static_cast<double>(companion->size()) /
                              static_cast<double>(basis.runs.size()));
  json["pilot_pairs"] = pilot_pairs(basis.runs);
  json["resamples"] = gain_resamples(companion->size());
  json["quantities"] = Json::array();
  for (const Column& column : basis.runs.quantities) {
    if (find_quantity(*companion, column.name) == nullptr) continue;
    Json entry = quantity_json(basis, *companion, column, cost);
    if (!entry["statistics"].empty()) json["quantities"].push_back(std::move(entry));
  }
  std::stable_sort(json["quantities"].begin(), json["quantities"].end(),
                   [](const Json& a, const Json& b) { return a["limited"] > b["limited"]; });
  return json;
}

}  // namespace cagetol
