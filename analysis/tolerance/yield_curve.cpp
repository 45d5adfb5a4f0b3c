#include "analysis/tolerance/yield_curve.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {
namespace {

/// The candidates by tolerance and centre of a dimension.
std::vector<LevelYield> levels_at_centres(const StudyPlan& plan, std::size_t dimension) {
  if (plan.dimensions[dimension].centres.size() < 2) return {};
  std::map<std::pair<double, double>, LevelYield> levels;
  for (std::size_t k = 0; k < plan.candidates.size(); ++k) {
    const Candidate& candidate = plan.candidates[k];
    LevelYield& level =
        levels[{candidate.tolerance_widths_mm[dimension], candidate.shift(dimension)}];
    level.tolerance_width_mm = candidate.tolerance_widths_mm[dimension];
    level.grade = candidate.grades[dimension];
    level.candidates.push_back(k);
  }
  std::vector<LevelYield> list;
  for (auto& [place, level] : levels) list.push_back(std::move(level));
  return list;
}

DimensionCurve curve_of(const StudyPlan& plan, std::size_t dimension) {
  DimensionCurve curve{plan.dimensions[dimension].key, {}, levels_at_centres(plan, dimension)};
  for (std::size_t k = 0; k < plan.candidates.size(); ++k) {
    const Candidate& candidate = plan.candidates[k];
    const double width = candidate.tolerance_widths_mm[dimension],
                 middle = candidate.middle(dimension);
    auto level =
        std::find_if(curve.levels.begin(), curve.levels.end(), [&](const LevelYield& known) {
          return known.tolerance_width_mm == width && known.middle == middle;
        });
    if (level == curve.levels.end())
      level = curve.levels.insert(level, {width, candidate.grades[dimension], {}, {}, middle});
    level->candidates.push_back(k);
  }
  std::sort(curve.levels.begin(), curve.levels.end(), [](const LevelYield& a, const LevelYield& b) {
    return std::pair(a.tolerance_width_mm, a.middle) < std::pair(b.tolerance_width_mm, b.middle);
  });
  return curve;
}

const LevelYield& level_of(const DimensionCurve& curve, std::size_t candidate) {
  const auto& levels = curve.at_centres.empty() ? curve.levels : curve.at_centres;
  return *std::find_if(levels.begin(), levels.end(), [&](const LevelYield& level) {
    return std::count(level.candidates.begin(), level.candidates.end(), candidate) > 0;
  });
}

/// A candidate's yield from those of its tolerances, where these have runs enough; else as it is.
Yield pooled_yield(const Yield& own, std::size_t candidate, const YieldCurves& curves,
                   const Yield& all, double confidence) {
  double fail = all.if_unknown_fail / all.fits, pass = all.if_unknown_pass / all.fits,
         minimum = all.ess;
  for (const DimensionCurve& curve : curves.dimensions) {
    const Yield& of_tolerance = level_of(curve, candidate).yield;
    minimum = std::min(minimum, of_tolerance.ess);
    const double fits = of_tolerance.fits / all.fits;
    fail *= of_tolerance.if_unknown_fail / all.if_unknown_fail / fits;
    pass *= of_tolerance.if_unknown_pass / all.if_unknown_pass / fits;
  }
  if (!(minimum >= kMinimumEffectiveRuns) || std::isnan(fail) || std::isnan(pass)) return own;
  Yield pooled = own;
  pooled.ess = minimum;
  pooled.pooled = true;
  pooled.if_unknown_fail = std::min(fail, 1.0);
  pooled.if_unknown_pass = std::clamp(pass, pooled.if_unknown_fail, 1.0);
  pooled.lower_bound = clopper_pearson_lower(pooled.if_unknown_fail * minimum, minimum, confidence);
  pooled.upper_bound = clopper_pearson_upper(pooled.if_unknown_pass * minimum, minimum, confidence);
  pooled.method = "product of the yields of its tolerances, for want of runs of its own";
  return yield_of_all(pooled, {own.fits, own.fits, 1});
}

struct Share {
  double value = 0, total = 0;
};

Share passing_share(const std::vector<Judgement>& joint, std::span<const double> weights) {
  double passing = 0, total = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    total += weights[i];
    if (joint[i] == Judgement::meets) passing += weights[i];
  }
  return {passing / total, total};
}

}  // namespace

YieldCurves yield_curves(const StudyData& runs, const MixtureWeights& mixture,
                         const std::vector<Judgement>& joint, const Resampling& resampling,
                         double confidence) {
  YieldCurves curves;
  for (std::size_t k = 0; k < mixture.candidate.size(); ++k)
    curves.candidates.push_back(yield_of_all(
        estimate_yield(runs, joint, mixture.candidate[k], resampling, confidence), mixture.fit[k]));
  const auto averaged = [&](const std::vector<std::size_t>& candidates) {
    return yield_of_all(
        estimate_yield(runs, joint, average_weights(mixture, candidates), resampling, confidence),
        average_fit(mixture, candidates));
  };
  for (std::size_t d = 0; d < runs.plan.dimensions.size(); ++d) {
    DimensionCurve curve = curve_of(runs.plan, d);
    for (auto* levels : {&curve.levels, &curve.at_centres})
      for (LevelYield& level : *levels) level.yield = averaged(level.candidates);
    curves.dimensions.push_back(std::move(curve));
  }
  if (curves.dimensions.size() < 2 || curves.candidates.empty()) return curves;
  std::vector<std::size_t> every(curves.candidates.size());
  std::iota(every.begin(), every.end(), 0);
  const Yield all = averaged(every);
  for (const std::size_t k : every)
    if (curves.candidates[k].ess < kMinimumEffectiveRuns)
      curves.candidates[k] = pooled_yield(curves.candidates[k], k, curves, all, confidence);
  return curves;
}

YieldDifference yield_difference(const std::vector<Judgement>& joint,
                                 std::span<const double> narrow, std::span<const double> wide,
                                 const Resampling& resampling, double narrow_fits,
                                 double wide_fits) {
  const Share n = passing_share(joint, narrow), w = passing_share(joint, wide);
  std::vector<double> of_lot(resampling.lots(), 0.0);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const double passes = joint[i] == Judgement::meets;
    of_lot[resampling.lot_of()[i]] += narrow_fits * narrow[i] * (passes - n.value) / n.total -
                                      wide_fits * wide[i] * (passes - w.value) / w.total;
  }
  double variance = 0;
  for (const double influence : of_lot) variance += influence * influence;
  const auto lots = static_cast<double>(of_lot.size());
  return {narrow_fits * n.value - wide_fits * w.value,
          std::sqrt(variance * lots / std::max(lots - 1, 1.0))};
}

}  // namespace cagetol
