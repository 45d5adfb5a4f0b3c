// Settled limits. A limit is settled on two models if all values of both lie on one side of it, and
// so far away that the share on the other side is too small to change a yield. The verdict on this
// limit is then the same for both models, even if their means differ.
#pragma once

#include <cstddef>
#include <span>

#include "analysis/study/estimate.hpp"
#include "analysis/study/study_plan.hpp"

namespace cagetol {

/// Side on which all values lie: between the limit's bounds, above or below them; both: on more
/// than one side.
enum class LimitSide { within, above, below, both };

struct SettledLimit {
  LimitSide side = LimitSide::both;
  /// Upper bound of the share on the other side, the larger of both models (tail_bounds.hpp). The
  /// confidence holds for both models and both tails together.
  double wrong_share = 1;
};

/// Assumption behind "settled", shown with the result.
inline constexpr const char* kSettledAssumption =
    "that values scatter normally, or that their tail towards the limit falls at least as fast as "
    "an exponential beyond the outer quarter";

/// Smallest number of pairs for a settled limit.
inline constexpr std::size_t kFewestSettledPairs = 8;

/// `values` and `reference` have one element per sample, NaN: no value. Only samples with both
/// values count.
SettledLimit settled_limit(std::span<const double> values, std::span<const double> reference,
                           const Limit& limit, double confidence);

/// Largest share p on the wrong side of a settled limit. With K candidates, p_k <= K p for
/// candidate k, and its yield has the standard error sqrt(Y (1 - Y) K / N). Therefore
///   p <= budget_share sqrt(Y (1 - Y) / (N K))
double allowed_wrong_share(double budget_share, double target_yield, double study_samples,
                           double candidates);

}  // namespace cagetol
