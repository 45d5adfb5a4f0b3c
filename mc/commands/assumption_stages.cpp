#include "mc/commands/assumption_stages.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "analysis/report/assumption_runs.hpp"
#include "analysis/tolerance/assumption_plan.hpp"
#include "analysis/tolerance/assumption_verdict.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/stage_study.hpp"
#include "mc/host/file_write.hpp"
#include "mc/study/assumption_ranges.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "mc/sweep/adopted_runs.hpp"
#include "mc/sweep/sweep_directory.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;

double one_nominal(const std::vector<double>& nominal) {
  const bool alike = std::all_of(nominal.begin(), nominal.end(),
                                 [&](double value) { return value == nominal.front(); });
  return alike ? nominal.front() : kUndefined;
}

AssumptionPlan plan_assumptions(const Study& base, const std::vector<Alternative>& alternatives,
                                const Campaign& campaign, const CampaignPlan& plan) {
  const ConfirmationRules rules{base.tolerance.target_yield, base.tolerance.confidence,
                                plan.error_shares};
  AssumptionPlan assumptions;
  assumptions.confirming = confirming_runs(0, rules);
  assumptions.seconds_per_run = plan.seconds_per_run / plan.processes;
  for (const Alternative& each : alternatives)
    assumptions.alternatives.push_back({each.key, each.unit, each.note, each.low, each.high,
                                        each.value, one_nominal(each.nominal)});
  if (campaign.attempts.empty()) return assumptions;
  std::vector<Confirmation> judged;
  for (const Attempt& attempt : campaign.attempts) judged.push_back(attempt.confirmation);
  assumptions.attempt = 1 + surest_attempt(judged);
  const Confirmation& attempt = judged[assumptions.attempt - 1];
  const double confidence = attempt_confidence(rules);
  const auto count = static_cast<double>(std::max<std::size_t>(alternatives.size(), 1));
  assumptions.settling = settling_runs(attempt.yield.if_unknown_fail, rules.target_yield,
                                       confidence, 1 - (1 - confidence) / count);
  const double wanted = base.recommend.assumption_samples;
  assumptions.runs = std::isnan(wanted) ? automatic_runs(assumptions)
                                        : static_cast<std::size_t>(std::ceil(wanted));
  return assumptions;
}

/// The cages and starts of the attempt with another value of the key.
Study alternative_study(const Study& attempt, const Alternative& alternative, std::size_t runs) {
  return changed_study(attempt, [&](Study& study) {
    study.name += fmt::format(", {} = {}", alternative.key, alternative.value);
    study.samples = static_cast<long>(runs);
    apply_alternative(alternative, study);
  });
}

/// Takes over what was run of this alternative with another number of runs.
void adopt_other_numbers(const Study& study, const std::string& directory,
                         const AssumptionPlan& plan, const AssumedValue& alternative) {
  const fs::path folder = fs::path(directory) / alternative_directory(plan, alternative);
  if (fs::exists(folder)) return;
  const std::string attempt = fmt::format("assume-{}-", plan.attempt);
  auto others = sweeps_like(directory, attempt, folder.filename());
  for (const fs::path& earlier :
       sweeps_like(fs::path(directory) / kEarlierFolder, attempt, folder.filename()))
    others.push_back(earlier);
  adopt_any(study, folder, others);
}

/// Whether this directory holds the plan's alternatives already, judged by an earlier command.
bool judged_before(const AssumptionPlan& plan, const std::string& file) {
  const auto stored = stored_assumption_plan(file);
  return stored && stored->runs > 0 && stored->attempt == plan.attempt &&
         to_json(*stored).at("alternatives") == to_json(plan).at("alternatives");
}

}  // namespace

int run_assumptions(const Study& base, const std::string& directory, const Campaign& campaign,
                    const CampaignPlan& plan, StagedSweeps& stages) {
  const auto alternatives = alternatives_of(base);
  const AssumptionPlan assumptions = plan_assumptions(base, alternatives, campaign, plan);
  const std::string file = directory + "/" + kAssumptionsFile;
  if (assumptions.runs == 0 && judged_before(assumptions, file)) return kDone;
  replace_file(file, to_json(assumptions).dump(1) + "\n");
  if (const std::string text = assumption_plan_text(assumptions); !text.empty())
    spdlog::info("{}", text);
  if (assumptions.runs == 0) return kDone;
  const auto& widths = campaign.attempts[assumptions.attempt - 1].recommendation.tolerances;
  const Study attempt = stage_study(base, {fmt::format("confirm-{}", assumptions.attempt),
                                           assumptions.runs, widths, plan.error_shares});
  for (std::size_t k = 0; k < alternatives.size(); ++k) {
    const AssumedValue& assumed = assumptions.alternatives[k];
    const Study study = alternative_study(attempt, alternatives[k], assumptions.runs);
    adopt_other_numbers(study, directory, assumptions, assumed);
    const int code =
        stages.sweep(study, directory + "/" + alternative_directory(assumptions, assumed));
    if (code != kDone) return code;
  }
  return kDone;
}

}  // namespace cagetol
