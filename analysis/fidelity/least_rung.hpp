// The least model that a quantity needs. Rungs of a model ladder, cheapest first and the last one
// the reference, run on the same samples (same geometry, same noise). What a rung does to the mean
// is the mean d of the paired differences rung - reference with Student's t interval; its budget is
// a share of the standard error that the study itself leaves,
//   budget = share * s / sqrt(N),  s: standard deviation over the reference's samples, N: samples
// of the study. Holds for differences that are about normal, and for any law as their number grows.
// A rung whose mean is not shown to be within the budget will still do for a limited quantity where
// every limit on it is settled (settled_limit.hpp): the study asks for yields then, not for means.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/fidelity/settled_limit.hpp"
#include "analysis/statistics/estimate.hpp"

namespace cagetol {

/// adequate: |shift| is within the budget with its whole interval; settled: it is not known to be,
/// but no limit can tell; biased: beyond it with its whole interval; unresolved: neither; unusable:
/// the rung has no value in too many of the samples.
enum class RungVerdict { adequate, settled, biased, unresolved, unusable };
const char* rung_verdict_name(RungVerdict verdict);
/// Whether the rung will do: adequate or settled.
bool will_do(RungVerdict verdict);

struct RungShift {
  Estimate shift;                    ///< rung minus reference
  double upper_limit = kUndefined;   ///< of |shift|
  double correlation = kUndefined;   ///< across samples, with the reference
  std::size_t pairs = 0;             ///< samples with a value on both
  std::size_t lost = 0;              ///< samples with a value on the reference only
  double pairs_needed = kUndefined;  ///< about, until the interval is as narrow as the budget
  /// Share on the wrong side of a limit, on this rung or the reference, at most; the largest of all
  /// limits on the quantity. NaN: no limit, or no pairs.
  double wrong_share = kUndefined;
  RungVerdict verdict = RungVerdict::unresolved;
};

struct LadderRule {
  double study_samples = 0;    ///< N
  double budget_share = 0.1;   ///< of the study's standard error
  double confidence = 0.95;    ///< of each interval
  double lost_share = 0.02;    ///< more lost samples than this make a rung unusable
  double target_yield = 0.95;  ///< of the study: how sure it can be of a yield
  double candidates = 1;       ///< tolerances among which the study shares its samples
};

struct QuantityLadder {
  double mean = kUndefined, deviation = kUndefined;  ///< of the reference
  double budget = kUndefined;
  double allowed_wrong_share = kUndefined;  ///< NaN without limits
  std::vector<RungShift> rungs;             ///< the reference, adequate by definition, last
  std::optional<std::size_t> least;         ///< none: the samples do not tell
};

/// `values[rung][sample]`, NaN where a run gave none; `limits` are those on the quantity. `least`
/// is the cheapest rung that will do; the reference only where every other one is biased or
/// unusable.
QuantityLadder least_rung(std::span<const std::vector<double>> values, const LadderRule& rule,
                          std::span<const Limit> limits = {});

/// Whether the reference itself leaves a limit on the quantity open, so that only its mean is left
/// to judge rungs by.
bool leaves_limit_open(const QuantityLadder& quantity);
/// Whether to show that the rung's mean is within the budget would take more samples than the study
/// has.
bool is_out_of_reach(const RungShift& rung, const LadderRule& rule);

/// The cheapest rung that will do for all quantities; the reference where no other one does.
std::size_t least_rung_for_all(std::span<const QuantityLadder> quantities);

}  // namespace cagetol
