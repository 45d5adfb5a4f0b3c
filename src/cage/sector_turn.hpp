// The basis of the cage table as seen from each sector.
//
// The undeviated cage looks the same from every sector. Its modes (rigid motions included) seen
// from sector k, in that sector's axes, are those seen from sector 0 times R^k: mode pairs turn by
// k times an angle, single modes keep or change their sign. Local fields belong to a sector each,
// `per_sector` of them; sector k sees those of sectors k - reach ... k + reach, the others have
// died away.
//
// "Seen" columns: modes, then local fields of sectors -reach ... reach relative to the viewer.
// "All" columns: modes, then local fields of sectors 0 ... Z-1.
#pragma once

#include <Eigen/Core>

namespace cagetol {

struct SectorTurn {
  Eigen::Index sectors = 0;
  Eigen::Index modes = 0;
  Eigen::Index per_sector = 0;
  Eigen::Index reach = 0;
  Eigen::VectorXi partner;  ///< per mode: the other of its pair, itself for a single one
  Eigen::VectorXd
      angle;  ///< per mode: turn per sector, of opposite sign for the second of a pair [rad]
  Eigen::MatrixXd cosine, sine;  ///< of k times the angle: column k of 0 ... Z-1

  Eigen::Index seen() const { return modes + (2 * reach + 1) * per_sector; }
  Eigen::Index all() const { return modes + sectors * per_sector; }
  /// First column, among all, of the local fields of the sector `offset` away from k.
  Eigen::Index local_column(Eigen::Index k, Eigen::Index offset) const {
    return modes + (k + offset + sectors) % sectors * per_sector;
  }
  /// First column, among the seen, of the local fields at `offset`.
  Eigen::Index seen_column(Eigen::Index offset) const {
    return modes + (offset + reach) * per_sector;
  }
};

/// Sets all that belongs to modes from `turn`, the matrix P with (modes turned forward by one
/// sector) = modes P. Throws UnsolvedCage where P is not made of single +-1 and 2 x 2
/// rotations.
void find_turn(SectorTurn& sector, const Eigen::MatrixXd& turn);

/// Adds the lower triangle of (R^k)^T matrix R^k to `sum`: what sector 0 projects on the modes,
/// turned to sector k.
void add_turned(const SectorTurn& sector, const Eigen::MatrixXd& matrix, Eigen::Index k,
                Eigen::MatrixXd& sum);

/// Mode columns times R^k: rows that read modes in sector k, from rows that read them in sector 0.
Eigen::MatrixXd turn_modes(const SectorTurn& sector, const Eigen::MatrixXd& rows, Eigen::Index k);

/// Coefficients of all columns as sector k sees them: one combination of fields a row.
Eigen::MatrixXd seen_coefficients(const SectorTurn& sector, const Eigen::MatrixXd& coefficients,
                                  Eigen::Index k);

}  // namespace cagetol
