#include "src/cage/mesh/hex20.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "src/cage/mesh/hex8_incompatible.hpp"

namespace cagetol {
namespace {

using Shape20Derivatives = Eigen::Matrix<double, 3, 20>;

constexpr std::array<std::array<double, 3>, 20> kNode = {
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
     {-1, 1, 1},   {0, -1, -1}, {1, 0, -1},  {0, 1, -1},  {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},
     {0, 1, 1},    {-1, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},   {-1, 1, 0}}};

/// One factor of a shape function: linear, or quadratic along the edge that the node halves.
double factor(double node, double xi) {
  return node == 0 ? 1 - xi * xi : 1 + node * xi;
}
double factor_slope(double node, double xi) {
  return node == 0 ? -2 * xi : node;
}

Shape20Derivatives local_derivatives(const Eigen::Vector3d& xi) {
  Shape20Derivatives value;
  for (int a = 0; a < 20; ++a) {
    const auto& n = kNode[static_cast<std::size_t>(a)];
    double f[3], slope[3], toward = -2;
    for (int i = 0; i < 3; ++i) {
      f[i] = factor(n[static_cast<std::size_t>(i)], xi[i]);
      slope[i] = factor_slope(n[static_cast<std::size_t>(i)], xi[i]);
      toward += n[static_cast<std::size_t>(i)] * xi[i];
    }
    for (int i = 0; i < 3; ++i) {
      const double others = f[(i + 1) % 3] * f[(i + 2) % 3];
      value(i, a) =
          a < 8 ? 0.125 * others * (slope[i] * toward + f[i] * n[static_cast<std::size_t>(i)])
                : 0.25 * slope[i] * others;
    }
  }
  return value;
}

Eigen::Vector3d gauss20(int g) {
  return hex8_corner(g) / std::sqrt(3.0);
}

/// Derivatives with respect to x, y, z, and the Jacobian's determinant.
Shape20Derivatives derivatives(const Hex20Nodes& nodes, const Eigen::Vector3d& xi,
                               double& determinant) {
  const Shape20Derivatives local = local_derivatives(xi);
  const Eigen::Matrix3d jacobian = local * nodes.transpose();
  determinant = jacobian.determinant();
  return jacobian.inverse() * local;
}

Hex20Strain strain_of(const Shape20Derivatives& slope) {
  Hex20Strain b = Hex20Strain::Zero();
  for (int a = 0; a < 20; ++a) {
    const double dx = slope(0, a), dy = slope(1, a), dz = slope(2, a);
    b(0, 3 * a) = b(3, 3 * a + 1) = b(5, 3 * a + 2) = dx;
    b(1, 3 * a + 1) = b(3, 3 * a) = b(4, 3 * a + 2) = dy;
    b(2, 3 * a + 2) = b(4, 3 * a + 1) = b(5, 3 * a) = dz;
  }
  return b;
}

}  // namespace

const std::array<double, 3>& hex20_node(int a) {
  return kNode[static_cast<std::size_t>(a)];
}

Eigen::Matrix<double, 20, 1> hex20_shape(const Eigen::Vector3d& xi) {
  Eigen::Matrix<double, 20, 1> value;
  for (int a = 0; a < 20; ++a) {
    const auto& n = kNode[static_cast<std::size_t>(a)];
    const double product = factor(n[0], xi[0]) * factor(n[1], xi[1]) * factor(n[2], xi[2]);
    value[a] =
        a < 8 ? 0.125 * product * (n[0] * xi[0] + n[1] * xi[1] + n[2] * xi[2] - 2) : 0.25 * product;
  }
  return value;
}

Eigen::Matrix<double, 60, 60> hex20_stiffness(const Hex20Nodes& nodes, const Material& material) {
  const Eigen::Matrix<double, 6, 6> d = elasticity(material);
  Eigen::Matrix<double, 60, 60> stiffness = Eigen::Matrix<double, 60, 60>::Zero();
  constexpr double weight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  const double place[3] = {-std::sqrt(0.6), 0, std::sqrt(0.6)};
  for (int g = 0; g < 27; ++g) {
    const int i = g / 9, j = g / 3 % 3, k = g % 3;
    double determinant = 0;
    const Hex20Strain b =
        strain_of(derivatives(nodes, {place[i], place[j], place[k]}, determinant));
    if (!(determinant > 0)) throw std::domain_error("an element is turned inside out");
    const Hex20Strain db = (weight[i] * weight[j] * weight[k] * determinant * d) * b;
    stiffness.noalias() += b.transpose() * db;
  }
  return stiffness;
}

Eigen::Matrix<double, 20, 20> hex20_mass(const Hex20Nodes& nodes, double density) {
  Eigen::Matrix<double, 20, 20> mass = Eigen::Matrix<double, 20, 20>::Zero();
  for (int g = 0; g < 8; ++g) {
    double determinant = 0;
    derivatives(nodes, gauss20(g), determinant);
    const Eigen::Matrix<double, 20, 1> n = hex20_shape(gauss20(g));
    mass.noalias() += density * determinant * n * n.transpose();
  }
  return mass;
}

Hex20Strain hex20_node_strain(const Hex20Nodes& nodes, int a) {
  const auto& n = hex20_node(a);
  Hex20Strain strain = Hex20Strain::Zero();
  for (int g = 0; g < 8; ++g) {
    const Eigen::Vector3d corner = hex8_corner(g);
    double weight = 0.125, determinant = 0;
    for (int i = 0; i < 3; ++i)
      weight *= 1 + std::sqrt(3.0) * n[static_cast<std::size_t>(i)] * corner[i];
    strain += weight * strain_of(derivatives(nodes, gauss20(g), determinant));
  }
  return strain;
}

}  // namespace cagetol
