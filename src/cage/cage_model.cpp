#include "src/cage/cage_model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "src/cage/field_recovery.hpp"
#include "src/cage/sector_polynomial.hpp"
#include "src/cage/sector_share.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::optional<CageFault> model_fault(const CageTable& table,
                                     const std::vector<PocketDeviation>& deviations) {
  if (static_cast<long>(deviations.size()) != table.cage.pocket_count) {
    throw std::invalid_argument("cage: one deviation per pocket is needed");
  }
  if (auto fault = cage_fault(table.cage, deviations)) return fault;
  for (std::size_t j = 0; j < deviations.size(); ++j) {
    if (!inside_range(deviations[j], table.range)) {
      return CageFault{CageFaultKind::outside_table, static_cast<int>(j),
                       "a deviation of the pocket is beyond what the cage table covers"};
    }
  }
  return std::nullopt;
}

/// Coefficients of all columns: of the kept modes, and of the static rest per contact force.
struct Coefficients {
  MatrixXd modes;
  MatrixXd residual;
};

/// The projections with what follows freely or statically.
struct Followed {
  Eigen::LLT<Eigen::Matrix<double, 6, 6>> rigid_mass;
  Eigen::LLT<MatrixXd> local_stiffness;
  MatrixXd local;  ///< l x elastic: local fields that go with each mode
};

/// Elastic modes. K has no entries on rigid motions, exactly, so these follow freely and what
/// remains of the mass decides; local fields follow statically.
void solve_modes(const SectorTurn& turn, const CageProjection& p, const Followed& followed,
                 long count, CageModel& model, Coefficients& out) {
  const Index elastic = turn.modes - 6;
  const MatrixXd stiffness = p.modal_stiffness + p.cross_stiffness.transpose() * followed.local;
  const MatrixXd coupling =
      p.modal_mass.topRightCorner(6, elastic) + p.cross_mass.transpose() * followed.local;
  const MatrixXd rigid = -followed.rigid_mass.solve(coupling);
  const MatrixXd mass =
      p.modal_mass.bottomRightCorner(elastic, elastic) + coupling.transpose() * rigid;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness, mass);
  const Index kept = std::min<Index>(count, elastic);
  const auto vectors = solver.eigenvectors().leftCols(kept);
  model.frequency =
      solver.eigenvalues().head(kept).cwiseMax(0).cwiseSqrt() / (2 * std::numbers::pi);
  out.modes.resize(turn.all(), kept);
  out.modes.topRows<6>() = rigid * vectors;
  out.modes.middleRows(6, elastic) = vectors;
  out.modes.bottomRows(turn.all() - turn.modes) = followed.local * vectors;
}

/// Static response to the loads (rows of all columns at the loaded points), inertia relief, minus
/// what the kept modes carry. Solved by elimination of the local fields.
void solve_residual(const SectorTurn& turn, const CageProjection& p, const Followed& followed,
                    const MatrixXd& load_rows, const Eigen::VectorXd& frequency,
                    Coefficients& out) {
  const Index elastic = turn.modes - 6;
  const Index local = turn.all() - turn.modes;
  const MatrixXd acceleration = followed.rigid_mass.solve(load_rows.leftCols<6>().transpose());
  const MatrixXd modal_force = load_rows.middleCols(6, elastic).transpose() -
                               p.modal_mass.bottomLeftCorner(elastic, 6) * acceleration;
  const MatrixXd local_force = load_rows.rightCols(local).transpose() - p.cross_mass * acceleration;
  const MatrixXd stiffness = p.modal_stiffness + p.cross_stiffness.transpose() * followed.local;
  out.residual.resize(turn.all(), load_rows.rows());
  out.residual.middleRows(6, elastic) =
      stiffness.llt().solve(modal_force + followed.local.transpose() * local_force);
  out.residual.bottomRows(local) = followed.local_stiffness.solve(local_force) +
                                   followed.local * out.residual.middleRows(6, elastic);
  out.residual.topRows<6>() = -followed.rigid_mass.solve(
      p.modal_mass.topRightCorner(6, elastic) * out.residual.middleRows(6, elastic) +
      p.cross_mass.transpose() * out.residual.bottomRows(local));
  const Eigen::ArrayXd omega = 2 * std::numbers::pi * frequency.array();
  const MatrixXd modal = (load_rows * out.modes).transpose();
  out.residual -= out.modes * (omega.square().inverse().matrix().asDiagonal() * modal);
}

