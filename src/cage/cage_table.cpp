#include "src/cage/cage_table.hpp"

#include <chrono>

#include "src/cage/cage_modes.hpp"
#include "src/cage/field_recovery.hpp"
#include "src/cage/sector_polynomial.hpp"
#include "src/cage/sector_share.hpp"
#include "src/cage/unsolved_cage.hpp"

namespace cagetol {
namespace {

/// Of the time a table takes, what goes before the tabulation.
constexpr double kBasisShare = 0.6;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Rows of stress with the component running first to rows with the station running first.
Eigen::MatrixXd by_component(const Eigen::MatrixXd& stress) {
  const Eigen::Index stations = stress.rows() / 6;
  Eigen::MatrixXd to(stress.rows(), stress.cols());
  for (Eigen::Index i = 0; i < stations; ++i)
    for (Eigen::Index c = 0; c < 6; ++c) to.row(stations * c + i) = stress.row(6 * i + c);
  return to;
}

/// Computes sector 0 at every sample of the deviations and fits the polynomials.
void tabulate(CageTable& table, const SectorGrid& grid, const CageBasis& basis,
              const std::function<void(double)>& progress) {
  const SectorTurn& turn = table.turn;
  const std::vector<int> watched = stress_stations(table.cage, table.stations, grid);
  const auto samples = polynomial_samples(table.range);
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd projection(share_layout(turn).size, count);
  Eigen::MatrixXd contact(3 * contact_points(table.stations) * turn.seen(), count);
  // Rigid motions, the first six columns, strain nothing.
  const Eigen::Index strained = turn.seen() - 6;
  Eigen::MatrixXd stress(6 * static_cast<Eigen::Index>(watched.size()) * strained, count);
  for (Eigen::Index s = 0; s < count; ++s) {
    const PocketDeviation& deviation = samples[static_cast<std::size_t>(s)];
    const HexMesh sector{sector_nodes(table.cage, deviation, grid), grid.elements};
    const BodyMatrices body = assemble_body(sector, table.material);
    FieldDrive drive{basis.inertia, seen_loads(turn, table.cage, table.stations, grid, deviation)};
    drive.loads += (body.mass.selfadjointView<Eigen::Lower>() * arms(sector.nodes)) *
                   basis.turning.transpose();
    const Eigen::MatrixXd carried = carry_fields(grid, body, basis.seen, drive);
    const auto project = [&](const SparseMatrix& matrix) {
      const Eigen::MatrixXd product = matrix.selfadjointView<Eigen::Lower>() * carried;
      return Eigen::MatrixXd(carried.transpose() * product);
    };
    pack_share(turn, project(body.stiffness), project(body.mass), projection.col(s));
    contact.col(s) = contact_rows(table.cage, table.stations, grid, deviation, carried).reshaped();
    stress.col(s) =
        by_component(nodal_stress(sector, table.material, carried.rightCols(strained), watched))
            .reshaped();
    progress(static_cast<double>(s + 1) / static_cast<double>(count));
  }
  table.projection = fit_polynomial(projection, table.range);
  table.projection.col(0).setZero();
  table.contact = fit_polynomial(contact, table.range);
  table.stress = fit_polynomial(stress, table.range).cast<float>();
  const HexMesh undeviated{sector_nodes(table.cage, {}, grid), grid.elements};
  table.attachment_stress =
      by_component(nodal_stress(undeviated, table.material, basis.attachments, watched))
          .cast<float>();
}

/// Integrals that couple modes with a spin about x, on the undeviated cage.
void spin_integrals(CageTable& table, const CageMesh& mesh, const Eigen::MatrixXd& shapes,
                    const SparseMatrix& mass) {
  Eigen::MatrixXd turned = Eigen::MatrixXd::Zero(shapes.rows(), shapes.cols());
  Eigen::MatrixXd in_plane = turned;
  for (Eigen::Index n = 0; n < mesh.mesh.nodes.cols(); ++n) {
    turned.row(3 * n + 1) = -shapes.row(3 * n + 2);
    turned.row(3 * n + 2) = shapes.row(3 * n + 1);
    in_plane.middleRows<2>(3 * n + 1) = shapes.middleRows<2>(3 * n + 1);
  }
  const auto m = mass.selfadjointView<Eigen::Lower>();
  table.gyroscopic = shapes.transpose() * (m * turned);
  table.in_plane = shapes.transpose() * (m * in_plane);
  table.centrifugal = shapes.transpose() * (m * arms(mesh.mesh.nodes));
}

}  // namespace

void complete_cage_table(CageTable& table, const CageDimensions& cage, const Material& material,
                         const CageStations& stations, const CageTableOptions& options) {
  table.cage = cage_at(cage, options.point);
  table.material = material;
  table.stations = stations;
  table.counts = mesh_counts(cage, options.density);
  table.range = table_range(table.cage);
  const SectorGrid grid = make_sector_grid(table.counts);
  table.stress_points.clear();
  for (int p : stress_stations(table.cage, stations, grid)) {
    table.stress_points.push_back(grid.points[static_cast<std::size_t>(p)]);
  }
}

CageTable make_cage_table(const CageDimensions& cage, const Material& material,
                          const CageStations& stations, const CageTableOptions& options,
                          const TableProgress& news) {
  const auto progress = [&](double share) {
    if (news) news(share);
  };
  progress(0);
  const auto start = std::chrono::steady_clock::now();
  CageTable table;
  complete_cage_table(table, cage, material, stations, options);
  const std::vector<PocketDeviation> none(static_cast<std::size_t>(cage.pocket_count));
  const auto meshed = make_cage_mesh(table.cage, none, table.counts);
  if (const auto* fault = std::get_if<CageFault>(&meshed)) {
    throw UnsolvedCage("the undeviated cage is impossible: " + fault->reason);
  }
  const CageMesh& mesh = std::get<CageMesh>(meshed);
  const auto solve = std::chrono::steady_clock::now();
  const BodyMatrices body = assemble_body(mesh.mesh, material);
  const ShiftedFactor factor(body, ring_shift(mesh.mesh, body));
  const FreeModes modes = checked_free_modes(mesh.mesh, body, factor, options.basis_modes);
  table.seconds_full = seconds_since(solve);
  const CageBasis basis =
      make_cage_basis(mesh, material, stations, table.range, body, factor, modes, options);
  table.turn = basis.turn;
  table.frequency = basis.frequency;
  table.family = basis.family;
  table.undeviated = basis.projection;
  table.dofs = 3 * mesh.mesh.nodes.cols();
  spin_integrals(table, mesh, basis.shapes, body.mass);
  tabulate(table, mesh.grid, basis,
           [&](double share) { progress(kBasisShare + (1 - kBasisShare) * share); });
  table.seconds_table = seconds_since(start);
  return table;
}

}  // namespace cagetol
