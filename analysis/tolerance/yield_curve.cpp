#include "analysis/tolerance/yield_curve.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

DimensionCurve curve_of(const StudyPlan& plan, std::size_t dimension) {
  DimensionCurve curve{plan.dimensions[dimension].key, {}};
  for (std::size_t k = 0; k < plan.candidates.size(); ++k) {
    const double band = plan.candidates[k].bands_mm[dimension];
    auto level = std::find_if(curve.levels.begin(), curve.levels.end(),
                              [&](const LevelYield& known) { return known.band_mm == band; });
    if (level == curve.levels.end())
      level = curve.levels.insert(level, {band, plan.candidates[k].grades[dimension], {}, {}});
    level->candidates.push_back(k);
  }
  std::sort(curve.levels.begin(), curve.levels.end(),
            [](const LevelYield& a, const LevelYield& b) { return a.band_mm < b.band_mm; });
  return curve;
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
  for (const auto& weights : mixture.candidate)
    curves.candidates.push_back(estimate_yield(runs, joint, weights, resampling, confidence));
  for (std::size_t d = 0; d < runs.plan.dimensions.size(); ++d) {
    DimensionCurve curve = curve_of(runs.plan, d);
    for (LevelYield& level : curve.levels)
      level.yield = estimate_yield(runs, joint, average_weights(mixture, level.candidates),
                                   resampling, confidence);
    curves.dimensions.push_back(std::move(curve));
  }
  return curves;
}

YieldDifference yield_difference(const std::vector<Judgement>& joint,
                                 std::span<const double> narrow, std::span<const double> wide,
                                 const Resampling& resampling) {
  const Share n = passing_share(joint, narrow), w = passing_share(joint, wide);
  std::vector<double> of_lot(resampling.lots(), 0.0);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const double passes = joint[i] == Judgement::meets;
    of_lot[resampling.lot_of()[i]] +=
        narrow[i] * (passes - n.value) / n.total - wide[i] * (passes - w.value) / w.total;
  }
  double variance = 0;
  for (const double influence : of_lot) variance += influence * influence;
  const auto lots = static_cast<double>(of_lot.size());
  return {n.value - w.value, std::sqrt(variance * lots / std::max(lots - 1, 1.0))};
}

}  // namespace cagetol
