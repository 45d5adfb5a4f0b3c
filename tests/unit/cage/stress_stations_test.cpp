// Where the stress of a cage is watched.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/cage/mesh/cage_stations.hpp"

namespace cagetol {
namespace {

TEST(StressStations, AreTheSameOnBothFacesAndAtBothEndsOfAPocket) {
  for (const double length : {8.2e-3, 9.25e-3, 9.65e-3, 11e-3}) {
    const CageDimensions cage{.pocket_length = length};
    for (const long density : {1, 2, 3, 4, 5, 6}) {
      const SectorGrid grid = make_sector_grid(mesh_counts(cage, density));
      const std::vector<int> stations = stress_stations(cage, {}, grid);
      const auto watched = [&](double radial, double around, double axial) {
        return std::any_of(stations.begin(), stations.end(), [&](int p) {
          const SectorPoint& s = grid.points[static_cast<std::size_t>(p)];
          return s.radial == radial && std::abs(s.around - around) < 1e-9 &&
                 std::abs(s.axial - axial) < 1e-9;
        });
      };
      for (const int p : stations) {
        const SectorPoint& s = grid.points[static_cast<std::size_t>(p)];
        EXPECT_TRUE(watched(s.radial, s.around, -s.axial)) << s.around << " " << s.axial;
        // The bar between two pockets has one middle plane.
        EXPECT_TRUE(s.around == 2 || watched(s.radial, -s.around, s.axial))
            << s.around << " " << s.axial;
      }
    }
  }
}

TEST(StressStations, OfAPinchedBarAreInsideItAndSaySo) {
  const CageDimensions cage;
  const SectorGrid grid = make_sector_grid(mesh_counts(cage, 4));
  int inside = 0;
  for (const int p : stress_stations(cage, {}, grid)) {
    const SectorPoint& s = grid.points[static_cast<std::size_t>(p)];
    const bool in_bar = std::abs(s.around) > 1 && std::abs(s.axial) < 1;
    inside += in_bar;
    EXPECT_EQ(station_name(s).starts_with("inside the bar"), in_bar) << station_name(s);
  }
  EXPECT_EQ(inside, 8);  // both ends of both bars, on two lines
}

}  // namespace
}  // namespace cagetol
