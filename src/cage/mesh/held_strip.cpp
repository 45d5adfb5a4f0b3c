#include "src/cage/mesh/held_strip.hpp"

#include <algorithm>

namespace cagetol {

using Eigen::Index;
using Eigen::MatrixXd;

Hex20Nodes strip_element(const Eigen::Matrix3Xd& nodes, const std::array<int, 20>& element) {
  Hex20Nodes at;
  for (std::size_t a = 0; a < 20; ++a) at.col(static_cast<Index>(a)) = nodes.col(element[a]);
  return at;
}

MatrixXd element_values(const std::array<int, 20>& element, const MatrixXd& field) {
  MatrixXd at(60, field.cols());
  for (std::size_t a = 0; a < 20; ++a)
    at.middleRows<3>(3 * static_cast<Index>(a)) = field.middleRows<3>(3 * element[a]);
  return at;
}

/// Calls f(row, column, element, i, j) for the lower triangle of every element between free
/// unknowns.
template <typename F>
void HeldStrip::for_each_entry(F f) const {
  for (std::size_t e = 0; e < strip_.elements.size(); ++e) {
    const auto& element = strip_.elements[e];
    for (int j = 0; j < 60; ++j) {
      const int column = unknown(element, j);
      if (column < 0) continue;
      for (int i = 0; i < 60; ++i)
        if (const int row = unknown(element, i); row >= column) f(row, column, e, i, j);
    }
  }
}

HeldStrip::HeldStrip(const BarStrip& strip, const std::vector<bool>& held)
    : strip_(strip), held_(held), place_(held.size(), -1) {
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i]) place_[i] = free_++;
  std::vector<Eigen::Triplet<double>> entries;
  for_each_entry(
      [&](int row, int column, std::size_t, int, int) { entries.emplace_back(row, column, 1); });
  matrix_.resize(free_, free_);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  slot_.reserve(entries.size());
  for_each_entry([&](int row, int column, std::size_t, int, int) {
    const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    slot_.push_back(static_cast<int>(std::lower_bound(begin, end, row) - matrix_.innerIndexPtr()));
  });
  solver_.analyzePattern(matrix_);
}

void HeldStrip::factorise(const std::vector<Hex20Matrix>& stiffness) {
  stiffness_ = &stiffness;
  double* values = matrix_.valuePtr();
  std::fill(values, values + matrix_.nonZeros(), 0.0);
  std::size_t next = 0;
  for_each_entry(
      [&](int, int, std::size_t e, int i, int j) { values[slot_[next++]] += stiffness[e](i, j); });
  solver_.factorize(matrix_);
}

MatrixXd HeldStrip::solve(const MatrixXd& force, const MatrixXd& driven) const {
  MatrixXd rest = force;
  for (std::size_t e = 0; e < strip_.elements.size(); ++e) {
    const auto& element = strip_.elements[e];
    const bool touches = std::any_of(element.begin(), element.end(), [&](int n) {
      const auto at = static_cast<std::size_t>(3 * n);
      return held_[at] || held_[at + 1] || held_[at + 2];
    });
    if (!touches) continue;
    const MatrixXd pushed = (*stiffness_)[e] * element_values(element, driven);
    for (std::size_t a = 0; a < 20; ++a)
      rest.middleRows<3>(3 * element[a]) -= pushed.middleRows<3>(3 * static_cast<Index>(a));
  }
  MatrixXd right(free_, force.cols());
  for (std::size_t i = 0; i < place_.size(); ++i)
    if (place_[i] >= 0) right.row(place_[i]) = rest.row(static_cast<Index>(i));
  const MatrixXd solved = solver_.solve(right);
  MatrixXd u = driven;
  for (std::size_t i = 0; i < place_.size(); ++i)
    if (place_[i] >= 0) u.row(static_cast<Index>(i)) = solved.row(place_[i]);
  return u;
}

}  // namespace cagetol
