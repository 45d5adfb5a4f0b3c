#include "analysis/tolerance/binding.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "analysis/statistics/binomial_bounds.hpp"
#include "analysis/tolerance/cost.hpp"

namespace cagetol {
namespace {

constexpr double kFew = 5;
/// A loss of good cages because they do not fit is known: above this share of what the target
/// allows to fail it counts as significant.
constexpr double kKnownLoss = 0.05;

/// Candidates among which the decision lies: those whose other tolerances meet the target with at
/// least one tolerance of dimension d. All of them where none does.
std::vector<bool> relevant_candidates(const StudyPlan& plan, const YieldCurves& curves,
                                      std::size_t d) {
  std::vector<bool> relevant(plan.candidates.size(), false);
  for (std::size_t k = 0; k < relevant.size(); ++k) {
    const Yield& yield = curves.candidates[k];
    if (yield.pooled || yield.ess < kFewestEffectiveRuns ||
        yield.if_unknown_fail < plan.target_yield)
      continue;
    for (std::size_t other = 0; other < relevant.size(); ++other)
      if (rest_of(plan.candidates[other], d) == rest_of(plan.candidates[k], d))
        relevant[other] = true;
  }
  if (std::none_of(relevant.begin(), relevant.end(), [](bool is) { return is; }))
    relevant.assign(relevant.size(), true);
  return relevant;
}

bool meets_target(const StudyPlan& plan, const Yield& yield) {
  return !yield.pooled && yield.ess >= kFewestEffectiveRuns &&
         yield.lower_bound >= plan.target_yield;
}

/// The widest (cheapest) candidate that meets the target, nothing where none does.
std::optional<std::size_t> widest_that_meets(const StudyPlan& plan, const YieldCurves& curves) {
  std::optional<std::size_t> widest;
  double most = 0;
  for (std::size_t k = 0; k < plan.candidates.size(); ++k) {
    if (!meets_target(plan, curves.candidates[k])) continue;
    const double worth = worth_of_tolerances(plan, plan.candidates[k].tolerance_widths_mm);
    if (widest && worth <= most) continue;
    widest = k;
    most = worth;
  }
  return widest;
}

/// Runs of a level, and the share of its cages that fit.
struct LevelRuns {
  std::vector<double> weights;
  double fits = 1;
};

LevelRuns runs_of_level(const LevelYield& level, const MixtureWeights& mixture,
                        const std::vector<bool>& relevant) {
  std::vector<std::size_t> kept;
  for (const std::size_t k : level.candidates)
    if (relevant[k]) kept.push_back(k);
  return {average_weights(mixture, kept), average_fit(mixture, kept).share};
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

/// Number of equally weighted lots that tell as much.
double effective_lots(std::span<const double> weights, const Resampling& resampling) {
  std::vector<double> of_lot(resampling.lots());
  for (std::size_t i = 0; i < weights.size(); ++i) of_lot[resampling.lot_of()[i]] += weights[i];
  return effective_sample_size(of_lot);
}

/// Loss of yield from narrow to wide tolerances, unknown runs counted so that it is least and
/// largest: as passing where they weigh less under the narrow tolerances, or where they weigh more.
struct LossRange {
  YieldDifference minimum, largest;
};

LossRange loss_range(const std::vector<Judgement>& joint, const LevelRuns& narrow_runs,
                     const LevelRuns& wide_runs, const Resampling& resampling) {
  const std::vector<double>&narrow = narrow_runs.weights, &wide = wide_runs.weights;
  const double narrow_sum = std::accumulate(narrow.begin(), narrow.end(), 0.0);
  const double wide_sum = std::accumulate(wide.begin(), wide.end(), 0.0);
  auto minimum = joint, largest = joint;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    if (joint[i] != Judgement::unknown) continue;
    const bool weighs_more = narrow[i] / narrow_sum > wide[i] / wide_sum;
    minimum[i] = weighs_more ? Judgement::misses : Judgement::meets;
    largest[i] = weighs_more ? Judgement::meets : Judgement::misses;
  }
  const auto difference = [&](const std::vector<Judgement>& judged) {
    return yield_difference(judged, narrow, wide, resampling, narrow_runs.fits, wide_runs.fits);
  };
  return {difference(minimum), difference(largest)};
}

BindingTest test_dimension(const DimensionCurve& curve, const MixtureWeights& mixture,
                           const std::vector<Judgement>& joint, const Resampling& resampling,
                           const std::vector<bool>& relevant, double error_each,
                           double target_yield, bool at_widest) {
  const LevelYield& narrowest = curve.levels.front();
  const LevelRuns narrow = runs_of_level(narrowest, mixture, relevant);
  const EffectiveRuns narrow_runs = effective_runs(joint, narrow.weights);
  const double meeting = 1 - narrow_runs.failing / narrow_runs.all,  // of cages that fit
      margin = narrow.fits * meeting - target_yield;
  BindingTest test{
      curve.key,
      Binding::undecided,
      0,
      0,
      std::max(margin, 0.0),
      tolerance_name(narrowest.grade, narrowest.tolerance_width_mm),
      tolerance_name(curve.levels.back().grade, curve.levels.back().tolerance_width_mm)};
  bool significant = false, enough = true;
  for (std::size_t i = 1; i < curve.levels.size(); ++i) {
    const LevelRuns wide = runs_of_level(curve.levels[i], mixture, relevant);
    const LossRange loss = loss_range(joint, narrow, wide, resampling);
    const EffectiveRuns runs = effective_runs(joint, wide.weights);
    const double lots = std::min(effective_lots(narrow.weights, resampling),
                                 effective_lots(wide.weights, resampling));
    const double known = narrow.fits - wide.fits;
    significant = significant || meeting * known > kKnownLoss * (1 - target_yield);
    test.largest_loss = std::max(test.largest_loss, loss.largest.value);
    if (lots < kFewestLots || std::min(runs.all, narrow_runs.all) < kFewestEffectiveRuns) {
      enough = false;
      test.largest_loss_bound = 1;
      continue;
    }
    const double two_sided = gsl_cdf_tdist_Qinv(0.5 * error_each, lots - 1);
    const double one_sided = gsl_cdf_tdist_Qinv(error_each, lots - 1);
    if (runs.failing < kFew) {
      const double bound =
          std::max(known, 0.0) + clopper_pearson_upper(runs.failing, runs.all, 1 - error_each);
      test.largest_loss_bound = std::max(test.largest_loss_bound, bound);
      continue;
    }
    // Of few runs that pass, as of few that fail, the scatter says too little.
    const double passing = std::max(runs.all - runs.failing, narrow_runs.all - narrow_runs.failing);
    if (passing >= kFew)
      significant = significant || loss.minimum.value > two_sided * loss.minimum.standard_error ||
                    loss.largest.value < -two_sided * loss.largest.standard_error;
    test.largest_loss_bound = std::max(
        test.largest_loss_bound, loss.largest.value + one_sided * loss.largest.standard_error);
  }
  if (significant)
    test.answer = Binding::binding;
  else if (curve.levels.size() > 1 && enough && at_widest &&
           test.largest_loss_bound <= test.allowed_loss)
    test.answer = Binding::not_binding;
  return test;
}

}  // namespace

const char* binding_name(Binding binding) {
  constexpr const char* kNames[] = {"binding", "not binding", "undecided"};
  return kNames[static_cast<int>(binding)];
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
  const auto widest = widest_that_meets(runs.plan, curves);
  for (std::size_t d = 0; d < curves.dimensions.size(); ++d) {
    const DimensionCurve& curve = curves.dimensions[d];
    const bool at_widest = widest && runs.plan.candidates[*widest].tolerance_widths_mm[d] ==
                                         curve.levels.back().tolerance_width_mm;
    tests.push_back(test_dimension(curve, mixture, joint, resampling,
                                   relevant_candidates(runs.plan, curves, d), error_each,
                                   runs.plan.target_yield, at_widest));
  }
  return tests;
}

std::vector<double> rest_of(const Candidate& candidate, std::size_t d) {
  auto rest = candidate.shifts;
  for (const auto* of : {&candidate.tolerance_widths_mm, &candidate.middles})
    for (std::size_t other = 0; other < of->size(); ++other)
      if (other != d) rest.push_back((*of)[other]);
  return rest;
}

std::string tolerance_name(const std::string& grade, double tolerance_width_mm) {
  return grade.empty() ? fmt::format("{:.4g} mm", tolerance_width_mm) : grade;
}

}  // namespace cagetol
