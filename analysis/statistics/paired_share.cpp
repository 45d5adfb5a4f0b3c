#include "analysis/statistics/paired_share.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>

#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {
namespace {

/// Part of an end's error that the share of gains has; the rest is for the share of pairs that
/// differ.
constexpr double kOfGains = 0.8;

/// Upper end of delta at this one-sided error; the lower one is that of losses taken for gains.
double upper_end(double pairs, double gained, double lost, double error) {
  const double differing = gained + lost;
  const double pi = clopper_pearson_upper(gained, differing, 1 - kOfGains * error);
  const double psi_confidence = 1 - (1 - kOfGains) * error;
  const double direction = 2 * pi - 1;
  return direction * (direction < 0 ? clopper_pearson_lower(differing, pairs, psi_confidence)
                                    : clopper_pearson_upper(differing, pairs, psi_confidence));
}

}  // namespace

double mcnemar_p_value(std::size_t gained, std::size_t lost) {
  const auto fewer = static_cast<unsigned>(std::min(gained, lost));
  return std::min(1.0, 2 * gsl_cdf_binomial_P(fewer, 0.5, static_cast<unsigned>(gained + lost)));
}

PairedShare paired_share(std::size_t pairs, std::size_t gained, std::size_t lost,
                         double confidence) {
  PairedShare share{pairs, gained, lost, {}, 1};
  if (pairs == 0) return share;
  const auto n = static_cast<double>(pairs), g = static_cast<double>(gained),
             l = static_cast<double>(lost);
  const double error = 0.5 * (1 - confidence);
  share.change = {(g - l) / n, -upper_end(n, l, g, error), upper_end(n, g, l, error)};
  share.p_value = mcnemar_p_value(gained, lost);
  return share;
}

}  // namespace cagetol
