// Which rows of a design belong together.
//
// A pick-freeze design runs, for each base point, the rows A, B, and A with one group taken from B
// for every group; a morris design runs trajectories of one step a group. Both keep the rows of a
// base (a trajectory) next to each other.
#pragma once

#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct DesignBlocks {
  std::size_t rows_per_base = 1;    ///< 1 for every design but pick-freeze and morris
  std::vector<std::string> groups;  ///< moved groups in the order of their rows; a group without
                                    ///< columns is called "noise"
};

/// From the stored points. Throws Refused when the points do not have the structure their design's
/// name promises.
DesignBlocks design_blocks(const StudyData& study);

/// Distinct group names in order of first appearance.
std::vector<std::string> group_names(const StudyDesign& design);

}  // namespace cagetol
