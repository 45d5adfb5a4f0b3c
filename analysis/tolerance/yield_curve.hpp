// Yield of every candidate tolerance, and of each dimension by itself.
//
// Many candidates share few runs. One with fewer than kMinimumEffectiveRuns of its own is estimated
// from its tolerances b_d, as if each dimension caused failures by itself:
//   y = y_all prod_d (y_d(b_d) / y_all)
// with y_all over all candidates and y_d(b) over those with the tolerance b. That is good enough to
// choose what fresh runs confirm, and claims nothing by itself (`Yield::pooled`).
#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/yield.hpp"
#include "analysis/tolerance/mixture_weights.hpp"

namespace cagetol {

/// One dimension at one of its candidate tolerances, the other dimensions drawn from all of theirs.
struct LevelYield {
  double tolerance_width_mm = 0;
  std::string grade;
  std::vector<std::size_t> candidates;  ///< the combinations with this tolerance
  Yield yield;
  double middle = 0;  ///< of its zone, as in Candidate
};

struct DimensionCurve {
  std::string key;
  std::vector<LevelYield> levels;  ///< narrowest first, over all centres
  /// Likewise one for each tolerance at each centre; empty where the centre is not in question.
  std::vector<LevelYield> at_centres;
};

struct YieldCurves {
  std::vector<Yield> candidates;  ///< in the order of the study's candidates
  std::vector<DimensionCurve> dimensions;
};

YieldCurves yield_curves(const StudyData& runs, const MixtureWeights& mixture,
                         const std::vector<Judgement>& joint, const Resampling& resampling,
                         double confidence);

/// Yield of `narrow` minus yield of `wide` on the same runs, unknown samples failing, with its
/// standard error linearised over lots: the weights are compared run by run, so what both share
/// cancels. The share of all cages that fit under each is known.
struct YieldDifference {
  double value = 0, standard_error = 0;
};
YieldDifference yield_difference(const std::vector<Judgement>& joint,
                                 std::span<const double> narrow, std::span<const double> wide,
                                 const Resampling& resampling, double narrow_fits = 1,
                                 double wide_fits = 1);

}  // namespace cagetol
