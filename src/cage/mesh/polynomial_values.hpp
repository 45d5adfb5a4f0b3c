// Values of the table's polynomials (sector_polynomial.hpp) at the deviations of every sector: the
// product of coefficients (polynomials x terms) and terms (terms x sectors).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace cagetol {

/// Values of a strip of polynomials for `count` sectors from the k-th on. Enough sums run side by
/// side to hide the latency of multiplications, and all of them stay in registers.
template <int count, Eigen::Index strip, typename Matrix>
void strip_values(const Matrix& coefficients, const Matrix& terms,
                  const std::vector<Eigen::Index>& acting, Eigen::Index from, Eigen::Index k,
                  Eigen::Index to, Matrix& values) {
  using Scalar = typename Matrix::Scalar;
  Eigen::Array<Scalar, strip, 1> sum[count];
#pragma GCC unroll 8
  for (int i = 0; i < count; ++i) sum[i].setZero();
  for (const Eigen::Index t : acting) {
    const Eigen::Array<Scalar, strip, 1> coefficient =
        coefficients.template block<strip, 1>(from, t).array();
#pragma GCC unroll 8
    for (int i = 0; i < count; ++i) sum[i] += coefficient * terms(t, k + i);
  }
#pragma GCC unroll 8
  for (int i = 0; i < count; ++i) values.template block<strip, 1>(to, k + i) = sum[i];
}

/// Terms that are not zero in at least one sector.
template <typename Matrix>
std::vector<Eigen::Index> acting_terms(const Matrix& terms) {
  std::vector<Eigen::Index> acting;
  for (Eigen::Index t = 0; t < terms.rows(); ++t)
    if ((terms.row(t).array() != 0).any()) acting.push_back(t);
  return acting;
}

/// Values of polynomials at the deviations of every sector (coefficients times terms): `rows`
/// polynomials from number `from` on, written to row `to` of the values and below. A general matrix
/// product would spend more time on packing than on multiplying. Most of the time goes into reading
/// coefficients, so those of terms that are not `acting` are skipped.
template <typename Matrix>
void put_values(const Matrix& coefficients, const Matrix& terms,
                const std::vector<Eigen::Index>& acting, Eigen::Index from, Eigen::Index rows,
                Eigen::Index to, Matrix& values) {
  constexpr Eigen::Index strip = 64 / sizeof(typename Matrix::Scalar);
  constexpr Eigen::Index together = 8;
  using Values = void (*)(const Matrix&, const Matrix&, const std::vector<Eigen::Index>&,
                          Eigen::Index, Eigen::Index, Eigen::Index, Matrix&);
  constexpr Values of[together + 1] = {
      nullptr,
      strip_values<1, strip, Matrix>,
      strip_values<2, strip, Matrix>,
      strip_values<3, strip, Matrix>,
      strip_values<4, strip, Matrix>,
      strip_values<5, strip, Matrix>,
      strip_values<6, strip, Matrix>,
      strip_values<7, strip, Matrix>,
      strip_values<8, strip, Matrix>,
  };
  if (rows < strip) {
    values.middleRows(to, rows) = coefficients.middleRows(from, rows).lazyProduct(terms);
    return;
  }
  for (Eigen::Index begin = 0; begin < rows; begin += strip) {
    const Eigen::Index row = std::min(begin, rows - strip);  // the last two strips may overlap
    for (Eigen::Index k = 0; k < terms.cols(); k += together)
      of[std::min(together, terms.cols() - k)](coefficients, terms, acting, from + row, k, to + row,
                                               values);
  }
}

/// Values of all polynomials.
template <typename Matrix>
Matrix polynomial_values(const Matrix& coefficients, const Matrix& terms) {
  Matrix values(coefficients.rows(), terms.cols());
  put_values(coefficients, terms, acting_terms(terms), 0, values.rows(), 0, values);
  return values;
}

}  // namespace cagetol
