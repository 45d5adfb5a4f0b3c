#include "analysis/tolerance/cost.hpp"

#include <algorithm>

namespace cagetol {

double cost_of_tolerance(const CostTable& table, double tolerance_width_mm) {
  const auto above = std::find_if(table.begin(), table.end(), [&](const auto& point) {
    return point.first >= tolerance_width_mm;
  });
  if (above == table.end()) return table.back().second;
  if (above == table.begin()) return above->second;
  const auto& [left, left_cost] = *std::prev(above);
  const auto& [right, right_cost] = *above;
  return left_cost + (right_cost - left_cost) * (tolerance_width_mm - left) / (right - left);
}

std::optional<double> cost_of_tolerances(const StudyPlan& plan,
                                         const std::vector<double>& tolerance_widths_mm) {
  double sum = 0;
  for (std::size_t d = 0; d < tolerance_widths_mm.size(); ++d) {
    if (plan.dimensions[d].cost.empty()) return std::nullopt;
    sum += cost_of_tolerance(plan.dimensions[d].cost, tolerance_widths_mm[d]);
  }
  return sum;
}

double worth_of_tolerances(const StudyPlan& plan, const std::vector<double>& tolerance_widths_mm) {
  if (const auto cost = cost_of_tolerances(plan, tolerance_widths_mm)) return -*cost;
  double width = 1;
  for (std::size_t d = 0; d < tolerance_widths_mm.size(); ++d) {
    double widest = 0;
    for (const Candidate& candidate : plan.candidates)
      widest = std::max(widest, candidate.tolerance_widths_mm[d]);
    width *= tolerance_widths_mm[d] / widest;
  }
  return width;
}

}  // namespace cagetol
