// Whether a limit is settled on two models: all of either's values lie so far on one side of it
// that the share on the other side is certainly too small to move a yield. Then no difference
// between the models can move the verdict on that limit, however their means differ.
#pragma once

#include <cstddef>
#include <span>

#include "analysis/statistics/estimate.hpp"
#include "analysis/study/study_plan.hpp"

namespace cagetol {

/// Where all values lie: between the limit's bounds, above or below them; both: here and there.
enum class LimitSide { within, above, below, both };

struct SettledLimit {
  LimitSide side = LimitSide::both;
  /// Largest share of a model's law on the other side, of both models the larger (tail_bounds.hpp).
  /// The confidence holds for both models and both tails together: each has its part of the error.
  double wrong_share = 1;
};

/// What "settled" rests on, to be shown with it.
inline constexpr const char* kSettledAssumption =
    "that values scatter normally, or that their tail towards the limit falls at least as fast as "
    "an exponential beyond the outer quarter";

/// Fewer pairs than this settle nothing.
inline constexpr std::size_t kFewestSettledPairs = 8;

/// `values` and `reference` have one element for each sample, NaN where a run gave none; samples
/// count with a value on both.
SettledLimit settled_limit(std::span<const double> values, std::span<const double> reference,
                           const Limit& limit, double confidence);

/// Share on the wrong side of a limit below which it is settled: with K candidates p_k <= K p, and
/// a yield of candidate k has the standard error sqrt(Y (1 - Y) K / N), so that
///   p <= budget_share sqrt(Y (1 - Y) / (N K)).
double allowed_wrong_share(double budget_share, double target_yield, double study_samples,
                           double candidates);

}  // namespace cagetol
