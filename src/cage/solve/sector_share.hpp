// The share of a sector in the cage's projected stiffness and mass, packed for the table, and the
// sum of the shares.
//
// Included: stiffness of elastic modes and local fields (exactly zero for rigid motions); mass of
// all modes; mass coupling of local fields with rigid motions. The remaining mass of local fields
// is left out: they follow statically.
#pragma once

#include <Eigen/Core>

#include "src/cage/solve/sector_turn.hpp"

namespace cagetol {

/// Sizes of the parts of a packed share, in this order.
struct ShareLayout {
  Eigen::Index modal_stiffness = 0;  ///< elastic x elastic, lower triangle by columns
  Eigen::Index cross_stiffness = 0;  ///< seen local x elastic
  Eigen::Index local_stiffness = 0;  ///< seen local x seen local, lower triangle by columns
  Eigen::Index modal_mass = 0;       ///< modes x modes, lower triangle by columns
  Eigen::Index cross_mass = 0;       ///< seen local x rigid
  Eigen::Index size = 0;
};
ShareLayout share_layout(const SectorTurn& turn);

/// Packs the projections on the seen columns.
void pack_share(const SectorTurn& turn, const Eigen::MatrixXd& stiffness,
                const Eigen::MatrixXd& mass, Eigen::Ref<Eigen::VectorXd> share);

/// Projections of the whole cage; l runs over the local fields of all sectors.
struct CageProjection {
  Eigen::MatrixXd modal_stiffness;  ///< elastic x elastic
  Eigen::MatrixXd cross_stiffness;  ///< l x elastic
  Eigen::MatrixXd local_stiffness;  ///< l x l
  Eigen::MatrixXd modal_mass;       ///< modes x modes
  Eigen::MatrixXd cross_mass;       ///< l x rigid
  Eigen::MatrixXd local_mass;       ///< l x l, of the undeviated cage: for static modes only
};

/// Adds the change of each sector's share (columns of `changes`), rotated to its sector. Only
/// changes may be summed in this way. The parts beyond the reach of local fields are left out here;
/// in the projections of the undeviated cage they cancel, because local fields are orthogonal to
/// modes there.
void add_shares(const SectorTurn& turn, const Eigen::MatrixXd& changes, CageProjection& projection);

}  // namespace cagetol
