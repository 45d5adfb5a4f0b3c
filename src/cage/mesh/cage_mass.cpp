#include "src/cage/mesh/cage_mass.hpp"

#include <cmath>
#include <numbers>

#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

/// Moments of the strip |t| < half inside the circle of radius R, for the half plane of positive
/// radial direction n: area, integral of n, integral of n^2 and integral of t^2. Closed forms of
/// integrals of sqrt(R^2 - t^2) over t.
struct Strip {
  double area, first, radial_second, tangential_second;
};

Strip strip(double radius, double half) {
  const double h = half, r2 = radius * radius, root = std::sqrt(r2 - h * h),
               angle = std::asin(h / radius);
  Strip s;
  s.area = h * root + r2 * angle;    // 2 int_0^h sqrt(R^2 - t^2)
  s.first = r2 * h - h * h * h / 3;  // int_0^h (R^2 - t^2)
  const double quartic = h * root * root * root / 4 + 3 * r2 / 8 * (h * root + r2 * angle);
  s.radial_second = 2.0 / 3 * quartic;  // 2/3 int_0^h (R^2 - t^2)^(3/2)
  s.tangential_second = 2 * (r2 / 8 * (h * root + r2 * angle) - h * root * root * root / 4);
  return s;  // 2 int_0^h t^2 sqrt(R^2 - t^2)
}

}  // namespace

CageMass cage_mass(const CageGeometry& cage, long roller_count) {
  const double rho = properties_of(cage.material).density, ro = cage.outer_diameter / 2,
               ri = cage.inner_diameter / 2;
  const double w = cage.width, ro2 = ro * ro, ri2 = ri * ri;
  CageMass m;
  m.mass = rho * w * std::numbers::pi * (ro2 - ri2);
  double polar = m.mass * (ro2 + ri2) / 2;
  double transverse = m.mass * (3 * (ro2 + ri2) + w * w) / 12;
  double first_y = 0, first_z = 0;
  for (long j = 0; j < roller_count; ++j) {
    const double length = each(cage.pocket_length, j), half = each(cage.pocket_width, j) / 2;
    const Strip outer = strip(ro, half), inner = strip(ri, half);
    const double line = rho * length;
    const double mass = line * (outer.area - inner.area);
    const double first = line * (outer.first - inner.first);
    const double second = line * (outer.radial_second - inner.radial_second +
                                  outer.tangential_second - inner.tangential_second);
    const double angle =
        2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(roller_count) +
        each(cage.pocket_pitch, j);
    m.mass -= mass;
    first_y -= first * std::cos(angle);
    first_z -= first * std::sin(angle);
    polar -= second;
    transverse -= second / 2 + mass * length * length / 12;
  }
  m.centre_y = first_y / m.mass;
  m.centre_z = first_z / m.mass;
  const double e2 = m.centre_y * m.centre_y + m.centre_z * m.centre_z;
  m.polar_inertia = polar - m.mass * e2;
  m.transverse_inertia = transverse - m.mass * e2 / 2;
  return m;
}

}  // namespace cagetol
