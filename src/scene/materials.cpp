#include "src/scene/materials.hpp"

#include <stdexcept>

namespace cagetol {
namespace {

/// Linear between the points, constant beyond them.
double young_at(const MaterialPreset& preset, double temperature) {
  const auto& points = preset.young;
  if (points.empty()) return preset.at_room.young;
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
  static const std::vector<MaterialPreset> presets = {
      {"bearing-steel",
       {208e9, 0.30, 7810},
       1700e6,
       0.02,
       "100Cr6, through hardened; ISO/TS 16281 for steel"},
      {"silicon-nitride",
       {310e9, 0.26, 3200},
       800e6,
       0.02,
       "makers' data of bearing grade Si3N4: 300 to 315 GPa, 3.2 g/cm3; bending strength"},
      {"steel-q235",
       {206e9, 0.30, 7850},
       235e6,
       0.02,
       "GB/T 700; the cage of Xin et al. 2024 (doi 10.3390/app14209433)"},
      {"steel-sheet", {210e9, 0.30, 7850}, 210e6, 0.02, "EN 10130, DC04 and its like"},
      {"aisi-4340",
       {205e9, 0.29, 7850},
       860e6,
       0.02,
       "AMS 6415 tempered to 28 to 36 HRC; a silver plating changes the friction only"},
      {"brass-cuzn40pb2",
       {102e9, 0.34, 8430},
       230e6,
       0.02,
       "EN 12164, machined; moduli of CuZn40 are 97 to 102 GPa, proof stress at least 230 MPa as "
       "drawn"},
      {"pa66-gf25",
       {5.2e9, 0.38, 1320},
       120e6,
       0.06,
       "polyamide 66 with 25 % glass, conditioned in humid air (50 %); typical of data sheets",
       {{23, 5.2e9}, {60, 4.2e9}, {90, 3.9e9}, {120, 3.5e9}, {150, 2.9e9}}},
      {"pa66-gf25-dry",
       {8.0e9, 0.38, 1320},
       170e6,
       0.03,
       "the same as moulded",
       {{23, 8.0e9}, {60, 6.0e9}, {90, 4.2e9}, {120, 3.5e9}, {150, 2.9e9}}},
      {"peek-cf30",
       {22.8e9, 0.40, 1480},
       210e6,
       0.02,
       "PEEK with 30 % carbon fibre and PTFE, along the flow; data sheet LATILUB 88/10-15T K/30",
       {{23, 22.8e9}, {60, 22.0e9}, {90, 20.0e9}, {120, 17.6e9}, {150, 13.2e9}}},
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
  return {given_or(material.young, young_at(preset, temperature)),
          given_or(material.poisson, preset.at_room.poisson),
          given_or(material.density, preset.at_room.density)};
}

bool softens(const MaterialChoice& material) {
  return std::isnan(material.young) && !material_named(material.name).young.empty();
}

Material cage_material(const Scene& scene) {
  return properties_of(scene.cage.material,
                       given_or(scene.cage.temperature, scene.lubrication.temperature));
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
