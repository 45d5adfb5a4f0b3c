// The fine mesh of half a bar: its fillets, its middle plane, its volume.
#include "src/cage/mesh/bar_strip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/cage/mesh/hex20.hpp"
#include "src/cage/mesh/sector_polynomial.hpp"

namespace cagetol {
namespace {

constexpr double kRadius = 0.5e-3;

Hex20Nodes element_of(const BarStrip& strip, const Eigen::Matrix3Xd& nodes, std::size_t e) {
  Hex20Nodes at;
  for (int a = 0; a < 20; ++a)
    at.col(a) = nodes.col(strip.elements[e][static_cast<std::size_t>(a)]);
  return at;
}

TEST(BarStrip, FilletsAreCylindersTangentToFaceAndEndWall) {
  const CageDimensions cage;
  const BarStrip strip = make_bar_strip({}, kRadius);
  const PocketDeviation deviation{.width = 0.1e-3, .length = -0.2e-3};
  const Eigen::Matrix3Xd nodes = strip_nodes(cage, deviation, strip);
  const double u = 0.5 * (cage.pocket_width + deviation.width) - kRadius;
  const double x = 0.5 * (cage.pocket_length + deviation.length) - kRadius;
  int on_fillet = 0;
  for (std::size_t i = 0; i < strip.place.size(); ++i) {
    const auto& [s, t, r] = strip.place[i];
    const long from = 2 * strip.counts.half_bar, to = from + 4 * strip.counts.half_arc;
    if (t != 0 || std::abs(s) < from || std::abs(s) > to) continue;
    const auto at = nodes.col(static_cast<Eigen::Index>(i));
    EXPECT_NEAR(std::hypot(at[2] - u, std::abs(at[0]) - x), kRadius, 1e-12);
    ++on_fillet;
  }
  EXPECT_GT(on_fillet, 50);
}

TEST(BarStrip, FillsHalfASectorAtEveryDeviationOfATable) {
  const CageDimensions cage;
  const BarStrip strip = make_bar_strip({}, kRadius);
  const PocketDeviation range = table_range(cage);
  Eigen::Matrix3Xd first;
  for (const PocketDeviation& d : polynomial_samples(range)) {
    const Eigen::Matrix3Xd nodes = strip_nodes(cage, d, strip);
    double volume = 0;
    for (std::size_t e = 0; e < strip.elements.size(); ++e)
      volume += hex20_mass(element_of(strip, nodes, e), 1).sum();
    // Half a sector from the pocket's middle, whose place follows pitch, less the half pocket;
    // fillets fill (1 - pi/4) r^2 of each corner. The pocket's walls are parallel.
    const double thickness = cage.outer_radius - cage.inner_radius;
    const double mean = 0.5 * (cage.outer_radius + cage.inner_radius);
    const double half = std::numbers::pi / 13 - d.pitch;
    const double pocket = 0.25 * (cage.pocket_width + d.width) * (cage.pocket_length + d.length);
    const double corners = 2 * (1 - std::numbers::pi / 4) * kRadius * kRadius;
    // The middle plane keeps its length where pockets deviate.
    const double expected =
        mean * thickness * half * cage.width - (2 * pocket - corners) * thickness;
    EXPECT_NEAR(volume / expected, 1, 0.02)
        << d.width << " " << d.length << " " << d.pitch << " " << d.squareness;
    if (first.size() == 0) first = nodes;
    for (std::size_t i = 0; i < strip.place.size(); ++i)
      if (strip.on_middle_plane(i)) {
        const auto at = static_cast<Eigen::Index>(i);
        EXPECT_LT((nodes.col(at) - first.col(at)).norm(), 1e-15);
      }
  }
}

TEST(BarStrip, PlacesAreThoseOfTheSectorGrid) {
  const CageDimensions cage;
  const BarStrip strip = make_bar_strip({}, kRadius);
  const PocketDeviation d{.width = 0.1e-3, .length = -0.2e-3, .pitch = 3e-3, .squareness = 5e-3};
  const Eigen::Matrix3Xd nodes = strip_nodes(cage, d, strip);
  const auto places = strip_places(cage, d, strip, nodes);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto at = nodes.col(static_cast<Eigen::Index>(i));
    const double offset =
        at.tail<2>().norm() * std::sin(std::atan2(at[2], at[1]) - d.pitch) - at[0] * d.squareness;
    const bool in_fillet = offset < 0.5 * (cage.pocket_width + d.width) - 1e-9 &&
                           std::abs(at[0]) < 0.5 * (cage.pocket_length + d.length) - 1e-9;
    if (in_fillet) continue;
    EXPECT_LT((sector_position(cage, d, places[i]) - at).norm(), 2e-6) << places[i].around;
  }
}

}  // namespace
}  // namespace cagetol
