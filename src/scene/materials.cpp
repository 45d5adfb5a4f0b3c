#include "src/scene/materials.hpp"

#include <stdexcept>

namespace cagetol {
namespace {

/// Linear between the points, constant beyond them; `at_room` where there are none.
double at_temperature(const std::vector<std::array<double, 2>>& points, double at_room,
                      double temperature) {
  if (points.empty()) return at_room;
  if (temperature <= points.front()[0]) return points.front()[1];
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (temperature > points[k][0]) continue;
    const double share = (temperature - points[k - 1][0]) / (points[k][0] - points[k - 1][0]);
    return points[k - 1][1] + share * (points[k][1] - points[k - 1][1]);
  }
  return points.back()[1];
}

}  // namespace

const std::vector<MaterialPreset>& material_presets() {
  // Loss factors: 0.02 of metal cages stands for their seats and joints, the metal alone has some
  // 0.001; of polymers their own. Assumptions all.
  // Fatigue strengths of the cage steels: 0.45 R_m (FKM guideline). Of PA66-GF: a third of the
  // tensile strength, 41 MPa at 1e7 cycles with 30 % glass in bending (ASTM D671, published tables
  // of compounders), also dry (assumption). Of PEEK-CF30: 0.36 of it (assumption).
  static const std::vector<MaterialPreset> presets = {
      {.name = "bearing-steel",
       .at_room = {208e9, 0.30, 7810},
       .expansion = 12e-6,
       .strength = {1700e6, 2200e6, 800e6},
       .loss_factor = 0.02,
       .source = "100Cr6, through hardened; ISO/TS 16281 for steel; fatigue strength: assumption"},
      {.name = "silicon-nitride",
       .at_room = {310e9, 0.26, 3200},
       .expansion = 3.2e-6,
       .strength = {800e6, 800e6, 400e6},
       .loss_factor = 0.02,
       .source =
           "makers' data of bearing grade Si3N4: 300 to 315 GPa, 3.2 g/cm3; bending strength, "
           "half of it as fatigue strength (assumption)"},
      {.name = "steel-q235",
       .at_room = {206e9, 0.30, 7850},
       .expansion = 12e-6,
       .strength = {235e6, 370e6, 165e6},
       .loss_factor = 0.02,
       .source = "GB/T 700; the cage of Xin et al. 2024 (doi 10.3390/app14209433)"},
      {.name = "steel-sheet",
       .at_room = {210e9, 0.30, 7850},
       .expansion = 12e-6,
       .strength = {210e6, 270e6, 120e6},
       .loss_factor = 0.02,
       .source = "EN 10130, DC04 and its like"},
      {.name = "aisi-4340",
       .at_room = {205e9, 0.29, 7850},
       .expansion = 12.3e-6,
       .strength = {860e6, 930e6, 420e6},
       .loss_factor = 0.02,
       .source = "AMS 6415 tempered to 28 to 36 HRC; a silver plating changes the friction only"},
      {.name = "cast-iron",
       .at_room = {110e9, 0.26, 7200},
       .expansion = 10.5e-6,
       .strength = {165e6, 250e6, 90e6},
       .loss_factor = 0.02,
       .source = "EN 1561, EN-GJL-250: 103 to 118 GPa; expansion near room temperature"},
      {.name = "aluminium-cast",
       .at_room = {75e9, 0.33, 2650},
       .expansion = 21e-6,
       .strength = {180e6, 220e6, 80e6},
       .loss_factor = 0.02,
       .source =
           "EN 1706, AC-43000 (AlSi10Mg) T6 from sand moulds; fatigue strength 80 to 110 MPa"},
      {.name = "brass-cuzn40pb2",
       .at_room = {102e9, 0.34, 8430},
       .expansion = 20.4e-6,
       .strength = {230e6, 410e6, 138e6},
       .loss_factor = 0.02,
       .source =
           "EN 12164, machined; moduli of CuZn40 are 97 to 102 GPa, strengths at least those of "
           "temper R410; fatigue strength of the like CuZn36Pb3 half hard at 1e8 cycles (ASM)"},
      {.name = "pa66-gf25",
       .at_room = {5.2e9, 0.38, 1320},
       .expansion = 30e-6,
       .strength = {120e6, 120e6, 40e6},
       .loss_factor = 0.06,
       .source = "polyamide 66 with 25 % glass, conditioned in humid air (50 %), along the flow; "
                 "typical of data sheets",
       .young = {{23, 5.2e9}, {60, 4.2e9}, {90, 3.9e9}, {120, 3.5e9}, {150, 2.9e9}},
       .softer = {{23, 1}, {60, 0.79}, {90, 0.68}, {120, 0.60}, {150, 0.52}}},
      {.name = "pa66-gf25-dry",
       .at_room = {8.0e9, 0.38, 1320},
       .expansion = 30e-6,
       .strength = {170e6, 170e6, 57e6},
       .loss_factor = 0.03,
       .source = "the same as moulded",
       .young = {{23, 8.0e9}, {60, 6.0e9}, {90, 4.2e9}, {120, 3.5e9}, {150, 2.9e9}},
       .softer = {{23, 1}, {60, 0.74}, {90, 0.58}, {120, 0.50}, {150, 0.42}}},
      {.name = "peek-cf30",
       .at_room = {22.8e9, 0.40, 1480},
       .expansion = 15e-6,
       .strength = {210e6, 210e6, 75e6},
       .loss_factor = 0.02,
       .source = "PEEK with 30 % carbon fibre and PTFE, along the flow; data sheet LATILUB "
                 "88/10-15T K/30; strengths over temperature typical of PEEK-CF30",
       .young = {{23, 22.8e9}, {60, 22.0e9}, {90, 20.0e9}, {120, 17.6e9}, {150, 13.2e9}},
       .softer = {{23, 1}, {60, 0.87}, {90, 0.76}, {120, 0.65}, {150, 0.46}}},
  };
  return presets;
}

