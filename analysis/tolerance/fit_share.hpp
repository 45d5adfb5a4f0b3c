// Share of the cages that fit, where the runs were drawn from those alone (study key redraw_jams).
//
//   P(good) = (1 - j)(1 - q)    j does not fit, by geometry; q of those that fit misses a limit
//
// The bounds of both multiply. An integrated j is within 1 ppm and takes none of the risk alpha;
// one from M drawn cages has the upper bound of Clopper and Pearson at alpha/50, which leaves
// 49 alpha/50 for q: the product holds at 1 - alpha however both depend on each other.
#pragma once

#include "analysis/statistics/yield.hpp"

namespace cagetol {

struct FitShare {
  double share = 1, bound = 1;  ///< 1 - j, and its lower bound
  double risk_left = 1;         ///< share of alpha that is left for q
};

/// Of a candidate, with the risk alpha. All of 1 where the runs hold cages that jam as well.
FitShare fit_share(const StudyData& runs, std::size_t candidate, double alpha);

/// The yield of all cages from that of the cages that fit.
Yield yield_of_all(Yield fitting, const FitShare& fit);

}  // namespace cagetol
