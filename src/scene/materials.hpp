// Named materials of cages, rollers, rings, shafts and housings: the values of the material keys
// that are left to auto. Strengths and moduli of one name scatter between deliveries, of polymers
// by a tenth and with moisture by a third: a measured value goes into the key of its own.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "src/scene/scene.hpp"

namespace cagetol {

struct MaterialPreset {
  std::string name;
  Material at_room;        ///< at 20 degC
  double expansion = 0;    ///< linear thermal expansion [1/K]
  Strength strength;       ///< at 20 degC
  double loss_factor = 0;  ///< of a cage as it runs, its joints and seats included
  std::string source;
  /// Young's modulus over temperature, ascending [degC, Pa]; empty: that of 20 degC at any.
  std::vector<std::array<double, 2>> young = {};
  /// Strengths over those of 20 degC, likewise; the fatigue strength falls as the tensile strength
  /// does (assumption).
  std::vector<std::array<double, 2>> softer = {};
};
const std::vector<MaterialPreset>& material_presets();

/// Throws std::domain_error where no preset has this name.
const MaterialPreset& material_named(const std::string& name);

/// The given properties, the others of the named material at `temperature` [degC].
Material properties_of(const MaterialChoice& material, double temperature = 20);

/// Linear thermal expansion, given or of the named material [1/K].
double expansion_of(const MaterialChoice& material);

/// Whether the named material is a polymer, which takes up water.
bool is_polymer(const MaterialChoice& material);

/// Whether its modulus depends on the temperature.
bool softens(const MaterialChoice& material);

/// Of the cage: that of the oil where it is not given [degC].
double cage_temperature(const Scene& scene);

/// Materials as a scene runs.
Material cage_material(const Scene& scene);
/// Strengths of the cage at its temperature.
Strength cage_strength(const Scene& scene);
Material roller_material(const Scene& scene);
Material ring_material(const Scene& scene);

/// Damping ratio of the cage's elastic modes: half its loss factor where it is not given.
double mode_damping(const CageGeometry& cage);

}  // namespace cagetol
