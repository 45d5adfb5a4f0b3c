#include "analysis/report/assumption_runs.hpp"

#include <fstream>

namespace cagetol {
namespace {

bool belongs_to(const StudyData& attempt, const StudyData& runs) {
  const auto tolerances = [](const StudyData& study) {
    return study.plan.candidates.empty() ? std::vector<double>()
                                         : study.plan.candidates.front().tolerance_widths_mm;
  };
  return static_cast<std::int64_t>(runs.size()) >= runs.design.samples_planned &&
         runs.provenance.seed == attempt.provenance.seed &&
         runs.provenance.build == attempt.provenance.build &&
         tolerances(runs) == tolerances(attempt);
}

}  // namespace

std::optional<AssumptionPlan> stored_assumption_plan(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) return std::nullopt;
  try {
    return assumption_plan_of(nlohmann::ordered_json::parse(stream));
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::optional<AssumptionRuns> read_assumption_runs(const std::filesystem::path& directory,
                                                   const std::vector<StudyData>& confirmations) {
  auto plan = stored_assumption_plan(directory / kAssumptionsFile);
  if (!plan || plan->alternatives.empty()) return std::nullopt;
  AssumptionRuns all{*std::move(plan), {}, {}};
  const std::size_t attempt = all.plan.attempt;
  if (attempt == 0 || attempt > confirmations.size() || all.plan.runs == 0) return all;
  for (const AssumedValue& alternative : all.plan.alternatives) {
    const auto file = directory / alternative_directory(all.plan, alternative) / "study.h5";
    if (!std::filesystem::exists(file)) continue;
    StudyData runs = read_study_data(file);
    if (!belongs_to(confirmations[attempt - 1], runs)) continue;
    all.alternatives.push_back(alternative);
    all.runs.push_back(std::move(runs));
  }
  return all;
}

}  // namespace cagetol
