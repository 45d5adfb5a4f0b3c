// From a pilot to a confirmed tolerance: which runs are made next, decided from the runs there are.
//
//   pilot      a mixture of all candidates: what a run costs, how much of the scatter is noise
//   mixture    the same with the runs that the plan affords: yields of all candidates, and the one
//              to try; extended as long as the budget affords it and no candidate is found
//   confirm-1  fresh independent runs at that tolerance, until its allowed failures are used up;
//              then confirm-2 at another one (attempt_choice.hpp)
//
// Decisions are pure functions of the stages' runs and of the stored plan, which keeps what was
// decided, so a campaign that is interrupted anywhere comes to the same stages again. Who runs a
// stage is the caller's business.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/tolerance/attempt_choice.hpp"

namespace cagetol {

struct Stage {
  std::string name;      ///< "pilot", "mixture", "confirm-1": also its directory
  std::size_t rows = 0;  ///< of the design
  std::vector<RecommendedTolerance>
      tolerances;                ///< of a confirmation, in the order of the dimensions
  std::size_t error_shares = 1;  ///< the confirmation has one of so many shares of the error
  /// Failing runs after which it ends, on its completed first ids; nothing: it has all its runs.
  std::optional<std::size_t> allowed_failures = {};
};

/// Runs a stage and gives its samples; nothing when it was interrupted.
using RunStage = std::function<std::optional<StudyData>(const Stage&)>;

/// Runs that failed, were censored or poisoned.
struct LostRuns {
  static constexpr double kConfidence = 0.95;
  std::size_t lost = 0, runs = 0;

  LostRuns& operator+=(const LostRuns& other);
  /// Lower bound of the share at kConfidence (Clopper-Pearson): one lost run of 32 is no evidence
  /// that more than 2 % are lost.
  double minimum_share() const;
};
LostRuns count_lost(const StudyData& runs);

enum class CampaignEnd {
  interrupted,
  confirmed,
  judged_again,   ///< an attempt passed, by runs that had been seen before limits or target changed
  no_candidate,   ///< no candidate meets the target, or none narrower than the last attempt
  not_confirmed,  ///< every planned attempt failed
  budget_spent,   ///< the budget affords no further attempt
};

struct Attempt {
  Recommendation recommendation;
  Confirmation confirmation;
};

struct Campaign {
  CampaignEnd end = CampaignEnd::interrupted;
  std::vector<Attempt> attempts;
};

/// Keeps the plan with what was decided, before it is run.
using KeepPlan = std::function<void(const CampaignPlan&)>;

/// Runs the stages. `plan` is asked once, after the pilot.
Campaign run_campaign(const Stage& pilot,
                      const std::function<CampaignPlan(const StudyData& pilot)>& plan,
                      const RunStage& run_stage, const KeepPlan& keep);

}  // namespace cagetol
