// How a drawing names tolerances.
#include "mc/study_file/tolerance.hpp"

#include <gtest/gtest.h>

namespace cagetol {
namespace {

TEST(Tolerance, DeviationsAreUpperAndLower) {
  const auto ends = deviations_of("+0.05/-0.02");
  ASSERT_TRUE(ends);
  EXPECT_EQ(ends->upper, 0.05);
  EXPECT_EQ(ends->lower, -0.02);
  EXPECT_EQ(deviations_of("+0.10/0")->lower, 0);
  EXPECT_EQ(deviations_of("-0.1/-0.2")->upper, -0.1);
  for (const char* other : {"", "/", "0.1", "0.1/", "/0", "0/+0.1", "0.1/0.1", "0,1/0", "0.1/0 mm",
                            "nan/0", "inf/0", "0.2/0.1/0"})
    EXPECT_FALSE(deviations_of(other)) << other;
}

TEST(Tolerance, ZonesHaveTheirMiddle) {
  EXPECT_EQ(zone_middle("", 0.1), 0);
  EXPECT_EQ(zone_middle("IT11", 0.09), 0);
  EXPECT_EQ(zone_middle("js11", 0.09), 0);
  EXPECT_EQ(zone_middle("H11", 0.09), 0.045);
  EXPECT_DOUBLE_EQ(zone_middle("+0.05/-0.02", 0.07), 0.015);
}

TEST(Tolerance, IsWrittenAsOnADrawing) {
  EXPECT_EQ(drawing_text("", 0.1), "±0.050 mm");
  EXPECT_EQ(drawing_text("IT13", 0.22), "±0.110 mm (IT13, js13)");
  EXPECT_EQ(drawing_text("js11", 0.09), "±0.045 mm (js11)");
  EXPECT_EQ(drawing_text("IT7", 0.015), "±0.0075 mm (IT7, js7)");
  EXPECT_EQ(drawing_text("H11", 0.09), "H11 (+0.090/0 mm)");
  EXPECT_EQ(drawing_text("+0.10/0", 0.1), "+0.10/0 mm");
}

TEST(Tolerance, ACandidateIsMovedByItsCentreAndTheMiddleOfItsZone) {
  Candidate candidate{{0.1, 0.2}, {"H9", ""}, {1, 2}};
  EXPECT_EQ(candidate.all_shifts(), (std::vector<double>{0, 0}));
  candidate.shifts = {0.5, -0.5};
  candidate.middles = {0.25, 0};
  EXPECT_EQ(candidate.all_shifts(), (std::vector<double>{0.75, -0.5}));
  EXPECT_EQ(candidate.centre_shift(0), 0.5);
}

}  // namespace
}  // namespace cagetol
