// The basis of the cage table as seen from each sector.
//
// The undeviated cage looks the same from every sector. Its modes (rigid motions included) in the
// axes of sector k are those of sector 0 times R^k: mode pairs rotate by k times an angle, single
// modes keep or change their sign. Each sector has `per_sector` local fields. Sector k sees the
// local fields of sectors k - reach ... k + reach; those of the others have decayed.
//
// "Seen" columns: modes, then local fields of sectors -reach ... reach relative to the viewer.
// "All" columns: modes, then local fields of sectors 0 ... Z-1.
#pragma once

#include <Eigen/Core>
#include <vector>

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
  /// First of all columns for the local fields of the sector `offset` away from k.
  Eigen::Index local_column(Eigen::Index k, Eigen::Index offset) const {
    return modes + (k + offset + sectors) % sectors * per_sector;
  }
  /// First seen column of the local fields at `offset`.
  Eigen::Index seen_column(Eigen::Index offset) const {
    return modes + (offset + reach) * per_sector;
  }
};

/// Numbers of the seen columns of sector 0 among all columns.
std::vector<Eigen::Index> seen_in_all(const SectorTurn& sector);

/// Sets the members about modes from the matrix P = `turn`, defined by
///   (modes rotated forward by one sector) = modes P
/// Throws UnsolvedCage if P does not consist of single +-1 and 2 x 2 rotations.
void find_turn(SectorTurn& sector, const Eigen::MatrixXd& turn);

/// Adds the lower triangle of (R^k)^T matrix R^k to `sum`: rotates a projection of sector 0 on the
/// modes to sector k.
void add_turned(const SectorTurn& sector, const Eigen::MatrixXd& matrix, Eigen::Index k,
                Eigen::MatrixXd& sum);

/// Mode columns times R^k: rows for modes in sector k from the rows for sector 0.
Eigen::MatrixXd turn_modes(const SectorTurn& sector, const Eigen::MatrixXd& rows, Eigen::Index k);

/// Coefficients of all columns as seen from sector k; each row is one combination of fields.
Eigen::MatrixXd seen_coefficients(const SectorTurn& sector, const Eigen::MatrixXd& coefficients,
                                  Eigen::Index k);

}  // namespace cagetol
