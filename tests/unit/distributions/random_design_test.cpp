#include "distributions/design.hpp"

#include <gtest/gtest.h>

#include "tests/unit/distributions/design_helpers.hpp"

namespace cagetol {
namespace {

const std::uint32_t width = stream_address("cage.pocket_width_mm");

DesignSpec cage_spec(std::uint32_t pockets) {
  DesignSpec spec = spec_of(DesignKind::random, 60, 0);
  spec.columns.push_back({Purpose::lot, width, 0});
  for (std::uint32_t j = 0; j < pockets; ++j) {
    spec.columns.push_back({Purpose::pocket, width, j});
  }
  return spec;
}

TEST(RandomDesign, IsTheAddressedUniformNumber) {
  const Design design(cage_spec(3));
  const std::vector<double> u = point_of(design, 17);
  EXPECT_EQ(u[0], uniform(2024, Purpose::lot, 17, width, 0));
  EXPECT_EQ(u[1], uniform(2024, Purpose::pocket, 17, width, 0));
  EXPECT_EQ(u[3], uniform(2024, Purpose::pocket, 17, width, 2));
}

TEST(RandomDesign, AddingAnInputInFrontOrAPocketShiftsNothing) {
  DesignSpec more = cage_spec(4);
  more.columns.insert(more.columns.begin(), {Purpose::lot, stream_address("new"), 0});
  const Design design(cage_spec(3)), larger(more);
  for (std::uint64_t row = 0; row < design.rows(); ++row) {
    const std::vector<double> u = point_of(design, row), v = point_of(larger, row);
    for (std::size_t i = 0; i < u.size(); ++i) EXPECT_EQ(u[i], v[i + 1]);
  }
}

TEST(RandomDesign, AddingRowsShiftsNothing) {
  DesignSpec more = cage_spec(3);
  more.rows = 1000;
  for (const std::uint64_t row : {0, 59}) {
    EXPECT_EQ(point_of(Design(cage_spec(3)), row), point_of(Design(more), row));
  }
}

TEST(RandomDesign, CagesOfALotShareLotColumnsOnly) {
  DesignSpec spec = cage_spec(2);
  spec.cages_per_lot = 20;
  const Design design(spec);
  for (std::uint64_t row = 0; row < 60; ++row) {
    const std::vector<double> u = point_of(design, row);
    EXPECT_EQ(design.lot_of(row), row / 20);
    EXPECT_EQ(u[0], uniform(2024, Purpose::lot, row / 20, width, 0));
    EXPECT_EQ(u[1], uniform(2024, Purpose::pocket, row, width, 0));
  }
}

}  // namespace
}  // namespace cagetol
