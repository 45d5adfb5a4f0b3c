#include "src/cage/mesh/cage_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/cage/mesh/hex8_incompatible.hpp"
#include "src/cage/mesh/sector_polynomial.hpp"

namespace cagetol {
namespace {

/// Area of the part of the annulus between -half and +half of the tangential offset, by its exact
/// integral.
double strip_area(double inner, double outer, double half) {
  const auto under = [&](double r) {
    return half * std::sqrt(r * r - half * half) + r * r * std::asin(half / r);
  };
  return under(outer) - under(inner);
}

double mesh_volume(const HexMesh& mesh) {
  double volume = 0;
  for (const auto& element : mesh.elements)
    volume += hex8_mass(element_nodes(mesh, element), 1).sum();
  return volume;
}

TEST(CageMesh, VolumeOfRingMinusPockets) {
  for (long pockets : {7L, 13L, 16L}) {
    CageDimensions cage;
    cage.pocket_count = pockets;
    cage.pocket_width = 2 * std::numbers::pi * 18.5e-3 / static_cast<double>(pockets) * 0.85;
    std::vector<PocketDeviation> deviations(static_cast<std::size_t>(pockets));
    deviations[1].width = 0.1e-3;
    deviations[2].length = -0.3e-3;
    deviations[3].pitch = 4e-3;
    const auto meshed = make_cage_mesh(cage, deviations, mesh_counts(cage, 6));
    const auto& mesh = std::get<CageMesh>(meshed).mesh;
    double exact = std::numbers::pi *
                   (std::pow(cage.outer_radius, 2) - std::pow(cage.inner_radius, 2)) * cage.width;
    for (const auto& deviation : deviations) {
      exact -= strip_area(cage.inner_radius, cage.outer_radius,
                          0.5 * (cage.pocket_width + deviation.width)) *
               (cage.pocket_length + deviation.length);
    }
    EXPECT_NEAR(mesh_volume(mesh) / exact, 1, 1.5e-3) << pockets;
  }
}

TEST(CageMesh, PocketFacesLieWhereTheDeviationsPutThem) {
  const CageDimensions cage;
  std::vector<PocketDeviation> deviations(13);
  deviations[4] = {.width = 0.12e-3, .length = -0.2e-3, .pitch = 3e-3, .squareness = 5e-3};
  const auto meshed = make_cage_mesh(cage, deviations, mesh_counts(cage, 3));
  const auto& mesh = std::get<CageMesh>(meshed);
  const double psi = 2 * std::numbers::pi * 4 / 13 + 3e-3;
  int faces = 0;
  int ends = 0;
  for (std::size_t p = 0; p < mesh.grid.points.size(); ++p) {
    const SectorPoint& point = mesh.grid.points[p];
    const Eigen::Vector3d x = mesh.mesh.nodes.col(mesh.sector_node[4][p]);
    if (std::abs(point.around) == 1) {
      const double u = -std::sin(psi) * x[1] + std::cos(psi) * x[2];
      EXPECT_NEAR(u, point.around * 0.5 * 7.77e-3 + 5e-3 * x[0], 1e-15);
      ++faces;
    }
    if (std::abs(point.axial) == 1 && std::abs(point.around) <= 1) {
      EXPECT_NEAR(x[0], point.axial * 0.5 * 9.05e-3, 1e-15);
      ++ends;
    }
  }
  EXPECT_GT(faces, 20);
  EXPECT_GT(ends, 20);
}

TEST(CageMesh, NeighbouringSectorsShareTheirMiddlePlane) {
  const CageDimensions cage;
  const SectorGrid grid = make_sector_grid(mesh_counts(cage, 2));
  const PocketDeviation a{.width = 0.1e-3, .length = 0.2e-3, .pitch = 2e-3, .squareness = 4e-3};
  const PocketDeviation b{.width = -0.1e-3, .length = -0.2e-3, .pitch = -2e-3, .squareness = -4e-3};
  const Eigen::Matrix3Xd left = sector_nodes(cage, a, grid);
  const Eigen::Matrix3Xd right = sector_rotation(cage, 1) * sector_nodes(cage, b, grid);
  std::vector<Eigen::Index> last;
  std::vector<Eigen::Index> first;
  for (std::size_t p = 0; p < grid.points.size(); ++p) {
    if (grid.column[p] == grid.columns) last.push_back(static_cast<Eigen::Index>(p));
    if (grid.column[p] == 0) first.push_back(static_cast<Eigen::Index>(p));
  }
  ASSERT_EQ(last.size(), first.size());
  for (std::size_t i = 0; i < last.size(); ++i) {
    EXPECT_LT((left.col(last[i]) - right.col(first[i])).norm(), 1e-15);
  }
}

/// Impossible geometry names the pocket and says what is wrong, and never crashes.
TEST(CageMesh, FaultsNameThePocket) {
  const CageDimensions cage;
  const auto fault = [&](const PocketDeviation& deviation) {
    std::vector<PocketDeviation> deviations(13);
    deviations[8] = deviation;
    const auto result = make_cage_mesh(cage, deviations, mesh_counts(cage, 2));
    if (const auto* found = std::get_if<CageFault>(&result)) return *found;
    return CageFault{CageFaultKind::geometry, -1, "none"};
  };
  EXPECT_EQ(fault({}).reason, "none");
  for (const auto& [deviation, word] : std::vector<std::pair<PocketDeviation, std::string>>{
           {{.width = 1.5e-3}, "middle of a bar"},
           {{.width = 60e-3}, "middle of a bar"},
           {{.pitch = 0.05}, "middle of a bar"},
           {{.squareness = 0.3}, "middle of a bar"},
           {{.width = -8e-3}, "width"},
           {{.length = -10e-3}, "length"},
           {{.length = 5e-3}, "side rings"},
           {{.width = std::nan("")}, "finite"}}) {
    const CageFault found = fault(deviation);
    EXPECT_EQ(found.pocket, 8) << word;
    EXPECT_NE(found.reason.find(word), std::string::npos) << found.reason;
  }
}

TEST(CageMesh, SceneGivesDimensionsAndDeviations) {
  Scene scene;
  scene.bearing.roller_count = 3;
  scene.cage.pocket_width = {7.6e-3, 7.7e-3, 7.8e-3};
  scene.cage.pocket_pitch = {0, 1e-3, 0};
  const CageDimensions cage = cage_dimensions(scene);
  EXPECT_NEAR(cage.pocket_width, 7.7e-3, 1e-15);
  const auto deviations = pocket_deviations(scene, cage);
  EXPECT_NEAR(deviations[2].width, 0.1e-3, 1e-15);
  EXPECT_NEAR(deviations[1].pitch, 1e-3, 1e-15);
  EXPECT_EQ(deviations[1].length, 0);
}

/// Also the largest corners that a scene may have, at every deviation of a table.
TEST(CageMesh, PocketsHaveFilletsAtEveryDeviationOfATable) {
  for (const double radius : {0.3e-3, 0.5e-3, 1e-3, 2.295e-3}) {
    const CageDimensions cage{.corner_radius = radius};
    const SectorGrid grid = make_sector_grid(mesh_counts(cage, 4));
    const Eigen::Matrix3Xd first = sector_nodes(cage, {}, grid);
    for (const PocketDeviation& d : polynomial_samples(table_range(cage))) {
      const HexMesh sector{sector_nodes(cage, d, grid), grid.elements};
      for (const auto& element : sector.elements)
        ASSERT_GT(hex8_smallest_jacobian(element_nodes(sector, element)), 0)
            << radius << " " << d.width << " " << d.length << " " << d.pitch << " " << d.squareness;
      const double u = 0.5 * (cage.pocket_width + d.width) - radius;
      const double x = 0.5 * (cage.pocket_length + d.length) - radius;
      int on_fillet = 0;
      for (std::size_t p = 0; p < grid.points.size(); ++p) {
        const auto node = static_cast<Eigen::Index>(p);
        const Eigen::Vector3d at = sector.nodes.col(node);
        if (std::abs(grid.points[p].around) == 2) {
          EXPECT_LT((at - first.col(node)).norm(), 1e-15);
        }
        const double around = std::abs(grid.points[p].around);
        const double axial = std::abs(grid.points[p].axial);
        if (std::max(around, axial) > 1 || (1 - around) * cage.pocket_width >= 2 * radius ||
            (1 - axial) * cage.pocket_length >= 2 * radius)
          continue;
        const double offset =
            std::abs(at.tail<2>().norm() * std::sin(std::atan2(at[2], at[1]) - d.pitch) -
                     at[0] * d.squareness);
        EXPECT_NEAR(std::hypot(offset - u, std::abs(at[0]) - x), radius, 1e-9);
        ++on_fillet;
      }
      EXPECT_GE(on_fillet, 20);  // the corners alone
    }
  }
}

TEST(CageMesh, CornersWiderThanThePocketAreAFault) {
  const CageDimensions cage{.corner_radius = 4e-3};
  const auto fault = cage_fault(cage, std::vector<PocketDeviation>(13));
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->reason.find("radius 4 mm"), std::string::npos) << fault->reason;
}

}  // namespace
}  // namespace cagetol
