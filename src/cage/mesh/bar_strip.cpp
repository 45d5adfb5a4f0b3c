#include "src/cage/mesh/bar_strip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/cage/mesh/hex20.hpp"

namespace cagetol {
namespace {

constexpr double kAlong = 1.7;  // grading of elements towards a fillet along the strip
constexpr double kAcross = 2.8;

/// Fraction of a row of `elements` that lies before half element `half`; elements shrink towards
/// the end of the row, nodes on edges halve them.
double graded_fraction(int half, long elements, double grading) {
  const auto line = [&](int element) {
    return 1 - std::pow(1 - static_cast<double>(element) / static_cast<double>(elements), grading);
  };
  return half % 2 == 0 ? line(half / 2) : 0.5 * (line(half / 2) + line(half / 2 + 1));
}

/// A point in the plane across the radial direction: axial position, and either the tangential
/// offset from the pocket's middle or the angle of the bar's middle plane.
struct Place2 {
  double x = 0, offset = 0;
  double toward_middle = 0;  ///< fraction of the angle from that offset to the middle plane
};

struct Outline {
  Place2 inner, outer;
};

/// Ends of the line across at half element `s` of the part x >= 0.
Outline outline_at(const CageDimensions& cage, const PocketDeviation& deviation,
                   const BarStrip& strip, int s) {
  const StripCounts& n = strip.counts;
  const double radius = strip.corner_radius;
  const double half_width = 0.5 * (cage.pocket_width + deviation.width);
  const double half_length = 0.5 * (cage.pocket_length + deviation.length);
  // The middle plane keeps its nodes where they are in the undeviated cage.
  const double undeviated = 0.5 * cage.pocket_length - radius;
  const double end = 0.5 * cage.width;
  const auto bar = static_cast<int>(2 * n.half_bar), arc = static_cast<int>(2 * n.half_arc);
  if (s <= bar) {
    const double f = strip.flat_fraction(s);
    return {{f * (half_length - radius), half_width, 0}, {f * undeviated, half_width, 1}};
  }
  if (s <= bar + 2 * arc) {
    const double f = static_cast<double>(s - bar) / arc;  // 1 at 45 degrees
    const double angle = f * std::numbers::pi / 4;
    const Place2 inner{half_length - radius + radius * std::sin(angle),
                       half_width - radius + radius * std::cos(angle), 0};
    if (f <= 1) return {inner, {undeviated + f * (end - undeviated), half_width, 1}};
    return {inner, {end, half_width - radius, 2 - f}};
  }
  const double f =
      1 - graded_fraction(static_cast<int>(2 * n.ring) - (s - bar - 2 * arc), n.ring, kAlong);
  const double offset = (1 - f) * (half_width - radius);
  return {{half_length, offset, 0}, {end, offset, 0}};
}

}  // namespace

double BarStrip::depth(int r) const {
  const auto line = [&](int element) {
    const double f = static_cast<double>(element) / static_cast<double>(counts.radial);
    return 0.5 * (1 - std::cos(std::numbers::pi * f));
  };
  return r % 2 == 0 ? line(r / 2) : 0.5 * (line(r / 2) + line(r / 2 + 1));
}

double BarStrip::across_fraction(int t) const {
  return 1 - graded_fraction(across() - t, counts.across, kAcross);
}

double BarStrip::flat_fraction(int s) const {
  return graded_fraction(s, counts.half_bar, kAlong);
}

int BarStrip::node_at(int s, int t, int r) const {
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] == std::array<int, 3>{s, t, r}) return static_cast<int>(i);
  return -1;
}

