// One newton on a bar: what it does belongs to the cage, not to the number of modes kept.
#include "src/cage/table/unit_bar_loads.hpp"

#include <gtest/gtest.h>

#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

using test::coarse_table;

std::vector<UnitBarLoad> loads_with(long modes, long pocket) {
  const std::vector<PocketDeviation> none(13);
  const auto made = make_cage_model(coarse_table(), none, {.modes = modes});
  return unit_bar_loads(coarse_table(), std::get<CageModel>(made), pocket);
}

TEST(UnitBarLoads, DoNotDependOnTheModesKept) {
  const auto few = loads_with(12, 0), many = loads_with(36, 0);
  ASSERT_EQ(few.size(), 3U);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_LT(few[i].kept_compliance, many[i].kept_compliance);
    EXPECT_NEAR(few[i].kept_compliance + few[i].other_compliance,
                many[i].kept_compliance + many[i].other_compliance, 1e-3 * many[i].kept_compliance);
    EXPECT_NEAR(few[i].stress, many[i].stress, 0.01 * many[i].stress);
    EXPECT_EQ(few[i].place, many[i].place);
  }
}

/// With whole pairs of modes, which 10 are.
TEST(UnitBarLoads, AreTheSameOfEveryPocketAndHalf) {
  const auto first = loads_with(10, 0), other = loads_with(10, 5);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const UnitBarLoad& mirrored = first[first.size() - 1 - i];
    EXPECT_NEAR(other[i].other_compliance, first[i].other_compliance,
                1e-3 * first[i].other_compliance);
    EXPECT_NEAR(mirrored.kept_compliance, first[i].kept_compliance,
                1e-3 * first[i].kept_compliance);
    EXPECT_NEAR(mirrored.stress, first[i].stress, 1e-3 * first[i].stress);
  }
}

}  // namespace
}  // namespace cagetol
