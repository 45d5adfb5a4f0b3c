#include "distributions/iso286.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>

namespace cagetol {
namespace {

TEST(Iso286, WidthsOfTheStandard) {
  const double up_to_10[] = {15, 22, 36, 58, 90, 150, 220, 360};
  const double up_to_18[] = {18, 27, 43, 70, 110, 180, 270, 430};
  for (int grade = 7; grade <= 14; ++grade) {
    EXPECT_EQ(grade_width_um(grade, 7.65), up_to_10[grade - 7]);
    EXPECT_EQ(grade_width_um(grade, 14), up_to_18[grade - 7]);
  }
  EXPECT_EQ(grade_width_um(5, 2), 4);
  EXPECT_EQ(grade_width_um(6, 40), 16);
  EXPECT_EQ(grade_width_um(14, 500), 1550);
}

TEST(Iso286, ABorderBelongsToTheLowerRange) {
  EXPECT_EQ(grade_width_um(9, 10), 36);
  EXPECT_EQ(grade_width_um(9, 10.001), 43);
  EXPECT_EQ(grade_width_um(9, 6), 30);
}

// The standard rounds i = 0.45 D^(1/3) + 0.001 D at the geometric mean D of a range; rounding stays
// below 12 %.
TEST(Iso286, WidthsFollowTheToleranceUnit) {
  const double multiples[] = {7, 10, 16, 25, 40, 64, 100, 160, 250, 400};
  const double ends[] = {3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};
  for (int r = 1; r < 13; ++r) {
    const double size = std::sqrt(ends[r - 1] * ends[r]);
    const double unit = 0.45 * std::cbrt(size) + 0.001 * size;
    for (int grade = 5; grade <= 14; ++grade)
      EXPECT_NEAR(grade_width_um(grade, ends[r]) / (multiples[grade - 5] * unit), 1, 0.12)
          << "IT" << grade << " up to " << ends[r];
  }
}

TEST(Iso286, CoarserGradesAndLargerSizesAreWider) {
  for (int grade = 5; grade < 14; ++grade)
    for (double size = 2; size < 450; size *= 1.7) {
      EXPECT_GT(grade_width_um(grade + 1, size), grade_width_um(grade, size));
      EXPECT_GE(grade_width_um(grade, 1.1 * size), grade_width_um(grade, size));
    }
}

TEST(Iso286, SnapsDown) {
  EXPECT_EQ(grade_within(58, 7.65), 10);
  EXPECT_EQ(grade_within(57.9, 7.65), 9);
  EXPECT_EQ(grade_within(5.9, 7.65), std::nullopt);
  EXPECT_EQ(grade_within(1e6, 7.65), 14);
}

TEST(Iso286, ClassesLieAboutTheNominalSizeOrAboveIt) {
  for (const char* centred : {"IT9", "js9", "JS9"}) {
    EXPECT_EQ(tolerance_class(centred)->grade, 9) << centred;
    EXPECT_EQ(tolerance_class(centred)->middle, 0) << centred;
  }
  EXPECT_EQ(tolerance_class("H14")->grade, 14);
  EXPECT_EQ(tolerance_class("H14")->middle, 0.5);
  for (const char* other : {"", "H", "h9", "Js9", "G7", "H9x", "9", "js-9", "IT9H"})
    EXPECT_FALSE(tolerance_class(other)) << other;
}

TEST(Iso286, Names) {
  EXPECT_EQ(grade_number("IT9"), 9);
  EXPECT_EQ(grade_number("IT14"), 14);
  for (const char* other : {"", "IT", "it9", "IT9x", "IT-3", "9", "IT99999999999"})
    EXPECT_EQ(grade_number(other), std::nullopt) << other;
  EXPECT_EQ(grade_name(11), "IT11");
}

TEST(Iso286, RefusesWhatIsNotInTheTable) {
  EXPECT_THROW(grade_width_um(4, 10), std::invalid_argument);
  EXPECT_THROW(grade_width_um(15, 10), std::invalid_argument);
  EXPECT_THROW(grade_width_um(9, 0), std::invalid_argument);
  EXPECT_THROW(grade_width_um(9, 501), std::invalid_argument);
}

}  // namespace
}  // namespace cagetol
