#include "src/cage/solve/cage_basis.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <numbers>

namespace cagetol {
namespace {

/// Fields turned forward by `steps` sectors about the axis.
Eigen::MatrixXd turn_fields(const CageMesh& mesh, const Eigen::MatrixXd& fields, long steps) {
  const long sectors = mesh.cage.pocket_count;
  const Eigen::Matrix3d rotation = sector_rotation(mesh.cage, steps);
  Eigen::MatrixXd turned(fields.rows(), fields.cols());
  for (long j = 0; j < sectors; ++j) {
    const auto& to = mesh.sector_node[static_cast<std::size_t>(j)];
    const auto& from =
        mesh.sector_node[static_cast<std::size_t>((j - steps + 2 * sectors) % sectors)];
    for (std::size_t p = 0; p < to.size(); ++p) {
      turned.middleRows<3>(3 * to[p]).noalias() = rotation * fields.middleRows<3>(3 * from[p]);
    }
  }
  return turned;
}

/// Forces on the nodes of sector 0 as forces on all nodes.
Eigen::MatrixXd on_whole_cage(const CageMesh& mesh, const Eigen::MatrixXd& sector_forces) {
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(3 * mesh.mesh.nodes.cols(), sector_forces.cols());
  const auto& node = mesh.sector_node[0];
  for (std::size_t p = 0; p < node.size(); ++p) {
    forces.middleRows<3>(3 * node[p]) +=
        sector_forces.middleRows<3>(3 * static_cast<Eigen::Index>(p));
  }
  return forces;
}

/// Rows of the nodes of sector 0.
Eigen::MatrixXd first_sector(const CageMesh& mesh, const Eigen::MatrixXd& fields) {
  const auto& node = mesh.sector_node[0];
  Eigen::MatrixXd rows(3 * static_cast<Eigen::Index>(node.size()), fields.cols());
  for (std::size_t p = 0; p < node.size(); ++p) {
    rows.middleRows<3>(3 * static_cast<Eigen::Index>(p)) = fields.middleRows<3>(3 * node[p]);
  }
  return rows;
}

/// Static response without what the modes of the basis carry: orthogonal to them in stiffness and
/// mass.
Eigen::MatrixXd residual_response(const CyclicCage& cyclic, const FreeModes& modes,
                                  const Eigen::MatrixXd& loads) {
  const Eigen::ArrayXd omega = 2 * std::numbers::pi * modes.frequency.array();
  const Eigen::MatrixXd carried = modes.shape.transpose() * loads;
  return cyclic.static_response(loads) -
         modes.shape * (omega.square().inverse().matrix().asDiagonal() * carried);
}

/// Forces on the middle planes of the bars around pocket 0 whose static response corrects what a
/// carried basis leaves out: carried modes keep their displacement on these planes, and when the
/// pocket deviates the two sides no longer pull there with equal force. The forces left over, for
/// every mode and deviation, are condensed to the few combinations that change the modes'
/// frequencies most.
Eigen::MatrixXd correction_loads(const CageMesh& mesh, const Material& material,
                                 const PocketDeviation& range, const CyclicCage& cyclic,
                                 const FreeModes& modes, const CageTableOptions& options) {
  const SectorGrid& grid = mesh.grid;
  const Eigen::Index count =
      std::min<Eigen::Index>(modes.frequency.size(), options.corrected_modes);
  const Eigen::MatrixXd fields = first_sector(mesh, modes.shape.leftCols(count));
  const Eigen::VectorXd eigenvalue =
      (2 * std::numbers::pi * modes.frequency.head(count).array()).square();
  const FieldDrive drive{eigenvalue.asDiagonal(), Eigen::MatrixXd::Zero(fields.rows(), count)};
  const auto unbalance = [&](const PocketDeviation& deviation) {
    const HexMesh sector{sector_nodes(mesh.cage, deviation, grid), grid.elements};
    const BodyMatrices part = assemble_body(sector, material);
    const Eigen::MatrixXd carried = carry_fields(grid, part, fields, drive);
    const Eigen::MatrixXd driven = carried * drive.inertia;
    Eigen::MatrixXd force = part.mass.selfadjointView<Eigen::Lower>() * driven;
    force -= part.stiffness.selfadjointView<Eigen::Lower>() * carried;
    return force;
  };
  const std::array<PocketDeviation, 4> deviations{
      PocketDeviation{.width = -0.5 * range.width}, PocketDeviation{.length = -0.5 * range.length},
      PocketDeviation{.pitch = 0.5 * range.pitch},
      PocketDeviation{.squareness = 0.5 * range.squareness}};
  const Eigen::MatrixXd balanced = unbalance({});
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(
      modes.shape.rows(), count * static_cast<Eigen::Index>(deviations.size()));
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const Eigen::MatrixXd force = unbalance(deviations[i]) - balanced;
    for (std::size_t p = 0; p < grid.points.size(); ++p) {
      if (!on_middle_plane(grid, p)) continue;
      loads.block(3 * mesh.sector_node[0][p], static_cast<Eigen::Index>(i) * count, 3, count) =
          force.middleRows<3>(3 * static_cast<Eigen::Index>(p)) *
          eigenvalue.cwiseSqrt().cwiseInverse().asDiagonal();
    }
  }
  const Eigen::MatrixXd gram = loads.transpose() * residual_response(cyclic, modes, loads);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> principal(gram);
  return loads * principal.eigenvectors().rightCols(options.corrections);
}

/// In-plane displacement of a mode at the middle of the end face, over a pocket.
Eigen::Vector2d end_face_motion(const std::vector<int>& node, const SectorReading& place,
                                const Eigen::Ref<const Eigen::VectorXd>& shape) {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  for (int a = 0; a < 8; ++a) {
    const auto point = static_cast<std::size_t>(place.point[static_cast<std::size_t>(a)]);
    value += place.weight[a] * shape.segment<2>(3 * node[point] + 1);
  }
  return value;
}

ModeFamily mode_family(const CageMesh& mesh, const SparseMatrix& mass,
                       const Eigen::Ref<const Eigen::VectorXd>& shape, double angle) {
  ModeFamily family;
  family.waves = std::lround(std::abs(angle) * static_cast<double>(mesh.cage.pocket_count) /
                             (2 * std::numbers::pi));
  Eigen::VectorXd axial = shape;
  for (Eigen::Index n = 0; n < mesh.mesh.nodes.cols(); ++n) axial.segment<2>(3 * n + 1).setZero();
  family.axial_share = axial.dot(mass.selfadjointView<Eigen::Lower>() * axial);
  const SectorReading front = read_at(mesh.grid, {0.5, 0, -2});
  const SectorReading back = read_at(mesh.grid, {0.5, 0, 2});
  double product = 0;
  for (const auto& node : mesh.sector_node) {
    product += end_face_motion(node, front, shape).dot(end_face_motion(node, back, shape));
  }
  family.opposed = product < 0;
  return family;
}

}  // namespace

