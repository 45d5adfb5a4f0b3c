#include "src/cage/table/cage_table.hpp"

#include <chrono>
#include <memory>
#include <stdexcept>

#include "src/cage/mesh/sector_polynomial.hpp"
#include "src/cage/mesh/strip_stations.hpp"
#include "src/cage/solve/cage_modes.hpp"
#include "src/cage/solve/sector_share.hpp"
#include "src/cage/solve/unsolved_cage.hpp"
#include "src/cage/stress/bar_stress.hpp"
#include "src/cage/stress/field_recovery.hpp"

namespace cagetol {
namespace {

/// Of the time a table takes, what goes before the tabulation: with sharp corners, with fillets.
constexpr double kBasisShare = 0.4, kBasisShareWithFillets = 0.1;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What is computed of sector 0 for one deviation.
struct DeviatedSector {
  Eigen::MatrixXd carried;        ///< seen columns
  Eigen::MatrixXd accelerations;  ///< of these
};

/// Computes sector 0 at every sample of the deviations and fits the polynomials.
class Tabulation {
 public:
  Tabulation(CageTable& table, const SectorGrid& grid, const CageBasis& basis)
      : table_(table),
        grid_(grid),
        basis_(basis),
        seen_(seen_in_all(table.turn)),
        watched_(stress_stations(table.cage, table.stations, grid)),
        samples_(polynomial_samples(table.range)) {
    const SectorTurn& turn = table.turn;
    inertia_ = Eigen::MatrixXd::Zero(turn.seen(), turn.seen());
    inertia_.topRows(turn.modes) = basis.sector.inertia(Eigen::all, seen_);
    const auto count = static_cast<Eigen::Index>(samples_.size());
    projection_.resize(share_layout(turn).size, count);
    contact_.resize(3 * contact_points(table.stations) * turn.seen(), count);
    stress_.resize(6 * static_cast<Eigen::Index>(table.stress_points.size()) * strained(), count);
    if (table.strip.corner_radius > 0)
      bars_ = std::make_unique<BarStress>(table.cage, table.stations, table.material, grid,
                                          table.strip, basis.sector);
  }

  void run(const std::function<void(double)>& progress) {
    std::vector<bool> done(samples_.size(), false);
    double finished = 0;
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      if (done[s]) continue;
      // The half bar of a leading face is the mirror image of a trailing face's in another sample.
      const std::size_t other = image(s);
      const DeviatedSector own = deviate(s);
      const DeviatedSector its = other == s ? own : deviate(other);
      bar_stress(s, own, other, its);
      if (other != s) bar_stress(other, its, s, own);
      finished += other == s ? 1 : 2;
      done[s] = done[other] = true;
      progress(finished / static_cast<double>(samples_.size()));
    }
    table_.projection = fit_polynomial(projection_, table_.range);
    table_.projection.col(0).setZero();
    table_.contact = fit_polynomial(contact_, table_.range);
    table_.stress = fit_polynomial(stress_, table_.range).cast<float>();
    far_stress();
  }

 private:
  /// Rigid motions, the first six columns, strain nothing.
  Eigen::Index strained() const { return table_.turn.seen() - 6; }

  std::size_t image(std::size_t s) const {
    const PocketDeviation wanted = mirrored(samples_[s]);
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (samples_[i].width == wanted.width && samples_[i].length == wanted.length &&
          samples_[i].pitch == wanted.pitch && samples_[i].squareness == wanted.squareness)
        return i;
    throw std::logic_error("cage: the samples of the deviations are not symmetric");
  }

  DeviatedSector deviate(std::size_t s) {
    const SectorTurn& turn = table_.turn;
    const auto column = static_cast<Eigen::Index>(s);
    const PocketDeviation& deviation = samples_[s];
    const HexMesh sector{sector_nodes(table_.cage, deviation, grid_), grid_.elements};
    const BodyMatrices body = assemble_body(sector, table_.material);
    const Eigen::VectorXd turning = basis_.sector.turning(seen_);
    FieldDrive drive{inertia_, seen_loads(turn, table_.cage, table_.stations, grid_, deviation)};
    drive.loads +=
        (body.mass.selfadjointView<Eigen::Lower>() * arms(sector.nodes)) * turning.transpose();
    DeviatedSector result{carry_fields(grid_, body, basis_.sector.fields(Eigen::all, seen_), drive),
                          {}};
    const Eigen::MatrixXd& carried = result.carried;
    const auto project = [&](const SparseMatrix& matrix) {
      return Eigen::MatrixXd(carried.transpose() * symmetric_product(matrix, carried));
    };
    pack_share(turn, project(body.stiffness), project(body.mass), projection_.col(column));
    contact_.col(column) =
        contact_rows(table_.cage, table_.stations, grid_, deviation, carried).reshaped();
    put(s, 0, nodal_stress(sector, table_.material, carried.rightCols(strained()), watched_));
    if (bars_) {
      result.accelerations = carried.leftCols(turn.modes) * inertia_.topRows(turn.modes);
      result.accelerations += arms(sector.nodes) * turning.transpose();
    }
    return result;
  }

