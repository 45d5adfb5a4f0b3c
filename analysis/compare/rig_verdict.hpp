// A slip that a rig has measured against runs of the same load and speed from several starts, and
// again under the ends of assumed ranges.
//
// Over starts, the interval in which one more run lies with probability 0.95, if slips scatter
// normally (the interval of prediction for one new value):
//
//   m -+ h,   h = t(n-1; 0.975) s sqrt(1 + 1/n)
//
// m, s mean and standard deviation over n starts. Over assumptions, each is an unknown of its own;
// the model is run with one of them at an end at a time, from the same starts, which gives the
// shift d of the mean. Shifts of independent unknowns add as variances do (JCGM 100:2008, 5.1.2),
// upwards and downwards by themselves because they are rarely alike:
//
//   m + sqrt(h^2 + sum u^2),   m - sqrt(h^2 + sum l^2)
//
// u^2, l^2 the larger of d^2 - v over the ends of an assumption that raise the slip, or lower it;
// v the variance of d by the scatter between starts; 0 where that is all there is. No slip is above
// 1. The sum is linear: where one shift is large it says that the model knows little, not how much.
#pragma once

#include <string>
#include <vector>

#include "analysis/study/estimate.hpp"

namespace cagetol {

/// Runs under one end of the range of an assumption.
struct AssumedSlips {
  std::string key;
  std::vector<double> slips;  ///< from the first of the starts; NaN: no result
};

struct RigVerdict {
  std::size_t runs = 0;  ///< starts with a result; below two there is nothing to hold against
  Estimate starts, all;  ///< slip: mean with the interval over starts, and over assumptions too
  bool within_starts = false, within_all = false;  ///< where the measurement lies
  bool is_wide = false;  ///< upper slip above three times the lower: a measurement settles more
  std::vector<double> shifts;  ///< of the mean, for each end; NaN: not known
  /// Ends between whose mean and m the measurement lies, -+h, the nearest first; and the end whose
  /// mean is nearest of all, -1 where none is nearer than m.
  std::vector<std::size_t> covering;
  long nearest = -1;
};

RigVerdict hold_against(double measured, const std::vector<double>& starts,
                        const std::vector<AssumedSlips>& ends);

}  // namespace cagetol
