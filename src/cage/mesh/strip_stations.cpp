#include "src/cage/mesh/strip_stations.hpp"

#include <algorithm>
#include <cmath>

#include "src/cage/mesh/hex20.hpp"

namespace cagetol {
namespace {

/// Depth to which every node is watched: on meshes finer than the default the stress of a fillet
/// peaks just inside the surface of the cage.
constexpr double kSurface = 0.06;
constexpr int kLineSamples = 48, kToleranceSamples = 16;
constexpr double kTolerance = 0.25;  ///< of the thickness, to both sides of the pitch circle

}  // namespace

StripStations strip_stations(const CageDimensions& cage, const CageStations& stations,
                             const BarStrip& strip) {
  StripStations watched;
  const auto add = [&](int s, int t, int r, double axial, double fillet) {
    const int node = strip.node_at(s, t, r);
    if (node < 0) return;
    watched.node.push_back(node);
    watched.place.push_back({strip.depth(r), 1 + strip.across_fraction(t), axial, fillet});
  };
  const int radial = strip.radial();
  const auto bar = static_cast<int>(2 * strip.counts.half_bar);
  const auto arc = static_cast<int>(2 * strip.counts.half_arc);
  const double pitch = bar_station(cage, stations, 1, 0).radial;
  const double flat = 1 - 2 * strip.corner_radius / cage.pocket_length;
  /// The line of nodes on which f is nearest to `wanted`.
  const auto nearest = [](int lines, double wanted, const auto& f) {
    int best = 0;
    for (int i = 0; i < lines; i += 2)
      if (std::abs(f(i) - wanted) < std::abs(f(best) - wanted)) best = i;
    return best;
  };
  const auto axial = [&](int s) { return flat * strip.flat_fraction(s); };
  for (const int side : {-1, 1}) {
    // Bars bend most near their end of the fillet, side rings near theirs.
    for (const double share : {0.0, 0.25, 0.5, 1.0, 1.5}) {
      const auto on = static_cast<int>(std::lround(share * arc));
      for (int r = 0; r <= radial; ++r)
        if (std::min(strip.depth(r), 1 - strip.depth(r)) < kSurface || r == radial / 2)
          add(side * (bar + on), 0, r, side, 0.5 * share);
    }
    // Forces off the middle put a bar's largest moment between middle and fillet.
    const int between = nearest(bar, 0.4, axial), under_load = nearest(bar, 0.68, axial);
    for (const int r : {0, radial}) add(side * between, 0, r, side * axial(between), -1);
    add(side * under_load, 0, pitch > 0.5 ? radial : 0, side * axial(under_load), -1);
    // Where two rollers pinch the end of a bar, most of the stress is inside it.
    const int pinched = nearest(bar, 0.87, axial);
    const int inside =
        nearest(strip.across(), 0.35, [&](int t) { return strip.across_fraction(t); });
    const int at_pitch = nearest(radial, pitch, [&](int r) { return strip.depth(r); });
    add(side * pinched, inside, at_pitch, side * axial(pinched), -1);
  }
  for (const int r : {0, radial}) add(0, 0, r, 0, -1);
  return watched;
}

Eigen::VectorXd strip_line_load(const CageDimensions& cage, const CageStations& stations,
                                const PocketDeviation& deviation, const BarStrip& strip,
                                const Eigen::Matrix3Xd& nodes, const Eigen::Vector3d& tangent,
                                std::size_t station) {
  const double scale = 1 + deviation.length / cage.pocket_length;
  const double flat = 0.5 * (cage.pocket_length + deviation.length) - strip.corner_radius;
  const double centre = scale * stations.bar_x[station];
  const auto [low, high, lean] = station_line(centre, scale * stations.bar_half[station], flat);
  const double half = 0.5 * (high - low);
  const double depth = bar_station(cage, stations, 1, 0).radial;
  const auto half_bar = static_cast<int>(2 * strip.counts.half_bar);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(nodes.size());
  double total = 0;
  for (const auto& element : strip.elements) {
    const auto& first = strip.place[static_cast<std::size_t>(element[0])];
    if (first[1] != 0 || first[0] < -half_bar || first[0] >= half_bar) continue;
    const double x0 = nodes(0, element[0]), x1 = nodes(0, element[1]);
    const double r0 = strip.depth(first[2]), r1 = strip.depth(first[2] + 2);
    for (int i = 0; i < kLineSamples; ++i) {
      const double t = (2 * i + 1.0) / kLineSamples - 1;
      const double x = low + half * (1 + t);
      if (x < x0 || x >= x1) continue;
      for (int k = 0; k < kToleranceSamples; ++k) {
        const double b = (2 * k + 1.0) / kToleranceSamples - 1;
        const double r = (depth + kTolerance * b - r0) / (r1 - r0);
        if (r < 0 || r >= 1) continue;
        const double weight = (1 + lean * t) * (1 - std::abs(b));
        const auto shape = hex20_shape({2 * (x - x0) / (x1 - x0) - 1, 2 * r - 1, -1});
        for (std::size_t a = 0; a < 20; ++a)
          load.segment<3>(3 * element[a]) += weight * shape[static_cast<Eigen::Index>(a)] * tangent;
        total += weight;
      }
    }
  }
  return load / total;
}

}  // namespace cagetol
