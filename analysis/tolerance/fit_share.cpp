#include "analysis/tolerance/fit_share.hpp"

#include <algorithm>

#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {

FitShare fit_share(const StudyData& runs, std::size_t candidate, double alpha) {
  constexpr double kExact = 1e-6, kRiskOfDraws = 1.0 / 50;
  const JamShares& jam = runs.jam;
  if (!runs.plan.redraw_jams || candidate >= jam.candidate.size()) return {};
  const double share = jam.candidate[candidate];
  if (jam.draws == 0) return {1 - share, std::max(1 - share - kExact, 0.0), 1};
  const double most = clopper_pearson_upper(share * jam.draws, jam.draws, 1 - kRiskOfDraws * alpha);
  return {1 - share, 1 - most, 1 - kRiskOfDraws};
}

Yield yield_of_all(Yield fitting, const FitShare& fit) {
  fitting.fits = fit.share;
  fitting.if_unknown_fail *= fit.share;
  fitting.if_unknown_pass *= fit.share;
  fitting.lower_bound *= fit.bound;
  fitting.upper_bound *= std::min(2 * fit.share - fit.bound, 1.0);
  return fitting;
}

}  // namespace cagetol
