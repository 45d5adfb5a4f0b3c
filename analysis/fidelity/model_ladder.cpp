#include "analysis/fidelity/model_ladder.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

std::vector<double> wall_times(const StudyData& runs) {
  for (const Column& column : runs.timing)
    if (column.name == "wall_s") return ok_values(runs, column.values);
  return std::vector<double>(runs.size(), kUndefined);
}

double median_ratio(const std::vector<double>& times, const std::vector<double>& reference) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < times.size(); ++k)
    if (std::isfinite(times[k] / reference[k])) ratios.push_back(times[k] / reference[k]);
  return ratios.empty() ? kUndefined : gsl_stats_median(ratios.data(), 1, ratios.size());
}

std::vector<Limit> limits_on(const std::string& quantity, const StudyPlan& plan) {
  std::vector<Limit> limits;
  for (const Limit& limit : plan.limits)
    if (limit.quantity == quantity) limits.push_back(limit);
  return limits;
}

}  // namespace

ModelLadder make_model_ladder(std::vector<LadderRung> rungs, const std::vector<StudyData>& runs,
                              const LadderRule& rule) {
  const StudyData& reference = runs.back();
  ModelLadder ladder;
  ladder.study = reference.plan.name;
  ladder.rule = rule;
  ladder.rule.target_yield = reference.plan.target_yield;
  ladder.rule.candidates =
      static_cast<double>(std::max<std::size_t>(reference.plan.candidates.size(), 1));
  ladder.samples = reference.size();
  ladder.rungs = std::move(rungs);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (runs[r].id != reference.id)
      throw StudyFileError("rung " + ladder.rungs[r].name,
                           "its runs are not those of the other rungs",
                           "remove its directory and start again");
    ladder.rungs[r].cost_ratio = median_ratio(wall_times(runs[r]), wall_times(reference));
    ladder.rungs[r].ok = static_cast<std::size_t>(
        std::count(runs[r].status.begin(), runs[r].status.end(), RunStatus::ok));
  }
  for (const Column& column : reference.quantities) {
    std::vector<std::vector<double>> values;
    for (const StudyData& rung : runs)
      values.push_back(ok_values(rung, find_quantity(rung, column.name)->values));
    auto limits = limits_on(column.name, reference.plan);
    const QuantityLadder judged = minimum_rung(values, ladder.rule, limits);
    ladder.quantities.push_back({column.name, column.unit, std::move(limits), judged});
  }
  return ladder;
}

std::size_t chosen_rung(const ModelLadder& ladder) {
  std::vector<QuantityLadder> limited;
  for (const LadderQuantity& quantity : ladder.quantities)
    if (quantity.limited()) limited.push_back(quantity.ladder);
  return limited.empty() ? ladder.rungs.size() - 1 : minimum_rung_for_all(limited);
}

}  // namespace cagetol
