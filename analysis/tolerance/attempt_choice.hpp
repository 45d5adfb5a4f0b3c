// Which tolerance the next attempt tries, with how many runs; and why wider ones were passed over.
//
// Tried is the widest (cheapest) candidate whose estimated yield meets the target, as long as
// another attempt remains and the runs left give it a fair chance, less those that the narrower one
// needs that would follow it. The last attempt takes the widest that will probably be confirmed;
// where there is none, the widest that is nearly as sure as the surest. What is confirmed is
// followed by wider ones, at the same share of the error, until one fails or no runs are left.
// A wider one that only the whole error affords, and probably confirms, is tried with it alone.
// Where it takes fewer runs in all, the narrower one is tried first, and the whole error is its and
// its followers': a fixed sequence of hypotheses, which ends with the first that fails. No
// candidate is taken to yield more than the share of its cages that fit together, which geometry
// tells; where no run misses a limit, how far the limits are says how few would.
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
  /// Where no run misses a limit, the share that would if values were normal; else 1. It decides
  /// what is tried, and claims nothing.
  double beyond = 1;
};
MixtureStudy study_mixture(const StudyData& mixture);

/// An attempt that was made.
struct Tried {
  Tolerance tolerance;
  bool passed = false;
};

struct AttemptChoice {
  std::size_t runs = 0;
  Recommendation recommendation;
};

/// `tried`: every attempt so far. The first choice also settles the plan's error_shares. Nothing
/// where no candidate is left whose estimate meets the target, or the runs left are too few.
std::optional<AttemptChoice> choose_attempt(const MixtureStudy& mixture, CampaignPlan& plan,
                                            const std::vector<Tried>& tried);

/// Whether more runs of the mixture may find a candidate for an attempt that the plan affords.
bool may_find_more(const MixtureStudy& mixture, const CampaignPlan& plan,
                   const std::vector<Tried>& tried);

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
