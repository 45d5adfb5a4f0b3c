// Modes of a whole body, none of them missing.
#pragma once

#include <gtest/gtest.h>

#include "src/cage/solve/cage_modes.hpp"

namespace cagetol {

/// The lowest `count` modes, less one where that would split a pair, counted by modes_below().
inline FreeModes checked_free_modes(const HexMesh& mesh, const BodyMatrices& body,
                                    const HeldFactor& factor, long count) {
  // Two more, so that a gap to those below and a split pair can be seen.
  FreeModes modes = free_modes(mesh, body, factor, count + 2);
  const Eigen::Index kept = whole_pairs(modes.frequency, count);
  const double between = 0.5 * (modes.frequency[kept - 1] + modes.frequency[kept]);
  EXPECT_EQ(modes_below(body, between), kept + modes.rigid.cols());
  modes.frequency = modes.frequency.head(kept).eval();
  modes.shape = modes.shape.leftCols(kept).eval();
  return modes;
}

}  // namespace cagetol
