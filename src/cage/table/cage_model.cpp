// Above 400 lines: one table, made, checked and told apart in one place.
#include "src/cage/table/cage_model.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "src/cage/mesh/polynomial_values.hpp"
#include "src/cage/mesh/sector_polynomial.hpp"
#include "src/cage/solve/sector_share.hpp"
#include "src/cage/stress/field_recovery.hpp"
#include "src/cage/table/bar_modes.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Which deviation of a pocket the table does not cover; empty where it covers all.
std::string beyond_range(const PocketDeviation& deviation, const CageTable& table) {
  const PocketDeviation& range = table.range;
  if (inside_range(deviation, range)) return "";
  const auto text = [](const char* what, double value, double limit, const std::string& unit) {
    return fmt::format("{} deviates by {:.4g} {}, the cage table covers +-{:.4g}", what,
                       1e3 * value, unit, 1e3 * limit);
  };
  const auto from = [](double undeviated) {
    return fmt::format("mm from {:.5g}", 1e3 * undeviated);
  };
  if (std::abs(deviation.width) > range.width)
    return text("pocket width", deviation.width, range.width, from(table.cage.pocket_width));
  if (std::abs(deviation.length) > range.length)
    return text("pocket length", deviation.length, range.length, from(table.cage.pocket_length));
  if (std::abs(deviation.pitch) > range.pitch)
    return text("pocket pitch", deviation.pitch, range.pitch, "mrad");
  return text("pocket squareness", deviation.squareness, range.squareness, "mrad");
}

std::optional<CageFault> model_fault(const CageTable& table,
                                     const std::vector<PocketDeviation>& deviations) {
  if (static_cast<long>(deviations.size()) != table.cage.pocket_count) {
    throw std::invalid_argument("cage: one deviation per pocket is needed");
  }
  if (auto fault = cage_fault(table.cage, deviations)) return fault;
  for (std::size_t j = 0; j < deviations.size(); ++j) {
    const std::string reason = beyond_range(deviations[j], table);
    if (!reason.empty()) {
      return CageFault{CageFaultKind::outside_table, static_cast<int>(j), reason};
    }
  }
  return std::nullopt;
}

/// Coefficients of all columns: of the elastic modes, kept and not, and of the static rest per
/// contact force and per square of the spin.
struct Coefficients {
  MatrixXd kept;
  MatrixXd left_out;
  MatrixXd residual;
  Eigen::VectorXd turning;
};

/// The projections with what follows freely or statically.
struct Followed {
  Eigen::LLT<Eigen::Matrix<double, 6, 6>> rigid_mass;
  Eigen::LLT<MatrixXd> local_stiffness;
  MatrixXd local;  ///< l x elastic: local fields that go with each mode
};

/// Elastic modes. K has no entries on rigid motions, exactly, so these follow freely and what
/// remains of the mass decides; local fields follow statically. Returns omega^2 of all.
Eigen::ArrayXd solve_modes(const SectorTurn& turn, const CageProjection& p,
                           const Followed& followed, Index kept, Coefficients& out) {
  const Index elastic = turn.modes - 6;
  MatrixXd stiffness = p.modal_stiffness;
  stiffness.noalias() += p.cross_stiffness.transpose() * followed.local;
  MatrixXd coupling = p.modal_mass.topRightCorner(6, elastic);
  coupling.noalias() += p.cross_mass.transpose() * followed.local;
  const MatrixXd rigid = -followed.rigid_mass.solve(coupling);
  MatrixXd mass = p.modal_mass.bottomRightCorner(elastic, elastic);
  mass.noalias() += coupling.transpose() * rigid;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness, mass);
  const auto combine = [&](const auto& vectors) {
    MatrixXd all(turn.all(), vectors.cols());
    all.topRows<6>().noalias() = rigid * vectors;
    all.middleRows(6, elastic) = vectors;
    all.bottomRows(turn.all() - turn.modes).noalias() = followed.local * vectors;
    return all;
  };
  out.kept = combine(solver.eigenvectors().leftCols(kept));
  out.left_out = combine(solver.eigenvectors().rightCols(elastic - kept));
  return solver.eigenvalues().array();
}