/// Column k of `flat` as the rows that sector k reads, on seen columns.
Eigen::Map<const MatrixXd> sector_rows(const SectorTurn& turn, const MatrixXd& flat, Index k) {
  return {flat.col(k).data(), flat.rows() / turn.seen(), turn.seen()};
}

/// Tangential rows of all bar stations on all columns. A unit force is what drives its attachment,
/// so on the undeviated cage its row on the local fields is the attachment's row of the stiffness,
/// without limit of reach; only the change is read from the sector.
MatrixXd bar_rows(const CageTable& table, const MatrixXd& contact, Index n) {
  const SectorTurn& turn = table.turn;
  const Index local = turn.all() - turn.modes;
  const Index seen_local = turn.seen() - turn.modes;
  const auto undeviated = sector_rows(turn, table.contact, 0);
  MatrixXd all(turn.sectors * 2 * n, turn.all());
  MatrixXd tangential(2 * n, turn.seen());
  for (Index k = 0; k < turn.sectors; ++k) {
    const auto rows = sector_rows(turn, contact, k);
    for (Index i = 0; i < 2 * n; ++i) {
      tangential.row(i) = rows.row(3 * i + 1);
      tangential.row(i).tail(seen_local) -= undeviated.row(3 * i + 1).tail(seen_local);
    }
    auto out = all.middleRows(2 * n * k, 2 * n);
    out = to_all_columns(turn, tangential, k);
    out.rightCols(local) += table.undeviated.local_stiffness.middleRows(k * turn.per_sector, 2 * n);
  }
  return all;
}

void fill_contact(const CageTable& table, const MatrixXd& terms, const Coefficients& coefficients,
                  const MatrixXd& load_rows, const MatrixXd& flat, CageModel& model) {
  const Index sectors = terms.cols();
  const Index per_sector = 3 * model.points;
  const Index n = model.bar_stations;
  model.contact.resize(sectors * per_sector, model.frequency.size());
  const MatrixXd modes = coefficients.modes.transpose();
  for (Index k = 0; k < sectors; ++k) {
    model.contact.middleRows(k * per_sector, per_sector).noalias() =
        sector_rows(table.turn, flat, k) * seen_coefficients(table.turn, modes, k).transpose();
  }
  model.residual_compliance.resize(2 * n, 2 * n * sectors);
  for (Index j = 0; j < sectors; ++j) {
    const Index own = 2 * n * j + n;
    const Index next = 2 * n * ((j + 1) % sectors);
    MatrixXd rows(2 * n, table.turn.all());
    rows << load_rows.middleRows(own, n), load_rows.middleRows(next, n);
    MatrixXd response(table.turn.all(), 2 * n);
    response << coefficients.residual.middleCols(own, n), coefficients.residual.middleCols(next, n);
    model.residual_compliance.middleCols(2 * n * j, 2 * n).noalias() = rows * response;
  }
}

