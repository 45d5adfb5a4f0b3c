#include "analysis/tolerance/binding.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {
namespace {

constexpr double kFewFailing = 5;

/// The candidate's bands without those of dimension d.
std::vector<double> rest_of(const Candidate& candidate, std::size_t d) {
  auto bands = candidate.bands_mm;
  bands.erase(bands.begin() + static_cast<std::ptrdiff_t>(d));
  return bands;
}

/// Candidates among which the decision lies: those whose other bands meet the target with at least
/// one band of dimension d. All of them where none does.
std::vector<bool> relevant_candidates(const StudyPlan& plan, const YieldCurves& curves,
                                      std::size_t d) {
  std::vector<bool> relevant(plan.candidates.size(), false);
  for (std::size_t k = 0; k < relevant.size(); ++k) {
    const Yield& yield = curves.candidates[k];
    if (yield.ess < kFewestEffectiveRuns || yield.if_unknown_fail < plan.target_yield) continue;
    for (std::size_t other = 0; other < relevant.size(); ++other)
      if (rest_of(plan.candidates[other], d) == rest_of(plan.candidates[k], d))
        relevant[other] = true;
  }
  if (std::none_of(relevant.begin(), relevant.end(), [](bool is) { return is; }))
    relevant.assign(relevant.size(), true);
  return relevant;
}

std::vector<double> level_weights(const LevelYield& level, const MixtureWeights& mixture,
                                  const std::vector<bool>& relevant) {
  std::vector<std::size_t> kept;
  for (const std::size_t k : level.candidates)
    if (relevant[k]) kept.push_back(k);
  return average_weights(mixture, kept);
}

/// Effective number of failing runs under the weights, and of all runs.
struct EffectiveRuns {
  double failing = 0, all = 0;
};

EffectiveRuns effective_runs(const std::vector<Judgement>& joint, std::span<const double> weights) {
  double total = 0, failing = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    total += weights[i];
    if (joint[i] != Judgement::meets) failing += weights[i];
  }
  const double ess = effective_sample_size(weights);
  return {ess * failing / total, ess};
}

BindingTest test_dimension(const DimensionCurve& curve, const MixtureWeights& mixture,
                           const std::vector<Judgement>& joint, const Resampling& resampling,
                           const std::vector<bool>& relevant, double error_each,
                           double target_yield) {
  const LevelYield& narrowest = curve.levels.front();
  BindingTest test{curve.key,
                   Binding::undecided,
                   0,
                   0,
                   1 - target_yield,
                   band_name(narrowest.grade, narrowest.band_mm),
                   band_name(curve.levels.back().grade, curve.levels.back().band_mm)};
  const auto narrow = level_weights(narrowest, mixture, relevant);
  const double two_sided = gsl_cdf_ugaussian_Qinv(0.5 * error_each);
  const double one_sided = gsl_cdf_ugaussian_Qinv(error_each);
  bool significant = false;
  for (std::size_t i = 1; i < curve.levels.size(); ++i) {
    const auto wide = level_weights(curve.levels[i], mixture, relevant);
    const YieldDifference loss = yield_difference(joint, narrow, wide, resampling);
    const EffectiveRuns runs = effective_runs(joint, wide);
    test.largest_loss = std::max(test.largest_loss, loss.value);
    if (runs.failing < kFewFailing) {
      const double bound = clopper_pearson_upper(runs.failing, runs.all, 1 - error_each);
      test.largest_loss_bound = std::max(test.largest_loss_bound, bound);
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
    case Binding::binding:
      return "binding";
    case Binding::not_binding:
      return "not binding";
    case Binding::undecided:
      break;
  }
  return "undecided";
}

std::vector<BindingTest> test_binding(const StudyData& runs, const MixtureWeights& mixture,
                                      const YieldCurves& curves,
                                      const std::vector<Judgement>& joint,
                                      const Resampling& resampling) {
  std::size_t comparisons = 0;
  for (const DimensionCurve& curve : curves.dimensions) comparisons += curve.levels.size() - 1;
  const double error_each =
      (1 - runs.plan.confidence) / static_cast<double>(std::max<std::size_t>(comparisons, 1));
  std::vector<BindingTest> tests;
  for (std::size_t d = 0; d < curves.dimensions.size(); ++d)
    tests.push_back(test_dimension(curves.dimensions[d], mixture, joint, resampling,
                                   relevant_candidates(runs.plan, curves, d), error_each,
                                   runs.plan.target_yield));
  return tests;
}

std::string band_name(const std::string& grade, double band_mm) {
  return grade.empty() ? fmt::format("{:.4g} mm", band_mm) : grade;
}

}  // namespace cagetol