/// Static response to the loads (rows of all columns at the loaded points), inertia relief, minus
/// what the kept modes carry: the modes left out, and the local fields, with the rigid motion that
/// keeps them orthogonal to all rigid motions.
void solve_residual(const SectorTurn& turn, const CageProjection& p, const Followed& followed,
                    const MatrixXd& load_rows, const Eigen::ArrayXd& left_out, Coefficients& out) {
  const Index local = turn.all() - turn.modes;
  const MatrixXd acceleration = followed.rigid_mass.solve(load_rows.leftCols<6>().transpose());
  MatrixXd response = load_rows.rightCols(local).transpose();
  response.noalias() -= p.cross_mass * acceleration;
  followed.local_stiffness.solveInPlace(response);
  const MatrixXd modal =
      left_out.inverse().matrix().asDiagonal() * (load_rows * out.left_out).transpose();
  out.residual.resize(turn.all(), load_rows.rows());
  out.residual.noalias() = out.left_out * modal;
  out.residual.bottomRows(local) += response;
  out.residual.topRows<6>() -= followed.rigid_mass.solve(p.cross_mass.transpose() * response);
}

/// Column k of `flat` as the rows that sector k reads, a column for each of `columns` fields.
template <typename Matrix>
Eigen::Map<const Matrix> sector_rows(const Matrix& flat, Index columns, Index k) {
  return {flat.col(k).data(), flat.rows() / columns, columns};
}

/// Tangential rows of all bar stations on all columns. A unit force is what drives its attachment,
/// so on the undeviated cage its row on the local fields is the attachment's row of the stiffness,
/// without limit of reach; only the change is read from the sector.
MatrixXd bar_rows(const CageTable& table, const MatrixXd& contact, Index n) {
  const SectorTurn& turn = table.turn;
  const auto undeviated = sector_rows(table.contact, turn.seen(), 0);
  MatrixXd all(turn.sectors * 2 * n, turn.all());
  MatrixXd tangential(2 * n, turn.seen());
  MatrixXd change(2 * n, turn.seen());
  for (Index k = 0; k < turn.sectors; ++k) {
    const auto rows = sector_rows(contact, turn.seen(), k);
    for (Index i = 0; i < 2 * n; ++i) {
      tangential.row(i) = rows.row(3 * i + 1);
      change.row(i) = tangential.row(i) - undeviated.row(3 * i + 1);
    }
    auto out = all.middleRows(2 * n * k, 2 * n);
    out.leftCols(turn.modes) = turn_modes(turn, tangential, k);
    out.rightCols(turn.all() - turn.modes) =
        table.undeviated.local_stiffness.middleRows(k * turn.per_sector, 2 * n);
    for (Index o = -turn.reach; o <= turn.reach; ++o) {
      out.middleCols(turn.local_column(k, o), turn.per_sector) +=
          change.middleCols(turn.seen_column(o), turn.per_sector);
    }
  }
  return all;
}

/// Static modes of the bars join the modes kept. What they carry stays in the rest until
/// leave_to_bar_modes().
void add_bar_modes(const CageTable& table, const CageProjection& projection,
                   const MatrixXd& load_rows, Coefficients& coefficients, CageModel& model) {
  BarModes bars = make_bar_modes(table, projection, load_rows, coefficients.residual);
  const Index kept = coefficients.kept.cols(), count = bars.fields.cols();
  coefficients.kept.conservativeResize(Eigen::NoChange, kept + count);
  coefficients.kept.rightCols(count) = bars.fields;
  model.frequency.conservativeResize(kept + count);
  model.frequency.tail(count) = bars.eigenvalue.sqrt() / (2 * std::numbers::pi);
  model.bar_mode_load = std::move(bars.load);
}

