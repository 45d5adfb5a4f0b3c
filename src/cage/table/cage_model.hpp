// The flexible cage of one sample: mass properties, elastic modes, displacement and stress rows.
//
// Frame: the cage's own (see cage_mesh.hpp), origin at the geometric centre. Elastic modes are
// mass-normalised and mass-orthogonal to all rigid motions (mean axes). With modal coordinates q
// and a spin Omega about x:
//
//   q_k'' + 2 zeta_k omega_k q_k' + omega_k^2 q_k
//       + (2 Omega gyroscopic q' - Omega^2 in_plane q)_k
//       = sum over forces f of rows(f) . f + Omega^2 centrifugal_k
//
// in_plane is the spin softening. The model has no centrifugal stress stiffening, which outweighs
// it: use both or neither.
//
// Stress at a station: modes q plus the static residual of the contact forces and of the
// centrifugal load, that is, the part which the kept modes do not carry.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "src/cage/solve/elastic_body.hpp"
#include "src/cage/table/cage_table.hpp"

namespace cagetol {

struct CageModelOptions {
  long modes = 10;        ///< elastic modes kept
  bool bar_modes = true;  ///< and a static mode of every bar (bar_modes.hpp)
  bool stress = true;     ///< with stress rows
};

struct CageModel {
  MassProperties body;        ///< of the deviated cage
  Eigen::VectorXd frequency;  ///< elastic modes, ascending, then static modes of the bars [Hz]
  /// Forces on all bar stations of which the bars' static modes are the responses [N], a column
  /// each; empty without them.
  Eigen::MatrixXd bar_mode_load;
  Eigen::Index elastic_modes() const { return frequency.size() - bar_mode_load.cols(); }
  long points = 0;        ///< contact points per pocket, in the order of cage_stations.hpp
  long bar_stations = 0;  ///< per face
  /// Displacement per modal coordinate: row 3 (points j + point) + (0 radial, 1 tangential, 2
  /// axial).
  Eigen::MatrixXd contact;
  /// Residual flexibility of bar j (after pocket j): tangential displacement at its bar stations
  /// per tangential force there, without the part of the kept modes [m/N]. Columns (2n) j +
  /// (leading stations of pocket j, trailing stations of pocket j+1).
  Eigen::MatrixXd residual_compliance;
  /// Stress per modal coordinate, and in the last column per square of the spin: row stations (6 j
  /// + component) + station, axes of sector j's frame [Pa].
  Eigen::MatrixXf stress;
  /// Residual stress per tangential force on bar stations up to `span` sectors away [Pa/N]: same
  /// rows; column 2n (o + span) + station for pocket j + o, o = -span ... span; trailing stations
  /// first, then leading.
  Eigen::MatrixXf stress_residual;
  /// The same for all sectors, of forces farther away, as on the undeviated cage: row stations
  /// component + station; column 2n o + station for pocket j + o, o = span + 1 ... Z - span - 1,
  /// others zero.
  Eigen::MatrixXf far_residual;
  long stress_stations = 0;  ///< per sector
  long span = 0;             ///< reach of stress_residual in sectors
  Eigen::MatrixXd gyroscopic;
  Eigen::MatrixXd in_plane;
  Eigen::VectorXd centrifugal;

  Eigen::Index contact_row(long pocket, long point, long direction) const {
    return 3 * (points * pocket + point) + direction;
  }
};

/// Place 0 ... 2 span in stress_residual of a pocket `offset` = 0 ... Z-1 sectors on, -1 where it
/// is far.
inline Eigen::Index near_place(Eigen::Index offset, Eigen::Index sectors, Eigen::Index span) {
  const Eigen::Index place = (offset + span) % sectors;
  return place <= 2 * span ? place : -1;
}

/// The cage with these deviations, or the fault that prevents it. Takes a few milliseconds at most.
std::variant<CageModel, CageFault> make_cage_model(const CageTable& table,
                                                   const std::vector<PocketDeviation>& deviations,
                                                   const CageModelOptions& options = {});

/// Von Mises stress at every station [Pa] from modal coordinates q, tangential forces on the cage
/// at the bar stations (towards larger theta; per pocket trailing, then leading stations) and the
/// spin of the centrifugal load (0: none).
Eigen::VectorXd station_stress(const CageModel& model, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& bar_forces, double spin = 0);

}  // namespace cagetol
