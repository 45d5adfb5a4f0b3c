#include "src/cage/mesh/cage_mass.hpp"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <numbers>

#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

/// Integrals of 1, y, z, y^2, z^2 over one pocket's cross-section (the strip |t| < half between the
/// two circles on its own side), by Gauss-Legendre panels across the strip, radially in closed form
/// of nothing but powers.
struct Section {
  double area = 0, y = 0, z = 0, yy = 0, zz = 0;
};

Section pocket_section(double inner, double outer, double half, double angle) {
  const std::array<double, 5> node = {-0.9061798459386640, -0.5384693101056831, 0,
                                      0.5384693101056831, 0.9061798459386640};
  const std::array<double, 5> weight = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                        0.4786286704993665, 0.2369268850561891};
  Section s;
  const int panels = 60;
  const double c = std::cos(angle), d = std::sin(angle);
  for (int p = 0; p < panels; ++p)
    for (std::size_t a = 0; a < 5; ++a) {
      const double t = half * (-1 + (2 * p + 1 + node[a]) / panels), dt = half / panels * weight[a];
      const double low = std::sqrt(inner * inner - t * t), high = std::sqrt(outer * outer - t * t);
      for (std::size_t b = 0; b < 5; ++b) {  // quadratic in n: exact
        const double n = (low + high) / 2 + (high - low) / 2 * node[b],
                     dA = dt * (high - low) / 2 * weight[b];
        const double y = n * c - t * d, z = n * d + t * c;
        s.area += dA;
        s.y += dA * y;
        s.z += dA * z;
        s.yy += dA * y * y;
        s.zz += dA * z * z;
      }
    }
  return s;
}

/// The same cage by quadrature.
CageMass by_quadrature(const CageGeometry& cage, long pockets) {
  const double rho = properties_of(cage.material).density, ri = cage.inner_diameter / 2,
               ro = cage.outer_diameter / 2, w = cage.width;
  const double disc = rho * w * pi * (ro * ro - ri * ri),
               disc_yy = rho * w * pi * (std::pow(ro, 4) - std::pow(ri, 4)) / 4;
  double m = disc, y = 0, z = 0, yy = disc_yy, zz = disc_yy, xx = disc * w * w / 12;
  for (long j = 0; j < pockets; ++j) {
    const double angle =
        2 * pi * static_cast<double>(j) / static_cast<double>(pockets) + each(cage.pocket_pitch, j);
    const double length = each(cage.pocket_length, j);
    const Section s = pocket_section(ri, ro, each(cage.pocket_width, j) / 2, angle);
    m -= rho * length * s.area;
    y -= rho * length * s.y;
    z -= rho * length * s.z;
    yy -= rho * length * s.yy;
    zz -= rho * length * s.zz;
    xx -= rho * length * s.area * length * length / 12;
  }
  CageMass result{m, y / m, z / m, 0, 0};
  const double cy = result.centre_y, cz = result.centre_z;
  result.polar_inertia = yy + zz - m * (cy * cy + cz * cz);
  result.transverse_inertia = xx + (yy + zz) / 2 - m * (cy * cy + cz * cz) / 2;
  return result;
}

void expect_same(const CageMass& a, const CageMass& b) {
  EXPECT_NEAR(a.mass, b.mass, 1e-12 * b.mass);
  EXPECT_NEAR(a.centre_y, b.centre_y, 1e-14);
  EXPECT_NEAR(a.centre_z, b.centre_z, 1e-14);
  EXPECT_NEAR(a.polar_inertia, b.polar_inertia, 1e-12 * b.polar_inertia);
  EXPECT_NEAR(a.transverse_inertia, b.transverse_inertia, 1e-12 * b.transverse_inertia);
}

TEST(CageMass, ClosedFormAgreesWithQuadrature) {
  CageGeometry cage;
  expect_same(cage_mass(cage, 13), by_quadrature(cage, 13));
  cage.inner_diameter = 62e-3;
  cage.outer_diameter = 70e-3;
  cage.pocket_width = {9.2e-3};
  cage.pocket_length = {10.2e-3};
  cage.width = 16e-3;
  expect_same(cage_mass(cage, 16), by_quadrature(cage, 16));
}

TEST(CageMass, DeviatingPocketsUnbalance) {
  CageGeometry cage;
  cage.pocket_width.assign(13, 7.65e-3);
  cage.pocket_length.assign(13, 9.25e-3);
  cage.pocket_pitch.assign(13, 0);
  cage.pocket_width[3] = 7.95e-3;
  cage.pocket_length[7] = 9.05e-3;
  cage.pocket_pitch[11] = 4e-3;
  expect_same(cage_mass(cage, 13), by_quadrature(cage, 13));
}

TEST(CageMass, OneWidePocketMovesTheCentreAwayFromIt) {
  CageGeometry cage;
  cage.pocket_width.assign(13, 7.65e-3);
  cage.pocket_width[0] = 7.75e-3;
  const CageMass m = cage_mass(cage, 13);
  // Missing: 0.1 mm wide, 9.25 mm long, 3.2 mm deep (chord heights differ little) at the mean
  // radius of 20.1 mm.
  const double missing = 7850 * 0.1e-3 * 9.25e-3 * 3.2e-3;
  EXPECT_NEAR(m.centre_y, -missing * 20.1e-3 / m.mass, 0.02 * std::abs(m.centre_y));
  EXPECT_NEAR(m.centre_z, 0, 1e-15);
}

TEST(CageMass, UniformCageIsBalanced) {
  const CageMass m = cage_mass(CageGeometry{}, 13);
  EXPECT_NEAR(m.centre_y, 0, 1e-17);
  EXPECT_NEAR(m.centre_z, 0, 1e-17);
}

}  // namespace
}  // namespace cagetol
