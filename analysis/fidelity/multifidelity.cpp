#include "analysis/fidelity/multifidelity.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

struct Pilot {
  std::vector<double> deviation, correlation;  ///< the latter with the expensive model
};

Pilot pilot_of(std::span<const std::vector<double>> values) {
  std::vector<std::vector<double>> kept(values.size());
  for (std::size_t k = 0; k < values.front().size(); ++k)
    if (std::none_of(values.begin(), values.end(),
                     [k](const auto& model) { return std::isnan(model[k]); }))
      for (std::size_t i = 0; i < values.size(); ++i) kept[i].push_back(values[i][k]);
  Pilot pilot;
  const std::size_t count = kept.front().size();
  for (const auto& model : kept) {
    const bool enough = count >= kFewestPilotSamples;
    pilot.deviation.push_back(enough ? gsl_stats_sd(model.data(), 1, count) : 0);
    pilot.correlation.push_back(
        enough ? gsl_stats_correlation(kept[0].data(), 1, model.data(), 1, count) : 0);
  }
  return pilot;
}

/// The plan with these models, sorted by falling correlation; gain 0 where it does not hold.
MultifidelityPlan plan_with(const std::vector<std::size_t>& models, const Pilot& pilot,
                            std::span<const double> costs) {
  const auto squared = [&](std::size_t i) {
    return i < models.size() ? std::pow(pilot.correlation[models[i]], 2) : 0;
  };
  MultifidelityPlan plan{models, {}, {}, 0};
  double root = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const double step = squared(i) - squared(i + 1), cost = costs[models[i]] / costs[models[0]];
    if (!(step > 0)) return plan;
    plan.ratios.push_back(std::sqrt(step / (cost * (1 - squared(1)))));
    plan.weights.push_back(pilot.correlation[models[i]] * pilot.deviation[models[0]] /
                           pilot.deviation[models[i]]);
    if (i > 0 && !(plan.ratios[i] > plan.ratios[i - 1])) return plan;
    root += std::sqrt(cost * step);
  }
  plan.gain = 1 / (root * root);
  return plan;
}

}  // namespace

MultifidelityPlan plan_multifidelity(std::span<const std::vector<double>> values,
                                     std::span<const double> costs) {
  const Pilot pilot = pilot_of(values);
  std::vector<std::size_t> helpers;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (pilot.deviation[i] > 0 && std::abs(pilot.correlation[i]) < 1) helpers.push_back(i);
  std::sort(helpers.begin(), helpers.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(pilot.correlation[a]) > std::abs(pilot.correlation[b]);
  });
  const MultifidelityPlan alone{{0}, {1}, {1}, 1};
  MultifidelityPlan best = alone;
  for (std::size_t chosen = 1; chosen < std::size_t{1} << helpers.size(); ++chosen) {
    std::vector<std::size_t> models = {0};
    for (std::size_t i = 0; i < helpers.size(); ++i)
      if (chosen >> i & 1) models.push_back(helpers[i]);
    const MultifidelityPlan plan = plan_with(models, pilot, costs);
    if (plan.gain > best.gain) best = plan;
  }
  return best.gain >= kLeastMultifidelityGain ? best : alone;
}

std::vector<std::size_t> multifidelity_counts(const MultifidelityPlan& plan,
                                              std::span<const double> costs, double cost) {
  double one = 0;
  for (std::size_t i = 0; i < plan.models.size(); ++i)
    one += plan.ratios[i] * costs[plan.models[i]];
  std::vector<std::size_t> counts;
  for (const double ratio : plan.ratios)
    counts.push_back(std::max<std::size_t>(2, static_cast<std::size_t>(ratio * cost / one)));
  return counts;
}

MultifidelityMean multifidelity_mean(const MultifidelityPlan& plan,
                                     std::span<const std::vector<double>> values) {
  MultifidelityMean mean;
  mean.value = 0;
  // What each sample adds to the deviation of the mean; samples of a shell, m_{i-1} <= k < m_i, are
  // alike. A sample that is left out of a term deviates there by nothing.
  std::vector<double> share(values.back().size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<std::size_t> kept;
    const auto term = [&](std::size_t k) {
      const double next = i + 1 < values.size() ? plan.weights[i + 1] * values[i + 1][k] : 0;
      return plan.weights[i] * values[i][k] - next;
    };
    for (std::size_t k = 0; k < values[i].size(); ++k)
      if (!std::isnan(term(k))) kept.push_back(k);
    mean.lost += values[i].size() - kept.size();
    const auto count = static_cast<double>(kept.size());
    double sum = 0;
    for (const std::size_t k : kept) sum += term(k);
    mean.value += sum / count;
    for (const std::size_t k : kept) share[k] += (term(k) - sum / count) / count;
  }
  double variance = 0;
  for (std::size_t i = 0, begin = 0; i < values.size(); begin = values[i++].size()) {
    const std::size_t count = values[i].size() - begin;
    if (count > 1)
      variance += static_cast<double>(count) * gsl_stats_variance(share.data() + begin, 1, count);
  }
  mean.standard_error = std::sqrt(variance);
  return mean;
}

}  // namespace cagetol
