// A 118 mm roller bearing of an aero engine's main shaft in oil: at 20,000 rpm and a light load its
// cage skids, and takes hundreds of turns to slow down.
#pragma once

#include "src/reading/scene_keys.hpp"

namespace cagetol {

inline Scene aero_bearing(double radial_load) {
  const toml::table table = parse_toml(R"(
name = "aero118"
[bearing]
roller_count = 28
bore_diameter_mm = 118
outside_diameter_mm = 164
width_mm = 22
inner_raceway_diameter_mm = 131.66
outer_raceway_diameter_mm = 157.08
shoulder_diameter_mm = 152.0
internal_clearance_um = 0
flange_clearance_mm = 0.03
[roller]
diameter_mm = 12.65
length_mm = 14.56
profile = "logarithmic"
density_kg_m3 = 7830
[cage]
guidance = "outer"
inner_diameter_mm = 140
outer_diameter_mm = 151.3
width_mm = 21
pocket_width_mm = 12.87
pocket_length_mm = 14.8
[lubrication]
model = "film"
viscosity_Pa_s = 0.0045
pressure_viscosity_1_GPa = 14
[load]
radial_N = 100
[speed]
inner_rpm = 20000
)",
                                       "aero bearing");
  Scene scene = read_scene(table, "aero bearing");
  scene.operation.radial_load = radial_load;
  return scene;
}

}  // namespace cagetol
