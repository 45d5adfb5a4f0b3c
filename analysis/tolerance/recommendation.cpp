#include "analysis/tolerance/recommendation.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "analysis/sensitivity/features.hpp"
#include "analysis/statistics/summary.hpp"
#include "analysis/tolerance/centre_response.hpp"
#include "analysis/tolerance/cost.hpp"
#include "distributions/iso286.hpp"
#include "mc/study_file/tolerance.hpp"

namespace cagetol {
namespace {

constexpr double kRounding = 1e-9;

/// Product of the tolerances of the dimensions that matter, each relative to its widest candidate.
double width_of(const Candidate& candidate, const YieldCurves& curves,
                const std::vector<BindingTest>& tests) {
  double product = 1;
  for (std::size_t d = 0; d < tests.size(); ++d)
    if (tests[d].answer != Binding::not_binding)
      product *=
          candidate.tolerance_widths_mm[d] / curves.dimensions[d].levels.back().tolerance_width_mm;
  return product;
}

/// Dimensions that are not binding stay at their widest candidate.
bool eligible(const Candidate& candidate, const YieldCurves& curves,
              const std::vector<BindingTest>& tests) {
  for (std::size_t d = 0; d < tests.size(); ++d)
    if (tests[d].answer == Binding::not_binding &&
        candidate.tolerance_widths_mm[d] != curves.dimensions[d].levels.back().tolerance_width_mm)
      return false;
  return true;
}

/// Mean of the quantity that breaks ties between centres, over all tolerances at the candidate's
/// centres, for one candidate has few runs; nothing where the study has no such quantity.
std::optional<double> mean_peak_force(const StudyData& runs, const MixtureWeights& mixture,
                                      std::size_t candidate) {
  const Column* column = find_quantity(runs, kCentreQuantity);
  if (column == nullptr) return std::nullopt;
  std::vector<std::size_t> same_centres;
  for (std::size_t k = 0; k < runs.plan.candidates.size(); ++k)
    if (runs.plan.candidates[k].shifts == runs.plan.candidates[candidate].shifts)
      same_centres.push_back(k);
  const double mean =
      weighted_mean(ok_values(runs, column->values), average_weights(mixture, same_centres));
  return std::isnan(mean) ? std::nullopt : std::optional(mean);
}

/// True where two candidates with equal tolerances differ in their centres and the first one
/// presses its pockets less.
bool better_centre(const StudyData& runs, const MixtureWeights& mixture, std::size_t one,
                   std::size_t other) {
  const Candidate &a = runs.plan.candidates[one], &b = runs.plan.candidates[other];
  if (a.tolerance_widths_mm != b.tolerance_widths_mm || a.shifts == b.shifts) return false;
  const auto force = mean_peak_force(runs, mixture, one),
             other_force = mean_peak_force(runs, mixture, other);
  return force && other_force && *force < *other_force;
}

/// The widest (or cheapest) that meets the target, or the best where none does.
void choose(const StudyData& runs, const MixtureWeights& mixture, const YieldCurves& curves,
            const std::vector<BindingTest>& tests, const CandidateFilter& allowed,
            Recommendation& result) {
  const StudyPlan& plan = runs.plan;
  double most = 0, best = -1;
  for (std::size_t k = 0; k < plan.candidates.size(); ++k) {
    const Yield& yield = curves.candidates[k];
    if (!eligible(plan.candidates[k], curves, tests)) continue;
    result.none_can_meet = result.none_can_meet && yield.upper_bound < plan.target_yield;
    if (yield.ess < kMinimumEffectiveRuns) continue;
    if (!allowed && yield.pooled) continue;  // nothing is claimed without runs of its own
    result.possible = true;
    const bool meets = allowed ? allowed(k) : yield.lower_bound >= plan.target_yield;
    const auto cost = cost_of_tolerances(plan, plan.candidates[k].tolerance_widths_mm);
    const double worth = cost ? -*cost : width_of(plan.candidates[k], curves, tests);
    if (result.meets_target && !meets) continue;
    const bool first_to_meet = meets && !result.meets_target;
    const Candidate &own = plan.candidates[k], &chosen = plan.candidates[result.candidate];
    const bool same_tolerances_chosen = result.meets_target && own.middles == chosen.middles &&
                                        own.tolerance_widths_mm == chosen.tolerance_widths_mm;
    const bool better = !meets                   ? yield.lower_bound > best
                        : worth != most          ? worth > most
                        : same_tolerances_chosen ? better_centre(runs, mixture, k, result.candidate)
                                                 : yield.lower_bound > best;
    if (!first_to_meet && !better) continue;
    result.meets_target = meets;
    result.candidate = k;
    most = worth;
    best = yield.lower_bound;
  }
}

double nominal_of(const StudyData& runs, const std::string& key) {
  const InputColumns* input = find_input(runs, key);
  return input == nullptr || input->nominal.empty() ? 0 : input->nominal.front();
}

/// A tolerance width in mm as the grade that fits into it; the tolerance itself where none does.
struct Snapped {
  double tolerance_width_mm = 0;
  std::string grade;
};
Snapped snap(const StudyData& runs, const std::string& key, double tolerance_width_mm) {
  if (!is_size(key)) return {tolerance_width_mm, ""};
  const double nominal = nominal_of(runs, key);
  if (!(nominal > 0)) return {tolerance_width_mm, ""};
  const auto grade = grade_within(1e3 * tolerance_width_mm * (1 + kRounding), nominal);
  if (!grade) return {tolerance_width_mm, ""};
  return {1e-3 * grade_width_um(*grade, nominal), grade_name(*grade)};
}

/// Tolerances of the chosen combination; a tolerance given in mm is snapped down. True when any
/// tolerance moved.
bool set_tolerances(const StudyData& runs, const YieldCurves& curves,
                    const std::vector<BindingTest>& tests, Recommendation& result) {
  bool moved = false;
  const Candidate& chosen = runs.plan.candidates[result.candidate];
  for (std::size_t d = 0; d < tests.size(); ++d) {
    const auto& key = runs.plan.dimensions[d].key;
    RecommendedTolerance width{key,
                               plain_name(key),
                               tests[d].answer == Binding::not_binding,
                               chosen.tolerance_widths_mm[d],
                               chosen.grades[d],
                               std::nullopt,
                               false};
    if (!runs.plan.dimensions[d].centres.empty())
      width.centre = nominal_of(runs, key) + chosen.centre_shift(d);
    width.widest_studied =
        chosen.tolerance_widths_mm[d] == curves.dimensions[d].levels.back().tolerance_width_mm;
    if (width.grade.empty()) {
      const Snapped snapped = snap(runs, key, width.tolerance_width_mm);
      moved = moved || snapped.tolerance_width_mm < width.tolerance_width_mm * (1 - kRounding);
      width.tolerance_width_mm = snapped.tolerance_width_mm;
      width.grade = snapped.grade;
    }
    result.tolerances.push_back(width);
  }
  return moved;
}

/// The yield at the snapped tolerances, where the runs can tell; narrower tolerances cannot be
/// claimed to do better otherwise.
void judge_snapped(const StudyData& runs, const MixtureWeights& mixture,
                   const std::vector<Judgement>& joint, const Resampling& resampling,
                   Recommendation& result) {
  if (mixture.log_mixture.empty()) return;
  std::vector<double> scales;
  for (std::size_t d = 0; d < result.tolerances.size(); ++d)
    scales.push_back(result.tolerances[d].tolerance_width_mm /
                     runs.plan.dimensions[d].tolerance_width_mm);
  auto weights =
      weights_of_scales(runs, mixture, scales, runs.plan.candidates[result.candidate].all_shifts());
  if (effective_sample_size(weights) < kMinimumEffectiveRuns) return;
  // No fewer cages fit than under the wider candidate.
  result.yield =
      yield_of_all(estimate_yield(runs, joint, weights, resampling, runs.plan.confidence),
                   mixture.fit[result.candidate]);
  result.weights = std::move(weights);
}

/// The candidate that differs from `chosen` only in dimension d, one tolerance narrower (step -1)
/// or wider (+1), the one whose zone lies most alike where there are several; npos for none.
std::size_t neighbour(const StudyPlan& plan, std::size_t chosen, std::size_t d, int step) {
  const Candidate& own = plan.candidates[chosen];
  const auto place = [d](const Candidate& of) { return of.middle(d) / of.tolerance_widths_mm[d]; };
  std::size_t best = std::string::npos;
  std::pair<double, double> least;
  for (std::size_t k = 0; k < plan.candidates.size(); ++k) {
    const Candidate& other = plan.candidates[k];
    const double wider = step * (other.tolerance_widths_mm[d] - own.tolerance_widths_mm[d]);
    if (!(wider > 0) || rest_of(other, d) != rest_of(own, d)) continue;
    const std::pair away(wider, std::abs(place(other) - place(own)));
    if (best == std::string::npos || away < least) best = k, least = away;
  }
  return best;
}

void add_steps(const StudyData& runs, const MixtureWeights& mixture, const YieldCurves& curves,
               const std::vector<Judgement>& joint, const Resampling& resampling,
               Recommendation& result) {
  const auto& plan = runs.plan;
  const double z = gsl_cdf_ugaussian_Qinv(0.5 * (1 - plan.confidence));
  for (std::size_t d = 0; d < plan.dimensions.size(); ++d)
    for (const int step : {-1, 1}) {
      const std::size_t other = neighbour(plan, result.candidate, d, step);
      if (other == std::string::npos || curves.candidates[other].pooled ||
          curves.candidates[other].ess < kFewestEffectiveRuns)
        continue;
      const auto difference = yield_difference(
          joint, mixture.candidate[other], mixture.candidate[result.candidate], resampling,
          mixture.fit[other].share, mixture.fit[result.candidate].share);
      const auto name = [&](std::size_t k) {
        return tolerance_name(plan.candidates[k].grades[d],
                              plan.candidates[k].tolerance_widths_mm[d]);
      };
      result.steps.push_back({plan.dimensions[d].key, name(result.candidate), name(other),
                              difference.value, difference.value - z * difference.standard_error,
                              difference.value + z * difference.standard_error});
    }
}

}  // namespace

Recommendation recommend_tolerance(const StudyData& runs, const MixtureWeights& mixture,
                                   const YieldCurves& curves, const std::vector<BindingTest>& tests,
                                   const std::vector<Judgement>& joint,
                                   const Resampling& resampling, const CandidateFilter& allowed) {
  Recommendation result;
  if (mixture.candidate.empty()) return result;
  choose(runs, mixture, curves, tests, allowed, result);
  if (!result.possible) return result;
  result.yield = curves.candidates[result.candidate];
  result.weights = mixture.candidate[result.candidate];
  if (set_tolerances(runs, curves, tests, result))
    judge_snapped(runs, mixture, joint, resampling, result);
  std::vector<double> widths;
  for (const RecommendedTolerance& tolerance : result.tolerances)
    widths.push_back(tolerance.tolerance_width_mm);
  result.cost = cost_of_tolerances(runs.plan, widths);
  add_steps(runs, mixture, curves, joint, resampling, result);
  return result;
}

Recommendation recommend_allowed(const StudyData& runs, const MixtureWeights& mixture,
                                 const YieldCurves& curves, const std::vector<BindingTest>& tests,
                                 const std::vector<Judgement>& joint, const Resampling& resampling,
                                 const CandidateFilter& allowed) {
  const auto recommend = [&](const std::vector<BindingTest>& with) {
    return recommend_tolerance(runs, mixture, curves, with, joint, resampling, allowed);
  };
  Recommendation held = recommend(tests);
  if (held.meets_target) return held;
  auto freed = tests;
  for (BindingTest& test : freed)
    if (test.answer == Binding::not_binding) test.answer = Binding::undecided;
  Recommendation other = recommend(freed);
  return other.meets_target ? other : held;
}

bool same_tolerances(const std::vector<double>& one, const std::vector<double>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](double a, double b) { return std::abs(a - b) <= kRounding * b; });
}

