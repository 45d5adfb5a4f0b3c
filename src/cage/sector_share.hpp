// A sector's share of the cage's projected stiffness and mass, packed for the table, and their sum.
//
// Kept: stiffness of elastic modes and local fields (rigid motions have none, exactly); mass of all
// modes, and of local fields with rigid motions. The mass of local fields otherwise is left out:
// they follow statically.
#pragma once

#include <Eigen/Core>

#include "src/cage/sector_turn.hpp"

namespace cagetol {

/// Sizes of the parts of a packed share, in their order.
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
};

/// Adds the change of each sector's share (columns of `changes`), turned to its place. Only changes
/// may be summed this way: the small parts beyond the reach of local fields, left out here, cancel
/// in the projections of the undeviated cage, where local fields are orthogonal to modes.
void add_shares(const SectorTurn& turn, const Eigen::MatrixXd& changes, CageProjection& projection);

}  // namespace cagetol
