#include "src/cage/mesh/sector_polynomial.hpp"

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <numbers>

namespace cagetol {
namespace {

using Point = std::array<double, 4>;

Point scaled(const PocketDeviation& deviation, const PocketDeviation& range) {
  return {deviation.width / range.width, deviation.length / range.length,
          deviation.pitch / range.pitch, deviation.squareness / range.squareness};
}

PocketDeviation unscaled(const Point& p, const PocketDeviation& range) {
  return {p[0] * range.width, p[1] * range.length, p[2] * range.pitch, p[3] * range.squareness};
}

}  // namespace

PocketDeviation table_range(const CageDimensions& cage) {
  const double half_bar =
      cage.inner_radius * (std::numbers::pi / static_cast<double>(cage.pocket_count) -
                           std::asin(0.5 * cage.pocket_width / cage.inner_radius));
  const double side = 0.5 * (cage.width - cage.pocket_length);
  return {.width = 0.5 * half_bar,
          .length = 0.2 * side,
          .pitch = 0.25 * half_bar / cage.inner_radius,
          .squareness = 0.15 * half_bar / (0.5 * cage.width)};
}

bool inside_range(const PocketDeviation& deviation, const PocketDeviation& range) {
  for (double p : scaled(deviation, range)) {
    if (!(std::abs(p) <= 1 + 1e-9)) return false;
  }
  return true;
}

Eigen::VectorXd polynomial_terms(const PocketDeviation& deviation, const PocketDeviation& range) {
  const Point p = scaled(deviation, range);
  Eigen::VectorXd terms(19);
  Eigen::Index next = 0;
  terms[next++] = 1;
  for (double value : p) terms[next++] = value;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i; j < 4; ++j) terms[next++] = p[i] * p[j];
  }
  const double s = p[0];
  const double l = p[1];
  terms.tail<4>() << s * s * s, s * s * l, s * l * l, l * l * l;
  return terms;
}

std::vector<PocketDeviation> polynomial_samples(const PocketDeviation& range) {
  std::vector<Point> points{{0, 0, 0, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    for (double value : {-1.0, -0.5, 0.5, 1.0}) {
      Point point{};
      point[i] = value;
      points.push_back(point);
    }
    for (std::size_t j = i + 1; j < 4; ++j) {
      for (double a : {-0.7, 0.7}) {
        for (double b : {-0.7, 0.7}) {
          Point point{};
          point[i] = a;
          point[j] = b;
          points.push_back(point);
        }
      }
    }
  }
  std::vector<PocketDeviation> samples;
  for (const Point& point : points) samples.push_back(unscaled(point, range));
  return samples;
}

Eigen::MatrixXd fit_polynomial(const Eigen::MatrixXd& values, const PocketDeviation& range) {
  const std::vector<PocketDeviation> samples = polynomial_samples(range);
  const auto count = static_cast<Eigen::Index>(samples.size());
  const Eigen::Index terms = polynomial_terms({}, range).size();
  Eigen::MatrixXd rises(count - 1, terms - 1);
  for (Eigen::Index i = 1; i < count; ++i) {
    rises.row(i - 1) =
        polynomial_terms(samples[static_cast<std::size_t>(i)], range).tail(terms - 1).transpose();
  }
  const Eigen::MatrixXd inverse = rises.completeOrthogonalDecomposition().pseudoInverse();
  Eigen::MatrixXd coefficients(values.rows(), terms);
  coefficients.col(0) = values.col(0);
  coefficients.rightCols(terms - 1).noalias() =
      (values.rightCols(count - 1).colwise() - values.col(0)) * inverse.transpose();
  return coefficients;
}

}  // namespace cagetol
