// Does a verdict survive what nobody knows? A tolerance is judged again under alternatives: other
// values of one assumed number, with the cages and starts of the confirming runs.
//
// A yield belongs to one state of knowledge. Each alternative has its own; none is mixed with
// another's. Runs without a result do not meet the limits, as in a confirmation; only an upper
// bound counts them as meeting.
//
// Confidences. The cages are those of the attempt to confirm, which was chosen by its runs, so
// every bound has the confidence of one attempt, 1 - alpha/m, alpha being 1 - confidence.
//   holds   the lower bound reaches the target. "Holds under all" is claimed only where every
//           alternative holds: it is wrong with at most the error of one (intersection-union test,
//           Berger 1982, doi:10.1080/00401706.1982.10487790), so nothing is shared.
//   fails   the upper bound lies below the target. One such alternative makes the claim, so k
//           alternatives share the error of the attempt (Bonferroni).
//   named   the paired change of the yield is not zero: McNemar's exact test, Holm's correction
//           over the alternatives, error rate 5 % shared by the m attempts.
#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/paired_difference.hpp"
#include "analysis/statistics/paired_share.hpp"
#include "analysis/tolerance/confirmation.hpp"

namespace cagetol {

enum class AssumptionAnswer { holds, fails, not_resolved };
/// "holds", "fails", "not resolved".
const char* answer_name(AssumptionAnswer answer);

/// Mean change of a limited quantity over the pairs in which both runs have it.
struct QuantityChange {
  std::string quantity, unit;
  PairedDifference paired;
};

struct AlternativeVerdict {
  std::size_t runs = 0, meeting = 0, unknown = 0;
  double yield = kUndefined;  ///< runs without a result fail
  double lower_bound = 0;     ///< at the confidence of an attempt
  double upper_bound = 1;     ///< with its error shared by the alternatives
  AssumptionAnswer answer = AssumptionAnswer::not_resolved;
  /// Of an alternative that is not resolved: runs that would settle it with the probability
  /// kWantedPower, if the yield is as estimated; 0: more than kMostSettlingRuns.
  std::size_t runs_needed = 0;
  PairedShare change;
  bool named = false;
  std::vector<QuantityChange> quantities;
};

struct AssumptionVerdicts {
  double lower_confidence = 0.95, upper_confidence = 0.95;  ///< of the bounds
  std::vector<AlternativeVerdict> alternatives;             ///< as given
  std::size_t holding = 0, failing = 0, unresolved = 0;
  /// Alternatives that do not hold, the most threatening first: those that fail by their yield,
  /// then those that are not resolved by the yield lost. The first one's key is worth measuring
  /// most.
  std::vector<std::size_t> threats;
};

inline constexpr double kFalseAlarms = 0.05;
inline constexpr std::size_t kMostSettlingRuns = 1'000'000;

/// About the fewest runs that settle, with the probability kWantedPower, whether a yield meets the
/// target. A yield above it needs a lower bound at `lower_confidence`, one below it an upper bound
/// at `upper_confidence`. 0: more than kMostSettlingRuns.
std::size_t settling_runs(double yield, double target, double lower_confidence,
                          double upper_confidence);

/// `confirming`: the runs of the attempt; `alternatives`: runs at the same tolerance. Throws
/// Refused unless all runs are independent.
AssumptionVerdicts judge_assumptions(const StudyData& confirming,
                                     const std::vector<StudyData>& alternatives,
                                     const ConfirmationRules& rules);

}  // namespace cagetol
