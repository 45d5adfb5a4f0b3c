// The runs of a grid, sorted into cells: levels of one dimension, and settings of all the others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct GridCells {
  std::string key, unit;       ///< of the dimension
  std::vector<double> levels;  ///< its lot deviations in ascending order
  /// What the other groups of inputs are set to, in words, in the order of the design; one empty
  /// text where there is no other group.
  std::vector<std::string> settings;
  std::vector<std::size_t> level_of, setting_of;  ///< of each sample

  /// Samples of one cell in the order of the study.
  std::vector<std::size_t> samples(std::size_t setting, std::size_t level) const;
  /// Index of a level, if the grid has it; the last digits of a double do not count.
  std::optional<std::size_t> find_level(double deviation) const;
};

/// Nothing where the design is no grid or the key does not vary by lot.
std::optional<GridCells> grid_cells(const StudyData& study, const std::string& key);

/// The key to draw responses over: that of the first trend, else the one with most levels; empty
/// where the design is no grid or nothing varies by lot.
std::string response_key(const StudyData& study);

}  // namespace cagetol
