// Verdict on a claimed trend, from the interval of the paired difference:
//
//   rises    agrees if the whole interval is above the claimed change (0 unless by_share or
//            by_value give one), disagrees if all of it is at or below, otherwise undecided
//   falls    the same with the opposite sign
//   level    agrees if the whole interval is within -+ the allowed change, disagrees if all of it
//            is outside, otherwise undecided
//   unclear  no claim; the result is only reported
#pragma once

#include <string>

#include "analysis/statistics/paired_difference.hpp"
#include "analysis/study/study_plan.hpp"

namespace cagetol {

enum class TrendVerdict { agrees, disagrees, undecided, no_claim, no_values };
const char* trend_verdict_name(TrendVerdict verdict);

struct TrendFinding {
  TrendVerdict verdict = TrendVerdict::no_values;
  double change = 0;   ///< claimed (for level: allowed) change in the quantity's unit
  std::string reason;  ///< reason for the verdict, in words
};

TrendFinding judge_trend(const Trend& trend, const PairedDifference& seen);

}  // namespace cagetol