const MaterialPreset& material_named(const std::string& name) {
  for (const MaterialPreset& preset : material_presets())
    if (preset.name == name) return preset;
  throw std::domain_error("material: there is none called '" + name + "'");
}

Material properties_of(const MaterialChoice& material, double temperature) {
  const MaterialPreset& preset = material_named(material.name);
  return {given_or(material.young, at_temperature(preset.young, preset.at_room.young, temperature)),
          given_or(material.poisson, preset.at_room.poisson),
          given_or(material.density, preset.at_room.density)};
}

double expansion_of(const MaterialChoice& material) {
  return given_or(material.expansion, material_named(material.name).expansion);
}

bool is_polymer(const MaterialChoice& material) {
  return !material_named(material.name).young.empty();
}

bool softens(const MaterialChoice& material) {
  return std::isnan(material.young) && is_polymer(material);
}

double cage_temperature(const Scene& scene) {
  return given_or(scene.cage.temperature, scene.lubrication.temperature);
}

Material cage_material(const Scene& scene) {
  return properties_of(scene.cage.material, cage_temperature(scene));
}

Strength cage_strength(const Scene& scene) {
  const CageGeometry& cage = scene.cage;
  const MaterialPreset& preset = material_named(cage.material.name);
  const double left = at_temperature(preset.softer, 1, cage_temperature(scene));
  return {given_or(cage.yield_stress, left * preset.strength.yield),
          given_or(cage.tensile_strength, left * preset.strength.tensile),
          given_or(cage.fatigue_strength, left * preset.strength.fatigue)};
}

Material roller_material(const Scene& scene) {
  return properties_of(scene.roller.material, scene.lubrication.temperature);
}

Material ring_material(const Scene& scene) {
  return properties_of(scene.bearing.ring_material, scene.lubrication.temperature);
}

double mode_damping(const CageGeometry& cage) {
  return given_or(cage.mode_damping, material_named(cage.material.name).loss_factor / 2);
}

}  // namespace cagetol
