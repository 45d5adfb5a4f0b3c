#include "src/cage/cage_model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "src/cage/field_recovery.hpp"
#include "src/cage/sector_polynomial.hpp"

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

struct Projected {
  MatrixXd stiffness;
  MatrixXd mass;
};

MatrixXd unpack(const Eigen::Ref<const Eigen::VectorXd>& packed, Index size) {
  MatrixXd matrix(size, size);
  Index next = 0;
  for (Index j = 0; j < size; ++j) {
    matrix.col(j).tail(size - j) = packed.segment(next, size - j);
    next += size - j;
  }
  matrix.triangularView<Eigen::StrictlyUpper>() = matrix.transpose();
  return matrix;
}

/// Sum over sectors of R^k^T A_k R^k.
Projected assemble(const CageTable& table, const MatrixXd& terms) {
  const Index size = table.columns;
  const Index packed = size * (size + 1) / 2;
  const MatrixXd shares = table.projection * terms;
  Projected sum{MatrixXd::Zero(size, size), MatrixXd::Zero(size, size)};
  for (Index k = 0; k < terms.cols(); ++k) {
    const auto turned = [&](const Eigen::Ref<const Eigen::VectorXd>& share) {
      const MatrixXd half = turn_columns(table, unpack(share, size), k);
      return turn_columns(table, half.transpose(), k);
    };
    sum.stiffness += turned(shares.col(k).head(packed));
    sum.mass += turned(shares.col(k).tail(packed));
  }
  return sum;
}

/// Coefficients in the basis: of the kept modes, and of the static rest per contact force.
struct Coefficients {
  MatrixXd modes;
  MatrixXd residual;
};

/// Elastic modes with their rigid part removed: K has no entries on rigid motions, exactly, so the problem is
/// that of the other columns with the mass that remains when rigid motions follow freely.
void solve_modes(const CageTable& table, const Projected& p, long count, CageModel& model,
                 Coefficients& out) {
  const Index elastic = table.modes - 6;
  const Eigen::LLT<Eigen::Matrix<double, 6, 6>> rigid(p.mass.topLeftCorner<6, 6>());
  const MatrixXd follow = rigid.solve(p.mass.block(0, 6, 6, elastic));
  const MatrixXd mass = p.mass.block(6, 6, elastic, elastic) -
                        p.mass.block(6, 0, elastic, 6) * follow;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(
      p.stiffness.block(6, 6, elastic, elastic), mass);
  const Index kept = std::min<Index>(count, elastic);
  model.frequency = solver.eigenvalues().head(kept).cwiseMax(0).cwiseSqrt() / (2 * std::numbers::pi);
  out.modes = MatrixXd::Zero(table.columns, kept);
  out.modes.middleRows(6, elastic) = solver.eigenvectors().leftCols(kept);
  out.modes.topRows<6>() = -follow * solver.eigenvectors().leftCols(kept);
}

/// Static response to the loads (rows of the basis at the loaded points), inertia relief, minus what the kept
/// modes carry.
void solve_residual(const CageTable& table, const Projected& p, const MatrixXd& load_rows,
                    const Eigen::VectorXd& frequency, Coefficients& out) {
  const Index elastic = table.columns - 6;
  const Eigen::LLT<Eigen::Matrix<double, 6, 6>> rigid(p.mass.topLeftCorner<6, 6>());
  const MatrixXd follow = rigid.solve(p.mass.block(0, 6, 6, elastic));
  const MatrixXd force = load_rows.rightCols(elastic).transpose() -
                         follow.transpose() * load_rows.leftCols<6>().transpose();
  const Eigen::LLT<MatrixXd> stiffness(p.stiffness.block(6, 6, elastic, elastic));
  out.residual.resize(table.columns, load_rows.rows());
  out.residual.bottomRows(elastic) = stiffness.solve(force);
  out.residual.topRows<6>() = -follow * out.residual.bottomRows(elastic);
  const Eigen::ArrayXd omega = 2 * std::numbers::pi * frequency.array();
  const MatrixXd modal = (load_rows * out.modes).transpose();
  out.residual -= out.modes * (omega.square().inverse().matrix().asDiagonal() * modal);
}

