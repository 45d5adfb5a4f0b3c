#include "src/cage/mesh/cage_stations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {
namespace {

constexpr int kLinePoints = 6;  // of the mean over a station's line

/// Rotates radial and tangential directions at angle theta; rows: radial, tangential, axial.
Eigen::Matrix3d directions(double theta) {
  Eigen::Matrix3d rows;
  rows << 0, std::cos(theta), std::sin(theta), 0, -std::sin(theta), std::cos(theta), 1, 0, 0;
  return rows;
}

/// The line of nodes nearest to `wanted` along a coordinate of the grid, on the same side of the
/// corner, the corner's aside.
double nearest_line(const SectorGrid& grid, double SectorPoint::*coordinate, double wanted) {
  double best = wanted < 1 ? 0 : 2;
  for (const SectorPoint& point : grid.points) {
    const double value = point.*coordinate;
    if (value != 1 && (value < 1) == (wanted < 1) &&
        std::abs(value - wanted) < std::abs(best - wanted))
      best = value;
  }
  return best;
}

bool between(double value, double low, double high) {
  return value >= low - 1e-12 && value <= high + 1e-12;
}

double local_coordinate(double value, double low, double high) {
  return std::clamp(2 * (value - low) / (high - low) - 1, -1.0, 1.0);
}

}  // namespace

CageStations cage_stations(const OperatingScene& scene) {
  CageStations stations;
  const CageGeometry& cage = scene.cage;
  double diameter = 0;
  for (double d : scene.roller.diameter)
    diameter += d / static_cast<double>(scene.roller.diameter.size());
  const long n = scene.discretisation.bar_stations;
  stations.bar_x.clear();
  stations.bar_half.clear();
  for (long i = 0; i < n; ++i) {
    const double t = n == 1 ? 0 : -1 + 2 * static_cast<double>(i) / static_cast<double>(n - 1);
    stations.bar_x.push_back(0.4 * t * scene.roller.length);
    // Neighbours share the line between them; nothing reaches beyond the roller's ends.
    const double spacing = n == 1 ? 1 : 0.8 / static_cast<double>(n - 1);
    stations.bar_half.push_back(std::min(spacing / 2, 0.5 - 0.4 * std::abs(t)) *
                                scene.roller.length);
  }
  stations.pitch_radius =
      0.25 * (scene.bearing.inner_raceway_diameter + scene.bearing.outer_raceway_diameter);
  stations.end_offset = 0.4 * diameter;
  stations.outer_guided = cage.guidance != Guidance::inner;
  double length = 0;
  for (double l : cage.pocket_length) length += l / static_cast<double>(cage.pocket_length.size());
  stations.land_offset =
      std::isnan(cage.land_offset) ? 0.25 * (cage.width + length) : cage.land_offset;
  return stations;
}

long contact_points(const CageStations& stations) {
  return 2 * static_cast<long>(stations.bar_x.size()) + 8;
}

SectorPoint bar_station(const CageDimensions& cage, const CageStations& stations, double face,
                        double x) {
  const double depth =
      (stations.pitch_radius - cage.inner_radius) / (cage.outer_radius - cage.inner_radius);
  return {std::clamp(depth, 0.0, 1.0), face, std::clamp(2 * x / cage.pocket_length, -1.0, 1.0)};
}

SectorReading read_at(const SectorGrid& grid, const SectorPoint& place) {
  for (const auto& element : grid.elements) {
    const SectorPoint& low = grid.points[static_cast<std::size_t>(element[0])];
    const SectorPoint& high = grid.points[static_cast<std::size_t>(element[6])];
    if (!between(place.radial, low.radial, high.radial) ||
        !between(place.around, low.around, high.around) ||
        !between(place.axial, low.axial, high.axial)) {
      continue;
    }
    SectorReading reading;
    reading.point = element;
    const double r = local_coordinate(place.radial, low.radial, high.radial);
    const double c = local_coordinate(place.around, low.around, high.around);
    const double x = local_coordinate(place.axial, low.axial, high.axial);
    const auto weight = [](double t, bool upper) { return 0.5 * (upper ? 1 + t : 1 - t); };
    for (int a = 0; a < 8; ++a) {
      const bool far_r = a % 4 == 1 || a % 4 == 2;
      const bool far_c = a % 4 >= 2;
      reading.weight[a] = weight(r, far_r) * weight(c, far_c) * weight(x, a >= 4);
    }
    return reading;
  }
  throw std::logic_error("cage: no element at the place of a station");
}

