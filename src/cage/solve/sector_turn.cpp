#include "src/cage/solve/sector_turn.hpp"

#include <cmath>
#include <numbers>

#include "src/cage/solve/unsolved_cage.hpp"

namespace cagetol {

using Eigen::Index;
using Eigen::MatrixXd;

std::vector<Index> seen_in_all(const SectorTurn& sector) {
  std::vector<Index> columns;
  for (Index i = 0; i < sector.modes; ++i) columns.push_back(i);
  for (Index o = -sector.reach; o <= sector.reach; ++o)
    for (Index i = 0; i < sector.per_sector; ++i) columns.push_back(sector.local_column(0, o) + i);
  return columns;
}

void find_turn(SectorTurn& sector, const MatrixXd& turn) {
  const double step = 2 * std::numbers::pi / static_cast<double>(sector.sectors);
  sector.modes = turn.rows();
  sector.partner.resize(sector.modes);
  sector.angle = Eigen::VectorXd::Zero(sector.modes);
  MatrixXd rest = turn;
  for (Index i = 0; i < sector.modes; ++i) {
    sector.partner[i] = static_cast<int>(i);
    if (std::abs(turn(i, i)) > 1 - 1e-5) {
      sector.angle[i] = turn(i, i) > 0 ? 0 : std::numbers::pi;
      rest(i, i) -= std::cos(sector.angle[i]);
      continue;
    }
    if (i + 1 == sector.modes) throw UnsolvedCage("a pair of modes of one frequency is split");
    const double angle = step * std::round(std::atan2(turn(i + 1, i), turn(i, i)) / step);
    sector.partner[i] = static_cast<int>(i + 1);
    sector.partner[i + 1] = static_cast<int>(i);
    sector.angle[i] = angle;
    sector.angle[i + 1] = -angle;
    Eigen::Matrix2d block;
    block << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    rest.block<2, 2>(i, i) -= block;
    ++i;
  }
  if (!(rest.cwiseAbs().maxCoeff() <= 1e-4)) {
    throw UnsolvedCage("its modes do not turn into each other from pocket to pocket");
  }
  const Eigen::RowVectorXd places =
      Eigen::RowVectorXd::LinSpaced(sector.sectors, 0, static_cast<double>(sector.sectors - 1));
  const MatrixXd turned = sector.angle * places;
  sector.cosine = turned.array().cos();
  sector.sine = turned.array().sin();
}

MatrixXd turn_modes(const SectorTurn& sector, const MatrixXd& rows, Index k) {
  MatrixXd turned(rows.rows(), sector.modes);
  const Index at = (k + sector.sectors) % sector.sectors;
  for (Index i = 0; i < sector.modes; ++i) {
    const Index other = sector.partner[i];
    if (other == i) {
      turned.col(i) = sector.cosine(i, at) * rows.col(i);
    } else {
      turned.col(i) = sector.cosine(i, at) * rows.col(i) - sector.sine(i, at) * rows.col(other);
    }
  }
  return turned;
}

void add_turned(const SectorTurn& sector, const MatrixXd& matrix, Index k, MatrixXd& sum) {
  const auto cosine = sector.cosine.col(k);
  const auto sine = sector.sine.col(k);
  Eigen::VectorXd column(sector.modes);
  for (Index j = 0; j < sector.modes; ++j) {
    // A single mode is its own partner and its sine is zero but for rounding.
    column = cosine[j] * matrix.col(j) - sine[j] * matrix.col(sector.partner[j]);
    for (Index i = j; i < sector.modes; ++i) {
      sum(i, j) += cosine[i] * column[i] - sine[i] * column[sector.partner[i]];
    }
  }
}

MatrixXd seen_coefficients(const SectorTurn& sector, const MatrixXd& coefficients, Index k) {
  MatrixXd seen(coefficients.rows(), sector.seen());
  seen.leftCols(sector.modes) = turn_modes(sector, coefficients, -k);  // R^k turns back as R^-k
  for (Index o = -sector.reach; o <= sector.reach; ++o) {
    seen.middleCols(sector.seen_column(o), sector.per_sector) =
        coefficients.middleCols(sector.local_column(k, o), sector.per_sector);
  }
  return seen;
}

}  // namespace cagetol
