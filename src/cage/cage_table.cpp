#include "src/cage/cage_table.hpp"

#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "src/cage/cage_modes.hpp"
#include "src/cage/field_recovery.hpp"
#include "src/cage/sector_polynomial.hpp"

namespace cagetol {
namespace {

constexpr double pi = std::numbers::pi;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Fields turned forward by `steps` sectors about the axis.
Eigen::MatrixXd turn_fields(const CageMesh& mesh, const Eigen::MatrixXd& fields, long steps) {
  const long sectors = mesh.cage.pocket_count;
  const Eigen::Matrix3d rotation = sector_rotation(mesh.cage, steps);
  Eigen::MatrixXd turned(fields.rows(), fields.cols());
  for (long j = 0; j < sectors; ++j) {
    const auto& to = mesh.sector_node[static_cast<std::size_t>(j)];
    const auto& from = mesh.sector_node[static_cast<std::size_t>((j - steps + sectors) % sectors)];
    for (std::size_t p = 0; p < to.size(); ++p) {
      turned.middleRows<3>(3 * to[p]).noalias() = rotation * fields.middleRows<3>(3 * from[p]);
    }
  }
  return turned;
}

/// Tangential unit forces on the bar after pocket 0, half on either face.
Eigen::MatrixXd bar_loads(const CageMesh& mesh, const CageStations& stations) {
  const CageDimensions& cage = mesh.cage;
  const double middle = pi / static_cast<double>(cage.pocket_count);
  const Eigen::Vector3d tangent(0, -std::sin(middle), std::cos(middle));
  const double radial = (stations.pitch_radius - cage.inner_radius) /
                        (cage.outer_radius - cage.inner_radius);
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(3 * mesh.mesh.nodes.cols(),
                                                static_cast<Eigen::Index>(stations.bar_x.size()));
  for (Eigen::Index i = 0; i < loads.cols(); ++i) {
    const double axial = stations.bar_x[static_cast<std::size_t>(i)] / (0.5 * cage.pocket_length);
    for (int side = 0; side < 2; ++side) {
      const SectorReading place =
          read_at(mesh.grid, {radial, side == 0 ? 1.0 : -1.0, std::clamp(axial, -1.0, 1.0)});
      const auto& node = mesh.sector_node[static_cast<std::size_t>(side)];
      for (int a = 0; a < 8; ++a) {
        const auto point = static_cast<std::size_t>(place.point[static_cast<std::size_t>(a)]);
        loads.block<3, 1>(3 * node[point], i) += 0.5 * place.weight[a] * tangent;
      }
    }
  }
  return loads;
}

/// Fills partner and angle from the turn of the modes by one sector: Phi^T M (turned Phi) = P, which has
/// single +-1 entries and 2 x 2 rotations on its diagonal.
void find_pairs(CageTable& table, const Eigen::MatrixXd& turn) {
  const Eigen::Index count = turn.rows();
  const double step = 2 * pi / static_cast<double>(table.cage.pocket_count);
  table.partner.resize(count);
  table.angle = Eigen::VectorXd::Zero(count);
  Eigen::MatrixXd rest = turn;
  for (Eigen::Index i = 0; i < count; ++i) {
    table.partner[i] = static_cast<int>(i);
    if (std::abs(turn(i, i)) > 1 - 1e-5) {
      table.angle[i] = turn(i, i) > 0 ? 0 : pi;
      rest(i, i) -= std::cos(table.angle[i]);
      continue;
    }
    if (i + 1 == count) throw std::runtime_error("cage: a mode pair is split");
    const double angle = step * std::round(std::atan2(turn(i + 1, i), turn(i, i)) / step);
    table.partner[i] = static_cast<int>(i + 1);
    table.partner[i + 1] = static_cast<int>(i);
    table.angle[i] = angle;
    table.angle[i + 1] = -angle;
    Eigen::Matrix2d block;
    block << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    rest.block<2, 2>(i, i) -= block;
    ++i;
  }
  if (rest.cwiseAbs().maxCoeff() > 1e-4) {
    throw std::runtime_error("cage: modes do not turn into each other from sector to sector");
  }
}

/// Families of the elastic modes: waves, axial share, symmetry about x = 0.
void find_families(CageTable& table, const CageMesh& mesh, const Eigen::MatrixXd& shapes,
                   const SparseMatrix& mass) {
  const Eigen::Index elastic = table.modes - 6;
  const double step = 2 * pi / static_cast<double>(table.cage.pocket_count);
  table.harmonic.resize(elastic);
  table.axial_share.resize(elastic);
  table.mirror.resize(elastic);
  const SectorReading front = read_at(mesh.grid, {0.5, 0, -2});
  const SectorReading back = read_at(mesh.grid, {0.5, 0, 2});
  for (Eigen::Index i = 0; i < elastic; ++i) {
    table.harmonic[i] = static_cast<int>(std::lround(std::abs(table.angle[6 + i]) / step));
    Eigen::VectorXd axial = shapes.col(6 + i);
    for (Eigen::Index n = 0; n < mesh.mesh.nodes.cols(); ++n) axial.segment<2>(3 * n + 1).setZero();
    table.axial_share[i] = axial.dot(mass.selfadjointView<Eigen::Lower>() * axial);
    double product = 0;
    for (const auto& node : mesh.sector_node) {
      const auto in_plane = [&](const SectorReading& place) {
        Eigen::Vector2d value = Eigen::Vector2d::Zero();
        for (int a = 0; a < 8; ++a) {
          const auto point = static_cast<std::size_t>(place.point[static_cast<std::size_t>(a)]);
          value += place.weight[a] * shapes.block<2, 1>(3 * node[point] + 1, 6 + i);
        }
        return value;
      };
      product += in_plane(front).dot(in_plane(back));
    }
    table.mirror[i] = product > 0 ? 1 : -1;
  }
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

/// Elements of sector 0 and its neighbours: all that touch a node of sector 0.
HexMesh around_first_sector(const CageMesh& mesh) {
  const auto per_sector = static_cast<std::ptrdiff_t>(mesh.grid.elements.size());
  const auto& all = mesh.mesh.elements;
  HexMesh part{mesh.mesh.nodes, {all.begin(), all.begin() + 2 * per_sector}};
  part.elements.insert(part.elements.end(), all.end() - per_sector, all.end());
  return part;
}

void pack(const Eigen::MatrixXd& matrix, Eigen::Ref<Eigen::VectorXd> packed) {
  Eigen::Index next = 0;
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    const Eigen::Index length = matrix.rows() - j;
    packed.segment(next, length) = matrix.col(j).tail(length);
    next += length;
  }
}

/// Computes sector 0 at every sample of the deviations and fits the polynomials.
void tabulate(CageTable& table, const CageMesh& mesh, const Eigen::MatrixXd& basis) {
  const SectorGrid& grid = mesh.grid;
  const auto gradient = nodal_gradient(around_first_sector(mesh), table.material, basis);
  const Eigen::MatrixXd fields = first_sector(mesh, basis);
  std::array<Eigen::MatrixXd, 3> slope;
  for (std::size_t axis = 0; axis < 3; ++axis) slope[axis] = first_sector(mesh, gradient[axis]);
  const Eigen::Matrix3Xd nodes = sector_nodes(table.cage, {}, grid);
  const std::vector<int> watched = stress_stations(grid);

  const auto samples = polynomial_samples(table.range);
  const auto count = static_cast<Eigen::Index>(samples.size());
  const Eigen::Index packed = table.columns * (table.columns + 1) / 2;
  const Eigen::Index contact_size = 3 * contact_points(table.stations) * table.columns;
  const Eigen::Index stress_size = 6 * static_cast<Eigen::Index>(watched.size()) * table.columns;
  Eigen::MatrixXd projection(2 * packed, count);
  Eigen::MatrixXd contact(contact_size, count);
  Eigen::MatrixXd stress(stress_size, count);
  for (Eigen::Index s = 0; s < count; ++s) {
    const PocketDeviation& deviation = samples[static_cast<std::size_t>(s)];
    const HexMesh sector{sector_nodes(table.cage, deviation, grid), grid.elements};
    Eigen::MatrixXd carried = fields;
    for (Eigen::Index p = 0; p < nodes.cols(); ++p) {
      const Eigen::Vector3d moved = sector.nodes.col(p) - nodes.col(p);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        carried.middleRows<3>(3 * p) +=
            moved[static_cast<Eigen::Index>(axis)] * slope[axis].middleRows<3>(3 * p);
      }
    }
    const BodyMatrices body = assemble_body(sector, table.material);
    const auto project = [&](const SparseMatrix& matrix) {
      const Eigen::MatrixXd product = matrix.selfadjointView<Eigen::Lower>() * carried;
      return Eigen::MatrixXd(carried.transpose() * product);
    };
    pack(project(body.stiffness), projection.col(s).head(packed));
    pack(project(body.mass), projection.col(s).tail(packed));
    contact.col(s) =
        contact_rows(table.cage, table.stations, grid, deviation, carried).reshaped();
    stress.col(s) = nodal_stress(sector, table.material, carried, watched).reshaped();
  }
  table.projection = fit_polynomial(projection, table.range);
  table.contact = fit_polynomial(contact, table.range);
  table.stress = fit_polynomial(stress, table.range);
}

/// Integrals that couple modes with a spin about x, on the undeviated cage.
void spin_integrals(CageTable& table, const CageMesh& mesh, const Eigen::MatrixXd& shapes,
                    const SparseMatrix& mass) {
  Eigen::MatrixXd turned = Eigen::MatrixXd::Zero(shapes.rows(), shapes.cols());
  Eigen::MatrixXd in_plane = turned;
  Eigen::VectorXd position = Eigen::VectorXd::Zero(shapes.rows());
  for (Eigen::Index n = 0; n < mesh.mesh.nodes.cols(); ++n) {
    turned.row(3 * n + 1) = -shapes.row(3 * n + 2);
    turned.row(3 * n + 2) = shapes.row(3 * n + 1);
    in_plane.middleRows<2>(3 * n + 1) = shapes.middleRows<2>(3 * n + 1);
    position.segment<2>(3 * n + 1) = mesh.mesh.nodes.col(n).tail<2>();
  }
  const auto m = mass.selfadjointView<Eigen::Lower>();
  table.gyroscopic = shapes.transpose() * (m * turned);
  table.in_plane = shapes.transpose() * (m * in_plane);
  table.centrifugal = shapes.transpose() * (m * position);
}

}  // namespace

