// What a tolerance costs to make, where the study says so.
//
// Straight lines through a table over the full width in mm, flat beyond its ends. Costs of
// dimensions add up; the currency is the user's.
#pragma once

#include <optional>
#include <vector>

#include "analysis/study/study_plan.hpp"

namespace cagetol {

double cost_of_tolerance(const CostTable& table, double tolerance_width_mm);

/// Sum over the dimensions; nothing where the study states no costs.
std::optional<double> cost_of_tolerances(const StudyPlan& plan,
                                         const std::vector<double>& tolerance_widths_mm);

/// The larger, the more a tolerance is preferred: less its cost; where the study states no costs,
/// the product of its tolerances, each in units of its widest candidate.
double worth_of_tolerances(const StudyPlan& plan, const std::vector<double>& tolerance_widths_mm);

}  // namespace cagetol
