// How many runs the stages of a recommendation have, fixed after the pilot: a budget of time
// becomes a number of runs once, so that no later decision depends on time.
//
// Half of a budget is for the mixture. Where the confirmations will need more, as the pilot's
// yields tell, the mixture leaves them up to three quarters, but takes 40 rows for each candidate
// first where half of the budget has them. Where jams alone decide, which are known without a run,
// it has no more. A raised budget extends the mixture, until an attempt is
// decided; then it gives the attempts all it adds.
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
  std::size_t spent = 0;  ///< runs that it had: fewer where its allowed failures were used up
};

struct CampaignPlan {
  std::size_t mixture_rows = 0;
  std::size_t confirm_runs = 0;  ///< of all attempts together
  std::size_t error_shares = 1;  ///< into which attempts divide the error; 1: a fixed sequence
  double seconds_per_run = 0;    ///< mean wall-clock time of the pilot's runs
  double processes = 1;
  CampaignSettings settings = {};             ///< for which the numbers were worked out
  std::vector<PlannedAttempt> attempts = {};  ///< decided so far
  double repeats_lost = 0;  ///< runs of smaller mixtures that are no rows of the larger one
  nlohmann::ordered_json judgement = {};  ///< what attempts are decided by (judgement_of)
};

/// Mean wall-clock time of the runs; 0 where they do not say.
double seconds_per_run(const StudyData& runs);

/// Fewest runs in all that can confirm anything: a pilot, a mixture that can judge one candidate,
/// one attempt without a failing run.
std::size_t minimum_budget(const ConfirmationRules& rules, double extra_replicates,
                           std::size_t pilot_runs);

/// Runs that a budget has for confirmations, where its mixture is as small as may be.
std::size_t most_confirming_runs(std::size_t budget, std::size_t pilot_runs);

/// Runs of the attempts decided so far.
std::size_t decided_runs(const CampaignPlan& plan);

/// The study's, with the plan's share of the error for each attempt.
ConfirmationRules attempt_rules(const CampaignPlan& plan, const StudyPlan& study);

/// Whether the runs that no attempt has had yet are enough for one more.
bool affords_attempt(const CampaignPlan& plan, const StudyPlan& study);

/// Gives the mixture up to as many rows again, of the runs that a last attempt does not need. False
/// where there is no budget, too little left of it, or a design whose first rows would change.
bool extend_mixture(CampaignPlan& plan, const StudyData& mixture);

/// `study_rows` is the mixture's size where there is no budget. Throws Refused when the budget is
/// spent before anything could be confirmed, with the budget that would do.
CampaignPlan plan_campaign(const StudyData& pilot, const CampaignSettings& settings,
                           std::size_t study_rows, double processes);

/// The plan for other settings, with all that was run and decided. Throws Refused when they afford
/// less than was decided.
CampaignPlan with_settings(const CampaignPlan& plan, const StudyData& pilot,
                           const CampaignSettings& settings);

/// The plan after limits, target or confidence have changed: pilot and mixture stay, attempts are
/// open again. Throws Refused where the settings afford none.
CampaignPlan with_judgement(CampaignPlan plan, const StudyData& pilot,
                            const CampaignSettings& settings);

nlohmann::ordered_json to_json(const CampaignPlan& plan);
/// Throws nlohmann::json::exception.
CampaignPlan campaign_plan_of(const nlohmann::ordered_json& json);

/// The plan in words, with predicted times and what the pilot says about noise.
std::string plan_text(const StudyData& pilot, const CampaignPlan& plan);

/// "with 300 confirming runs: IT11 to 95 %, ...": the widest candidate whose share without a jam so
/// many runs would probably confirm in one attempt. `jams`: shares of the candidates; may be empty.
std::string decidable_text(const std::vector<Candidate>& candidates,
                           const std::vector<double>& jams, ConfirmationRules rules,
                           std::size_t runs);

/// "45 s", "12 min", "3.4 h".
std::string duration_text(double seconds);

/// What an attempt may count on: halfway from the estimate to its bound, since the best of many
/// looks too good.
double expected_yield(const Yield& yield);

}  // namespace cagetol
