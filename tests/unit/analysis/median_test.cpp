#include "analysis/statistics/median.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace cagetol {
namespace {

TEST(Median, OfOddEvenAndNone) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(Median, OfTheWholeIsUnknownWhereOneValueIs) {
  EXPECT_EQ(median_of_whole({3, 1, 2}), 2);
  EXPECT_TRUE(std::isnan(median_of_whole({3, std::numeric_limits<double>::quiet_NaN(), 2})));
}

}  // namespace
}  // namespace cagetol
