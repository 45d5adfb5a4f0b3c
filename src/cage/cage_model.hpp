// The flexible cage of one sample: mass properties, elastic modes, and everything read from them.
//
// Frame: the cage's own (see cage_mesh.hpp), origin at the geometric centre. Elastic modes are
// mass-normalised and mass-orthogonal to all rigid motions (mean axes), so that with modal
// coordinates q
//   q_k'' + 2 zeta_k omega_k q_k' + omega_k^2 q_k = sum over forces f of rows(f) . f
// and a spin Omega about x adds, on the left, 2 Omega gyroscopic q' - Omega^2 in_plane q and, on
// the right, Omega^2 centrifugal. (in_plane is the spin softening; without the centrifugal stress
// stiffening, which the model does not hold, it has the wrong sign: use both or neither.)
//
// Stress at a station: modes q plus the quasi-static rest of what the kept modes do not carry, of
// the contact forces (residual attachment) and of the centrifugal load.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "src/cage/cage_table.hpp"
#include "src/cage/elastic_body.hpp"

namespace cagetol {

struct CageModelOptions {
  long modes = 20;     ///< elastic modes kept
  bool stress = true;  ///< stress rows too
};

struct CageModel {
  MassProperties body;        ///< of the deviated cage
  Eigen::VectorXd frequency;  ///< elastic modes, rising [Hz]
  long points = 0;            ///< contact points per pocket, in the order of cage_stations.hpp
  long bar_stations = 0;      ///< per face
  /// Displacement per modal coordinate: row 3 (points j + point) + (0 radial, 1 tangential, 2
  /// axial).
  Eigen::MatrixXd contact;
  /// Tangential displacement at the bar stations of bar j (after pocket j) per tangential force
  /// there, beyond what the kept modes give [m/N]: columns (2n) j + (leading stations of pocket j,
  /// trailing of pocket j+1).
  Eigen::MatrixXd residual_compliance;
  /// Stress per modal coordinate, and in the last column per square of the spin: row stations (6 j
  /// + component) + station, axes of sector j's frame [Pa].
  Eigen::MatrixXf stress;
  /// Stress per tangential force on bar stations near by: same rows; column 2n (o + span) + station
  /// for pocket j + o, o = -span ... span; trailing stations first, then leading [Pa/N].
  Eigen::MatrixXf stress_residual;
  /// The same for all sectors, of forces farther away, as on the undeviated cage: row stations
  /// component + station; column 2n o + station for pocket j + o, o = span + 1 ... Z - span - 1,
  /// others zero.
  Eigen::MatrixXf far_residual;
  long stress_stations = 0;  ///< per sector
  long span = 0;             ///< how many sectors away a force is near by
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

/// The cage with these deviations, or why there is none. At most a few milliseconds.
std::variant<CageModel, CageFault> make_cage_model(const CageTable& table,
                                                   const std::vector<PocketDeviation>& deviations,
                                                   const CageModelOptions& options = {});

/// Von Mises stress at every station: modal coordinates q, tangential forces on the bar stations in
/// the order pocket, trailing stations, leading stations (on the cage, towards larger theta), and
/// the spin whose centrifugal load acts (0: none) [Pa].
Eigen::VectorXd station_stress(const CageModel& model, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& bar_forces, double spin = 0);

}  // namespace cagetol
