#include "src/cage/solve/sector_share.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

Index triangle(Index n) {
  return n * (n + 1) / 2;
}

void pack_lower(const Eigen::Ref<const MatrixXd>& matrix, double* to) {
  for (Index j = 0; j < matrix.cols(); ++j) {
    for (Index i = j; i < matrix.rows(); ++i) *to++ = matrix(i, j);
  }
}

void unpack_lower(const double* from, Eigen::Ref<MatrixXd> matrix) {
  for (Index j = 0; j < matrix.cols(); ++j) {
    for (Index i = j; i < matrix.rows(); ++i) matrix(i, j) = matrix(j, i) = *from++;
  }
}

}  // namespace

ShareLayout share_layout(const SectorTurn& turn) {
  const Index elastic = turn.modes - 6;
  const Index local = turn.seen() - turn.modes;
  ShareLayout layout{triangle(elastic),    local * elastic, triangle(local),
                     triangle(turn.modes), local * 6,       0};
  layout.size = layout.modal_stiffness + layout.cross_stiffness + layout.local_stiffness +
                layout.modal_mass + layout.cross_mass;
  return layout;
}

void pack_share(const SectorTurn& turn, const MatrixXd& stiffness, const MatrixXd& mass,
                Eigen::Ref<Eigen::VectorXd> share) {
  const ShareLayout layout = share_layout(turn);
  const Index elastic = turn.modes - 6;
  const Index local = turn.seen() - turn.modes;
  double* to = share.data();
  pack_lower(stiffness.block(6, 6, elastic, elastic), to);
  to += layout.modal_stiffness;
  Eigen::Map<MatrixXd>(to, local, elastic) = stiffness.block(turn.modes, 6, local, elastic);
  to += layout.cross_stiffness;
  pack_lower(stiffness.bottomRightCorner(local, local), to);
  to += layout.local_stiffness;
  pack_lower(mass.topLeftCorner(turn.modes, turn.modes), to);
  to += layout.modal_mass;
  Eigen::Map<MatrixXd>(to, local, 6) = mass.block(turn.modes, 0, local, 6);
}

void add_shares(const SectorTurn& turn, const MatrixXd& changes, CageProjection& projection) {
  const ShareLayout layout = share_layout(turn);
  const Index modes = turn.modes;
  const Index elastic = modes - 6;
  const Index local = turn.seen() - modes;
  const Index per = turn.per_sector;
  MatrixXd share_stiffness = MatrixXd::Zero(modes, modes);
  MatrixXd share_mass = share_stiffness;
  MatrixXd share_local(local, local);
  MatrixXd share_cross = MatrixXd::Zero(2 * local, modes);
  MatrixXd stiffness = share_stiffness;
  MatrixXd mass = share_stiffness;
  for (Index k = 0; k < turn.sectors; ++k) {
    if (changes.col(k).isZero(0)) continue;
    const double* from = changes.col(k).data();
    unpack_lower(from, share_stiffness.bottomRightCorner(elastic, elastic));
    from += layout.modal_stiffness;
    share_cross.block(0, 6, local, elastic) = Eigen::Map<const MatrixXd>(from, local, elastic);
    from += layout.cross_stiffness;
    unpack_lower(from, share_local);
    from += layout.local_stiffness;
    unpack_lower(from, share_mass);
    from += layout.modal_mass;
    share_cross.block(local, 0, local, 6) = Eigen::Map<const MatrixXd>(from, local, 6);

    add_turned(turn, share_stiffness, k, stiffness);
    add_turned(turn, share_mass, k, mass);
    const MatrixXd cross = turn_modes(turn, share_cross, k);
    for (Index o = -turn.reach; o <= turn.reach; ++o) {
      const Index to = turn.local_column(k, o) - modes;
      const Index at = turn.seen_column(o) - modes;
      projection.cross_stiffness.middleRows(to, per) += cross.block(at, 6, per, elastic);
      projection.cross_mass.middleRows(to, per) += cross.block(local + at, 0, per, 6);
      for (Index p = -turn.reach; p <= turn.reach; ++p) {
        projection.local_stiffness.block(to, turn.local_column(k, p) - modes, per, per) +=
            share_local.block(at, turn.seen_column(p) - modes, per, per);
      }
    }
  }
  stiffness.triangularView<Eigen::StrictlyUpper>() = stiffness.transpose();
  mass.triangularView<Eigen::StrictlyUpper>() = mass.transpose();
  projection.modal_stiffness += stiffness.bottomRightCorner(elastic, elastic);
  projection.modal_mass += mass;
}

}  // namespace cagetol
