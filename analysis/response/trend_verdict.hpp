// Does a claimed trend show in the runs? Decided by the interval of the paired difference alone:
//   rises  agrees where the whole interval lies above the change claimed (0 unless by_share or
//          by_value ask for more), disagrees where it lies at or below it, else undecided
//   falls  the same mirrored
//   level  agrees where the whole interval lies within -+ the change that counts as none, disagrees
//          where it lies outside
//   unclear  no claim to judge: what these runs do is reported
#pragma once

#include <string>

#include "analysis/statistics/paired_difference.hpp"
#include "analysis/study/study_plan.hpp"

namespace cagetol {

enum class TrendVerdict { agrees, disagrees, undecided, no_claim, no_values };
const char* trend_verdict_name(TrendVerdict verdict);

struct TrendFinding {
  TrendVerdict verdict = TrendVerdict::no_values;
  double change = 0;   ///< that the claim asks for (or, for level, allows), in the quantity's unit
  std::string reason;  ///< why this verdict, in words
};

TrendFinding judge_trend(const Trend& trend, const PairedDifference& seen);

}  // namespace cagetol
