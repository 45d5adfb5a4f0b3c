// Outcomes, limits, failures, worst samples.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analysis/report/json_parts.hpp"
#include "analysis/tolerance/campaign.hpp"
#include "analysis/tolerance/limit_margin.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kWorstSamples = 5;
constexpr std::array kStatuses = {RunStatus::ok,       RunStatus::jammed,  RunStatus::failed,
                                  RunStatus::censored, RunStatus::not_run, RunStatus::poisoned};

std::string replay_command(const ReportBasis& basis, std::int64_t id) {
  return fmt::format("cagetol replay {} --sample {}", basis.directory, id);
}

}  // namespace

std::string limit_text(const Limit& limit, const std::string& unit) {
  const std::string suffix = unit.empty() || unit == "-" ? "" : " " + unit;
  std::string text;
  if (limit.minimum) text += fmt::format("at least {:.4g}{}", *limit.minimum, suffix);
  if (limit.minimum && limit.maximum) text += " and ";
  if (limit.maximum) text += fmt::format("at most {:.4g}{}", *limit.maximum, suffix);
  return text;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json to_json(const Estimate& estimate) {
  return {{"value", number(estimate.value)},
          {"lower", number(estimate.lower)},
          {"upper", number(estimate.upper)}};
}

Json to_json(const Yield& yield) {
  return {{"runs", yield.runs},
          {"effective_runs", yield.ess},
          {"missing_runs", yield.missing_runs},
          {"unknown_runs", yield.unknown_runs},
          {"if_unknown_fail", number(yield.if_unknown_fail)},
          {"if_unknown_pass", number(yield.if_unknown_pass)},
          {"lower_bound", number(yield.lower_bound)},
          {"upper_bound", number(yield.upper_bound)},
          {"fits", yield.fits},
          {"method", yield.method}};
}

/// How the runs that miss are spread over lots of several cages; null where each has one.
Json lots_json(const ReportBasis& basis) {
  std::vector<double> runs(basis.resampling.lots()), misses = runs, share = runs;
  for (std::size_t i = 0; i < basis.joint.size(); ++i) {
    const std::size_t lot = basis.resampling.lot_of()[i];
    ++runs[lot];
    misses[lot] += basis.joint[i] != Judgement::meets;
    share[lot] = misses[lot] / runs[lot];
  }
  if (!(basis.study.plan.cages_per_lot > 1) || runs.empty()) return nullptr;
  std::sort(share.begin(), share.end());
  return {
      {"lots", runs.size()},
      {"misses", std::accumulate(misses.begin(), misses.end(), 0.0)},
      {"with_misses", std::count_if(share.begin(), share.end(), [](double s) { return s > 0; })},
      {"median_yield", 1 - share[share.size() / 2]},
      {"yield_of_the_worst_twentieth", 1 - share[(share.size() - 1) * 19 / 20]},
      {"worst_yield", 1 - share.back()}};
}

Json outcomes_json(const ReportBasis& basis) {
  Json outcomes;
  outcomes["samples"] = basis.study.size();
  outcomes["samples_planned"] = basis.study.design.samples_planned;
  outcomes["rows"] = basis.runs.size();
  outcomes["rows_planned"] = basis.study.design.rows_planned;
  outcomes["noise_repeats"] = std::count_if(
      basis.study.replicate.begin(), basis.study.replicate.end(), [](auto k) { return k > 0; });
  outcomes["redraw_jams"] = basis.study.plan.redraw_jams;
  outcomes["lots"] = lots_json(basis);
  Json counts = Json::array();
  for (const RunStatus status : kStatuses) {
    const auto count = std::count(basis.study.status.begin(), basis.study.status.end(), status);
    const auto rows = std::count(basis.runs.status.begin(), basis.runs.status.end(), status);
    counts.push_back({{"status", run_status_name(status)}, {"samples", count}, {"rows", rows}});
  }
  outcomes["counts"] = counts;
  const auto lost = static_cast<double>(count_lost(basis.study).lost);
  outcomes["failed_share"] =
      basis.study.size() > 0 ? lost / static_cast<double>(basis.study.size()) : 0.0;
  outcomes["allowed_failure_share"] = basis.study.plan.allowed_failure_share;
  outcomes["windows_cut"] = 0;
  for (const Column& column : basis.study.run)
    if (column.name == "windows_cut")
      outcomes["windows_cut"] = std::count_if(column.values.begin(), column.values.end(),
                                              [](double windows) { return windows > 0; });
  const auto ok = static_cast<double>(
      std::count(basis.runs.status.begin(), basis.runs.status.end(), RunStatus::ok));
  outcomes["success_share"] =
      basis.runs.size() > 0 ? ok / static_cast<double>(basis.runs.size()) : 0.0;
  return outcomes;
}

Json limits_json(const ReportBasis& basis) {
  const std::vector<double> equal(basis.runs.size(), 1.0);
  Json limits;
  Json single = Json::array();
  for (const Limit& limit : basis.study.plan.limits) {
    const Column* column = find_quantity(basis.runs, limit.quantity);
    const std::string unit = column == nullptr ? "" : column->unit;
    const Yield yield = estimate_yield(basis.runs, judge(basis.runs, limit), equal,
                                       basis.resampling, basis.confidence);
    Json entry{{"quantity", limit.quantity},
               {"unit", unit},
               {"minimum", limit.minimum ? Json(*limit.minimum) : Json()},
               {"maximum", limit.maximum ? Json(*limit.maximum) : Json()},
               {"text", limit_text(limit, unit)},
               {"source", limit.source},
               {"cage_revolutions", limit.cage_revolutions},
               {"yield", to_json(yield)}};
    if (column == nullptr)
      entry["note"] = "the study has no such quantity: this limit cannot be judged";
    single.push_back(std::move(entry));
  }
  limits["each"] = single;
  limits["joint"] =
      to_json(estimate_yield(basis.runs, basis.joint, equal, basis.resampling, basis.confidence));
  return limits;
}

Json failures_json(const ReportBasis& basis) {
  Json list = Json::array();
  const StudyData& study = basis.study;
  for (std::size_t i = 0; i < study.size(); ++i) {
    if (study.status[i] == RunStatus::ok) continue;
    list.push_back(
        {{"id", study.id[i]},
         {"status", run_status_name(study.status[i])},
         {"reason", study.reason[i]},
         {"pocket", study.pocket[i] >= 0 ? Json(study.pocket[i]) : Json()},
         {"interference_um", study.pocket[i] >= 0 ? number(study.interference_um[i]) : Json()},
         {"replay", replay_command(basis, study.id[i])}});
  }
  return {{"samples", list}};
}

Json worst_samples_json(const ReportBasis& basis) {
  Json worst = Json::array();
  const StudyData& runs = basis.runs;
  for (const Limit& limit : basis.study.plan.limits) {
    const Column* column = find_quantity(runs, limit.quantity);
    if (column == nullptr || (!limit.maximum && !limit.minimum)) continue;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (!std::isnan(column->values[i])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return margin_of(limit, column->values[a]) < margin_of(limit, column->values[b]);
    });
    order.resize(std::min(order.size(), kWorstSamples));
    for (const std::size_t i : order)
      worst.push_back({{"quantity", limit.quantity},
                       {"unit", column->unit},
                       {"id", runs.id[i]},
                       {"value", column->values[i]},
                       {"meets_limit", margin_of(limit, column->values[i]) >= 0},
                       {"limit", limit_text(limit, column->unit)},
                       {"replay", replay_command(basis, runs.id[i])}});
  }
  return worst;
}

}  // namespace cagetol
