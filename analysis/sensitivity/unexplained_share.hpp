// Share of an output's variance that no feature explains.
//
// The output is fitted by a straight line and a parabola of every feature at once, by lines alone
// where there are fewer than eight lots for each feature.
//
//   U = residual variance / whole variance, both of statistics/lot_variance.hpp
//
// Steps and interactions of features count as unexplained. The interval is that of log U by its
// influence function r_i^2 / mean(r^2) - d_i^2 / mean(d^2), summed over lots, r_i the residuals and
// d_i the deviations from the mean, with Student's t.
#pragma once

#include <span>
#include <vector>

#include "analysis/sensitivity/features.hpp"
#include "analysis/statistics/resampling.hpp"

namespace cagetol {

/// At most 1. NaN without features or if the runs are too few for the fit.
Estimate unexplained_share(const std::vector<Feature>& features, std::span<const double> output,
                           const Resampling& resampling, double confidence);

}  // namespace cagetol
