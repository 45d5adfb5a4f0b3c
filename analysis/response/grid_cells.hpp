// The runs of a grid design, sorted into cells: level of one dimension and setting of all others.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct GridCells {
  std::string key, unit;       ///< of the dimension
  std::vector<double> levels;  ///< lot deviations of the dimension, ascending
  /// Settings of the other groups of inputs as text, in the order of the design. A single empty
  /// text if there is no other group.
  std::vector<std::string> settings;
  std::vector<std::size_t> level_of, setting_of;  ///< of each sample

  /// Samples of one cell in the order of the study.
  std::vector<std::size_t> samples(std::size_t setting, std::size_t level) const;
};

/// The cells. Empty if the design is not a grid or the key does not vary by lot.
std::optional<GridCells> grid_cells(const StudyData& study, const std::string& key);

/// Key on the horizontal axis of response figures: the one with the most levels. Empty if the
/// design is not a grid or no key varies by lot.
std::string response_key(const StudyData& study);

}  // namespace cagetol