void complete_cage_table(CageTable& table, const CageDimensions& cage, const Material& material,
                         const CageStations& stations, const CageTableOptions& options) {
  table.cage = cage;
  table.material = material;
  table.stations = stations;
  table.counts = mesh_counts(cage, options.density);
  table.range = table_range(cage);
  const SectorGrid grid = make_sector_grid(table.counts);
  table.stress_points.clear();
  for (int p : stress_stations(grid)) {
    table.stress_points.push_back(grid.points[static_cast<std::size_t>(p)]);
  }
}

CageTable make_cage_table(const CageDimensions& cage, const Material& material,
                          const CageStations& stations, const CageTableOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  CageTable table;
  complete_cage_table(table, cage, material, stations, options);
  const std::vector<PocketDeviation> none(static_cast<std::size_t>(cage.pocket_count));
  const auto meshed = make_cage_mesh(cage, none, table.counts);
  if (const auto* fault = std::get_if<CageFault>(&meshed)) {
    throw std::runtime_error("cage: the undeviated cage is impossible: " + fault->reason);
  }
  const CageMesh& mesh = std::get<CageMesh>(meshed);
  table.dofs = static_cast<double>(3 * mesh.mesh.nodes.cols());

  const auto solve = std::chrono::steady_clock::now();
  const BodyMatrices body = assemble_body(mesh.mesh, material);
  const ShiftedFactor factor(body, ring_shift(mesh.mesh, body));
  const FreeModes modes = checked_free_modes(mesh.mesh, body, factor, options.basis_modes);
  table.seconds_full = seconds_since(solve);
  table.frequency = modes.frequency;
  table.modes = 6 + modes.frequency.size();

  Eigen::MatrixXd shapes(modes.shape.rows(), table.modes);
  shapes.leftCols<6>() = rigid_motions(mesh.mesh.nodes);
  shapes.rightCols(table.modes - 6) = modes.shape;
  const auto mass = body.mass.selfadjointView<Eigen::Lower>();
  Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(table.modes, table.modes);
  turn.topLeftCorner<3, 3>() = turn.block<3, 3>(3, 3) = sector_rotation(cage, 1);
  turn.bottomRightCorner(table.modes - 6, table.modes - 6) =
      modes.shape.transpose() * (mass * turn_fields(mesh, modes.shape, 1));
  find_pairs(table, turn);
  find_families(table, mesh, shapes, body.mass);
  spin_integrals(table, mesh, shapes, body.mass);

  const Eigen::MatrixXd attachment =
      free_static_response(body, factor, modes.rigid, bar_loads(mesh, stations));
  table.columns = table.modes + cage.pocket_count * attachment.cols();
  Eigen::MatrixXd basis(shapes.rows(), table.columns);
  basis.leftCols(table.modes) = shapes;
  for (long bar = 0; bar < cage.pocket_count; ++bar) {
    basis.middleCols(table.modes + bar * attachment.cols(), attachment.cols()) =
        turn_fields(mesh, attachment, bar);
  }
  tabulate(table, mesh, basis);
  table.seconds_table = seconds_since(start);
  return table;
}

Eigen::MatrixXd turn_columns(const CageTable& table, const Eigen::MatrixXd& matrix, long k) {
  Eigen::MatrixXd turned(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < table.modes; ++i) {
    const double angle = static_cast<double>(k) * table.angle[i];
    turned.col(i) = std::cos(angle) * matrix.col(i);
    if (table.partner[i] != i) turned.col(i) -= std::sin(angle) * matrix.col(table.partner[i]);
  }
  const long sectors = table.cage.pocket_count;
  const Eigen::Index per_bar = (table.columns - table.modes) / sectors;
  for (long bar = 0; bar < sectors; ++bar) {
    turned.middleCols(table.modes + bar * per_bar, per_bar) =
        matrix.middleCols(table.modes + ((bar - k + sectors) % sectors) * per_bar, per_bar);
  }
  return turned;
}

}  // namespace cagetol
