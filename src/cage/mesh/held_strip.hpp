// Linear elasticity of a bar strip (bar_strip.hpp) with some of its unknowns held at given values.
#pragma once

#include <Eigen/CholmodSupport>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "src/cage/mesh/bar_strip.hpp"
#include "src/cage/mesh/hex20.hpp"

namespace cagetol {

using Hex20Matrix = Eigen::Matrix<double, 60, 60>;

Hex20Nodes strip_element(const Eigen::Matrix3Xd& nodes, const std::array<int, 20>& element);

/// Rows of a field at the nodes of an element.
Eigen::MatrixXd element_values(const std::array<int, 20>& element, const Eigen::MatrixXd& field);

/// The pattern of the matrix and its order of elimination serve all deviations.
class HeldStrip {
 public:
  /// `held`: of each unknown 3 node + direction. Keeps a reference to `strip`.
  HeldStrip(const BarStrip& strip, const std::vector<bool>& held);

  /// `stiffness` of each element; kept by reference for solve().
  void factorise(const std::vector<Hex20Matrix>& stiffness);

  /// Displacement under nodal forces; held unknowns have their values in `driven`, whose other rows
  /// are zero.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& force, const Eigen::MatrixXd& driven) const;

 private:
  template <typename F>
  void for_each_entry(F f) const;
  int unknown(const std::array<int, 20>& element, int i) const {
    return place_[static_cast<std::size_t>(3 * element[static_cast<std::size_t>(i / 3)] + i % 3)];
  }

  const BarStrip& strip_;
  std::vector<bool> held_;
  std::vector<int> place_;  ///< of each unknown among the free ones, -1: held
  int free_ = 0;
  Eigen::SparseMatrix<double> matrix_;
  std::vector<int> slot_;  ///< in the matrix, of each entry of each element
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver_;
  const std::vector<Hex20Matrix>* stiffness_ = nullptr;
};

}  // namespace cagetol
