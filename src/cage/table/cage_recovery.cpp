#include "src/cage/table/cage_recovery.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <numbers>
#include <numeric>

#include "src/cage/solve/cage_modes.hpp"
#include "src/cage/solve/sector_carry.hpp"
#include "src/cage/stress/field_recovery.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Nodes of a sector out of fields on the whole mesh, in the sector's own frame.
MatrixXd in_sector(const CageMesh& mesh, const MatrixXd& fields, std::size_t sector) {
  const auto& node = mesh.sector_node[sector];
  const Eigen::Matrix3d back = sector_rotation(mesh.cage, static_cast<long>(sector)).transpose();
  MatrixXd rows(3 * static_cast<Index>(node.size()), fields.cols());
  for (std::size_t p = 0; p < node.size(); ++p) {
    rows.middleRows<3>(3 * static_cast<Index>(p)) = back * fields.middleRows<3>(3 * node[p]);
  }
  return rows;
}

/// Combinations of the full solve's modes that move the contact points as the model's modes do:
/// least squares, then the nearest matrix with orthonormal columns.
MatrixXd matching(const CageTable& table, const CageMesh& mesh,
                  const std::vector<PocketDeviation>& deviations, const MatrixXd& shapes,
                  const MatrixXd& contact) {
  const Index per_sector = 3 * contact_points(table.stations);
  MatrixXd rows(contact.rows(), shapes.cols());
  for (std::size_t j = 0; j < deviations.size(); ++j) {
    rows.middleRows(static_cast<Index>(j) * per_sector, per_sector) = contact_rows(
        table.cage, table.stations, mesh.grid, deviations[j], in_sector(mesh, shapes, j));
  }
  const MatrixXd fitted = rows.colPivHouseholderQr().solve(contact);
  const Eigen::JacobiSVD<MatrixXd> svd(fitted, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return svd.matrixU() * svd.matrixV().transpose();
}

std::vector<int> every_node(const HexMesh& mesh) {
  std::vector<int> nodes(static_cast<std::size_t>(mesh.nodes.cols()));
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

}  // namespace

Eigen::VectorXd bar_forces_on_nodes(const CageMesh& mesh, const CageStations& stations,
                                    const std::vector<PocketDeviation>& deviations,
                                    const Eigen::VectorXd& bar_forces) {
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(3 * mesh.mesh.nodes.cols());
  const Index per_pocket = 2 * static_cast<Index>(stations.bar_x.size());
  for (std::size_t j = 0; j < deviations.size(); ++j) {
    const auto sector = static_cast<Index>(j);
    const Eigen::VectorXd own = bar_loads(mesh.cage, stations, mesh.grid, deviations[j]) *
                                bar_forces.segment(per_pocket * sector, per_pocket);
    const Eigen::Matrix3d rotation = sector_rotation(mesh.cage, sector);
    for (std::size_t p = 0; p < mesh.grid.points.size(); ++p) {
      nodal.segment<3>(3 * mesh.sector_node[j][p]) +=
          rotation * own.segment<3>(3 * static_cast<Index>(p));
    }
  }
  return nodal;
}

std::variant<CageRecovery, CageFault> recover_cage(const CageTable& table,
                                                   const std::vector<PocketDeviation>& deviations,
                                                   const CageStates& states) {
  const MatrixXd& q = states.q;
  const auto made =
      make_cage_model(table, deviations,
                      {.modes = states.q.rows() - (states.bar_modes ? table.turn.sectors : 0),
                       .bar_modes = states.bar_modes,
                       .stress = false});
  if (const auto* fault = std::get_if<CageFault>(&made)) return *fault;
  const CageModel& model = std::get<CageModel>(made);
  auto meshed = make_cage_mesh(table.cage, deviations, table.counts);
  if (const auto* fault = std::get_if<CageFault>(&meshed)) return *fault;
  CageRecovery recovery{std::move(std::get<CageMesh>(meshed)), {}};
  const CageMesh& mesh = recovery.mesh;
  const BodyMatrices body = assemble_body(mesh.mesh, table.material);
  const HeldFactor factor(body.stiffness, rigid_motions(mesh.mesh.nodes));
  // A few modes more than the model keeps, lest its last one be half of a pair that is split.
  const Index elastic = model.elastic_modes(), bars = q.rows() - elastic;
  const FreeModes modes = free_modes(mesh.mesh, body, factor, elastic + 4);
  MatrixXd shapes(3 * mesh.mesh.nodes.cols(), q.rows());
  shapes.leftCols(elastic) =
      modes.shape * matching(table, mesh, deviations, modes.shape, model.contact.leftCols(elastic));
  const Eigen::VectorXd flexibility =
      (2 * std::numbers::pi * model.frequency.array()).square().inverse();

  const Eigen::VectorXd centrifugal =
      body.mass.selfadjointView<Eigen::Lower>() * arms(mesh.mesh.nodes);
  const auto on_nodes = [&](const MatrixXd& forces) {
    MatrixXd nodal(shapes.rows(), forces.cols());
    for (Index i = 0; i < forces.cols(); ++i)
      nodal.col(i) = bar_forces_on_nodes(mesh, table.stations, deviations, forces.col(i));
    return nodal;
  };
  const auto response = [&](const MatrixXd& loads) {
    return free_static_response(body, factor, modes.rigid, loads);
  };
  /// Of the first modes, under static loads.
  const auto coordinates = [&](Index count, const MatrixXd& loads) -> MatrixXd {
    return flexibility.head(count).asDiagonal() * (shapes.leftCols(count).transpose() * loads);
  };
  if (bars > 0) {
    const MatrixXd loads = on_nodes(model.bar_mode_load);
    shapes.rightCols(bars) =
        response(loads) - shapes.leftCols(elastic) * coordinates(elastic, loads);
  }
  const MatrixXd loads =
      on_nodes(states.bar_force) + centrifugal * states.spin.cwiseAbs2().transpose();
  recovery.displacement = shapes * (q - coordinates(q.rows(), loads)) + response(loads);
  return recovery;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> stress_everywhere(const HexMesh& mesh,
                                                           const Material& material,
                                                           const Eigen::VectorXd& displacement) {
  return nodal_stress(mesh, material, displacement, every_node(mesh))
      .reshaped(6, mesh.nodes.cols());
}

}  // namespace cagetol
