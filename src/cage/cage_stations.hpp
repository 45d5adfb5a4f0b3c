// Where the cage is touched and where its stress is watched, and the reading of displacement fields
// there.
//
// Contact points of a pocket, in this order (n bar stations per face):
//   0 ... n-1           trailing face (u = -S/2), rising x     bar stations at the pitch radius
//   n ... 2n-1          leading face (u = +S/2), rising x
//   2n, 2n+1            end wall at x = -L/2, u = -a and +a    a = end_offset, at the pitch radius
//   2n+2, 2n+3          end wall at x = +L/2, u = -a and +a
//   2n+4, 2n+5          guiding surface at x = -+land_offset, middle of the pocket
//   2n+6, 2n+7          guiding surface at x = -+land_offset, middle of the bar after the pocket
// Each point has three displacement rows: radial, tangential, axial, along e_r and e_t of the
// pocket's own centre (nominal angle plus pitch deviation); at the bar's middle along those of the
// bar's middle plane.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/cage_mesh.hpp"

namespace cagetol {

struct CageStations {
  /// Axial positions on the bar faces [m], and a station stands for bar_x +- bar_half: on the
  /// undeviated pocket. On a longer one both grow with its length, else the ends of the loaded line
  /// would cross lines of the mesh and no polynomial would follow.
  std::vector<double> bar_x = {-3.6e-3, 0, 3.6e-3};
  std::vector<double> bar_half = {0.9e-3, 1.8e-3, 0.9e-3};
  double pitch_radius = 19.5e-3;  ///< of bar stations and end points [m]
  double end_offset = 3.0e-3;     ///< tangential offset of the end points [m]
  double land_offset = 5.8e-3;    ///< axial position of the guide lands [m]
  bool outer_guided = true;       ///< guiding surface is the outer one
};

/// Stations of a scene: bar_stations at the middles' span +-0.4 L_w, end points at 0.8 of the
/// roller radius, lands at scene.cage.land_offset or, if auto, in the middle of the side rings.
CageStations cage_stations(const Scene& scene);

long contact_points(const CageStations& stations);  ///< per pocket

/// Place of a bar station at axial position x of the undeviated pocket; face -1: trailing, +1:
/// leading. Beyond the pocket's end: there.
SectorPoint bar_station(const CageDimensions& cage, const CageStations& stations, double face,
                        double x);

/// A displacement reading: weights on the grid points of one element.
struct SectorReading {
  std::array<int, 8> point{};
  Eigen::Matrix<double, 8, 1> weight = Eigen::Matrix<double, 8, 1>::Zero();
};

/// Reads at a place of the grid. The place must lie in the material.
SectorReading read_at(const SectorGrid& grid, const SectorPoint& place);

/// The mean over the line on the bar's face that station i stands for, as readings that add up: a
/// roller touches along a line, and a force in a point would bring a stress of its own.
std::vector<SectorReading> read_bar(const CageDimensions& cage, const CageStations& stations,
                                    const SectorGrid& grid, double face, std::size_t i);

/// The rows of all contact points of a pocket: 3 contact_points x 3 points of the grid, times
/// fields in the sector's own frame. A bar station beyond the pocket's end reads at the end.
Eigen::MatrixXd contact_rows(const CageDimensions& cage, const CageStations& stations,
                             const SectorGrid& grid, const PocketDeviation& deviation,
                             const Eigen::MatrixXd& sector_fields);

/// Grid points at which the stress can be largest: the pocket's four corners, the bar faces at and
/// beside the middle, under the outermost bar stations and, at every depth, beside the root, the
/// inside of the bars near their ends, where rollers pinch them, the side rings' edges at the
/// pocket's middle and beside the bars.
std::vector<int> stress_stations(const CageDimensions& cage, const CageStations& stations,
                                 const SectorGrid& grid);

/// "pocket corner, leading face, x > 0, outer surface" and the like, for reports.
std::string station_name(const SectorPoint& point);

}  // namespace cagetol
