#include "analysis/tolerance/jam_onset.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace cagetol {
namespace {

/// Ten times as many for each 0.1 mm.
const JamCurve kCurve{"cage.pocket_width_mm", {0.1, 0.2, 0.3, 0.4}, {2e-8, 2e-6, 0.0002, 0.02}};

TEST(JamOnset, LiesBetweenTheTolerancesOfTheCurve) {
  const JamOnset onset = jam_onset(kCurve, 0.998);
  EXPECT_NEAR(*onset.ppm_mm, 0.2 - 0.1 * std::log10(2) / 2, 1e-12);
  EXPECT_NEAR(*onset.limit_mm, 0.35, 1e-12);
  EXPECT_NEAR(*jam_onset(kCurve, 0.9998).limit_mm, 0.3, 1e-9);  // so many still meet the target
}

TEST(JamOnset, IsNotClaimedBeyondTheCurve) {
  EXPECT_FALSE(jam_onset(kCurve, 0.9).limit_mm);
  const JamOnset always = jam_onset({"x", {0.1, 0.2}, {0.2, 0.5}}, 0.9);
  EXPECT_FALSE(always.ppm_mm);
  EXPECT_DOUBLE_EQ(*always.limit_mm, 0.1);
}

// Of drawn cages few shares may be none.
TEST(JamOnset, KnowsCurvesThatBeginWithoutAJam) {
  const JamOnset onset = jam_onset({"x", {0.1, 0.2, 0.3}, {0, 0, 0.001}}, 0.9);
  EXPECT_GT(*onset.ppm_mm, 0.2);
  EXPECT_LT(*onset.ppm_mm, 0.3);
}

TEST(JamOnset, SharesAreThoseWhoseToleranceItFinds) {
  for (const double share : {1e-7, 2e-6, 3e-5, 0.01})
    EXPECT_NEAR(share_of_jams(kCurve, *tolerance_of_jams(kCurve, share)), share, 1e-9 * share);
  EXPECT_DOUBLE_EQ(share_of_jams(kCurve, 0.01), 2e-8);
  EXPECT_DOUBLE_EQ(share_of_jams(kCurve, 9), 0.02);
  EXPECT_EQ(share_of_jams({}, 0.1), 0);
}

}  // namespace
}  // namespace cagetol
