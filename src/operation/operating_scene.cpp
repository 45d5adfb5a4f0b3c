#include "src/operation/operating_scene.hpp"

#include "src/operation/operating_clearance.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

/// Volume grows by heat and moisture, mass does not.
void keep_mass(MaterialChoice& material, double g) {
  material.density = properties_of(material).density / ((1 + g) * (1 + g) * (1 + g));
}

void grow_rings(const OperatingClearance& by, double roller_length, BearingGeometry& b) {
  const auto grown = [&](double clearance, double heat) {
    return clearance + (roller_length + clearance) * heat - roller_length * by.roller_heat;
  };
  if (b.inner_flanges != FlangeSides::none)
    b.inner_flange_clearance =
        grown(given_or(b.inner_flange_clearance, b.flange_clearance), by.inner_ring_heat);
  b.flange_clearance = grown(b.flange_clearance, by.outer_ring_heat);
  // What stands on a ring moves with its raceway.
  for (double* diameter : {&b.inner_land_diameter, &b.inner_flange_diameter})
    *diameter += *diameter * by.inner_ring_heat + by.inner_raceway.total() -
                 b.inner_raceway_diameter * by.inner_ring_heat;
  for (double* diameter : {&b.outer_land_diameter, &b.shoulder_diameter})
    *diameter += *diameter * by.outer_ring_heat + by.outer_raceway.total() -
                 b.outer_raceway_diameter * by.outer_ring_heat;
  b.inner_raceway_diameter += by.inner_raceway.total();
  b.outer_raceway_diameter += by.outer_raceway.total();
  b.bore_diameter += by.bore.total();
  b.outside_diameter += by.outside.total();
  b.width *= 1 + by.inner_ring_heat;
  keep_mass(b.ring_material, by.inner_ring_heat);
}

void grow_rollers(const OperatingClearance& by, RollerGeometry& roller) {
  for (double* length : {&roller.length, &roller.corner_radius, &roller.end_radius})
    *length *= 1 + by.roller_heat;
  for (auto* lengths : {&roller.diameter, &roller.taper}) scale(*lengths, 1 + by.roller_heat);
  for (double& diameter : roller.diameter) diameter += by.roller_spin;
  keep_mass(roller.material, by.roller_heat);
}

/// `guide` is the growth of the radius of the ring that guides the cage [m].
void grow_cage(const OperatingClearance& by, double guide, CageGeometry& cage) {
  const double every = 1 + by.cage_growth, around = every * (1 + by.cage_spin);
  const double radius =
      (cage.guidance == Guidance::inner ? cage.inner_diameter : cage.outer_diameter) / 2;
  const double outwards = guide - radius * (around - 1);
  cage.guide_clearance += cage.guidance == Guidance::inner ? -outwards : outwards;
  for (double* length : {&cage.inner_diameter, &cage.outer_diameter, &cage.face_radius})
    *length *= around;
  for (double* length :
       {&cage.width, &cage.land_offset, &cage.land_width, &cage.edge_radius, &cage.corner_radius})
    *length *= every;
  for (auto* lengths : {&cage.pocket_width, &cage.retention_inner, &cage.retention_outer})
    scale(*lengths, around);
  scale(cage.pocket_length, every);
  keep_mass(cage.material, by.cage_growth);
}

}  // namespace

OperatingScene::OperatingScene(const Scene& as_made) : Scene(as_made) {
  if (!changes_in_operation(as_made)) return;
  const OperatingClearance by = operating_clearance(as_made);
  grow_rings(by, as_made.roller.length, bearing);
  grow_rollers(by, roller);
  const auto land = cage.guidance == Guidance::inner ? inner_land_diameter : outer_land_diameter;
  grow_cage(by, (land(bearing) - land(as_made.bearing)) / 2, cage);
  fit.inner_interference = fit.outer_interference = kAuto;
  temperature.growth = operation.centrifugal_growth = false;
  cage.swelling = 0;
}

}  // namespace cagetol