void fill_stress(const CageTable& table, const MatrixXd& terms, const Coefficients& coefficients,
                 CageModel& model) {
  const MatrixXd flat = table.stress * terms;
  const Index sectors = terms.cols();
  const Index per_sector = flat.rows() / table.turn.seen();
  const Index per_pocket = 2 * model.bar_stations;
  const Index kept = model.frequency.size();
  const Index forces = (2 * model.span + 1) * per_pocket;
  model.stress.resize(sectors * per_sector, kept);
  model.stress_residual.resize(sectors * per_sector, forces);
  const MatrixXd residual = coefficients.residual.transpose();
  MatrixXd coefficient(kept + forces, table.turn.all());
  coefficient.topRows(kept) = coefficients.modes.transpose();
  for (Index k = 0; k < sectors; ++k) {
    for (Index o = -model.span; o <= model.span; ++o) {
      const Index pocket = (k + o + sectors) % sectors;
      coefficient.middleRows(kept + (o + model.span) * per_pocket, per_pocket) =
          residual.middleRows(pocket * per_pocket, per_pocket);
    }
    const MatrixXd stress = sector_rows(table.turn, flat, k) *
                            seen_coefficients(table.turn, coefficient, k).transpose();
    model.stress.middleRows(k * per_sector, per_sector) = stress.leftCols(kept);
    model.stress_residual.middleRows(k * per_sector, per_sector) = stress.rightCols(forces);
  }
}

}  // namespace

std::variant<CageModel, CageFault> make_cage_model(const CageTable& table,
                                                   const std::vector<PocketDeviation>& deviations,
                                                   const CageModelOptions& options) {
  if (auto fault = model_fault(table, deviations)) return *fault;
  const Index sectors = table.cage.pocket_count;
  MatrixXd terms(table.projection.cols(), sectors);
  for (Index k = 0; k < sectors; ++k) {
    terms.col(k) = polynomial_terms(deviations[static_cast<std::size_t>(k)], table.range);
  }
  const SectorTurn& turn = table.turn;
  CageProjection projection = table.undeviated;
  add_shares(turn, table.projection * terms, projection);
  Followed followed;
  followed.rigid_mass.compute(projection.modal_mass.topLeftCorner<6, 6>());
  followed.local_stiffness.compute(projection.local_stiffness);
  followed.local = -followed.local_stiffness.solve(projection.cross_stiffness);

  CageModel model;
  model.points = contact_points(table.stations);
  model.bar_stations = static_cast<long>(table.stations.bar_x.size());
  model.body = mass_properties(projection.modal_mass.topLeftCorner<6, 6>());
  Coefficients coefficients;
  solve_modes(turn, projection, followed, options.modes, model, coefficients);

  const MatrixXd contact = table.contact * terms;
  const Index n = model.bar_stations;
  const MatrixXd load_rows = bar_rows(table, contact, n);
  solve_residual(turn, projection, followed, load_rows, model.frequency, coefficients);
  fill_contact(table, terms, coefficients, load_rows, contact, model);
  model.stress_stations = static_cast<long>(table.stress_points.size());
  model.span = turn.reach;
  if (options.stress) fill_stress(table, terms, coefficients, model);

  const MatrixXd kept = coefficients.modes.topRows(turn.modes);
  model.gyroscopic = kept.transpose() * table.gyroscopic * kept;
  model.in_plane = kept.transpose() * table.in_plane * kept;
  model.centrifugal = kept.transpose() * table.centrifugal;
  return model;
}

Eigen::VectorXd station_stress(const CageModel& model, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& bar_forces) {
  Eigen::VectorXd components = model.stress * q;
  const Index per_sector = 6 * model.stress_stations;
  const Index per_pocket = 2 * model.bar_stations;
  const Index sectors = components.size() / per_sector;
  Eigen::VectorXd near(model.stress_residual.cols());
  for (Index k = 0; k < sectors; ++k) {
    for (Index o = -model.span; o <= model.span; ++o) {
      near.segment((o + model.span) * per_pocket, per_pocket) =
          bar_forces.segment(((k + o + sectors) % sectors) * per_pocket, per_pocket);
    }
    components.segment(k * per_sector, per_sector).noalias() +=
        model.stress_residual.middleRows(k * per_sector, per_sector) * near;
  }
  Eigen::VectorXd stress(components.size() / 6);
  for (Index i = 0; i < stress.size(); ++i) stress[i] = von_mises(components.segment<6>(6 * i));
  return stress;
}

}  // namespace cagetol
