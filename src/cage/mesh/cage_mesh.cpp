#include "src/cage/mesh/cage_mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "src/cage/mesh/hex8_incompatible.hpp"

namespace cagetol {
namespace {

/// Exponent of the grading towards the pocket's corners; 1 is even.
constexpr double kGrading = 1.5;

/// Angle of a line across the pocket at the tangential offset u + x gamma.
double pocket_angle(const PocketDeviation& deviation, double u, double x, double radius) {
  return deviation.pitch + std::asin((u + x * deviation.squareness) / radius);
}

/// What a point of the pocket's outline moves towards the pocket's middle to lie on a fillet [m].
struct Fillet {
  double axial = 0, around = 0;
};

/// For the point at fractions s and t of the pocket's half width and half length, one of them 1. Of
/// the undeviated pocket it decides which points lie on the fillet, so that no point changes sides
/// when the pocket deviates.
Fillet fillet_at(const CageDimensions& cage, double half_length, double half_width, double s,
                 double t) {
  const double r = cage.corner_radius;
  if (s < 1 && t < 1) return {};
  const bool face = s == 1;
  const double from_corner =
      0.5 * (face ? (1 - t) * cage.pocket_length : (1 - s) * cage.pocket_width);
  if (from_corner >= r) return {};
  const double angle = std::numbers::pi / 4 * (1 - from_corner / r);
  const double along = r * (1 - std::sin(angle)), inward = r * (1 - std::cos(angle));
  if (face) return {along - (1 - t) * half_length, inward};
  return {inward, along - (1 - s) * half_width};
}

CageFault geometry_fault(long pocket, std::string reason) {
  return {CageFaultKind::geometry, static_cast<int>(pocket), std::move(reason)};
}

std::optional<CageFault> pocket_fault(const CageDimensions& cage, const PocketDeviation& deviation,
                                      long pocket) {
  const double width = cage.pocket_width + deviation.width;
  const double length = cage.pocket_length + deviation.length;
  if (!std::isfinite(width + length + deviation.pitch + deviation.squareness)) {
    return geometry_fault(pocket, "a deviation of the pocket is not a finite number");
  }
  if (width <= 0)
    return geometry_fault(pocket, fmt::format("pocket width is {:.4g} mm", 1e3 * width));
  if (length <= 0) {
    return geometry_fault(pocket, fmt::format("pocket length is {:.4g} mm", 1e3 * length));
  }
  const double side = 0.5 * (cage.width - length);
  if (side <= 0) {
    return geometry_fault(
        pocket,
        fmt::format("pocket breaks through the side rings, which are {:.4g} mm thick", 1e3 * side));
  }
  if (2 * cage.corner_radius >= std::min(width, length)) {
    return geometry_fault(pocket, fmt::format("pocket has no room for corners of radius {:.4g} mm",
                                              1e3 * cage.corner_radius));
  }
  // The narrowest place of a half bar: inner surface, at the pocket end towards which the face
  // leans.
  const double offset = 0.5 * width + 0.5 * cage.width * std::abs(deviation.squareness);
  const double bar = offset < cage.inner_radius
                         ? std::numbers::pi / static_cast<double>(cage.pocket_count) -
                               std::abs(deviation.pitch) - std::asin(offset / cage.inner_radius)
                         : -1.0;
  if (bar <= 0) {
    return geometry_fault(pocket,
                          fmt::format("pocket reaches past the middle of a bar, which keeps "
                                      "{:.4g} mm of its half at the inner surface",
                                      1e3 * bar * cage.inner_radius));
  }
  return std::nullopt;
}

/// Line `p` of a row of `inner` elements from -1 to 1 between two rows of `outer` elements that
/// reach to -2 and 2. Elements shrink towards -1 and 1, where the pocket's corners concentrate the
/// strain.
double graded(long p, long inner, long outer) {
  if (p < 0) return -graded(inner - p, inner, outer);
  if (p > inner) {
    return 1 + std::pow(static_cast<double>(p - inner) / static_cast<double>(outer), kGrading);
  }
  const double t = -1 + 2 * static_cast<double>(p) / static_cast<double>(inner);
  return std::copysign(1 - std::pow(1 - std::abs(t), kGrading), t);
}

}  // namespace

MeshCounts mesh_counts(const CageDimensions& cage, long density) {
  const double thickness = cage.outer_radius - cage.inner_radius;
  const double mean_radius = 0.5 * (cage.inner_radius + cage.outer_radius);
  const double half_bar =
      mean_radius * (std::numbers::pi / static_cast<double>(cage.pocket_count) -
                     std::asin(std::min(0.99, 0.5 * cage.pocket_width / mean_radius)));
  const double side = 0.5 * (cage.width - cage.pocket_length);
  // Bars and side rings carry the strain, so the elements follow their widths; a cage much thicker
  // than these are wide bounds the number of elements.
  const double step =
      std::max(0.5 * thickness, 1.3 * std::min(2 * half_bar, side)) / static_cast<double>(density);
  const auto count = [](double length, double by) {
    return std::max(1L, static_cast<long>(std::ceil(length / by - 1e-9)));
  };
  return {.radial = density,
          .half_bar = count(half_bar, 2 * step / 3),
          .pocket = 2 * count(0.5 * cage.pocket_width, 4 * step / 3),
          .side = count(side, step),
          .length = 2 * count(0.5 * cage.pocket_length, step)};
}

Eigen::Vector3d sector_position(const CageDimensions& cage, const PocketDeviation& deviation,
                                const SectorPoint& point) {
  // How far into the bar: 0 at the pocket face and inside the pocket, 1 at the bar's middle plane.
  const double bar = std::max(0.0, std::abs(point.around) - 1);
  const double ring = std::max(0.0, std::abs(point.axial) - 1);
  const double pocket_half = 0.5 * (cage.pocket_length + deviation.length);
  const double half_length = 0.5 * (cage.pocket_length + (1 - bar) * deviation.length);
  const double t = std::clamp(point.axial, -1.0, 1.0);
  const double radius = cage.inner_radius + point.radial * (cage.outer_radius - cage.inner_radius);
  const double half_width = 0.5 * (cage.pocket_width + deviation.width);
  const double s = std::clamp(point.around, -1.0, 1.0);
  const Fillet fillet = fillet_at(cage, pocket_half, half_width, std::abs(s), std::abs(t));
  const double x = t * half_length + (point.axial - t) * (0.5 * cage.width - half_length) -
                   (t < 0 ? -1 : 1) * (1 - bar) * (1 - ring) * fillet.axial;
  const double u = s * half_width - (s < 0 ? -1 : 1) * (1 - ring) * fillet.around;
  const double face = pocket_angle(deviation, u, x, radius);
  const double middle =
      std::copysign(std::numbers::pi / static_cast<double>(cage.pocket_count), point.around);
  const double theta = (1 - bar) * face + bar * middle;
  return {x, radius * std::cos(theta), radius * std::sin(theta)};
}

Eigen::Matrix3d sector_rotation(const CageDimensions& cage, long sector) {
  const double angle =
      2 * std::numbers::pi * static_cast<double>(sector) / static_cast<double>(cage.pocket_count);
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

SectorGrid make_sector_grid(const MeshCounts& counts) {
  SectorGrid grid;
  grid.counts = counts;
  grid.columns = 2 * counts.half_bar + counts.pocket;
  const long rows = 2 * counts.side + counts.length;
  const auto around = [&](long c) {
    return graded(c - counts.half_bar, counts.pocket, counts.half_bar);
  };
  const auto axial = [&](long x) { return graded(x - counts.side, counts.length, counts.side); };
  const auto open = [&](double c, double x) { return std::abs(c) < 1 && std::abs(x) < 1; };

  const long nr = counts.radial + 1;
  std::vector<int> number(static_cast<std::size_t>((grid.columns + 1) * (rows + 1) * nr), -1);
  const auto at = [&](long c, long x, long r) -> int& {
    return number[static_cast<std::size_t>((c * (rows + 1) + x) * nr + r)];
  };
  for (long c = 0; c <= grid.columns; ++c) {
    for (long x = 0; x <= rows; ++x) {
      if (open(around(c), axial(x))) continue;
      for (long r = 0; r < nr; ++r) {
        at(c, x, r) = static_cast<int>(grid.points.size());
        grid.points.push_back(
            {static_cast<double>(r) / static_cast<double>(counts.radial), around(c), axial(x)});
        grid.column.push_back(static_cast<int>(c));
      }
    }
  }
  for (long c = 0; c < grid.columns; ++c) {
    for (long x = 0; x < rows; ++x) {
      if (open(0.5 * (around(c) + around(c + 1)), 0.5 * (axial(x) + axial(x + 1)))) continue;
      for (long r = 0; r < counts.radial; ++r) {
        grid.elements.push_back({at(c, x, r), at(c, x, r + 1), at(c + 1, x, r + 1), at(c + 1, x, r),
                                 at(c, x + 1, r), at(c, x + 1, r + 1), at(c + 1, x + 1, r + 1),
                                 at(c + 1, x + 1, r)});
      }
    }
  }
  return grid;
}

std::vector<int> mirror_points(const SectorGrid& grid) {
  std::map<std::array<long, 3>, int> number;
  const auto key = [](const SectorPoint& p, double side) {
    return std::array<long, 3>{std::lround(1e7 * p.radial), std::lround(1e7 * side * p.around),
                               std::lround(1e7 * p.axial)};
  };
  for (std::size_t i = 0; i < grid.points.size(); ++i)
    number[key(grid.points[i], 1)] = static_cast<int>(i);
  std::vector<int> mirror;
  for (const SectorPoint& point : grid.points) mirror.push_back(number.at(key(point, -1)));
  return mirror;
}

Eigen::MatrixXd mirror_field(const std::vector<int>& mirror, const Eigen::MatrixXd& field) {
  Eigen::MatrixXd out(field.rows(), field.cols());
  for (std::size_t p = 0; p < mirror.size(); ++p) {
    const auto to = 3 * static_cast<Eigen::Index>(p);
    out.middleRows<3>(to) = field.middleRows<3>(3 * mirror[p]);
    out.row(to + 2) *= -1;
  }
  return out;
}

Eigen::Matrix3Xd sector_nodes(const CageDimensions& cage, const PocketDeviation& deviation,
                              const SectorGrid& grid) {
  Eigen::Matrix3Xd nodes(3, static_cast<Eigen::Index>(grid.points.size()));
  for (Eigen::Index p = 0; p < nodes.cols(); ++p) {
    nodes.col(p) = sector_position(cage, deviation, grid.points[static_cast<std::size_t>(p)]);
  }
  return nodes;
}

std::optional<CageFault> cage_fault(const CageDimensions& cage,
                                    const std::vector<PocketDeviation>& deviations) {
  for (std::size_t j = 0; j < deviations.size(); ++j) {
    if (auto fault = pocket_fault(cage, deviations[j], static_cast<long>(j))) return fault;
  }
  return std::nullopt;
}

std::variant<CageMesh, CageFault> make_cage_mesh(const CageDimensions& cage,
                                                 const std::vector<PocketDeviation>& deviations,
                                                 const MeshCounts& counts) {
  if (auto fault = cage_fault(cage, deviations)) return *fault;
  CageMesh result{cage, make_sector_grid(counts), {}, {}};
  const SectorGrid& grid = result.grid;
  const auto sectors = static_cast<std::size_t>(cage.pocket_count);
  result.sector_node.assign(sectors, std::vector<int>(grid.points.size(), -1));

  // Points of a sector's last column are those of the first column of the next sector.
  int count = 0;
  std::vector<std::size_t> first_column;
  std::vector<std::size_t> last_column;
  for (std::size_t p = 0; p < grid.points.size(); ++p) {
    if (grid.column[p] == 0) first_column.push_back(p);
    if (grid.column[p] == grid.columns) last_column.push_back(p);
  }
  for (auto& node : result.sector_node) {
    for (std::size_t p = 0; p < grid.points.size(); ++p) {
      if (grid.column[p] < grid.columns) node[p] = count++;
    }
  }
  for (std::size_t j = 0; j < sectors; ++j) {
    for (std::size_t i = 0; i < last_column.size(); ++i) {
      result.sector_node[j][last_column[i]] =
          result.sector_node[(j + 1) % sectors][first_column[i]];
    }
  }

  result.mesh.nodes.resize(3, count);
  for (std::size_t j = 0; j < sectors; ++j) {
    const Eigen::Matrix3Xd nodes =
        sector_rotation(cage, static_cast<long>(j)) * sector_nodes(cage, deviations[j], grid);
    for (std::size_t p = 0; p < grid.points.size(); ++p) {
      result.mesh.nodes.col(result.sector_node[j][p]) = nodes.col(static_cast<Eigen::Index>(p));
    }
    for (const auto& corners : grid.elements) {
      std::array<int, 8> element{};
      for (std::size_t a = 0; a < 8; ++a) {
        element[a] = result.sector_node[j][static_cast<std::size_t>(corners[a])];
      }
      result.mesh.elements.push_back(element);
      if (hex8_smallest_jacobian(element_nodes(result.mesh, element)) <= 0) {
        return geometry_fault(static_cast<long>(j),
                              "an element of the pocket's sector is inverted");
      }
    }
  }
  return result;
}

CageDimensions cage_dimensions(const OperatingScene& scene) {
  const CageGeometry& geometry = scene.cage;
  const auto mean = [&](const std::vector<double>& values) {
    double sum = 0;
    for (double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  };
  return {.pocket_count = scene.bearing.roller_count,
          .inner_radius = 0.5 * geometry.inner_diameter,
          .outer_radius = 0.5 * geometry.outer_diameter,
          .width = geometry.width,
          .pocket_width = mean(geometry.pocket_width),
          .pocket_length = mean(geometry.pocket_length),
          .corner_radius = geometry.corner_radius};
}

std::vector<PocketDeviation> pocket_deviations(const OperatingScene& scene,
                                               const CageDimensions& cage) {
  const CageGeometry& geometry = scene.cage;
  std::vector<PocketDeviation> deviations(static_cast<std::size_t>(cage.pocket_count));
  for (long j = 0; j < cage.pocket_count; ++j) {
    deviations[static_cast<std::size_t>(j)] = {
        .width = each(geometry.pocket_width, j) - cage.pocket_width,
        .length = each(geometry.pocket_length, j) - cage.pocket_length,
        .pitch = each(geometry.pocket_pitch, j),
        .squareness = each(geometry.pocket_squareness, j)};
  }
  return deviations;
}

}  // namespace cagetol
