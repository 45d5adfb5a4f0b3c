// A claim of a source: the [[trend]] entries with the same words and source are its readings, in
// one or several quantities, pairs of levels and settings. It counts once, however many these are.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "analysis/response/grid_cells.hpp"
#include "analysis/response/trend_verdict.hpp"

namespace cagetol {

enum class ClaimVerdict { agrees, in_part, disagrees, undecided, no_claim, no_values };
const char* claim_verdict_name(ClaimVerdict verdict);

/// agrees: all readings agree; in part: some of them; disagrees: none agrees, at least one
/// disagrees; undecided: neither.
ClaimVerdict judge_claim(std::span<const TrendVerdict> readings);

/// Levels of the grid that lie from `from` towards `to`, and beyond it to the end, nearest first.
std::vector<std::size_t> levels_towards(const GridCells& cells, double from, double to);

/// First and last place of every unbroken row of true values.
std::vector<std::pair<std::size_t, std::size_t>> unbroken(const std::vector<bool>& holds);

/// Clearance of a roller in its nominal pocket along the dimension `key`, in its unit; empty where
/// the key is no width or length of pockets.
std::optional<double> nominal_clearance(const StudyPlan& plan, const std::string& key);

}  // namespace cagetol
