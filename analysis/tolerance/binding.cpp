#include "analysis/tolerance/binding.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {
namespace {

constexpr double kFewFailures = 5;

/// Upper bound of the share of failures at a level, from its effective number of runs.
double failure_bound(const LevelYield& level, double confidence) {
  const double trials = level.yield.ess;
  return 1 - clopper_pearson_lower(level.yield.if_unknown_fail * trials, trials, confidence);
}

BindingTest test_dimension(const DimensionCurve& curve, const MixtureWeights& mixture,
                           const std::vector<Judgement>& joint, const Resampling& resampling,
                           double error_each, double target_yield) {
  const LevelYield& narrowest = curve.levels.front();
  BindingTest test{curve.key, Binding::undecided, 0, 0, 1 - target_yield,
                   band_name(narrowest.grade, narrowest.band_mm),
                   band_name(curve.levels.back().grade, curve.levels.back().band_mm)};
  const auto narrow = average_weights(mixture, narrowest.candidates);
  const double failing = narrowest.yield.missing_runs + narrowest.yield.unknown_runs;
  const double two_sided = gsl_cdf_ugaussian_Qinv(0.5 * error_each);
  const double one_sided = gsl_cdf_ugaussian_Qinv(error_each);
  bool significant = false;
  for (std::size_t i = 1; i < curve.levels.size(); ++i) {
    const LevelYield& level = curve.levels[i];
    const YieldDifference loss =
        yield_difference(joint, narrow, average_weights(mixture, level.candidates), resampling);
    test.largest_loss = std::max(test.largest_loss, loss.value);
    if (failing < kFewFailures) {
      test.largest_loss_bound = std::max(test.largest_loss_bound, failure_bound(level, 1 - error_each));
      continue;
    }
    significant = significant || std::abs(loss.value) > two_sided * loss.standard_error;
    test.largest_loss_bound =
        std::max(test.largest_loss_bound, loss.value + one_sided * loss.standard_error);
  }
  if (significant)
    test.answer = Binding::binding;
  else if (curve.levels.size() > 1 && test.largest_loss_bound <= test.allowed_loss)
    test.answer = Binding::not_binding;
  return test;
}

}  // namespace

const char* binding_name(Binding binding) {
  switch (binding) {
    case Binding::binding: return "binding";
    case Binding::not_binding: return "not binding";
    case Binding::undecided: break;
  }
  return "undecided";
}

std::vector<BindingTest> test_binding(const StudyData& runs, const MixtureWeights& mixture,
                                      const YieldCurves& curves, const std::vector<Judgement>& joint,
                                      const Resampling& resampling) {
  std::size_t comparisons = 0;
  for (const DimensionCurve& curve : curves.dimensions) comparisons += curve.levels.size() - 1;
  const double error_each =
      (1 - runs.plan.confidence) / static_cast<double>(std::max<std::size_t>(comparisons, 1));
  std::vector<BindingTest> tests;
  for (const DimensionCurve& curve : curves.dimensions)
    tests.push_back(test_dimension(curve, mixture, joint, resampling, error_each, runs.plan.target_yield));
  return tests;
}

std::string band_name(const std::string& grade, double band_mm) {
  return grade.empty() ? fmt::format("{:.4g} mm", band_mm) : grade;
}

}  // namespace cagetol
