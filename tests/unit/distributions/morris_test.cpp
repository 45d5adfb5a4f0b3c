#include "distributions/designs/morris.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "tests/unit/distributions/design_helpers.hpp"

namespace cagetol {
namespace {

constexpr std::uint64_t trajectories = 300;

/// Group 0: columns 0 and 3; groups 1 and 2: columns 1 and 2.
DesignSpec grouped_spec() {
  DesignSpec spec = spec_of(DesignKind::morris, trajectories * 4, 4);
  spec.columns[3].group = 0;
  return spec;
}

TEST(Morris, MovesOneGroupAtATimeAndEachOnce) {
  const DesignSpec spec = grouped_spec();
  const Design design(spec);
  const double delta = 4.0 / (2 * (4 - 1));
  for (std::uint64_t trajectory = 0; trajectory < trajectories; ++trajectory) {
    std::set<std::uint32_t> moved;
    EXPECT_FALSE(design.moved_group(design.row_of(0, trajectory)));
    for (std::uint64_t step = 1; step <= 3; ++step) {
      const std::uint64_t row = design.row_of(step, trajectory);
      EXPECT_EQ(row, trajectory * 4 + step);
      const auto before = point_of(design, row - 1), after = point_of(design, row);
      const std::uint32_t group = design.moved_group(row).value();
      moved.insert(group);
      for (std::size_t i = 0; i < 4; ++i) {
        const double expected = spec.columns[i].group == group ? delta : 0;
        EXPECT_NEAR(std::abs(after[i] - before[i]), expected, 1e-15);
      }
    }
    EXPECT_EQ(moved.size(), 3u);
  }
}

TEST(Morris, VisitsAllLevelsOrdersAndDirectionsEvenly) {
  const Design design(grouped_spec());
  std::map<double, int> levels;
  std::map<std::array<std::uint32_t, 3>, int> orders;
  int upwards = 0, together = 0;
  for (std::uint64_t trajectory = 0; trajectory < trajectories; ++trajectory) {
    const auto first = point_of(design, design.row_of(0, trajectory));
    const auto last = point_of(design, design.row_of(3, trajectory));
    ++levels[first[0]];
    upwards += last[1] > first[1];
    together += (last[0] > first[0]) == (last[3] > first[3]);
    std::array<std::uint32_t, 3> order{};
    for (std::uint64_t step = 1; step <= 3; ++step) {
      order[step - 1] = design.moved_group(design.row_of(step, trajectory)).value();
    }
    ++orders[order];
  }
  ASSERT_EQ(levels.size(), 4u);
  EXPECT_EQ(levels.begin()->first, 0);
  EXPECT_EQ(levels.rbegin()->first, 1);
  for (const auto& [level, count] : levels) EXPECT_NEAR(count, 75, 4 * 7.5);
  EXPECT_EQ(orders.size(), 6u);
  for (const auto& [order, count] : orders) EXPECT_NEAR(count, 50, 4 * 6.5);
  EXPECT_NEAR(upwards, 150, 4 * 8.7);
  EXPECT_NEAR(together, 150, 4 * 8.7);
}

TEST(Morris, TrimScalesLevels) {
  DesignSpec spec = grouped_spec();
  spec.trim = 0.1;
  const Design design(spec);
  std::set<double> levels;
  for (std::uint64_t row = 0; row < design.rows(); ++row) levels.insert(point_of(design, row)[2]);
  ASSERT_EQ(levels.size(), 4u);
  EXPECT_EQ(*levels.begin(), 0.1);
  EXPECT_EQ(*levels.rbegin(), 0.9);
}

TEST(Morris, SourceChangesWhenTheGroupMoves) {
  const Design design(grouped_spec());
  for (std::uint64_t row = 0; row < design.rows(); ++row) {
    for (std::uint32_t group = 0; group < 3; ++group) {
      const std::uint64_t source = design.source_of(row, group);
      EXPECT_EQ(source / 2, design.base_of(row));
      if (design.block_of(row) == 0) {
        EXPECT_EQ(source % 2, 0u);
      } else {
        EXPECT_EQ(source != design.source_of(row - 1, group), design.moved_group(row) == group);
      }
    }
  }
}

}  // namespace
}  // namespace cagetol
