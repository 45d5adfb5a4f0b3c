// Probability laws of one number. Sampling uses the quantile function only, so that a law works
// with every design.
//
// A law is in the unit of its key. Call check() first: the other functions assume a law that it
// accepts. A law of zero width (sigma = 0) is valid and means a constant.
#pragma once

#include <string_view>
#include <variant>

#include "distributions/laws/capability.hpp"
#include "distributions/laws/empirical.hpp"
#include "distributions/laws/histogram.hpp"
#include "distributions/laws/interval.hpp"
#include "distributions/laws/lognormal.hpp"
#include "distributions/laws/normal.hpp"
#include "distributions/laws/triangular.hpp"
#include "distributions/laws/truncated_normal.hpp"
#include "distributions/laws/uniform.hpp"
#include "distributions/laws/weibull.hpp"

namespace cagetol {

using Law = std::variant<Normal, TruncatedNormal, Uniform, Triangular, Lognormal, Weibull,
                         Histogram, Empirical, Capability>;

/// Throws std::invalid_argument with reason and remedy if the parameters are not valid.
void check(const Law& law);

/// The smallest x with cdf(x) >= p. quantile(0) and quantile(1) are the ends of the support and may
/// be infinite. Throws std::domain_error unless 0 <= p <= 1.
double quantile(const Law& law, double p);

/// P(X <= x).
double cdf(const Law& law, double x);

/// Density. Throws std::domain_error for laws without one: empirical laws and laws of zero width.
double pdf(const Law& law, double x);

double mean(const Law& law);
double standard_deviation(const Law& law);

/// The smallest closed interval with probability 1.
Interval support(const Law& law);

/// The name in study files: "normal", "truncated_normal", ...
std::string_view law_name(const Law& law);

}  // namespace cagetol
