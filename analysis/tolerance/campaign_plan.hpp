// How many runs the stages of a recommendation have, fixed after the pilot: a budget of time
// becomes a number of runs once, so that no later decision depends on time.
//
// Half of a budget is for the mixture. Where the confirmations will need more, as the pilot's
// yields tell, the mixture leaves them up to three quarters. A raised budget gives all it adds to
// the confirmations: the mixture's runs are kept as they are.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/tolerance/confirmation.hpp"
#include "analysis/tolerance/yield_curve.hpp"

namespace cagetol {

/// An attempt to confirm, as it was decided.
struct PlannedAttempt {
  std::size_t candidate = 0, runs = 0;
};

struct CampaignPlan {
  std::size_t mixture_rows = 0;
  std::size_t confirm_runs = 0;  ///< of all attempts together
  double seconds_per_run = 0;    ///< mean wall-clock time of the pilot's runs
  double processes = 1;
  CampaignSettings settings = {};             ///< for which the numbers were worked out
  std::vector<PlannedAttempt> attempts = {};  ///< decided so far
};

/// Fewest runs in all that can confirm anything: a pilot, a mixture that can judge one candidate,
/// one attempt without a failing run.
std::size_t minimum_budget(const ConfirmationRules& rules, double extra_replicates,
                           std::size_t pilot_runs);

/// Runs of the attempts decided so far.
std::size_t decided_runs(const CampaignPlan& plan);

/// Whether the runs that no attempt has had yet are enough for one more.
bool affords_attempt(const CampaignPlan& plan, const ConfirmationRules& rules);

/// `study_rows` is the mixture's size where there is no budget. Throws Refused when the budget is
/// spent before anything could be confirmed, with the budget that would do.
CampaignPlan plan_campaign(const StudyData& pilot, const CampaignSettings& settings,
                           std::size_t study_rows, double processes);

/// The plan for other settings, with all that was run and decided. Throws Refused when they afford
/// less than was decided.
CampaignPlan with_settings(const CampaignPlan& plan, const StudyData& pilot,
                           const CampaignSettings& settings);

nlohmann::ordered_json to_json(const CampaignPlan& plan);
/// Throws nlohmann::json::exception.
CampaignPlan campaign_plan_of(const nlohmann::ordered_json& json);

/// The plan in words, with predicted times and what the pilot says about noise.
std::string plan_text(const StudyData& pilot, const CampaignPlan& plan);

/// "45 s", "12 min", "3.4 h".
std::string duration_text(double seconds);

/// What an attempt may count on: halfway from the estimate to its bound, since the best of many
/// looks too good.
double expected_yield(const Yield& yield);

}  // namespace cagetol
