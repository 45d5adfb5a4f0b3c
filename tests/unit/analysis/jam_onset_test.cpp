#include "analysis/tolerance/jam_onset.hpp"

#include <gtest/gtest.h>

namespace cagetol {
namespace {

const JamCurve kCurve{"cage.pocket_width_mm", {0.1, 0.2, 0.3, 0.4}, {0, 0, 0.01, 0.05}};

TEST(JamOnset, LiesBetweenTheTolerancesDrawn) {
  const JamOnset onset = jam_onset(kCurve, 0.97);
  EXPECT_DOUBLE_EQ(*onset.free_mm, 0.2);
  EXPECT_NEAR(*onset.limit_mm, 0.35, 1e-12);
  EXPECT_NEAR(*jam_onset(kCurve, 0.99).limit_mm, 0.3, 1e-9);  // 1 % of jams still meets 99 %
}

TEST(JamOnset, IsNotClaimedBeyondTheCurve) {
  EXPECT_FALSE(jam_onset(kCurve, 0.9).limit_mm);
  const JamOnset always = jam_onset({"x", {0.1, 0.2}, {0.2, 0.5}}, 0.9);
  EXPECT_FALSE(always.free_mm);
  EXPECT_DOUBLE_EQ(*always.limit_mm, 0.1);
}

}  // namespace
}  // namespace cagetol