BarStrip make_bar_strip(const StripCounts& counts, double corner_radius) {
  BarStrip strip{counts, corner_radius, {}, {}};
  const int half = strip.half_length(), across = strip.across(), radial = strip.radial();
  std::vector<int> number(static_cast<std::size_t>((2 * half + 1) * (across + 1) * (radial + 1)),
                          -1);
  const auto at = [&](int s, int t, int r) -> int& {
    return number[static_cast<std::size_t>(((s + half) * (across + 1) + t) * (radial + 1) + r)];
  };
  for (int s = -half; s <= half; ++s)
    for (int t = 0; t <= across; ++t)
      for (int r = 0; r <= radial; ++r) {
        if ((s & 1) + (t & 1) + (r & 1) > 1) continue;
        at(s, t, r) = static_cast<int>(strip.place.size());
        strip.place.push_back({s, t, r});
      }
  for (int s = -half; s < half; s += 2)
    for (int t = 0; t < across; t += 2)
      for (int r = 0; r < radial; r += 2) {
        std::array<int, 20> element{};
        for (int a = 0; a < 20; ++a) {
          const auto& local = hex20_node(a);
          element[static_cast<std::size_t>(a)] =
              at(s + 1 + static_cast<int>(local[0]), t + 1 + static_cast<int>(local[2]),
                 r + 1 + static_cast<int>(local[1]));
        }
        strip.elements.push_back(element);
      }
  return strip;
}

Eigen::Matrix3Xd strip_nodes(const CageDimensions& cage, const PocketDeviation& deviation,
                             const BarStrip& strip) {
  const double middle = std::numbers::pi / static_cast<double>(cage.pocket_count);
  Eigen::Matrix3Xd nodes(3, static_cast<Eigen::Index>(strip.place.size()));
  for (std::size_t i = 0; i < strip.place.size(); ++i) {
    const auto& [s, t, r] = strip.place[i];
    const double radius =
        cage.inner_radius + strip.depth(r) * (cage.outer_radius - cage.inner_radius);
    const Outline outline = outline_at(cage, deviation, strip, std::abs(s));
    const double side = s < 0 ? -1 : 1;
    const auto angle = [&](const Place2& p) {
      const double face =
          deviation.pitch + std::asin((p.offset + side * p.x * deviation.squareness) / radius);
      return face + p.toward_middle * (middle - face);
    };
    const double f = strip.across_fraction(t);
    const double theta = (1 - f) * angle(outline.inner) + f * angle(outline.outer);
    nodes.col(static_cast<Eigen::Index>(i))
        << side * ((1 - f) * outline.inner.x + f * outline.outer.x),
        radius * std::cos(theta), radius * std::sin(theta);
  }
  return nodes;
}

std::vector<SectorPoint> strip_places(const CageDimensions& cage, const PocketDeviation& deviation,
                                      const BarStrip& strip, const Eigen::Matrix3Xd& nodes) {
  const double middle = std::numbers::pi / static_cast<double>(cage.pocket_count);
  const double half_width = 0.5 * (cage.pocket_width + deviation.width);
  std::vector<SectorPoint> places;
  for (std::size_t i = 0; i < strip.place.size(); ++i) {
    const auto node = nodes.col(static_cast<Eigen::Index>(i));
    const double radius = node.tail<2>().norm(), x = node[0];
    const double theta = std::atan2(node[2], node[1]);
    const double face =
        deviation.pitch + std::asin((half_width + x * deviation.squareness) / radius);
    SectorPoint p;
    p.radial = strip.depth(strip.place[i][2]);
    if (theta >= face) {
      p.around = 1 + std::min(1.0, (theta - face) / (middle - face));
    } else {
      p.around = std::clamp(
          (radius * std::sin(theta - deviation.pitch) - x * deviation.squareness) / half_width, 0.0,
          1.0);
    }
    const double bar = std::max(0.0, p.around - 1);
    const double half_length = 0.5 * (cage.pocket_length + (1 - bar) * deviation.length);
    const double along = std::abs(x);
    p.axial = along <= half_length ? along / half_length
                                   : 1 + (along - half_length) / (0.5 * cage.width - half_length);
    if (strip.on_cut(i)) p.around = 0;
    if (strip.on_middle_plane(i)) p.around = 2;
    if (p.around < 1 - 1e-9) p.axial = std::max(p.axial, 1.0);
    p.axial = std::copysign(std::min(p.axial, 2.0), x);
    places.push_back(p);
  }
  return places;
}

}  // namespace cagetol
