// The tolerance that may be printed on the drawing, as far as one sweep can tell.
//
// Among the candidate combinations with an effective sample size of at least 30 whose lower yield
// bound meets the target, the widest is taken: the largest product of the tolerances of the
// dimensions that matter, each in units of its widest candidate. A dimension that is not binding is
// left out of this choice and never recommended; the yield is then the one with that dimension at
// its widest candidate, so that a small effect that went unnoticed cannot flatter the result. Where
// the study states what tolerances cost, the cheapest is taken instead of the widest. Tolerances
// given in mm are snapped down to an ISO 286 grade and judged again.
//
// The choice looks for the best of several noisy figures, so its bound is too good on average: it
// is a recommendation until fresh independent runs at that tolerance have confirmed it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/tolerance/binding.hpp"

namespace cagetol {

/// One dimension of the recommendation.
struct RecommendedTolerance {
  std::string key, name;  ///< "cage.pocket_width_mm", "pocket width"
  bool not_binding = false;
  double tolerance_width_mm =
      0;              ///< of a dimension that is not binding: the tolerance for which the yield is
                      ///< stated, no recommendation
  std::string grade;  ///< as in Candidate, or that of ISO 286 snapped to
  std::optional<double> centre = {};  ///< nominal value in the key's unit, where it is in question
  bool widest_studied = false;        ///< there is no wider candidate: more may be possible
};

/// What narrowing one dimension by one candidate would gain, or widening lose, from the recommended
/// (or best) combination.
struct StepEffect {
  std::string key, from, to;
  double change = 0, lower = 0, upper = 0;  ///< of the yield, with its interval
};

struct Recommendation {
  bool possible = false;  ///< the study has candidates with enough effective runs
  bool meets_target = false;
  bool none_can_meet = true;  ///< every candidate's upper bound misses the target
  std::size_t candidate =
      0;  ///< the recommended combination, or the best where none meets the target
  std::vector<RecommendedTolerance> tolerances;
  std::optional<double> cost;  ///< of these tolerances, where the study states costs
  Yield yield;
  std::vector<double> weights;  ///< of the runs, for statistics at the recommended tolerance
  std::vector<StepEffect> steps;
};

/// Says of a candidate whether it may be recommended.
using CandidateFilter = std::function<bool(std::size_t candidate)>;

/// An empty filter allows every candidate whose lower bound meets the target; any other one decides
/// alone, and `meets_target` says that it allowed one.
Recommendation recommend_tolerance(const StudyData& runs, const MixtureWeights& mixture,
                                   const YieldCurves& curves, const std::vector<BindingTest>& tests,
                                   const std::vector<Judgement>& joint,
                                   const Resampling& resampling,
                                   const CandidateFilter& allowed = {});

/// The same; where no candidate allowed has the dimensions that are not binding at their widest,
/// these are taken for undecided: an attempt there that did not confirm says that they may matter
/// after all.
Recommendation recommend_allowed(const StudyData& runs, const MixtureWeights& mixture,
                                 const YieldCurves& curves, const std::vector<BindingTest>& tests,
                                 const std::vector<Judgement>& joint, const Resampling& resampling,
                                 const CandidateFilter& allowed);

/// Tolerances in mm, and by which their laws are moved (Candidate::all_shifts).
struct Tolerance {
  std::vector<double> tolerance_widths_mm, shifts;
};

/// Up to rounding.
bool same_tolerances(const std::vector<double>& one, const std::vector<double>& other);
bool same_centres(const Tolerance& one, const Tolerance& other);
bool same_tolerance(const Tolerance& one, const Tolerance& other);

/// Of a confirming attempt.
Tolerance tolerance_tried(const StudyData& attempt);

/// Tolerances of a candidate in mm, those without a grade snapped down to one where there is one.
std::vector<double> snapped_tolerances(const StudyData& runs, const Candidate& candidate);
/// The same with its centres.
Tolerance snapped_tolerance(const StudyData& runs, const Candidate& candidate);

}  // namespace cagetol
