#include "analysis/tolerance/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {
namespace {

Tolerance tolerance_of(const StudyPlan& plan, const Recommendation& recommendation) {
  Tolerance chosen{{}, plan.candidates[recommendation.candidate].shifts};
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
  const auto mixed = run_stage({"mixture", planned.mixture_rows, {}});
  if (!mixed) return campaign;

  const MixtureStudy mixture = study_mixture(*mixed);
  const auto rules = confirmation_rules(mixture.runs.plan, 0);
  std::vector<Tolerance> failed;
  while (campaign.attempts.size() < rules.attempts) {
    const std::size_t number = campaign.attempts.size();
    AttemptChoice next;
    if (number < planned.attempts.size()) {
      next = {planned.attempts[number].runs,
              recommendation_of(mixture, planned.attempts[number].candidate)};
    } else {
      const auto chosen = choose_attempt(mixture, planned, failed);
      if (!chosen) {
        campaign.end =
            affords_attempt(planned, rules) ? CampaignEnd::no_candidate : CampaignEnd::budget_spent;
        return campaign;
      }
      next = *chosen;
      planned.attempts.push_back({next.recommendation.candidate, next.runs});
      keep(planned);
    }
    const Stage stage{fmt::format("confirm-{}", number + 1), next.runs,
                      next.recommendation.tolerances};
    const auto confirming = run_stage(stage);
    if (!confirming) return campaign;
    campaign.attempts.push_back({next.recommendation, judge_confirmation(*confirming, rules)});
    failed.push_back(tolerance_of(mixture.runs.plan, next.recommendation));
    if (campaign.attempts.back().confirmation.passed) {
      campaign.end = CampaignEnd::confirmed;
      return campaign;
    }
  }
  campaign.end = CampaignEnd::not_confirmed;
  return campaign;
}

}  // namespace cagetol
