#include "src/operation/operating_clearance.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

/// Speeds of both rings; zero where nothing grows by them [rad/s].
struct GrowingSpeeds {
  double inner = 0, outer = 0;
};
GrowingSpeeds growing_speeds(const Scene& scene) {
  if (!scene.operation.centrifugal_growth) return {};
  return {largest_inner_speed(scene.operation), largest_outer_speed(scene.operation)};
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

struct PartTemperatures {
  double inner_ring, outer_ring, rollers, shaft, housing;
};
PartTemperatures part_temperatures(const Scene& scene) {
  const Temperatures& given = scene.temperature;
  PartTemperatures parts{};
  parts.inner_ring = given_or(given.inner_ring, scene.lubrication.temperature);
  parts.outer_ring = given_or(given.outer_ring, scene.lubrication.temperature);
  parts.rollers = given_or(given.rollers, (parts.inner_ring + parts.outer_ring) / 2);
  parts.shaft = given_or(given.shaft, parts.inner_ring);
  parts.housing = given_or(given.housing, parts.outer_ring);
  return parts;
}

/// Thermal strain of a part.
double heat_of(const Scene& scene, const MaterialChoice& material, double temperature) {
  if (!scene.temperature.growth) return 0;
  return expansion_of(material) * (temperature - scene.temperature.reference);
}

PressFit inner_fit(const Scene& scene, const PartTemperatures& at, double speed) {
  const BearingGeometry& b = scene.bearing;
  const double seat = b.bore_diameter / 2;
  const ThickRing shaft{scene.fit.shaft_bore / 2, seat, properties_of(scene.fit.shaft_material)},
      ring{seat, b.inner_raceway_diameter / 2, ring_material(scene)};
  return {{shaft, heat_of(scene, scene.fit.shaft_material, at.shaft), speed},
          {ring, heat_of(scene, b.ring_material, at.inner_ring), speed},
          scene.fit.inner_interference,
          seat};
}

PressFit outer_fit(const Scene& scene, const PartTemperatures& at, double speed) {
  const BearingGeometry& b = scene.bearing;
  const double seat = b.outside_diameter / 2,
               end = given_or(scene.fit.housing_diameter, std::numeric_limits<double>::infinity());
  const ThickRing ring{b.outer_raceway_diameter / 2, seat, ring_material(scene)},
      housing{seat, end / 2, properties_of(scene.fit.housing_material)};
  const double housing_speed = std::isfinite(end) ? speed : 0;
  return {{ring, heat_of(scene, b.ring_material, at.outer_ring), speed},
          {housing, heat_of(scene, scene.fit.housing_material, at.housing), housing_speed},
          scene.fit.outer_interference,
          seat};
}

/// e of the cage at this speed.
double cage_strain(const Scene& scene, double speed) {
  const CageGeometry& cage = scene.cage;
  const Material material = cage_material(scene);
  const double radius = (cage.inner_diameter + cage.outer_diameter) / 4,
               thickness = (cage.outer_diameter - cage.inner_diameter) / 2,
               length = mean_of(cage.pocket_length);
  const double pockets =
      static_cast<double>(scene.bearing.roller_count) * mean_of(cage.pocket_width) * length;
  const double mass =
      given_or(cage.mass, material.density * thickness *
                              (2 * std::numbers::pi * radius * cage.width - pockets));
  const double section = thickness * (cage.width - length);
  return mass * speed * speed * radius / (2 * std::numbers::pi * material.young * section);
}

/// Growth by rotation of what turns between the rings.
void add_spin(const Scene& scene, const GrowingSpeeds& speeds, OperatingClearance& at) {
  const double inner = scene.bearing.inner_raceway_diameter / 2,
               outer = scene.bearing.outer_raceway_diameter / 2,
               roller = mean_of(scene.roller.diameter) / 2;
  const double cage_speed = (speeds.inner * inner + speeds.outer * outer) / (inner + outer);
  const double roller_speed = (cage_speed * (inner + outer) / 2 - speeds.inner * inner) / roller;
  at.roller_spin = 2 * spinning_growth({0, roller, roller_material(scene)}, roller_speed, roller);
  at.cage_spin = cage_strain(scene, cage_speed);
}

}  // namespace

bool grows_by_rotation(const Scene& scene) {
  const GrowingSpeeds speeds = growing_speeds(scene);
  return speeds.inner != 0 || speeds.outer != 0;
}

bool changes_in_operation(const Scene& scene) {
  return given_or(scene.fit.inner_interference, 0) != 0 ||
         given_or(scene.fit.outer_interference, 0) != 0 || scene.temperature.growth ||
         scene.cage.swelling != 0 || grows_by_rotation(scene);
}

OperatingClearance operating_clearance(const Scene& scene) {
  OperatingClearance at;
  if (!changes_in_operation(scene)) return at;
  const BearingGeometry& b = scene.bearing;
  const PartTemperatures parts = part_temperatures(scene);
  const GrowingSpeeds speeds = growing_speeds(scene);
  const PressFit inner = inner_fit(scene, parts, speeds.inner),
                 outer = outer_fit(scene, parts, speeds.outer);
  at.inner_raceway = fit_growth(inner, true, b.inner_raceway_diameter / 2);
  at.outer_raceway = fit_growth(outer, false, b.outer_raceway_diameter / 2);
  at.bore = fit_growth(inner, true, inner.radius);
  at.outside = fit_growth(outer, false, outer.radius);
  at.inner_fit = fit_state(inner);
  at.outer_fit = fit_state(outer);
  at.inner_ring_heat = inner.outside.heat;
  at.outer_ring_heat = outer.inside.heat;
  at.roller_heat = heat_of(scene, scene.roller.material, parts.rollers);
  at.cage_growth =
      heat_of(scene, scene.cage.material, cage_temperature(scene)) + scene.cage.swelling;
  if (grows_by_rotation(scene)) add_spin(scene, speeds, at);
  return at;
}

}  // namespace cagetol
