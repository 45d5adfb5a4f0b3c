// The temperature at which a nominal bearing sheds the power that it loses, by short runs of it
// with a rigid cage: losses fall as the oil warms, what is shed grows
// (src/operation/heat_shed.hpp).
#pragma once

#include <string>

#include "src/scene/scene.hpp"

namespace cagetol {

/// The scene at its temperature, with what was found (Temperatures::found); itself where nothing is
/// to be found. Equal for any machine that runs it: rounded to 0.01 K. Throws InputError where the
/// bearing cannot shed its power below kHottest, or has more than one temperature, or does not run.
/// The first run is at the temperature `first` [degC]; kAuto: 30 K above where nothing is shed.
Scene with_temperature_found(const Scene& scene, double first = kAuto);

/// A sentence where the bearing loses more than it sheds at the temperature that the scene gives,
/// by one short run; empty where it does not, is dry, or does not run.
std::string temperature_doubt(const Scene& scene);
/// Likewise, of a bearing known to lose `power` [W]; NaN: not known, no doubt.
std::string temperature_doubt(const Scene& scene, double power);

inline constexpr double kHottestBalance = 250;  ///< [degC]

}  // namespace cagetol
