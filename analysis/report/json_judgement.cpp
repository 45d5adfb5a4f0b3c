// Runs judged by other limits, target or confidence than their study's.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/report/json_parts.hpp"
#include "analysis/statistics/order_statistics.hpp"

namespace cagetol {
namespace {

/// Resamples that keep the curves of fifty candidates within a second.
constexpr std::size_t kResamples = 50;
constexpr std::size_t kSteps = 20;

std::vector<std::string> stated(const StudyPlan& plan, const StudyData& units) {
  std::vector<std::string> list;
  for (const Limit& limit : plan.limits) {
    const Column* column = find_quantity(units, limit.quantity);
    list.push_back(limit.quantity + " " + limit_text(limit, column ? column->unit : ""));
  }
  list.push_back(fmt::format("target {:.6g} %", 100 * plan.target_yield));
  list.push_back(fmt::format("confidence {:.6g} %", 100 * plan.confidence));
  return list;
}

std::string only_in(const std::vector<std::string>& list, const std::vector<std::string>& other) {
  std::string text;
  for (const std::string& each : list)
    if (std::find(other.begin(), other.end(), each) == other.end())
      text += (text.empty() ? "" : ", ") + each;
  return text;
}

/// The bound, and quantiles of the runs from the smallest to the largest.
std::vector<double> values_of(const StudyData& runs, const Limit& limit, double bound) {
  std::vector<double> values = {bound};
  const Column* column = find_quantity(runs, limit.quantity);
  const auto known = column ? ok_values(runs, column->values) : std::vector<double>();
  const auto order = ascending_order(known);
  for (std::size_t step = 0; step <= kSteps && !order.empty(); ++step)
    values.push_back(known[order[(order.size() - 1) * step / kSteps]]);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace

std::string judgement_text(const StudyData& study) {
  const auto before = stated(read_study_plan(study.plan.whole.dump(), ""), study),
             now = stated(study.plan, study);
  return fmt::format("Judged by what was stated after the runs: {} in place of {}.",
                     only_in(now, before),
                     only_in(before, now).empty() ? "no limit" : only_in(before, now));
}

std::string judgement_settings(const StudyPlan& plan) {
  std::string limits;
  for (const Limit& limit : plan.limits) {
    std::string source = Json(limit.source).dump();
    std::erase(source, '\'');
    limits += fmt::format("{}{{quantity=\"{}\"", limits.empty() ? "" : ", ", limit.quantity);
    if (limit.minimum) limits += fmt::format(", min={}", *limit.minimum);
    if (limit.maximum) limits += fmt::format(", max={}", *limit.maximum);
    limits += fmt::format(", source={}, cage_revolutions={}}}", source, limit.cage_revolutions);
  }
  return fmt::format(
      " --set 'limit=[{}]' --set tolerance.target_yield={} --set tolerance.confidence={}", limits,
      plan.target_yield, plan.confidence);
}

Json limit_curves_json(const StudyData& study) {
  const StudyData runs = select_samples(study, first_runs(study));
  const StudyPlan& plan = runs.plan;
  const Resampling resampling(runs, kResamples);
  const bool mixed = !plan.candidates.empty() && rows_follow_laws(runs);
  const MixtureWeights mixture = mixed ? mixture_weights(runs) : MixtureWeights{};
  const std::vector<double> equal(runs.size(), 1.0);
  const auto yields_by = [&](const std::vector<Judgement>& joint) {
    return mixed ? yield_curves(runs, mixture, joint, resampling, plan.confidence).candidates
                 : std::vector{estimate_yield(runs, joint, equal, resampling, plan.confidence)};
  };
  Json list = Json::array();
  StudyData judged = results_of(runs);
  for (Limit& limit : judged.plan.limits)
    for (auto* side : {&limit.minimum, &limit.maximum}) {
      if (!*side) continue;
      const double bound = **side;
      const auto values = values_of(runs, limit, bound);
      Json candidates = Json::array();
      for (const double value : values) {
        *side = value;
        const auto yields = yields_by(judge_all(judged));
        for (std::size_t k = 0; k < yields.size(); ++k) {
          Json& entry = candidates[k];
          entry["name"] = mixed ? candidate_name(runs, plan.candidates[k]) : "all runs";
          entry["effective_runs"] = yields[k].ess;
          entry["shown"] = yields[k].ess >= kMinimumEffectiveRuns;
          entry["if_unknown_fail"].push_back(number(yields[k].if_unknown_fail));
          entry["if_unknown_pass"].push_back(number(yields[k].if_unknown_pass));
          entry["lower_bound"].push_back(number(yields[k].lower_bound));
          entry["upper_bound"].push_back(number(yields[k].upper_bound));
        }
      }
      *side = bound;
      const Column* column = find_quantity(runs, limit.quantity);
      list.push_back({{"quantity", limit.quantity},
                      {"unit", column ? column->unit : ""},
                      {"side", side == &limit.maximum ? "max" : "min"},
                      {"bound", bound},
                      {"values", values},
                      {"candidates", std::move(candidates)}});
    }
  return list;
}

}  // namespace cagetol
