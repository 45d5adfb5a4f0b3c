#include "analysis/response/trend_verdict.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cagetol {
namespace {

/// What the interval says by itself.
std::string seen_text(const PairedDifference& seen) {
  if (seen.identical) return fmt::format("all {} pairs are identical to the bit", seen.pairs);
  if (seen.difference.lower > 0) return "it rises";
  if (seen.difference.upper < 0) return "it falls";
  return fmt::format("no change shows in {} pairs", seen.pairs);
}

/// `sign` +1 for rises, -1 for falls.
TrendFinding judge_direction(const PairedDifference& seen, double change, int sign) {
  const double low = sign > 0 ? seen.difference.lower : -seen.difference.upper;
  const double high = sign > 0 ? seen.difference.upper : -seen.difference.lower;
  TrendFinding finding{TrendVerdict::undecided, change, {}};
  if (low > change) {
    finding.verdict = TrendVerdict::agrees;
    finding.reason = seen_text(seen) + (change > 0 ? ", by more than claimed" : "");
  } else if (high <= change) {
    finding.verdict = TrendVerdict::disagrees;
    finding.reason = seen_text(seen) + (low > 0      ? ", but by less than claimed"
                                        : change > 0 ? ", and a change as claimed is excluded"
                                                     : "");
  } else {
    finding.reason =
        change > 0 && low > 0
            ? seen_text(seen) + ", but its interval does not settle whether by as much as claimed"
            : fmt::format("the interval of {} pairs holds both answers", seen.pairs);
  }
  return finding;
}

TrendFinding judge_level(const PairedDifference& seen, double change) {
  const Estimate& d = seen.difference;
  TrendFinding finding{TrendVerdict::undecided, change, {}};
  if (seen.identical || (d.lower > -change && d.upper < change)) {
    finding.verdict = TrendVerdict::agrees;
    finding.reason =
        seen.identical ? seen_text(seen) : "the change stays within what counts as none";
  } else if (d.lower >= change || d.upper <= -change) {
    finding.verdict = TrendVerdict::disagrees;
    finding.reason = seen_text(seen) + ", by more than counts as none";
  } else {
    finding.reason =
        fmt::format("the interval of {} pairs reaches beyond what counts as none", seen.pairs);
  }
  return finding;
}

}  // namespace

const char* trend_verdict_name(TrendVerdict verdict) {
  switch (verdict) {
    case TrendVerdict::agrees:
      return "agrees";
    case TrendVerdict::disagrees:
      return "disagrees";
    case TrendVerdict::undecided:
      return "undecided";
    case TrendVerdict::no_claim:
      return "no claim";
    case TrendVerdict::no_values:
      return "no values";
  }
  return "unknown";
}

TrendFinding judge_trend(const Trend& trend, const PairedDifference& seen) {
  if (seen.pairs == 0)
    return {TrendVerdict::no_values, 0, "no pair of runs has a value of this quantity"};
  const double change =
      trend.by_value > 0 ? trend.by_value : trend.by_share * std::abs(seen.first_mean);
  if (seen.pairs < 2)
    return {TrendVerdict::undecided, change, "a single pair of runs has no interval"};
  if (trend.expected == "unclear") return {TrendVerdict::no_claim, 0, seen_text(seen)};
  if (trend.expected == "level") return judge_level(seen, change);
  return judge_direction(seen, change, trend.expected == "rises" ? 1 : -1);
}

}  // namespace cagetol
