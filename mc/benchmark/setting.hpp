// A way to integrate: a method with the tolerance it is run at.
#pragma once

#include <string>
#include <vector>

#include "src/scene/scene.hpp"
#include "src/simulate.hpp"

namespace cagetol {

struct Setting {
  IntegrationMethod method = IntegrationMethod::rodasp;
  double tolerance = 0;  ///< as a multiple of the error scales
};

/// "rodas3 at 0.001".
std::string setting_label(const Setting& setting);

/// The scene's own setting.
Setting setting_of(const Scene& scene);

/// The scene, integrated that way.
Scene with_setting(const Scene& scene, const Setting& setting);

/// Every method there is, in the order of their spellings.
std::vector<IntegrationMethod> all_methods();

/// Each method (all if none is named) at a ladder of tolerances, the scene's own setting first.
std::vector<Setting> setting_ladder(const Scene& scene,
                                    const std::vector<IntegrationMethod>& methods);

/// Options for runs of that scene: the table of its flexible cage, made once for all of them.
SimulateOptions with_cage_table(const Scene& scene);

/// A tight setting of a method of another kind, to hold `method` against: explicit Runge-Kutta for
/// linearly implicit methods, RODASP for all others.
Setting reference_setting(IntegrationMethod method);
/// The two methods that reference_setting() chooses from.
inline constexpr IntegrationMethod kReferenceMethods[] = {IntegrationMethod::rodasp,
                                                          IntegrationMethod::arkode_erk};

}  // namespace cagetol