bool same_centres(const Tolerance& one, const Tolerance& other) {
  for (std::size_t d = 0; d < one.tolerance_widths_mm.size(); ++d) {
    const double a = one.shifts.empty() ? 0 : one.shifts[d],
                 b = other.shifts.empty() ? 0 : other.shifts[d];
    if (std::abs(a - b) > kRounding * std::max({std::abs(a), std::abs(b), 1.0})) return false;
  }
  return true;
}

bool same_tolerance(const Tolerance& one, const Tolerance& other) {
  return same_tolerances(one.tolerance_widths_mm, other.tolerance_widths_mm) &&
         same_centres(one, other);
}

Tolerance tolerance_tried(const StudyData& attempt) {
  const Candidate& candidate = attempt.plan.candidates.front();
  return {candidate.tolerance_widths_mm, candidate.all_shifts()};
}

Tolerance snapped_tolerance(const StudyData& runs, const Candidate& candidate) {
  return {snapped_tolerances(runs, candidate), candidate.all_shifts()};
}

std::vector<double> snapped_tolerances(const StudyData& runs, const Candidate& candidate) {
  auto widths = candidate.tolerance_widths_mm;
  for (std::size_t d = 0; d < widths.size(); ++d)
    if (candidate.grades[d].empty())
      widths[d] = snap(runs, runs.plan.dimensions[d].key, widths[d]).tolerance_width_mm;
  return widths;
}

}  // namespace cagetol
