#include "analysis/compare/rig_verdict.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "analysis/compare/bias.hpp"

namespace cagetol {

RigVerdict hold_against(double measured, const std::vector<double>& starts,
                        const std::vector<AssumedSlips>& ends) {
  constexpr double predicted = 0.95, wide = 3;  // probability; upper over lower slip
  RigVerdict verdict;
  const Bias own = compare_pairs(starts, starts, 1);  // for mean and deviation
  const auto n = static_cast<double>(verdict.runs = own.pairs);
  if (verdict.runs < 2) return verdict;
  const double half =
      gsl_cdf_tdist_Pinv(0.5 * (1 + predicted), n - 1) * own.deviation * std::sqrt(1 + 1 / n);
  const auto distance = [&](std::size_t k) {
    return std::abs(measured - own.mean - verdict.shifts[k]);
  };
  std::map<std::string, std::array<double, 2>> squares;  // of shifts down and up
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const Bias d = compare_pairs(ends[k].slips, starts, 1);
    verdict.shifts.push_back(d.bias);
    double& largest = squares[ends[k].key][d.bias > 0];
    if (d.pairs > 1) largest = std::max(largest, d.bias * d.bias - std::pow(d.standard_error, 2));
    if (measured - own.mean >= std::min(0.0, d.bias) - half &&
        measured - own.mean <= std::max(0.0, d.bias) + half)
      verdict.covering.push_back(k);
    if (distance(k) < (verdict.nearest < 0 ? std::abs(measured - own.mean)
                                           : distance(static_cast<std::size_t>(verdict.nearest))))
      verdict.nearest = static_cast<long>(k);
  }
  std::ranges::sort(verdict.covering, {}, distance);
  double down = half * half, up = down;
  for (const auto& [key, square] : squares) down += square[0], up += square[1];
  verdict.starts = {own.mean, own.mean - half, std::min(own.mean + half, 1.0)};
  verdict.all = {own.mean, own.mean - std::sqrt(down), std::min(own.mean + std::sqrt(up), 1.0)};
  verdict.is_wide = verdict.all.upper > wide * verdict.all.lower;
  const auto within = [&](const Estimate& e) { return measured >= e.lower && measured <= e.upper; };
  verdict.within_starts = within(verdict.starts);
  verdict.within_all = within(verdict.all);
  return verdict;
}

}  // namespace cagetol
