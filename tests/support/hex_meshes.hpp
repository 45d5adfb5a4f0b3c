// Simple meshes of hexahedra for element tests.
#pragma once

#include <cmath>
#include <numbers>

#include "src/cage/mesh/cage_mesh.hpp"

namespace cagetol::test {

/// A box of nx x ny x nz elements between the origin and `size`.
inline HexMesh box_mesh(const Eigen::Vector3d& size, int nx, int ny, int nz) {
  HexMesh mesh;
  mesh.nodes.resize(3, (nx + 1) * (ny + 1) * (nz + 1));
  const auto at = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        mesh.nodes.col(at(i, j, k)) << size[0] * i / nx, size[1] * j / ny, size[2] * k / nz;
      }
    }
  }
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        mesh.elements.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
                                 at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
                                 at(i, j + 1, k + 1)});
      }
    }
  }
  return mesh;
}

/// A plain ring about x: nr through the thickness, nc around, nx along the width.
inline HexMesh ring_mesh(double inner, double outer, double width, int nr, int nc, int nx) {
  HexMesh mesh;
  mesh.nodes.resize(3, (nr + 1) * nc * (nx + 1));
  const auto at = [&](int r, int c, int x) { return (x * nc + c % nc) * (nr + 1) + r; };
  for (int x = 0; x <= nx; ++x) {
    for (int c = 0; c < nc; ++c) {
      for (int r = 0; r <= nr; ++r) {
        const double radius = inner + (outer - inner) * r / nr;
        const double theta = 2 * std::numbers::pi * c / nc;
        mesh.nodes.col(at(r, c, x)) << width * x / nx - 0.5 * width, radius * std::cos(theta),
            radius * std::sin(theta);
      }
    }
  }
  for (int x = 0; x < nx; ++x) {
    for (int c = 0; c < nc; ++c) {
      for (int r = 0; r < nr; ++r) {
        mesh.elements.push_back({at(r, c, x), at(r + 1, c, x), at(r + 1, c + 1, x), at(r, c + 1, x),
                                 at(r, c, x + 1), at(r + 1, c, x + 1), at(r + 1, c + 1, x + 1),
                                 at(r, c + 1, x + 1)});
      }
    }
  }
  return mesh;
}

}  // namespace cagetol::test
