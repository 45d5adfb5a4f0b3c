// Rare failures: what may be said of parts per million, and by which route.
//
//   P(bad) <= 1 - (1 - j)(1 - sum_l q_l)
//
// j the share of cages that do not fit, known from geometry; q_l the share of fitting cages that
// miss limit l. The pilot decides the route of each limit before the runs that it is judged by:
//
//   counted        the fresh runs can show the target: Clopper-Pearson
//   extrapolated   the limit lies 7 standard deviations away or more and there are 1000 fresh
//                  runs: upper bound from the tail (statistics/pareto_bound.hpp), no estimate;
//                  where a run misses the limit, at least the exact bound
//   not stated     neither
//
// Brute force shows at most p where none of log(1 - c) / log(1 - p) runs misses.
#pragma once

#include <string>
#include <vector>

#include "analysis/study/estimate.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct RareSettings {
  double target = 63e-6;          ///< share of cages in question
  std::size_t fresh_runs = 1000;  ///< after the pilot
};

enum class RareRoute { counted, extrapolated, unstated };

/// Widths of the curves, as shares of that of the runs.
inline constexpr double kRareWidths[] = {0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5};

struct RareLimit {
  std::string quantity;
  double bound = 0;
  bool is_maximum = true;
  RareRoute route = RareRoute::unstated;
  double distance = kUndefined;  ///< standard deviations from mean to bound, of the pilot
  double noise = kUndefined;     ///< share of the start in the variance
  double missed = 0;  ///< number of the runs judged: beyond the limit, or without a value
  double exact_lower = 0, exact_upper = 1;  ///< of the share, Clopper-Pearson, one-sided each
  double upper = kUndefined;                ///< of the share, where it is stated
  double if_normal = kUndefined;            ///< share beyond the limit if values were normal
  /// Of a limit that is extrapolated, by dimension and kRareWidths, the other dimensions as they
  /// are: each run moved by what the width does to it, a straight line in the lot and in the
  /// scatter of the pockets.
  std::vector<std::vector<double>> upper_at = {};
};

struct Rare {
  double runs = 0, lost = 0;  ///< number judged: the fresh ones, the pilot's where there are none
  double jams = 0, jams_upper = 0, draws = 0;  ///< of JamShares; draws 0: integrated
  std::vector<RareLimit> limits = {};
  double exact_upper = 1;     ///< share of all cages that jam or miss any limit
  double upper = kUndefined;  ///< the same, where every limit is stated
};

/// Runs of which none misses, to show at most `share`.
double showing_runs(double share, double confidence);

/// The routes of all limits, from the pilot.
std::vector<RareLimit> rare_routes(const StudyData& pilot, const RareSettings& settings);

/// `runs` are the fresh ones; the first ones of the pilot where fresh ones can state nothing. They
/// are of one candidate, cages that fit.
Rare judge_rare(const StudyData& pilot, const StudyData& runs, const RareSettings& settings);

}  // namespace cagetol
