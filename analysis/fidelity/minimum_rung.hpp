// The cheapest model that is sufficient for a quantity. The rungs of a model ladder, ordered by
// cost with the reference last, run on the same samples (same geometry, same noise). The shift of a
// rung is the mean of the paired differences rung - reference, with Student's t interval. It must
// not exceed
//   budget = share * s / sqrt(N)
// a share of the standard error of the study. s: standard deviation of the reference's samples, N:
// samples of the study. The interval is valid for approximately normal differences, and for any law
// if there are many.
//
// A rung that is not shown to be within the budget is still sufficient for a limited quantity if
// every limit on it is settled (settled_limit.hpp), because the study then needs yields and not
// means.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/fidelity/settled_limit.hpp"
#include "analysis/study/estimate.hpp"

namespace cagetol {

/// adequate: the whole interval of |shift| is within the budget; biased: the whole interval exceeds
/// it; settled: not adequate, but all limits are settled; unresolved: none of these; unusable: too
/// many samples have no value on the rung.
enum class RungVerdict { adequate, settled, biased, unresolved, unusable };
const char* rung_verdict_name(RungVerdict verdict);
/// True if the rung is sufficient: adequate or settled.
bool will_do(RungVerdict verdict);

struct RungShift {
  Estimate shift;                    ///< rung minus reference
  double upper_limit = kUndefined;   ///< of |shift|
  double correlation = kUndefined;   ///< across samples, with the reference
  std::size_t pairs = 0;             ///< samples with both values
  std::size_t lost = 0;              ///< samples with a value on the reference only
  double pairs_needed = kUndefined;  ///< estimate for an interval as narrow as the budget
  /// Upper bound of the share on the wrong side of a limit, on this rung or the reference: the
  /// largest of all limits on the quantity. NaN: no limit, or no pairs.
  double wrong_share = kUndefined;
  RungVerdict verdict = RungVerdict::unresolved;
};

struct LadderRule {
  double study_samples = 0;    ///< N
  double budget_share = 0.1;   ///< of the study's standard error
  double confidence = 0.95;    ///< of each interval
  double lost_share = 0.02;    ///< more lost samples than this make a rung unusable
  double target_yield = 0.95;  ///< of the study
  double candidates = 1;       ///< number of tolerances among which the samples are divided
};

struct QuantityLadder {
  double mean = kUndefined, deviation = kUndefined;  ///< of the reference
  double budget = kUndefined;
  double allowed_wrong_share = kUndefined;  ///< NaN without limits
  std::vector<RungShift> rungs;             ///< the reference, adequate by definition, last
  std::optional<std::size_t> minimum;       ///< empty: the samples do not determine it
};

/// Judges the rungs. `values[rung][sample]`, NaN: no value; `limits` are those on the quantity.
/// `least` is the cheapest sufficient rung. It is the reference only if all others are biased or
/// unusable.
QuantityLadder minimum_rung(std::span<const std::vector<double>> values, const LadderRule& rule,
                            std::span<const Limit> limits = {});

/// True if a limit on the quantity is not settled on the reference itself. Rungs can then be judged
/// by the mean only.
bool leaves_limit_open(const QuantityLadder& quantity);
/// True if the study has too few samples to show that the rung's mean is within the budget.
bool is_out_of_reach(const RungShift& rung, const LadderRule& rule);

/// The cheapest rung that is sufficient for all quantities; the reference if no other one is.
std::size_t minimum_rung_for_all(std::span<const QuantityLadder> quantities);

}  // namespace cagetol