void fill_contact(const CageTable& table, const MatrixXd& terms, const Coefficients& coefficients,
                  const MatrixXd& load_rows, const MatrixXd& flat, CageModel& model) {
  const Index sectors = terms.cols();
  const Index per_sector = 3 * model.points;
  const Index n = model.bar_stations;
  model.contact.resize(sectors * per_sector, model.frequency.size());
  const MatrixXd modes = coefficients.kept.transpose();
  for (Index k = 0; k < sectors; ++k) {
    model.contact.middleRows(k * per_sector, per_sector).noalias() =
        sector_rows(flat, table.turn.seen(), k) *
        seen_coefficients(table.turn, modes, k).transpose();
  }
  // Static modes of the bars reach farther than a sector sees.
  if (const Index bars = model.bar_mode_load.cols(); bars > 0) {
    const MatrixXd moved = load_rows * coefficients.kept.rightCols(bars);
    for (Index k = 0; k < sectors; ++k)
      for (Index i = 0; i < 2 * n; ++i)
        model.contact.row(model.contact_row(k, i, 1)).tail(bars) = moved.row(2 * n * k + i);
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

/// What forces on all bar stations of the undeviated cage leave beyond the kept modes, in sector 0:
/// attachments and modes left out, less what static modes of the bars carry. Where the last mode
/// kept has its partner left out, neither counts.
Eigen::MatrixXf far_residual(const CageTable& table, Index kept, Index span, bool bar_modes) {
  const SectorTurn& turn = table.turn;
  const Index stations = 2 * static_cast<Index>(table.stations.bar_x.size());
  const auto contact = sector_rows(table.contact, turn.seen(), 0);
  MatrixXd tangential(stations, turn.modes);
  for (Index i = 0; i < stations; ++i) tangential.row(i) = contact.row(3 * i + 1).head(turn.modes);
  std::vector<Index> left_out;
  for (Index i = kept; i < table.frequency.size(); ++i)
    if (turn.partner[6 + i] >= 6 + kept) left_out.push_back(6 + i);
  const auto count = static_cast<Index>(left_out.size());
  Eigen::VectorXd flexibility(count);
  for (Index i = 0; i < count; ++i)
    flexibility[i] = 1 / std::pow(2 * std::numbers::pi *
                                      table.frequency[left_out[static_cast<std::size_t>(i)] - 6],
                                  2);
  MatrixXd rows(stations * turn.sectors, count);  // of all stations on the modes left out
  for (Index o = 0; o < turn.sectors; ++o)
    rows.middleRows(o * stations, stations) = turn_modes(turn, tangential, o)(Eigen::all, left_out);
  const MatrixXd coordinates = flexibility.asDiagonal() * rows.transpose();
  const auto stress = sector_rows(table.stress, turn.seen() - 6, 0);
  Eigen::MatrixXf strained_by(stress.rows(), count);
  for (Index i = 0; i < count; ++i)
    strained_by.col(i) = stress.col(left_out[static_cast<std::size_t>(i)] - 6);
  Eigen::MatrixXf all = table.attachment_stress;
  all.noalias() += strained_by * coordinates.cast<float>();
  if (bar_modes) {
    MatrixXd compliance = rows * coordinates;
    for (Index o = 0; o < turn.sectors; ++o)
      for (Index k = 0; k < turn.sectors; ++k)
        compliance.block(k * stations, o * stations, stations, stations) +=
            table.undeviated.local_stiffness.block(k * turn.per_sector, o * turn.per_sector,
                                                   stations, stations);
    const MatrixXd forces = forces_on_bars(table.stations, turn.sectors);
    const MatrixXd moved = forces.transpose() * compliance;
    const MatrixXd carried = (moved * forces).llt().solve(moved);
    all -= (all * forces.cast<float>()).eval() * carried.cast<float>();
  }
  Eigen::MatrixXf far = Eigen::MatrixXf::Zero(all.rows(), all.cols());
  const Index first = (span + 1) * stations, columns = (turn.sectors - 2 * span - 1) * stations;
  if (columns > 0) far.middleCols(first, columns) = all.middleCols(first, columns);
  return far;
}

/// Adds to the stress of the bars' static modes what forces far away contribute to them, as on the
/// undeviated cage.
void add_far_bars(const CageTable& table, const MatrixXd& fields, CageModel& model) {
  const SectorTurn& turn = table.turn;
  const Index per_pocket = 2 * model.bar_stations, rows = table.attachment_stress.rows();
  Eigen::MatrixXf far = Eigen::MatrixXf::Zero(table.attachment_stress.cols(), fields.cols());
  for (Index k = 0; k < turn.sectors; ++k) {
    for (Index o = model.span + 1; o < turn.sectors - model.span; ++o)
      far.middleRows(o * per_pocket, per_pocket) =
          fields.middleRows(turn.local_column(0, (k + o) % turn.sectors), per_pocket).cast<float>();
    model.stress.middleRows(k * rows, rows)
        .middleCols(model.frequency.size() - fields.cols(), fields.cols())
        .noalias() += table.attachment_stress * far;
  }
}

/// Stress rows of a sector that are formed together: what that takes, of all sectors, stays in the
/// second cache.
constexpr Index kStressRows = 96;

void fill_stress(const CageTable& table, const MatrixXd& terms, const Coefficients& coefficients,
                 CageModel& model) {
  const Index sectors = terms.cols();
  const Index strained = table.turn.seen() - 6;
  const Index per_sector = 6 * model.stress_stations;
  const Index per_pocket = 2 * model.bar_stations;
  const Index kept = model.frequency.size();
  const Index near = 2 * model.span + 1;
  const Index bars = model.bar_mode_load.cols();
  // What strains a sector: modes, turning, forces near by, a column each.
  MatrixXd combination(kept + 1 + near * per_pocket, table.turn.all());
  combination.topRows(kept) = coefficients.kept.transpose();
  combination.row(kept) = coefficients.turning.transpose();
  std::vector<Eigen::MatrixXf> strain;
  for (Index k = 0; k < sectors; ++k) {
    for (Index o = 0; o < near; ++o) {
      const Index pocket = (k + o - model.span + sectors) % sectors;
      combination.middleRows(kept + 1 + o * per_pocket, per_pocket) =
          coefficients.residual.middleCols(pocket * per_pocket, per_pocket).transpose();
    }
    strain.emplace_back(seen_coefficients(table.turn, combination, k)
                            .rightCols(strained)
                            .transpose()
                            .cast<float>());
  }
  model.stress.resize(per_sector * sectors, kept + 1);
  model.stress_residual.resize(per_sector * sectors, near * per_pocket);
  const Eigen::MatrixXf term = terms.cast<float>();
  const std::vector<Index> acting = acting_terms(term);
  const Index parts = (per_sector + kStressRows - 1) / kStressRows;
  Eigen::MatrixXf values, product;
  for (Index part = 0; part < parts; ++part) {
    const Index first = part * per_sector / parts;
    const Index rows = (part + 1) * per_sector / parts - first;
    values.resize(rows * strained, sectors);
    for (Index c = 0; c < strained; ++c)
      put_values(table.stress, term, acting, per_sector * c + first, rows, c * rows, values);
    for (Index k = 0; k < sectors; ++k) {
      product.noalias() = sector_rows(values, strained, k) * strain[static_cast<std::size_t>(k)];
      const Index row = per_sector * k + first;
      model.stress.middleRows(row, rows) = product.leftCols(kept + 1);
      model.stress_residual.middleRows(row, rows) = product.rightCols(near * per_pocket);
    }
  }
  if (bars > 0) add_far_bars(table, coefficients.kept.rightCols(bars), model);
  model.far_residual = far_residual(table, kept - bars, model.span, bars > 0);
}

/// Takes what the bars' static modes carry out of the static rest.
void leave_to_bar_modes(CageModel& model) {
  const Index bars = model.bar_mode_load.cols(), sectors = bars;
  const Index elastic = model.frequency.size() - bars, per_pocket = 2 * model.bar_stations;
  const Eigen::VectorXd flexibility =
      (2 * std::numbers::pi * model.frequency.tail(bars).array()).square().inverse();
  // Coordinates of the bars' modes under a unit force on each station.
  MatrixXd rows(per_pocket * sectors, bars);
  for (Index k = 0; k < sectors; ++k)
    for (Index i = 0; i < per_pocket; ++i)
      rows.row(per_pocket * k + i) = model.contact.row(model.contact_row(k, i, 1)).tail(bars);
  const MatrixXd carried = flexibility.asDiagonal() * rows.transpose();
  for (Index j = 0; j < sectors; ++j) {
    const Index own = per_pocket * j + model.bar_stations, next = per_pocket * ((j + 1) % sectors);
    MatrixXd at(per_pocket, bars);
    at << rows.middleRows(own, model.bar_stations), rows.middleRows(next, model.bar_stations);
    model.residual_compliance.middleCols(per_pocket * j, per_pocket).noalias() -=
        at * flexibility.asDiagonal() * at.transpose();
  }
  if (model.stress.size() == 0) return;
  const Index per_sector = model.stress.rows() / sectors;
  const Eigen::MatrixXf each = carried.cast<float>();
  for (Index k = 0; k < sectors; ++k) {
    const auto stress =
        model.stress.middleRows(k * per_sector, per_sector).middleCols(elastic, bars);
    for (Index o = -model.span; o <= model.span; ++o)
      model.stress_residual
          .block(k * per_sector, (o + model.span) * per_pocket, per_sector, per_pocket)
          .noalias() -=
          stress * each.middleCols((k + o + sectors) % sectors * per_pocket, per_pocket);
  }
  const Eigen::VectorXf turning =
      (flexibility.array() * model.centrifugal.tail(bars).array()).cast<float>();
  model.stress.rightCols(1).noalias() -= model.stress.middleCols(elastic, bars) * turning;
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
  add_shares(turn, polynomial_values(table.projection, terms), projection);
  Followed followed;
  followed.rigid_mass.compute(projection.modal_mass.topLeftCorner<6, 6>());
  followed.local_stiffness.compute(projection.local_stiffness);
  followed.local = -followed.local_stiffness.solve(projection.cross_stiffness);

  CageModel model;
  model.points = contact_points(table.stations);
  model.bar_stations = static_cast<long>(table.stations.bar_x.size());
  model.body = mass_properties(projection.modal_mass.topLeftCorner<6, 6>());
  Coefficients coefficients;
  const Index kept = std::clamp<Index>(options.modes, 0, table.frequency.size());
  const Eigen::ArrayXd eigenvalues = solve_modes(turn, projection, followed, kept, coefficients);
  const Eigen::ArrayXd left_out = eigenvalues.tail(eigenvalues.size() - kept);
  model.frequency = eigenvalues.head(kept).max(0).sqrt() / (2 * std::numbers::pi);

  const MatrixXd contact = polynomial_values(table.contact, terms);
  const Index n = model.bar_stations;
  const MatrixXd load_rows = bar_rows(table, contact, n);
  solve_residual(turn, projection, followed, load_rows, left_out, coefficients);
  coefficients.turning =
      coefficients.left_out *
      ((coefficients.left_out.topRows(turn.modes).transpose() * table.centrifugal).array() /
       left_out)
          .matrix();
  if (options.bar_modes) add_bar_modes(table, projection, load_rows, coefficients, model);
  fill_contact(table, terms, coefficients, load_rows, contact, model);
  model.stress_stations = static_cast<long>(table.stress_points.size());
  model.span = turn.reach;
  if (options.stress) fill_stress(table, terms, coefficients, model);

  const MatrixXd modal = coefficients.kept.topRows(turn.modes);
  model.gyroscopic = modal.transpose() * table.gyroscopic * modal;
  model.in_plane = modal.transpose() * table.in_plane * modal;
  model.centrifugal = modal.transpose() * table.centrifugal;
  if (options.bar_modes) leave_to_bar_modes(model);
  return model;
}

Eigen::VectorXd station_stress(const CageModel& model, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& bar_forces, double spin) {
  Eigen::VectorXd modal(q.size() + 1);
  modal << q, spin * spin;
  Eigen::VectorXd components = model.stress.cast<double>() * modal;
  const Index per_sector = 6 * model.stress_stations;
  const Index per_pocket = 2 * model.bar_stations;
  const Index sectors = components.size() / per_sector;
  for (Index k = 0; k < sectors; ++k) {
    auto here = components.segment(k * per_sector, per_sector);
    for (Index o = 0; o < sectors; ++o) {
      const Eigen::VectorXd force = bar_forces.segment((k + o) % sectors * per_pocket, per_pocket);
      const Index near = near_place(o, sectors, model.span);
      if (near >= 0)
        here +=
            model.stress_residual.block(k * per_sector, near * per_pocket, per_sector, per_pocket)
                .cast<double>() *
            force;
      else
        here += model.far_residual.middleCols(o * per_pocket, per_pocket).cast<double>() * force;
    }
  }
  Eigen::VectorXd stress(components.size() / 6);
  for (Index k = 0; k < sectors; ++k)
    for (Index i = 0; i < model.stress_stations; ++i)
      stress[k * model.stress_stations + i] =
          von_mises(components.segment(k * per_sector, per_sector)
                        .reshaped(model.stress_stations, 6)
                        .row(i)
                        .transpose());
  return stress;
}

}  // namespace cagetol
