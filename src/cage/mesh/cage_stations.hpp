// Contact points and stress stations of the cage, and the values of displacement fields there.
//
// Contact points of a pocket, in this order (n bar stations per face):
//   0 ... n-1           trailing face (u = -S/2), rising x     bar stations at the pitch radius
//   n ... 2n-1          leading face (u = +S/2), rising x
//   2n, 2n+1            side ring face at x = -L/2, u = -a and +a, at the pitch radius
//   2n+2, 2n+3          side ring face at x = +L/2, u = -a and +a (a = end_offset)
//   2n+4, 2n+5          guiding surface at x = -+land_offset, middle of the pocket
//   2n+6, 2n+7          guiding surface at x = -+land_offset, middle of the bar after the pocket
// Each point has three displacement rows: radial, tangential and axial. e_r and e_t are those at
// the centre of the pocket (nominal angle plus pitch deviation), or of the bar's middle plane for
// points on it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/mesh/cage_mesh.hpp"
#include "src/operation/operating_scene.hpp"

namespace cagetol {

struct CageStations {
  /// Axial positions of the bar stations [m]; a station represents bar_x +- bar_half. Both are for
  /// the undeviated pocket and scale with the length of a pocket: otherwise the ends of the loaded
  /// line would cross mesh lines, and the polynomials of the table would not fit.
  std::vector<double> bar_x = {-3.6e-3, 0, 3.6e-3};
  std::vector<double> bar_half = {0.9e-3, 1.8e-3, 0.9e-3};
  double pitch_radius = 19.5e-3;  ///< of bar stations and end points [m]
  double end_offset = 3.0e-3;     ///< tangential offset of the end points [m]
  double land_offset = 5.8e-3;    ///< axial position of the guide lands [m]
  bool outer_guided = true;       ///< the outer surface is the guiding surface
};

/// Stations of a scene: bar stations over +-0.4 L_w, end points at 0.8 of the roller radius, lands
/// at scene.cage.land_offset (auto: middle of the side rings).
CageStations cage_stations(const OperatingScene& scene);

long contact_points(const CageStations& stations);  ///< per pocket

/// Position of a bar station at axial position x of the undeviated pocket, limited to the pocket's
/// ends. `face` -1: trailing, +1: leading.
SectorPoint bar_station(const CageDimensions& cage, const CageStations& stations, double face,
                        double x);

/// Interpolation of a displacement: weights of the grid points of one element.
struct SectorReading {
  std::array<int, 8> point{};
  Eigen::Matrix<double, 8, 1> weight = Eigen::Matrix<double, 8, 1>::Zero();
};

/// Interpolation at a position in the material of the grid.
SectorReading read_at(const SectorGrid& grid, const SectorPoint& place);

/// The part of a station's line, at `centre` +- `half`, that lies on the flat of the bar's face,
/// which ends at +-`flat`: roller ends have chamfers. A density 1 + lean t over it, t from -1 to 1,
/// keeps the force's moment as far as a positive density can.
struct StationLine {
  double low = 0, high = 0, lean = 0;
};
StationLine station_line(double centre, double half, double flat);

/// Mean over the line on the bar face that station i represents, as a sum of interpolations. A
/// roller touches along a line; a point force would cause a stress peak of its own.
std::vector<SectorReading> read_bar(const CageDimensions& cage, const CageStations& stations,
                                    const SectorGrid& grid, double face, std::size_t i);

/// Displacement rows of all contact points of a pocket, to be multiplied with fields in the
/// sector's own frame: 3 contact_points rows, 3 columns for each grid point. A bar station beyond
/// the pocket's end is read at the end.
Eigen::MatrixXd contact_rows(const CageDimensions& cage, const CageStations& stations,
                             const SectorGrid& grid, const PocketDeviation& deviation,
                             const Eigen::MatrixXd& sector_fields);

/// Grid points at which the stress can be largest, without those that a fine mesh watches
/// (bar_stress.hpp) if the corners have a radius:
///   - the four corners of the pocket
///   - bar faces: at and beside the middle, under the outermost bar stations and, at every depth,
///     beside the root
///   - inside the bars near their ends, where rollers pinch them
///   - edges of the side rings at the middle of the pocket and beside the bars
std::vector<int> stress_stations(const CageDimensions& cage, const CageStations& stations,
                                 const SectorGrid& grid);

/// Name of a stress station for reports: "pocket corner, leading face, x > 0, outer surface".
std::string station_name(const SectorPoint& point);

}  // namespace cagetol
