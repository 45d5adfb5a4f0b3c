#include "src/cage/mesh/hex8_incompatible.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace cagetol {
namespace {

using ShapeDerivatives = Eigen::Matrix<double, 3, 8>;
using StrainMatrix = Eigen::Matrix<double, 6, 33>;

constexpr std::array<std::array<double, 3>, 8> kCorner = {{{-1, -1, -1},
                                                           {1, -1, -1},
                                                           {1, 1, -1},
                                                           {-1, 1, -1},
                                                           {-1, -1, 1},
                                                           {1, -1, 1},
                                                           {1, 1, 1},
                                                           {-1, 1, 1}}};

Eigen::Matrix<double, 8, 1> shape(const Eigen::Vector3d& xi) {
  Eigen::Matrix<double, 8, 1> value;
  for (int a = 0; a < 8; ++a) {
    const auto& c = kCorner[static_cast<std::size_t>(a)];
    value[a] = 0.125 * (1 + c[0] * xi[0]) * (1 + c[1] * xi[1]) * (1 + c[2] * xi[2]);
  }
  return value;
}

ShapeDerivatives shape_derivatives(const Eigen::Vector3d& xi) {
  ShapeDerivatives value;
  for (int a = 0; a < 8; ++a) {
    const auto& c = kCorner[static_cast<std::size_t>(a)];
    const double f0 = 1 + c[0] * xi[0];
    const double f1 = 1 + c[1] * xi[1];
    const double f2 = 1 + c[2] * xi[2];
    value.col(a) << 0.125 * c[0] * f1 * f2, 0.125 * f0 * c[1] * f2, 0.125 * f0 * f1 * c[2];
  }
  return value;
}

Eigen::Vector3d gauss_point(int g) {
  return hex8_corner(g) / std::sqrt(3.0);
}

/// Jacobian dx/dxi: row i is the derivative of the position with respect to xi_i.
Eigen::Matrix3d jacobian(const Hex8Nodes& nodes, const ShapeDerivatives& derivatives) {
  return derivatives * nodes.transpose();
}

struct PointDerivatives {
  Hex8Derivatives derivatives;
  double determinant = 0;
};

PointDerivatives derivatives_at(const Hex8Nodes& nodes, const Eigen::Matrix3d& centre_inverse,
                                double centre_determinant, const Eigen::Vector3d& xi) {
  const ShapeDerivatives local = shape_derivatives(xi);
  const Eigen::Matrix3d j = jacobian(nodes, local);
  PointDerivatives point;
  point.determinant = j.determinant();
  point.derivatives.leftCols<8>() = j.inverse() * local;
  const Eigen::Vector3d bubble = -2 * xi * (centre_determinant / point.determinant);
  point.derivatives.rightCols<3>() = centre_inverse * bubble.asDiagonal();
  return point;
}

StrainMatrix strain_matrix(const Hex8Derivatives& derivatives) {
  StrainMatrix b = StrainMatrix::Zero();
  for (int a = 0; a < 11; ++a) {
    const double dx = derivatives(0, a);
    const double dy = derivatives(1, a);
    const double dz = derivatives(2, a);
    b(0, 3 * a) = dx;
    b(1, 3 * a + 1) = dy;
    b(2, 3 * a + 2) = dz;
    b(3, 3 * a) = dy;
    b(3, 3 * a + 1) = dx;
    b(4, 3 * a + 1) = dz;
    b(4, 3 * a + 2) = dy;
    b(5, 3 * a) = dz;
    b(5, 3 * a + 2) = dx;
  }
  return b;
}

Eigen::Matrix<double, 6, 24> eliminate_internal(const StrainMatrix& b,
                                                const Hex8Internal& internal) {
  return b.leftCols<24>() + b.rightCols<9>() * internal;
}

}  // namespace

Eigen::Vector3d hex8_corner(int a) {
  const auto& c = kCorner[static_cast<std::size_t>(a)];
  return {c[0], c[1], c[2]};
}

Hex8Nodes element_nodes(const HexMesh& mesh, const std::array<int, 8>& element) {
  Hex8Nodes nodes;
  for (int a = 0; a < 8; ++a) nodes.col(a) = mesh.nodes.col(element[static_cast<std::size_t>(a)]);
  return nodes;
}

