#include "analysis/fidelity/control_variate.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "analysis/fidelity/multifidelity.hpp"
#include "distributions/random_stream.hpp"

namespace cagetol {
namespace {

/// Columns of h and c; c is longer.
struct Terms {
  std::vector<double> h, c;
};

struct Pairs {
  std::vector<double> first, second;
};

Pairs known_pairs(std::span<const double> first, std::span<const double> second) {
  Pairs pairs;
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (std::isnan(first[k]) || std::isnan(second[k])) continue;
    pairs.first.push_back(first[k]);
    pairs.second.push_back(second[k]);
  }
  return pairs;
}

double known_mean(std::span<const double> values) {
  double sum = 0, count = 0;
  for (const double value : values)
    if (!std::isnan(value)) {
      sum += value;
      ++count;
    }
  return sum / count;
}

bool meets(double value, std::span<const Limit> limits) {
  return std::all_of(limits.begin(), limits.end(), [value](const Limit& limit) {
    return !(limit.minimum && value < *limit.minimum) && !(limit.maximum && value > *limit.maximum);
  });
}

/// The limits leave one interval.
struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};
Interval allowed(std::span<const Limit> limits) {
  Interval interval;
  for (const Limit& limit : limits) {
    if (limit.minimum) interval.lower = std::max(interval.lower, *limit.minimum);
    if (limit.maximum) interval.upper = std::min(interval.upper, *limit.maximum);
  }
  return interval;
}

/// Squares are centred by the mean of f with control variate. With the mean of the expensive runs
/// alone the squares of both models would correlate less.
Terms squares(const PairedRuns& runs) {
  Terms terms;
  const double f = helped_estimate(HelpedStatistic::mean, runs, {}).value,
               g = known_mean(runs.cheap);
  for (const double x : runs.expensive) terms.h.push_back((x - f) * (x - f));
  for (const double x : runs.cheap) terms.c.push_back((x - g) * (x - g));
  return terms;
}

Terms passes(const PairedRuns& runs, std::span<const Limit> limits) {
  Terms terms;
  for (const double x : runs.expensive) terms.h.push_back(std::isnan(x) ? x : meets(x, limits));
  const Pairs pairs = known_pairs(runs.expensive, runs.cheap);
  double at_zero, slope, cov00, cov01, cov11, rest;
  gsl_fit_linear(pairs.second.data(), 1, pairs.first.data(), 1, pairs.first.size(), &at_zero,
                 &slope, &cov00, &cov01, &cov11, &rest);
  const double scatter = std::sqrt(rest / static_cast<double>(pairs.first.size() - 2));
  const Interval within = allowed(limits);
  for (const double x : runs.cheap) {
    const double expected = at_zero + slope * x;
    if (std::isnan(x))
      terms.c.push_back(x);
    else if (scatter > 0)
      terms.c.push_back(gsl_cdf_ugaussian_P((within.upper - expected) / scatter) -
                        gsl_cdf_ugaussian_P((within.lower - expected) / scatter));
    else
      terms.c.push_back(meets(expected, limits));
  }
  return terms;
}

Terms terms_of(HelpedStatistic statistic, const PairedRuns& runs, std::span<const Limit> limits) {
  switch (statistic) {
    case HelpedStatistic::deviation:
      return squares(runs);
    case HelpedStatistic::yield:
      return passes(runs, limits);
    case HelpedStatistic::mean:
      break;
  }
  return {{runs.expensive.begin(), runs.expensive.end()}, {runs.cheap.begin(), runs.cheap.end()}};
}

/// Of a root, where the statistic is one.
void take_root(double& value, double& error) {
  value = std::sqrt(std::max(value, 0.0));
  error = value > 0 ? error / (2 * value) : kUndefined;
}

}  // namespace

const char* helped_statistic_name(HelpedStatistic statistic) {
  switch (statistic) {
    case HelpedStatistic::deviation:
      return "standard deviation";
    case HelpedStatistic::yield:
      return "yield";
    case HelpedStatistic::mean:
      break;
  }
  return "mean";
}