  /// Stress at the leading face of sample `s` and at the trailing face of sample `other`.
  void bar_stress(std::size_t s, const DeviatedSector& own, std::size_t other,
                  const DeviatedSector& its) {
    if (!bars_) return;
    bars_->deviate(samples_[s]);
    const auto first = static_cast<Eigen::Index>(watched_.size());
    const std::vector<Eigen::Index> columns(seen_.begin() + 6, seen_.end());
    const auto stress = [&](int face, const DeviatedSector& sector) {
      return bars_->stress(face, columns, sector.carried.rightCols(strained()),
                           sector.accelerations.rightCols(strained()));
    };
    const Eigen::MatrixXd leading = stress(1, own), trailing = stress(-1, its);
    put(s, first, leading);
    put(other, first + trailing.rows() / 6, trailing);
  }

  /// Rows 6 i + component of a sample as rows with the station running first, from station `first`.
  void put(std::size_t s, Eigen::Index first, const Eigen::MatrixXd& stress) {
    place(stress, first,
          stress_.col(static_cast<Eigen::Index>(s))
              .reshaped(stress_.rows() / strained(), strained()));
  }
  template <typename To>
  void place(const Eigen::MatrixXd& stress, Eigen::Index first, To&& to) const {
    const auto stations = static_cast<Eigen::Index>(table_.stress_points.size());
    for (Eigen::Index i = 0; i < stress.rows() / 6; ++i)
      for (Eigen::Index c = 0; c < 6; ++c) to.row(stations * c + first + i) = stress.row(6 * i + c);
  }

  /// Of attachments of all sectors on the undeviated cage.
  void far_stress() {
    const SectorTurn& turn = table_.turn;
    const auto per_pocket = 2 * static_cast<Eigen::Index>(table_.stations.bar_x.size());
    std::vector<Eigen::Index> attachments;
    for (Eigen::Index o = 0; o < turn.sectors; ++o)
      for (Eigen::Index i = 0; i < per_pocket; ++i)
        attachments.push_back(turn.local_column(0, o) + i);
    const HexMesh sector{sector_nodes(table_.cage, {}, grid_), grid_.elements};
    const Eigen::MatrixXd fields = basis_.sector.fields(Eigen::all, attachments);
    Eigen::MatrixXd stress(6 * static_cast<Eigen::Index>(table_.stress_points.size()),
                           fields.cols());
    place(nodal_stress(sector, table_.material, fields, watched_), 0, stress);
    if (bars_) {
      Eigen::MatrixXd accelerations = basis_.sector.fields.leftCols(turn.modes) *
                                      basis_.sector.inertia(Eigen::all, attachments);
      accelerations += arms(sector.nodes) * basis_.sector.turning(attachments).transpose();
      bars_->deviate({});
      auto first = static_cast<Eigen::Index>(watched_.size());
      for (const int face : {1, -1}) {
        const Eigen::MatrixXd rows = bars_->stress(face, attachments, fields, accelerations);
        place(rows, first, stress);
        first += rows.rows() / 6;
      }
    }
    table_.attachment_stress = stress.cast<float>();
  }

  CageTable& table_;
  const SectorGrid& grid_;
  const CageBasis& basis_;
  std::vector<Eigen::Index> seen_;
  std::vector<int> watched_;
  std::vector<PocketDeviation> samples_;
  Eigen::MatrixXd inertia_;  ///< seen x seen
  Eigen::MatrixXd projection_, contact_, stress_;
  std::unique_ptr<BarStress> bars_;
};

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
  table.gyroscopic = shapes.transpose() * symmetric_product(mass, turned);
  table.in_plane = shapes.transpose() * symmetric_product(mass, in_plane);
  table.centrifugal = shapes.transpose() * symmetric_product(mass, arms(mesh.mesh.nodes));
}

}  // namespace

void complete_cage_table(CageTable& table, const CageDimensions& cage, const Material& material,
                         const CageStations& stations, const CageTableOptions& options) {
  table.cage = cage_at(cage, options.point);
  table.material = material;
  table.stations = stations;
  table.counts = mesh_counts(cage, options.density);
  table.range = table_range(table.cage);
  table.strip = make_bar_strip(options.strip, cage.corner_radius);
  const SectorGrid grid = make_sector_grid(table.counts);
  table.stress_points.clear();
  for (int p : stress_stations(table.cage, stations, grid)) {
    table.stress_points.push_back(grid.points[static_cast<std::size_t>(p)]);
  }
  if (cage.corner_radius == 0) return;
  for (const int face : {1, -1})
    for (SectorPoint point : strip_stations(table.cage, stations, table.strip).place) {
      point.around *= face;
      table.stress_points.push_back(point);
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
  const CyclicCage cyclic(mesh, material);
  const FreeModes modes = cyclic.modes(options.basis_modes);
  const CageBasis basis =
      make_cage_basis(mesh, material, stations, table.range, cyclic, modes, options);
  table.turn = basis.sector.turn;
  table.frequency = basis.frequency;
  table.family = basis.family;
  table.undeviated = basis.projection;
  table.dofs = 3 * mesh.mesh.nodes.cols();
  spin_integrals(table, mesh, basis.shapes, cyclic.mass());
  const double done = cage.corner_radius > 0 ? kBasisShareWithFillets : kBasisShare;
  Tabulation(table, mesh.grid, basis).run([&](double share) {
    progress(done + (1 - done) * share);
  });
  table.seconds_table = seconds_since(start);
  return table;
}

}  // namespace cagetol