StationLine station_line(double centre, double half, double flat) {
  StationLine line;
  line.low = std::clamp(centre - half, -flat, 0.999 * flat);
  line.high = std::clamp(centre + half, 0.999 * line.low, flat);
  const double reach = 0.5 * (line.high - line.low);
  if (reach > 0)
    line.lean = std::clamp(3 * (centre - 0.5 * (line.low + line.high)) / reach, -1.0, 1.0);
  return line;
}

std::vector<SectorReading> read_bar(const CageDimensions& cage, const CageStations& stations,
                                    const SectorGrid& grid, double face, std::size_t i) {
  const StationLine line = station_line(stations.bar_x[i], stations.bar_half[i],
                                        0.5 * cage.pocket_length - cage.corner_radius);
  std::vector<SectorReading> readings;
  for (int k = 0; k < kLinePoints; ++k) {
    const double along = (2 * k + 1.0) / kLinePoints - 1;
    const double x = 0.5 * (line.low + line.high + along * (line.high - line.low));
    readings.push_back(read_at(grid, bar_station(cage, stations, face, x)));
    readings.back().weight *= (1 + line.lean * along) / kLinePoints;
  }
  return readings;
}

Eigen::MatrixXd contact_rows(const CageDimensions& cage, const CageStations& stations,
                             const SectorGrid& grid, const PocketDeviation& deviation,
                             const Eigen::MatrixXd& sector_fields) {
  Eigen::MatrixXd rows(3 * contact_points(stations), sector_fields.cols());
  Eigen::Index next = 0;
  const auto add_readings = [&](const std::vector<SectorReading>& readings, double theta) {
    auto out = rows.middleRows<3>(next);
    out.setZero();
    const Eigen::Matrix3d frame = directions(theta);
    for (const SectorReading& reading : readings)
      for (int a = 0; a < 8; ++a) {
        if (reading.weight[a] == 0) continue;
        out += reading.weight[a] * frame *
               sector_fields.middleRows<3>(3 * reading.point[static_cast<std::size_t>(a)]);
      }
    next += 3;
  };
  const auto add = [&](const SectorPoint& place, double theta) {
    add_readings({read_at(grid, place)}, theta);
  };
  const double half_length = 0.5 * (cage.pocket_length + deviation.length);
  const double half_width = 0.5 * (cage.pocket_width + deviation.width);
  for (double face : {-1.0, 1.0}) {
    for (std::size_t i = 0; i < stations.bar_x.size(); ++i)
      add_readings(read_bar(cage, stations, grid, face, i), deviation.pitch);
  }
  const double radial = bar_station(cage, stations, 1, 0).radial;
  const double across = std::min(1.0, stations.end_offset / half_width);
  for (double end : {-1.0, 1.0}) {
    for (double side : {-1.0, 1.0}) add({radial, side * across, end}, deviation.pitch);
  }
  const double bar_middle = std::numbers::pi / static_cast<double>(cage.pocket_count);
  const double surface = stations.outer_guided ? 1 : 0;
  const auto land = [&](double half) {
    const double t = stations.land_offset <= half
                         ? stations.land_offset / half
                         : 1 + (stations.land_offset - half) / (0.5 * cage.width - half);
    return std::min(t, 2.0);
  };
  for (double end : {-1.0, 1.0}) {
    add({surface, 0, end * std::max(1.0, land(half_length))}, deviation.pitch);
  }
  for (double end : {-1.0, 1.0})
    add({surface, 2, end * land(0.5 * cage.pocket_length)}, bar_middle);
  return rows;
}

