#include "analysis/tolerance/rare.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "analysis/sensitivity/features.hpp"
#include "analysis/sensitivity/noise_share.hpp"
#include "analysis/statistics/binomial_bounds.hpp"
#include "analysis/statistics/pareto_bound.hpp"
#include "analysis/study/judgement.hpp"
#include "analysis/tolerance/fit_share.hpp"

namespace cagetol {
namespace {

using Values = std::vector<double>;

/// Standard deviations from which on a limit is far: nearer ones would have bounds beyond 63 ppm.
constexpr double kFar = 7;

/// Values of the runs less the bound, turned so that what is above 0 misses; NaN without a result.
Values beyond_bound(const StudyData& runs, const RareLimit& limit) {
  Values values = ok_values(runs, find_quantity(runs, limit.quantity)->values);
  for (double& value : values) value = (limit.is_maximum ? 1 : -1) * (value - limit.bound);
  return values;
}

Values known_values(Values values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values;
}

/// Standard deviations from the mean of such values to the bound.
double distance_of(const Values& beyond) {
  const double room = -gsl_stats_mean(beyond.data(), 1, beyond.size()),
               deviation = gsl_stats_sd(beyond.data(), 1, beyond.size());
  return deviation > 0 ? room / deviation : std::copysign(HUGE_VAL, room);
}

/// Upper bound of the share by the limit's route; NaN where none is stated.
double stated_bound(const RareLimit& limit, const Values& beyond, double confidence) {
  const auto count = static_cast<double>(beyond.size());
  const double counted = clopper_pearson_upper(limit.missed, count, confidence);
  if (limit.route == RareRoute::unstated) return kUndefined;
  if (limit.route == RareRoute::counted) return counted;
  const double tail = extrapolated_bound(known_values(beyond), 0, confidence);
  return limit.missed > 0 ? std::max(tail, counted) : std::min(tail, counted);
}

/// Moves the value of each run to a tolerance that is wider by so many of its widths.
void widen(const std::vector<Feature>& features, const std::string& key, double widths,
           Values& values) {
  const std::size_t n = values.size();
  const Values before = values;
  for (const Feature& feature : features) {
    const double* x = feature.values.data();
    const bool scales = feature.name.ends_with("from cage to cage") ||
                        feature.name.ends_with("within-cage scatter");
    if (feature.input != key || !scales) continue;
    const double slope =
        gsl_stats_covariance(x, 1, before.data(), 1, n) / gsl_stats_variance(x, 1, n);
    for (std::size_t i = 0; i < n; ++i) values[i] += widths * slope * x[i];
  }
}

/// What the runs say of a limit, whose route is fixed.
void judge(const StudyData& runs, const StudyData& pilot, RareLimit& limit) {
  const double confidence = runs.plan.confidence, count = static_cast<double>(runs.size());
  const Values beyond = beyond_bound(runs, limit);
  for (const double value : beyond) limit.missed += !(value <= 0);
  limit.exact_lower = clopper_pearson_lower(limit.missed, count, confidence);
  limit.exact_upper = clopper_pearson_upper(limit.missed, count, confidence);
  limit.upper = stated_bound(limit, beyond, confidence);
  limit.if_normal = gsl_cdf_ugaussian_Q(distance_of(known_values(beyond)));
  limit.noise = noise_share(pilot, beyond_bound(pilot, limit), confidence).share.value;
  if (limit.route != RareRoute::extrapolated || limit.missed > 0) return;
  const auto features = cage_features(runs);
  for (const ToleranceDimension& dimension : runs.plan.dimensions) {
    limit.upper_at.emplace_back();
    for (const double width : kRareWidths) {
      Values moved = beyond;
      widen(features, dimension.key, width - 1, moved);
      limit.upper_at.back().push_back(extrapolated_bound(moved, 0, confidence));
    }
  }
}

}  // namespace

double showing_runs(double share, double confidence) {
  return std::ceil(std::log1p(-confidence) / std::log1p(-share));
}

std::vector<RareLimit> rare_routes(const StudyData& pilot, const RareSettings& settings) {
  const StudyData runs = select_samples(pilot, first_runs(pilot));
  const double showing = showing_runs(settings.target, pilot.plan.confidence);
  std::vector<RareLimit> routes;
  for (const Limit& limit : pilot.plan.limits)
    for (const bool is_maximum : {false, true}) {
      const auto& bound = is_maximum ? limit.maximum : limit.minimum;
      if (!bound || find_quantity(runs, limit.quantity) == nullptr) continue;
      RareLimit route{limit.quantity, *bound, is_maximum};
      route.distance = distance_of(known_values(beyond_bound(runs, route)));
      if (static_cast<double>(settings.fresh_runs) >= showing)
        route.route = RareRoute::counted;
      else if (route.distance >= kFar && settings.fresh_runs >= kFewestTailValues)
        route.route = RareRoute::extrapolated;
      routes.push_back(std::move(route));
    }
  return routes;
}

Rare judge_rare(const StudyData& pilot, const StudyData& runs, const RareSettings& settings) {
  Rare rare{.runs = static_cast<double>(runs.size()), .limits = rare_routes(pilot, settings)};
  const double alpha = 1 - runs.plan.confidence;
  const FitShare fit = fit_share(runs, 0, alpha);
  const double left = fit.risk_left * alpha;
  if (const JamShares& jam = runs.jam; !jam.candidate.empty()) {
    rare.jams = jam.candidate.front(), rare.draws = jam.draws;
    rare.jams_upper = jam.draws > 0 ? 1 - fit.bound : rare.jams + jam.error.front();
  }
  double missed = 0, sum = 0;
  for (const RunStatus status : runs.status) rare.lost += status != RunStatus::ok;
  for (const Judgement judged : judge_all(runs)) missed += judged != Judgement::meets;
  for (RareLimit& limit : rare.limits) {
    judge(runs, pilot, limit);
    sum += stated_bound(limit, beyond_bound(runs, limit),
                        1 - left / static_cast<double>(rare.limits.size()));
  }
  const double fits = 1 - rare.jams_upper;
  rare.exact_upper = 1 - fits * (1 - clopper_pearson_upper(missed, rare.runs, 1 - left));
  rare.upper = 1 - fits * (1 - (sum > 1 ? 1 : sum));
  return rare;
}

}  // namespace cagetol
