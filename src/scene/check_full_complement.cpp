#include <algorithm>
#include <cmath>

#include "src/scene/roller_gap.hpp"
#include "src/scene/scene_check.hpp"

namespace cagetol {

void check_full_complement(const Scene& scene, const SceneCheck& check) {
  const double thickest =
      *std::max_element(scene.roller.diameter.begin(), scene.roller.diameter.end());
  const long most = most_rollers(pitch_radius(scene.bearing), thickest);
  check.require(total_roller_gap(scene) > 0, "bearing.roller_count",
                "so many rollers do not fit beside each other without a cage (" +
                    check.with_value("cage.model") + ", " + check.with_value("roller.diameter_mm") +
                    ", pitch circle " + in_mm(2 * pitch_radius(scene.bearing)) + ")",
                "give at most " + std::to_string(most) + " rollers");
  check.require(scene.start.state != StartState::steady, "start.state",
                "the steady state that is sought is one of rollers in a cage (" +
                    check.with_value("cage.model") + ")",
                "set start.state = \"auto\" or \"equilibrium\"");
}

}  // namespace cagetol