HelpedEstimate helped_estimate(HelpedStatistic statistic, const PairedRuns& runs,
                               std::span<const Limit> limits) {
  HelpedEstimate estimate;
  if (known_pairs(runs.expensive, runs.cheap).first.size() < kFewestPilotSamples) return estimate;
  const Terms terms = terms_of(statistic, runs, limits);
  const Pairs pairs = known_pairs(terms.h, terms.c);
  const std::size_t count = pairs.first.size();
  if (count < kFewestPilotSamples) return estimate;
  const double variance = gsl_stats_variance(pairs.second.data(), 1, count);
  const Pairs expensive = known_pairs(terms.h, terms.h);
  const auto n = static_cast<double>(expensive.first.size());
  estimate.plain = gsl_stats_mean(expensive.first.data(), 1, expensive.first.size());
  estimate.plain_error =
      gsl_stats_sd(expensive.first.data(), 1, expensive.first.size()) / std::sqrt(n);
  if (variance > 0 && estimate.plain_error > 0) {
    const double weight =
        gsl_stats_covariance(pairs.first.data(), 1, pairs.second.data(), 1, count) / variance;
    const MultifidelityPlan plan{{0, 1}, {1, 1}, {1, weight}, 1};
    const std::vector<std::vector<double>> values = {terms.h, terms.c};
    const MultifidelityMean mean = multifidelity_mean(plan, values);
    estimate.value = mean.value;
    estimate.standard_error = mean.standard_error;
    estimate.lost = mean.lost;
    estimate.correlation =
        gsl_stats_correlation(pairs.first.data(), 1, pairs.second.data(), 1, count);
  }
  if (statistic == HelpedStatistic::deviation) {
    take_root(estimate.plain, estimate.plain_error);  // for the error; the value has n - 1
    const Pairs values = known_pairs(runs.expensive, runs.expensive);
    estimate.plain = gsl_stats_sd(values.first.data(), 1, values.first.size());
    take_root(estimate.value, estimate.standard_error);
  }
  return estimate;
}

double gain_at_cost(double correlation, double samples, double cheap_samples, double cost) {
  if (std::isnan(correlation)) return 0;
  const double rest = 1 - correlation * correlation * (1 - samples / cheap_samples);
  return 1 / ((1 + cost * cheap_samples / samples) * rest);
}

double best_cheap_ratio(double correlation, double cost) {
  const double squared = correlation * correlation;
  return std::max(1.0, std::sqrt(squared / (cost * std::max(1 - squared, 1e-12))));
}

double resampled_gain(HelpedStatistic statistic, const PairedRuns& runs,
                      std::span<const Limit> limits, double cost, std::uint64_t seed,
                      int resamples) {
  const std::size_t n = runs.expensive.size(), m = runs.cheap.size();
  std::vector<double> expensive(n), cheap(m), plain, helped;
  for (int b = 0; b < resamples; ++b) {
    RandomStream draws(seed, Purpose::bootstrap, static_cast<std::uint64_t>(b),
                       stream_address("multifidelity"));
    const auto one_of = [&](std::size_t begin, std::size_t end) {
      return begin +
             std::min(end - begin - 1,
                      static_cast<std::size_t>(draws.next() * static_cast<double>(end - begin)));
    };
    for (std::size_t k = 0; k < m; ++k) {
      const std::size_t from = k < n ? one_of(0, n) : one_of(n, m);
      cheap[k] = runs.cheap[from];
      if (k < n) expensive[k] = runs.expensive[from];
    }
    const HelpedEstimate estimate = helped_estimate(statistic, {expensive, cheap}, limits);
    if (std::isnan(estimate.value) || std::isnan(estimate.plain)) continue;
    plain.push_back(estimate.plain);
    helped.push_back(estimate.value);
  }
  if (plain.size() < 2) return kUndefined;
  const double share = 1 + cost * static_cast<double>(m) / static_cast<double>(n);
  return gsl_stats_variance(plain.data(), 1, plain.size()) / share /
         gsl_stats_variance(helped.data(), 1, helped.size());
}

}  // namespace cagetol
