// A scene of the program that is set like the planar reference (planar_bearing_reference.hpp): what
// that leaves out is switched off, the rest is taken from it. No constraint holds the rollers in
// the plane. Every section of this bearing is alike, so nothing moves them out of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/model/state.hpp"
#include "src/scene/scene.hpp"
#include "tests/support/planar_bearing_reference.hpp"

namespace cagetol {

inline Scene planar_scene(const PlanarBearing& bearing) {
  Scene scene;  // NU 205 with straight rollers and one slice
  scene.operation.gravity = 0;
  scene.operation.radial_load = bearing.load;
  scene.operation.inner_speed = bearing.inner_speed;
  scene.discretisation.race_slices = scene.discretisation.bar_stations = 1;
  scene.cage.pocket_width = {2 * (bearing.roller_radius + bearing.half_clearance)};
  scene.cage.polar_inertia = bearing.cage_inertia;
  // So heavy that no force moves it from the middle, where it touches no land.
  scene.cage.mass = 1e6;
  scene.cage.transverse_inertia = 1e3;
  // Perfectly elastic bodies: only oil damps.
  scene.contact.race.restitution = scene.contact.bar.restitution = 1;
  scene.contact.friction_static = bearing.friction.static_coefficient;
  scene.contact.friction_dynamic = bearing.friction.dynamic_coefficient;
  scene.contact.static_speed = bearing.friction.static_speed;
  scene.contact.dynamic_speed = bearing.friction.dynamic_speed;
  Lubrication& oil = scene.lubrication;
  oil.model = LubricationModel::film;
  oil.viscosity = bearing.oil.viscosity;
  oil.pressure_viscosity = bearing.oil.pressure_viscosity;
  oil.eyring_stress = bearing.oil.eyring;
  oil.limiting_shear = bearing.oil.limiting;
  oil.race_roughness = bearing.oil.race_roughness;
  oil.pocket_roughness = bearing.oil.pocket_roughness;
  oil.race_layer = bearing.oil.race_layer;
  oil.outer_layer = bearing.oil.outer_layer > 0 ? bearing.oil.outer_layer
                                                : std::numeric_limits<double>::infinity();
  oil.pocket_layer = bearing.oil.pocket_layer;
  oil.inlet_heating = oil.churning = oil.land_film = false;
  return scene;
}

/// Largest magnitude of the rollers' axial places, tilts and skews, and of their rates, each in its
/// SI unit. Zero to the bit throughout a run of planar_scene().
inline double out_of_plane(const StateLayout& l, const double* y) {
  double most = 0;
  for (int j = 0; j < l.rollers; ++j) {
    for (const RollerPosition slot : {kAxial, kAxisY, kAxisZ})
      most = std::max(most, std::abs(y[l.position(slot, j)]));
    for (const RollerVelocity slot : {kAxialSpeed, kAxisRateY, kAxisRateZ})
      most = std::max(most, std::abs(y[l.velocity(slot, j)]));
  }
  return most;
}

}  // namespace cagetol