std::string family_name(const ModeFamily& family) {
  const bool axial = family.axial_share > 0.5;
  return std::string(axial ? "out-of-plane " : "in-plane ") + std::to_string(family.waves) +
         (!axial && family.opposed ? " opposed" : "");
}

Eigen::VectorXd arms(const Eigen::Matrix3Xd& nodes) {
  Eigen::VectorXd arm = Eigen::VectorXd::Zero(nodes.size());
  for (Eigen::Index n = 0; n < nodes.cols(); ++n)
    arm.segment<2>(3 * n + 1) = nodes.col(n).tail<2>();
  return arm;
}

Eigen::MatrixXd seen_loads(const SectorTurn& turn, const CageDimensions& cage,
                           const CageStations& stations, const SectorGrid& grid,
                           const PocketDeviation& deviation) {
  Eigen::MatrixXd loads =
      Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(grid.points.size()), turn.seen());
  loads.middleCols(turn.seen_column(0), 2 * static_cast<Eigen::Index>(stations.bar_x.size())) =
      bar_loads(cage, stations, grid, deviation);
  return loads;
}

CageBasis make_cage_basis(const CageMesh& mesh, const Material& material,
                          const CageStations& stations, const PocketDeviation& range,
                          const CyclicCage& cyclic, const FreeModes& modes,
                          const CageTableOptions& options) {
  CageBasis basis;
  SectorTurn& turn = basis.sector.turn;
  const auto mass = cyclic.mass().selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd centrifugal = mass * arms(mesh.mesh.nodes);
  Eigen::MatrixXd turning = residual_response(cyclic, modes, centrifugal);
  const double norm = std::sqrt((turning.transpose() * (mass * turning)).value());
  turning /= norm;
  const double turning_stiffness = (turning.transpose() * centrifugal).value() / norm;

  const Eigen::Index free = 6 + modes.frequency.size();
  const Eigen::Index elastic = modes.frequency.size() + 1;
  turn.sectors = mesh.cage.pocket_count;
  turn.reach = std::min<Eigen::Index>(options.reach, (turn.sectors - 1) / 2);
  basis.frequency = modes.frequency;
  basis.shapes.resize(modes.shape.rows(), 6 + elastic);
  basis.shapes << rigid_motions(mesh.mesh.nodes), modes.shape, turning;
  const auto elastic_shapes = basis.shapes.rightCols(elastic);
  Eigen::MatrixXd forward = Eigen::MatrixXd::Zero(6 + elastic, 6 + elastic);
  forward.topLeftCorner<3, 3>() = forward.block<3, 3>(3, 3) = sector_rotation(mesh.cage, 1);
  forward.bottomRightCorner(elastic, elastic) =
      elastic_shapes.transpose() * (mass * turn_fields(mesh, elastic_shapes, 1));
  find_turn(turn, forward);
  for (Eigen::Index i = 0; i < modes.frequency.size(); ++i) {
    basis.family.push_back(mode_family(mesh, cyclic.mass(), modes.shape.col(i), turn.angle[6 + i]));
  }

  const Eigen::MatrixXd bars = on_whole_cage(mesh, bar_loads(mesh.cage, stations, mesh.grid, {}));
  Eigen::MatrixXd loads(bars.rows(), bars.cols() + options.corrections);
  loads << bars, correction_loads(mesh, material, range, cyclic, modes, options);
  const Eigen::RowVectorXd by_turning = turning.transpose() * loads / turning_stiffness;
  const Eigen::MatrixXd local = residual_response(cyclic, modes, loads) - turning * by_turning;
  turn.per_sector = loads.cols();
  basis.sector.fields.resize(3 * static_cast<Eigen::Index>(mesh.grid.points.size()), turn.all());
  basis.sector.fields.leftCols(turn.modes) = first_sector(mesh, basis.shapes);
  basis.sector.inertia = Eigen::MatrixXd::Zero(turn.modes, turn.all());
  basis.sector.inertia.diagonal().segment(6, elastic - 1) =
      (2 * std::numbers::pi * modes.frequency.array()).square();
  const Eigen::MatrixXd gram = basis.shapes.transpose() * (mass * basis.shapes);
  const Eigen::LLT<Eigen::MatrixXd> free_mass(gram.topLeftCorner(free, free));
  const auto carried = [&](const Eigen::MatrixXd& forces) -> Eigen::MatrixXd {
    return free_mass.solve(basis.shapes.leftCols(free).transpose() * forces);
  };
  basis.sector.inertia.col(free).head(free) = -carried(centrifugal) / norm;
  basis.sector.turning = Eigen::VectorXd::Zero(turn.all());
  basis.sector.turning[free] = 1 / norm;
  for (Eigen::Index o = 0; o < turn.sectors; ++o) {
    const Eigen::Index column = turn.local_column(0, o);
    basis.sector.fields.middleCols(column, turn.per_sector) =
        first_sector(mesh, turn_fields(mesh, local, o));
    basis.sector.inertia.block(0, column, free, turn.per_sector) =
        -carried(turn_fields(mesh, loads, o)) -
        basis.sector.inertia.col(free).head(free) * by_turning;
    basis.sector.turning.segment(column, turn.per_sector) = -by_turning.transpose() / norm;
  }
  CageProjection& p = basis.projection;
  const Eigen::Index all_local = turn.all() - turn.modes;
  p.modal_stiffness = basis.sector.inertia.block(6, 6, elastic, elastic);
  p.modal_stiffness.col(elastic - 1).setZero();
  p.modal_stiffness(elastic - 1, elastic - 1) = turning_stiffness;
  p.cross_stiffness = Eigen::MatrixXd::Zero(all_local, elastic);
  p.local_stiffness.resize(all_local, all_local);
  p.local_mass.resize(all_local, all_local);
  const Eigen::MatrixXd local_momentum = mass * local;
  p.modal_mass = gram;
  p.cross_mass = Eigen::MatrixXd::Zero(all_local, 6);
  for (Eigen::Index o = 0; o < turn.sectors; ++o) {
    const Eigen::MatrixXd turned = turn_fields(mesh, local, o).transpose();
    const Eigen::MatrixXd energy = turned * loads, inertia = turned * local_momentum;
    for (Eigen::Index k = 0; k < turn.sectors; ++k) {
      const Eigen::Index row = turn.local_column(k, o) - turn.modes,
                         column = turn.local_column(k, 0) - turn.modes;
      p.local_stiffness.block(row, column, turn.per_sector, turn.per_sector) = energy;
      p.local_mass.block(row, column, turn.per_sector, turn.per_sector) = inertia;
    }
  }
  return basis;
}

}  // namespace cagetol
