#include "src/cage/mesh/cage_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

/// No constant: it would make the table whenever the program starts.
const CageDimensions& coarse_cage() {
  return test::coarse_table().cage;
}

CageMesh mesh_of(const std::vector<PocketDeviation>& deviations) {
  return std::get<CageMesh>(make_cage_mesh(coarse_cage(), deviations, test::coarse_table().counts));
}

double area(const CageSurface& surface) {
  double sum = 0;
  for (const auto& cell : surface.cells) {
    double twice = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto a = static_cast<std::size_t>(cell[i]);
      const auto b = static_cast<std::size_t>(cell[(i + 1) % 4]);
      twice += surface.across[a] * surface.up[b] - surface.across[b] * surface.up[a];
    }
    sum += std::abs(twice) / 2;
  }
  return sum;
}

TEST(CageSurface, CylindersHaveTheirAreaWithoutThePockets) {
  const CageMesh mesh = mesh_of(std::vector<PocketDeviation>(13));
  for (const bool outer : {false, true}) {
    const double radius = outer ? coarse_cage().outer_radius : coarse_cage().inner_radius;
    const double pocket =
        2 * std::asin(coarse_cage().pocket_width / 2 / radius) * coarse_cage().pocket_length;
    const CageSurface surface = cylinder_surface(mesh, outer);
    EXPECT_NEAR(area(surface), 2 * std::numbers::pi * coarse_cage().width - 13 * pocket, 1e-9);
    for (const int node : surface.node)
      EXPECT_NEAR(mesh.mesh.nodes.col(node).tail<2>().norm(), radius, 1e-9);
  }
}

TEST(CageSurface, WallsOfAPocketAreAStripAroundIt) {
  auto deviations = test::scattered_pockets(2);
  const PocketDeviation deviation{.width = 1e-4, .length = 2e-4, .pitch = 2e-3};
  deviations[5] = deviation;
  const CageSurface walls = pocket_walls(mesh_of(deviations), deviation, 5);
  const double around = 2 * (coarse_cage().pocket_width + coarse_cage().pocket_length + 3e-4);
  EXPECT_NEAR(*std::min_element(walls.across.begin(), walls.across.end()), 0, 1e-9);
  EXPECT_NEAR(*std::max_element(walls.across.begin(), walls.across.end()), around, 1e-9);
  EXPECT_NEAR(area(walls), around * (coarse_cage().outer_radius - coarse_cage().inner_radius),
              1e-9 * 1e-3);
}

}  // namespace
}  // namespace cagetol