std::vector<int> stress_stations(const CageDimensions& cage, const CageStations& stations,
                                 const SectorGrid& grid) {
  // Forces off the middle put the largest moment of a bar between middle and root. Side rings bend
  // most just off the bars' roots: an edge's own corner averages the stress of three elements.
  const double between = nearest_line(grid, &SectorPoint::axial, 0.4);
  const double half_way = nearest_line(grid, &SectorPoint::around, 0.5);
  const double next_to_root = nearest_line(grid, &SectorPoint::axial, 0.999);
  // Which line off a root has it depends on the cage, so all of them are watched; a coarse mesh has
  // one.
  const double nearest_off_bar = nearest_line(grid, &SectorPoint::around, 0.65);
  const double nearest_in_bar = nearest_line(grid, &SectorPoint::around, 1.35);
  const double depths = static_cast<double>(grid.counts.radial);
  // Rollers push on the bars nearer to one surface.
  const double pitch = bar_station(cage, stations, 1, 0).radial;
  const double loaded = std::round(pitch);
  // Where two rollers pinch the end of a bar, most of the stress is inside it.
  const double pinched_depth = std::round(depths * pitch) / depths;
  const double pinched_end = nearest_line(grid, &SectorPoint::axial, 0.87);
  // Lines on both sides of the middle differ by rounding.
  const auto on = [](double value, double line) { return std::abs(value - line) < 1e-9; };
  std::vector<int> watched;
  for (std::size_t p = 0; p < grid.points.size(); ++p) {
    const SectorPoint& point = grid.points[p];
    const bool surface = point.radial == 0 || point.radial == 1;
    const double around = std::abs(point.around);
    const double axial = std::abs(point.axial);
    const bool corner = around == 1 && axial == 1 && surface;
    const bool bar_middle = around == 1 && surface && (axial == 0 || on(axial, between));
    const bool under_load = around == 1 && point.radial == loaded && axial > 0.55 && axial < 0.82;
    const bool off_bar = on(around, nearest_off_bar) || (around > 0.6 && around < 1 - 1e-9);
    const bool in_bar = on(around, nearest_in_bar) || (around > 1.1 && around < 1.6);
    const bool pinched = in_bar && on(point.radial, pinched_depth) && on(axial, pinched_end);
    const bool bar_root = around == 1 && on(axial, next_to_root);
    const bool side_ring = (surface && around == 0 && (axial == 1 || axial == 2)) ||
                           (point.radial == 0 && on(around, half_way) && axial == 2);
    // Out-of-plane bending: the ring's end face over the bars and beside them.
    const bool over_bar =
        point.radial == 0 && axial == 2 && (around == 1 || point.around == 2 || off_bar);
    const bool side_root = off_bar && axial == 1;
    const bool of_bar = corner || bar_middle || under_load || pinched || bar_root || side_root;
    if ((cage.corner_radius == 0 && of_bar) || side_ring || over_bar)
      watched.push_back(static_cast<int>(p));
  }
  return watched;
}

std::string station_name(const SectorPoint& point) {
  const std::string surface = point.radial == 0   ? "inner surface"
                              : point.radial == 1 ? "outer surface"
                                                  : "inside the thickness";
  const std::string face = point.around < 0 ? "trailing face" : "leading face";
  const std::string half = point.axial < 0 ? "x < 0" : "x > 0";
  if (point.fillet >= 0) {
    const std::string part = point.fillet < 0.5   ? "fillet at the bar"
                             : point.fillet > 0.5 ? "fillet at the side ring"
                                                  : "middle of the fillet";
    return part + ", " + face + ", " + half + ", " + surface;
  }
  if (std::abs(point.around) == 1 && std::abs(point.axial) == 1) {
    return "bar root, " + face + ", " + half + ", " + surface;
  }
  if (std::abs(point.around) > 1 && std::abs(point.axial) < 1)
    return "inside the bar, " + face + ", " + half + ", " + surface;
  if (std::abs(point.around) == 1)
    return (point.axial == 0 ? "bar middle, " + face : "bar, " + face + ", " + half) + ", " +
           surface;
  const std::string place =
      std::abs(point.axial) == 2
          ? (std::abs(point.around) >= 1 ? "end face over the bar" : "end face")
      : point.around == 0 ? "pocket end"
                          : "beside the bar, " + face;
  return "side ring, " + place + ", " + half + ", " + surface;
}

}  // namespace cagetol
