#include "analysis/tolerance/centre_curve.hpp"

#include "analysis/study/refused.hpp"

namespace cagetol {
namespace {

constexpr double kStep = 1.0 / 32;  ///< of the tolerance
constexpr int kCurveSteps = 4, kMapSteps = 2;

double units_per_mm(const StudyData& runs, const std::string& key) {
  const InputColumns* input = find_input(runs, key);
  const std::string unit = input == nullptr ? "mm" : input->unit;
  if (unit == "mm") return 1;
  if (unit == "um") return 1e3;
  if (unit == "nm") return 1e6;
  if (unit == "m") return 1e-3;
  throw Refused("centres refused: " + key + " is no length");
}

}  // namespace

CentreCurves centre_curves(const StudyData& runs, const MixtureWeights& mixture,
                           const Tolerance& tolerance, const std::vector<Judgement>& joint,
                           const Resampling& resampling, double confidence) {
  const auto& dimensions = runs.plan.dimensions;
  const auto& tolerance_widths_mm = tolerance.tolerance_widths_mm;
  std::vector<double> scales, units;
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    scales.push_back(tolerance_widths_mm[d] / dimensions[d].tolerance_width_mm);
    units.push_back(units_per_mm(runs, dimensions[d].key));
  }
  const auto at = [&](const std::vector<double>& steps) {
    CentreYield centre;
    std::vector<double> shifts;
    for (std::size_t d = 0; d < steps.size(); ++d) {
      centre.shifts_mm.push_back(steps[d] * kStep * tolerance_widths_mm[d]);
      shifts.push_back(centre.shifts_mm[d] * units[d] +
                       (tolerance.shifts.empty() ? 0 : tolerance.shifts[d]));
    }
    const auto weights = weights_of_scales(runs, mixture, scales, shifts);
    centre.ess = effective_sample_size(weights);
    if (centre.ess >= kFewestEffectiveRuns)
      centre.yield = estimate_yield(runs, joint, weights, resampling, confidence);
    return centre;
  };
  CentreCurves curves;
  for (std::size_t d = 0; d < dimensions.size(); ++d) {
    curves.dimensions.emplace_back();
    for (int step = -kCurveSteps; step <= kCurveSteps; ++step) {
      std::vector<double> steps(dimensions.size(), 0.0);
      steps[d] = step;
      curves.dimensions[d].push_back(at(steps));
    }
  }
  if (dimensions.size() < 2) return curves;
  for (int first = -kMapSteps; first <= kMapSteps; ++first)
    for (int second = -kMapSteps; second <= kMapSteps; ++second) {
      std::vector<double> steps(dimensions.size(), 0.0);
      steps[0] = first;
      steps[1] = second;
      curves.map.push_back(at(steps));
    }
  return curves;
}

}  // namespace cagetol
