#include "analysis/tolerance/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {
namespace {

Tolerance tolerance_of(const StudyPlan& plan, const Recommendation& recommendation) {
  Tolerance chosen{{}, plan.candidates[recommendation.candidate].all_shifts()};
  for (const RecommendedTolerance& tolerance : recommendation.tolerances)
    chosen.tolerance_widths_mm.push_back(tolerance.tolerance_width_mm);
  return chosen;
}

}  // namespace

LostRuns& LostRuns::operator+=(const LostRuns& other) {
  lost += other.lost;
  runs += other.runs;
  return *this;
}

double LostRuns::minimum_share() const {
  return clopper_pearson_lower(static_cast<double>(lost), static_cast<double>(runs), kConfidence);
}

LostRuns count_lost(const StudyData& runs) {
  const auto lost = std::count_if(runs.status.begin(), runs.status.end(), [](RunStatus status) {
    return status == RunStatus::failed || status == RunStatus::censored ||
           status == RunStatus::poisoned;
  });
  return {static_cast<std::size_t>(lost), runs.size()};
}

Campaign run_campaign(const Stage& pilot,
                      const std::function<CampaignPlan(const StudyData& pilot)>& plan,
                      const RunStage& run_stage, const KeepPlan& keep) {
  Campaign campaign;
  const auto piloted = run_stage(pilot);
  if (!piloted) return campaign;
  CampaignPlan planned = plan(*piloted);
  std::optional<MixtureStudy> mixture;
  const auto mix = [&] {
    const auto runs = run_stage({"mixture", planned.mixture_rows, {}});
    mixture.reset();
    if (runs) mixture.emplace(study_mixture(*runs));
    return mixture.has_value();
  };
  if (!mix()) return campaign;
  std::vector<Tried> tried;
  for (std::size_t number = 0;; ++number) {
    if (number == planned.attempts.size()) {
      auto chosen = choose_attempt(*mixture, planned, tried);
      while (!chosen && may_find_more(*mixture, planned, tried) &&
             extend_mixture(planned, mixture->runs)) {
        keep(planned);
        if (!mix()) return campaign;
        chosen = choose_attempt(*mixture, planned, tried);
      }
      if (!chosen) break;
      planned.attempts.push_back({chosen->recommendation.candidate, chosen->runs, chosen->runs});
      keep(planned);
    }
    PlannedAttempt& attempt = planned.attempts[number];
    const ConfirmationRules rules =
        rules_for(attempt_rules(planned, mixture->runs.plan), mixture->runs, attempt.candidate);
    const Recommendation tolerance = recommendation_of(*mixture, attempt.candidate);
    const auto confirming =
        run_stage({fmt::format("confirm-{}", number + 1), attempt.runs, tolerance.tolerances,
                   planned.error_shares, allowed_failures(attempt.runs, rules)});
    if (!confirming) return campaign;
    attempt.spent = confirming->size();
    campaign.attempts.push_back({tolerance, judge_confirmation(*confirming, rules)});
    tried.push_back({tolerance_of(mixture->runs.plan, tolerance),
                     campaign.attempts.back().confirmation.passed});
  }
  const bool confirmed =
      std::any_of(campaign.attempts.begin(), campaign.attempts.end(),
                  [](const Attempt& each) { return each.confirmation.confirms(); });
  const bool passed =
      std::any_of(tried.begin(), tried.end(), [](const Tried& each) { return each.passed; });
  campaign.end = confirmed                                      ? CampaignEnd::confirmed
                 : passed                                       ? CampaignEnd::judged_again
                 : tried.size() >= planned.error_shares         ? CampaignEnd::not_confirmed
                 : affords_attempt(planned, mixture->runs.plan) ? CampaignEnd::no_candidate
                                                                : CampaignEnd::budget_spent;
  return campaign;
}

}  // namespace cagetol
