#include <cmath>
#include <utility>

#include "src/scene/operating_clearance.hpp"
#include "src/scene/pocket_clearances.hpp"
#include "src/scene/scene_check.hpp"

namespace cagetol {
namespace {

void check_fits(const Scene& scene, const SceneCheck& check) {
  const auto& bearing = scene.bearing;
  check.require(scene.fit.shaft_bore < bearing.bore_diameter, "fit.shaft_bore_mm",
                "the shaft has no wall: its bore is not smaller than the bearing's (" +
                    check.with_value("bearing.bore_diameter_mm") + ")",
                "give a smaller bore, 0 for a solid shaft");
  check.require(!(scene.fit.housing_diameter <= bearing.outside_diameter),
                "fit.housing_diameter_mm",
                "the housing has no wall: its outside is not larger than the bearing's (" +
                    check.with_value("bearing.outside_diameter_mm") + ")",
                "give a larger diameter, or \"auto\" for a large housing");
  const Temperatures& t = scene.temperature;
  for (const auto& [key, temperature] :
       {std::pair{"temperature.inner_ring_C", t.inner_ring},
        std::pair{"temperature.outer_ring_C", t.outer_ring},
        std::pair{"temperature.rollers_C", t.rollers}, std::pair{"temperature.shaft_C", t.shaft},
        std::pair{"temperature.housing_C", t.housing}})
    check.require(t.growth || std::isnan(temperature), key,
                  "no part grows by heat (" + check.with_value("temperature.growth") + ")",
                  "set temperature.growth = true, or leave the temperature out");
}

// A bearing that can be assembled may seize in operation.
void check_in_operation(const Scene& scene, const SceneCheck& check) {
  if (!changes_in_operation(scene)) return;
  const Scene hot = operating_scene(scene);
  const auto say = [](const std::string& what, double clearance) {
    return "in operation (fits, temperatures, centrifugal growth) " + what + ", by " +
           in_um(-clearance);
  };
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const PocketClearances left = pocket_clearances(hot, j);
    const std::string pocket = "pocket " + std::to_string(j) + " is not ";
    check.require(left.tangential > 0 || scene.allow_interference, "cage.pocket_width_mm",
                  say(pocket + "wider than its roller", left.tangential),
                  "give a wider pocket, or correct the temperatures");
    check.require(left.axial > 0 || scene.allow_interference, "cage.pocket_length_mm",
                  say(pocket + "longer than its roller", left.axial),
                  "give a longer pocket, or correct the temperatures");
  }
  const PocketClearances left = pocket_clearances(hot, 0);
  check.require(left.ring[0] > 0, "cage.inner_diameter_mm",
                say("the cage seizes on the inner ring", left.ring[0]),
                "give a larger inner diameter of the cage, or correct fits and temperatures");
  check.require(left.ring[1] > 0, "cage.outer_diameter_mm",
                say("the cage seizes in the outer ring", left.ring[1]),
                "give a smaller outer diameter of the cage, or correct fits and temperatures");
  check.require(left.flange >= 0, "bearing.flange_clearance_mm",
                say("the rollers do not fit between their flanges", left.flange),
                "give a larger clearance, or correct the temperatures");
}

}  // namespace

void check_operation(const Scene& scene, const SceneCheck& check) {
  check_fits(scene, check);
  check_in_operation(scene, check);
}

}  // namespace cagetol
