// How far the runs of a study stay from a limit, and whether the limit decides anything.
//
//   margin = (bound - value)/|bound| for a maximum, (value - bound)/|bound| for a minimum
//
// positive within the limit; of a limit with both, the smaller one. A bound of zero has margins in
// the quantity's unit. The extreme run is the one with the smallest margin.
//
// What a limit does, of n runs with a judgement of which k miss it:
//   decides              some run misses it and no other limit
//   follows              runs that miss it miss another limit too: without it the yield is the same
//   met by enough runs   k = 0, and so many runs that at the confidence the share missed is less
//                        than what the target yield allows (Clopper-Pearson, one-sided)
//   open                 k = 0, but too few runs to say so
//   within the model's error   moved by the known bias of the model, one way or the other, the
//                        share missed leaves its interval (Clopper-Pearson, two-sided)
// The last one comes before the others. Intervals take runs for independent.
#pragma once

#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

enum class LimitRole { decides, follows, met, open, within_model_error };
const char* limit_role_name(LimitRole role);

struct LimitMargin {
  Limit limit;
  double median = 0, median_margin = 0;    ///< of the runs with a value; NaN without
  double extreme = 0, extreme_margin = 0;  ///< of the run with the smallest margin
  std::size_t judged = 0, missed = 0, unknown = 0;
  std::size_t alone = 0;                      ///< runs that miss this limit and no other
  double missed_lower = 0, missed_upper = 0;  ///< of the share missed
  double model_error = 0;                     ///< known bias of the quantity; NaN: not measured
  LimitRole role = LimitRole::open;
  std::size_t runs_needed = 0;  ///< without a miss, to be enough
};

/// Of one value, as a share of the bound.
double margin_of(const Limit& limit, double value);

/// Runs without a miss that bound the share missed by 1 - target: target^n <= 1 - confidence.
std::size_t runs_without_miss(double confidence, double target_yield);

/// Of every limit of the study. `model_errors`: one for each limit, NaN where not measured; empty:
/// none is. A jammed run has no values and counts as a miss of the cage, not of a limit.
std::vector<LimitMargin> limit_margins(const StudyData& runs,
                                       const std::vector<double>& model_errors = {});

}  // namespace cagetol