/// Rows of `tabulated` for each sector, in the basis of the whole cage.
std::vector<MatrixXd> sector_rows(const CageTable& table, const MatrixXd& tabulated,
                                  const MatrixXd& terms) {
  const MatrixXd flat = tabulated * terms;
  std::vector<MatrixXd> rows;
  for (Index k = 0; k < terms.cols(); ++k) {
    rows.push_back(
        turn_columns(table, flat.col(k).reshaped(flat.rows() / table.columns, table.columns), k));
  }
  return rows;
}

void fill_stress(const CageTable& table, const MatrixXd& terms, const Coefficients& coefficients,
                 CageModel& model) {
  const std::vector<MatrixXd> rows = sector_rows(table, table.stress, terms);
  const Index per_sector = rows.front().rows();
  const Index per_pocket = 2 * model.bar_stations;
  const Index sectors = terms.cols();
  model.stress.resize(sectors * per_sector, model.frequency.size());
  model.stress_residual.resize(sectors * per_sector, (2 * model.span + 1) * per_pocket);
  MatrixXd near(table.columns, model.stress_residual.cols());
  for (Index k = 0; k < sectors; ++k) {
    for (Index o = -model.span; o <= model.span; ++o) {
      const Index pocket = (k + o + sectors) % sectors;
      near.middleCols((o + model.span) * per_pocket, per_pocket) =
          coefficients.residual.middleCols(pocket * per_pocket, per_pocket);
    }
    const MatrixXd& stress = rows[static_cast<std::size_t>(k)];
    model.stress.middleRows(k * per_sector, per_sector).noalias() =
        stress.leftCols(table.modes) * coefficients.modes.topRows(table.modes);
    model.stress_residual.middleRows(k * per_sector, per_sector).noalias() = stress * near;
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
  const Projected projected = assemble(table, terms);

  CageModel model;
  model.points = contact_points(table.stations);
  model.bar_stations = static_cast<long>(table.stations.bar_x.size());
  model.body = mass_properties(projected.mass.topLeftCorner<6, 6>());
  Coefficients coefficients;
  solve_modes(table, projected, options.modes, model, coefficients);

  const std::vector<MatrixXd> contact = sector_rows(table, table.contact, terms);
  const Index per_sector = 3 * model.points;
  const Index n = model.bar_stations;
  model.contact.resize(sectors * per_sector, model.frequency.size());
  MatrixXd load_rows(sectors * 2 * n, table.columns);
  for (Index k = 0; k < sectors; ++k) {
    const MatrixXd& rows = contact[static_cast<std::size_t>(k)];
    model.contact.middleRows(k * per_sector, per_sector).noalias() = rows * coefficients.modes;
    for (Index i = 0; i < 2 * n; ++i) load_rows.row(2 * n * k + i) = rows.row(3 * i + 1);
  }
  solve_residual(table, projected, load_rows, model.frequency, coefficients);
  model.residual_compliance.resize(2 * n, 2 * n * sectors);
  for (Index j = 0; j < sectors; ++j) {
    MatrixXd rows(2 * n, table.columns);
    MatrixXd response(table.columns, 2 * n);
    const Index next = (j + 1) % sectors;
    rows.topRows(n) = load_rows.middleRows(2 * n * j + n, n);
    rows.bottomRows(n) = load_rows.middleRows(2 * n * next, n);
    response.leftCols(n) = coefficients.residual.middleCols(2 * n * j + n, n);
    response.rightCols(n) = coefficients.residual.middleCols(2 * n * next, n);
    model.residual_compliance.middleCols(2 * n * j, 2 * n).noalias() = rows * response;
  }
  model.stress_stations = static_cast<long>(table.stress_points.size());
  model.span = std::min<long>(options.span, (sectors - 1) / 2);
  if (options.stress) fill_stress(table, terms, coefficients, model);

  const MatrixXd kept = coefficients.modes.topRows(table.modes);
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
