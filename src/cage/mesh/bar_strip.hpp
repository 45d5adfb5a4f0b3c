// Fine mesh of half a bar with its fillets, for stress (bar_stress.hpp).
//
// Half a sector is a strip bent twice: one half of a side ring, half the bar, the same half of the
// other side ring. Its inner edge is the outline of the pocket, fillets included; its outer edge is
// the middle plane of the bar and the end faces of the cage. Lines of nodes run straight from one
// to the other, so the whole strip is one block of 20-node hexahedra:
//   s  along the strip, from the middle of the pocket at x < 0 over the bar to that at x > 0
//   t  across, from the pocket's outline (0) to the outer edge (1)
//   r  from the inner (0) to the outer surface (1)
// A fillet is what an end mill leaves that moves along the pocket's radial middle line: a cylinder
// of the corner radius about an axis in that direction, tangent to face and side ring face.
// Positions are those of the leading face, in the sector's own frame. Trailing faces are mirror
// images.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "src/cage/mesh/cage_mesh.hpp"

namespace cagetol {

/// Numbers of elements.
struct StripCounts {
  long half_bar = 6;  ///< along the flat of the bar's face, from the middle to a fillet
  long half_arc = 4;  ///< along 45 degrees of a fillet
  long ring = 3;      ///< from a fillet to the middle of the pocket
  long across = 5;    ///< from the pocket's outline to the outer edge
  long radial = 3;    ///< through the thickness
};

struct BarStrip {
  StripCounts counts;
  double corner_radius = 0;
  /// Place of a node in half elements: s from -half_length() to half_length(), t and r from 0.
  std::vector<std::array<int, 3>> place;
  std::vector<std::array<int, 20>> elements;

  int half_length() const {
    return static_cast<int>(2 * (counts.half_bar + 2 * counts.half_arc + counts.ring));
  }
  int across() const { return static_cast<int>(2 * counts.across); }
  int radial() const { return static_cast<int>(2 * counts.radial); }
  /// Depth in the thickness of half element r, 0 at the inner and 1 at the outer surface. Elements
  /// are thinner at the surfaces.
  double depth(int r) const;
  /// Fraction of the way across at half element t, and of half the flat of the bar's face at half
  /// element s. Elements shrink towards the outline and the fillets.
  double across_fraction(int t) const;
  double flat_fraction(int s) const;
  /// s of the end of the outer edge on the bar's middle plane.
  int corner() const { return static_cast<int>(2 * (counts.half_bar + counts.half_arc)); }
  bool on_cut(std::size_t node) const { return std::abs(place[node][0]) == half_length(); }
  bool on_middle_plane(std::size_t node) const {
    return place[node][1] == across() && std::abs(place[node][0]) <= corner();
  }
  /// Node at a place; -1 if none is there.
  int node_at(int s, int t, int r) const;
};

BarStrip make_bar_strip(const StripCounts& counts, double corner_radius);

/// Positions of the nodes for the deviations of the strip's pocket [m]. Nodes on the middle plane
/// do not depend on them.
Eigen::Matrix3Xd strip_nodes(const CageDimensions& cage, const PocketDeviation& deviation,
                             const BarStrip& strip);

/// The same places in the coordinates of the sector grid, to read its fields there. Places in a
/// fillet, where the grid has no material, are moved to the pocket's side ring face.
std::vector<SectorPoint> strip_places(const CageDimensions& cage, const PocketDeviation& deviation,
                                      const BarStrip& strip, const Eigen::Matrix3Xd& nodes);

}  // namespace cagetol
