#include "src/cage/table/bar_modes.hpp"

#include <Eigen/Eigenvalues>

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Of fields by their coefficients; local fields have none with the elastic modes.
MatrixXd mass_between(const CageProjection& p, const MatrixXd& local_mass, const MatrixXd& fields) {
  const Index modes = p.modal_mass.rows(), local = fields.rows() - modes;
  const auto modal = fields.topRows(modes);
  const auto follow = fields.bottomRows(local);
  const MatrixXd across = follow.transpose() * (p.cross_mass * fields.topRows<6>());
  MatrixXd mass = modal.transpose() * p.modal_mass * modal;
  mass.noalias() += follow.transpose() * (local_mass * follow);
  return mass + across + across.transpose();
}

}  // namespace

MatrixXd forces_on_bars(const CageStations& stations, Index sectors) {
  const auto n = static_cast<Index>(stations.bar_x.size());
  double length = 0;
  for (double half : stations.bar_half) length += half;
  MatrixXd forces = MatrixXd::Zero(2 * n * sectors, sectors);
  for (Index j = 0; j < sectors; ++j)
    for (Index i = 0; i < n; ++i) {
      const double share = 0.5 * stations.bar_half[static_cast<std::size_t>(i)] / length;
      forces(2 * n * j + n + i, j) = share;                // leading face of the pocket before
      forces(2 * n * ((j + 1) % sectors) + i, j) = share;  // trailing face of the one after
    }
  return forces;
}

BarModes make_bar_modes(const CageTable& table, const CageProjection& projection,
                        const MatrixXd& rows, const MatrixXd& residual) {
  const MatrixXd forces = forces_on_bars(table.stations, table.turn.sectors);
  const MatrixXd responses = residual * forces;
  MatrixXd stiffness = forces.transpose() * (rows * responses);
  stiffness = (0.5 * (stiffness + stiffness.transpose())).eval();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(
      stiffness, mass_between(projection, table.undeviated.local_mass, responses));
  BarModes modes;
  modes.eigenvalue = solver.eigenvalues().array();
  modes.load = forces * solver.eigenvectors();
  modes.fields = responses * solver.eigenvectors();
  return modes;
}

}  // namespace cagetol