double hex8_smallest_jacobian(const Hex8Nodes& nodes) {
  double smallest = jacobian(nodes, shape_derivatives(Eigen::Vector3d::Zero())).determinant();
  for (int a = 0; a < 8; ++a) {
    smallest = std::min(smallest, jacobian(nodes, shape_derivatives(hex8_corner(a))).determinant());
  }
  return smallest;
}

Eigen::Matrix<double, 6, 6> elasticity(const Material& material) {
  const double nu = material.poisson;
  const double shear = material.young / (2 * (1 + nu));
  const double lame = 2 * shear * nu / (1 - 2 * nu);
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
  d.topLeftCorner<3, 3>().setConstant(lame);
  d.topLeftCorner<3, 3>().diagonal().array() += 2 * shear;
  d.bottomRightCorner<3, 3>().diagonal().setConstant(shear);
  return d;
}

Hex8 hex8_stiffness(const Hex8Nodes& nodes, const Material& material) {
  const Eigen::Matrix3d centre = jacobian(nodes, shape_derivatives(Eigen::Vector3d::Zero()));
  const Eigen::Matrix3d centre_inverse = centre.inverse();
  const double centre_determinant = centre.determinant();
  const Eigen::Matrix<double, 6, 6> d = elasticity(material);
  Eigen::Matrix<double, 33, 33> full = Eigen::Matrix<double, 33, 33>::Zero();
  for (int g = 0; g < 8; ++g) {
    const PointDerivatives point =
        derivatives_at(nodes, centre_inverse, centre_determinant, gauss_point(g));
    const StrainMatrix b = strain_matrix(point.derivatives);
    const StrainMatrix db = point.determinant * (d * b);
    full.noalias() += b.transpose() * db;
  }
  Hex8 element;
  const Eigen::Matrix<double, 9, 9> inner = full.bottomRightCorner<9, 9>();
  const Hex8Internal coupling = full.bottomLeftCorner<9, 24>();
  element.internal = -inner.llt().solve(coupling);
  element.stiffness = full.topLeftCorner<24, 24>();
  element.stiffness.noalias() += coupling.transpose() * element.internal;
  return element;
}

Eigen::Matrix<double, 8, 8> hex8_mass(const Hex8Nodes& nodes, double density) {
  Eigen::Matrix<double, 8, 8> mass = Eigen::Matrix<double, 8, 8>::Zero();
  for (int g = 0; g < 8; ++g) {
    const Eigen::Vector3d xi = gauss_point(g);
    const Eigen::Matrix<double, 8, 1> n = shape(xi);
    const double weight = density * jacobian(nodes, shape_derivatives(xi)).determinant();
    mass.noalias() += weight * n * n.transpose();
  }
  return mass;
}

std::array<Eigen::Matrix<double, 6, 24>, 8> hex8_corner_strain(const Hex8Nodes& nodes,
                                                               const Hex8Internal& internal) {
  const Eigen::Matrix3d centre = jacobian(nodes, shape_derivatives(Eigen::Vector3d::Zero()));
  const Eigen::Matrix3d centre_inverse = centre.inverse();
  std::array<Eigen::Matrix<double, 6, 24>, 8> at_gauss;
  std::array<Eigen::Matrix<double, 6, 24>, 8> at_corner;
  for (int g = 0; g < 8; ++g) {
    const auto point =
        derivatives_at(nodes, centre_inverse, centre.determinant(), gauss_point(g)).derivatives;
    at_gauss[static_cast<std::size_t>(g)] = eliminate_internal(strain_matrix(point), internal);
  }
  for (int a = 0; a < 8; ++a) {
    // Gauss points are the corners of a cube 1/sqrt(3) the size; the corner lies at sqrt(3) in its
    // frame.
    const Eigen::Matrix<double, 8, 1> weight = shape(std::sqrt(3.0) * hex8_corner(a));
    auto& strain = at_corner[static_cast<std::size_t>(a)];
    strain.setZero();
    for (int g = 0; g < 8; ++g) strain += weight[g] * at_gauss[static_cast<std::size_t>(g)];
  }
  return at_corner;
}

}  // namespace cagetol
