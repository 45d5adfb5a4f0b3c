// The least model that a quantity needs. Rungs of a model ladder, cheapest first and the last one
// the reference, run on the same samples (same geometry, same noise). What a rung does to the mean
// is the mean d of the paired differences rung - reference with Student's t interval; its budget is
// a share of the standard error that the study itself leaves,
//   budget = share * s / sqrt(N),  s: standard deviation over the reference's samples, N: samples
// of the study. Holds for differences that are about normal, and for any law as their number grows.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/estimate.hpp"

namespace cagetol {

/// adequate: |shift| is within the budget with its whole interval; biased: beyond it with its whole
/// interval; unresolved: neither; unusable: the rung has no value in too many of the samples.
enum class RungVerdict { adequate, biased, unresolved, unusable };
const char* rung_verdict_name(RungVerdict verdict);

struct RungShift {
  Estimate shift;                    ///< rung minus reference
  double upper_limit = kUndefined;   ///< of |shift|
  double correlation = kUndefined;   ///< across samples, with the reference
  std::size_t pairs = 0;             ///< samples with a value on both
  std::size_t lost = 0;              ///< samples with a value on the reference only
  double pairs_needed = kUndefined;  ///< about, until the interval is as narrow as the budget
  RungVerdict verdict = RungVerdict::unresolved;
};

struct LadderRule {
  double study_samples = 0;   ///< N
  double budget_share = 0.1;  ///< of the study's standard error
  double confidence = 0.95;   ///< of each interval
  double lost_share = 0.02;   ///< more lost samples than this make a rung unusable
};

struct QuantityLadder {
  double mean = kUndefined, deviation = kUndefined;  ///< of the reference
  double budget = kUndefined;
  std::vector<RungShift> rungs;      ///< the reference, adequate by definition, last
  std::optional<std::size_t> least;  ///< none: the samples do not tell
};

/// `values[rung][sample]`, NaN where a run gave none. `least` is the cheapest adequate rung; the
/// reference only where every other one is biased or unusable.
QuantityLadder least_rung(std::span<const std::vector<double>> values, const LadderRule& rule);

/// The cheapest rung that is adequate for all quantities; the reference where no other one is.
std::size_t least_rung_for_all(std::span<const QuantityLadder> quantities);

}  // namespace cagetol
