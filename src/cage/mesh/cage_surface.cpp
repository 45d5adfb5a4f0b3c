#include "src/cage/mesh/cage_surface.hpp"

#include <cmath>
#include <map>
#include <numbers>

namespace cagetol {
namespace {

/// Corners of an element's faces.
constexpr std::array<std::array<std::size_t, 4>, 6> kFaces = {
    {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Adds the faces of a sector whose points all satisfy `on`; `flat` places a point, given in the
/// sector's own frame.
template <typename On, typename Flat>
void add_faces(const CageMesh& cage, std::size_t sector, const On& on, const Flat& flat,
               CageSurface& surface) {
  const Eigen::Matrix3d back = sector_rotation(cage.cage, static_cast<long>(sector)).transpose();
  std::map<int, int> point_of;  // of the grid -> of the surface
  const auto point = [&](int p) {
    const auto [found, is_new] = point_of.try_emplace(p, static_cast<int>(surface.node.size()));
    if (is_new) {
      const int node = cage.sector_node[sector][static_cast<std::size_t>(p)];
      const auto [across, up] = flat(Eigen::Vector3d(back * cage.mesh.nodes.col(node)));
      surface.node.push_back(node);
      surface.across.push_back(across);
      surface.up.push_back(up);
    }
    return found->second;
  };
  for (const auto& element : cage.grid.elements)
    for (const auto& face : kFaces) {
      bool all = true;
      for (const std::size_t corner : face)
        all = all && on(cage.grid.points[static_cast<std::size_t>(element[corner])]);
      if (!all) continue;
      std::array<int, 4> cell{};
      for (std::size_t i = 0; i < 4; ++i) cell[i] = point(element[face[i]]);
      surface.cells.push_back(cell);
    }
}

}  // namespace

CageSurface cylinder_surface(const CageMesh& cage, bool outer) {
  CageSurface surface;
  for (std::size_t j = 0; j < cage.sector_node.size(); ++j) {
    const double centre = 2 * std::numbers::pi * static_cast<double>(j) /
                          static_cast<double>(cage.sector_node.size());
    add_faces(
        cage, j, [&](const SectorPoint& p) { return p.radial == (outer ? 1 : 0); },
        [&](const Eigen::Vector3d& at) {
          return std::pair(centre + std::atan2(at[2], at[1]), at[0]);
        },
        surface);
  }
  return surface;
}

CageSurface pocket_walls(const CageMesh& cage, const PocketDeviation& deviation, long pocket) {
  const double length = cage.cage.pocket_length + deviation.length;
  const double width = cage.cage.pocket_width + deviation.width;
  const Eigen::Vector3d tangent(0, -std::sin(deviation.pitch), std::cos(deviation.pitch));
  CageSurface surface;
  const auto add = [&](const auto& on, const auto& along) {
    add_faces(
        cage, static_cast<std::size_t>(pocket), on,
        [&](const Eigen::Vector3d& at) {
          return std::pair(along(at[0], at.dot(tangent)), at.tail<2>().norm());
        },
        surface);
  };
  const auto on_bar = [](double face) {
    return [face](const SectorPoint& p) { return p.around == face && std::abs(p.axial) <= 1; };
  };
  const auto on_end = [](double end) {
    return [end](const SectorPoint& p) { return p.axial == end && std::abs(p.around) <= 1; };
  };
  add(on_bar(-1), [&](double x, double) { return length / 2 + x; });
  add(on_end(1), [&](double, double u) { return length + width / 2 + u; });
  add(on_bar(1), [&](double x, double) { return 1.5 * length + width - x; });
  add(on_end(-1), [&](double, double u) { return 2 * length + 1.5 * width - u; });
  return surface;
}

}  // namespace cagetol
