// Which tolerance the next attempt tries, with how many runs; and why wider ones were passed over.
//
// Tried is the widest (cheapest) candidate whose estimated yield meets the target, as long as
// another attempt remains and the runs left give it a fair chance: what fails is followed by the
// next narrower one. The last attempt takes the widest that will probably be confirmed; where there
// is none, the widest that is nearly as sure as the surest. Runs are kept back for the attempts
// that may follow. No candidate is taken to yield more than the share of its cages that fit
// together, which geometry tells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/tolerance/campaign_plan.hpp"
#include "analysis/tolerance/recommendation.hpp"

namespace cagetol {

/// What a mixture says about its candidates.
struct ToleranceStudy {
  MixtureWeights mixture;
  YieldCurves curves;
  std::vector<BindingTest> tests;
};
ToleranceStudy study_tolerances(const StudyData& runs, const std::vector<Judgement>& joint,
                                const Resampling& resampling);

/// The mixture's runs and what they say.
struct MixtureStudy {
  StudyData runs;  ///< without noise replicates
  std::vector<Judgement> joint;
  Resampling resampling;
  ToleranceStudy tolerances;
};
MixtureStudy study_mixture(const StudyData& mixture);

struct AttemptChoice {
  std::size_t runs = 0;
  Recommendation recommendation;
};

/// `failed`: those of every attempt so far. Nothing where no candidate is left whose
/// estimate meets the target, or the runs left are too few for an attempt.
std::optional<AttemptChoice> choose_attempt(const MixtureStudy& mixture, const CampaignPlan& plan,
                                            const std::vector<Tolerance>& failed);

/// The recommendation of this very candidate.
Recommendation recommendation_of(const MixtureStudy& mixture, std::size_t candidate);

/// A candidate wider (cheaper) than the one decided for that no attempt has tried.
struct PassedOver {
  std::size_t candidate = 0;
  std::string reason;
  /// To confirm it by one attempt, if its yield is as estimated; 0: no number of runs would.
  std::size_t runs_needed = 0;
};

/// `runs` and `curves` are the mixture's; `tried`: those of all attempts, the last one
/// decided for.
std::vector<PassedOver> passed_over(const StudyData& runs, const YieldCurves& curves,
                                    const std::vector<Tolerance>& tried);

}  // namespace cagetol
