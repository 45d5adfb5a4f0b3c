#include <cmath>
#include <utility>

#include "src/operation/operating_clearance.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/reading/scene_check.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/pocket_clearances.hpp"

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

/// Elastic strain that no part of a bearing bears.
constexpr double kLargestStrain = 0.01;

// Thick rings are elastic.
void check_strains(const Scene& scene, const SceneCheck& check) {
  const auto& bearing = scene.bearing;
  const OperatingClearance by = operating_clearance(scene);
  const auto held = [&](double growth, double diameter) {
    return std::abs(growth) <= kLargestStrain * diameter;
  };
  check.require(held(by.inner_raceway.fit, bearing.inner_raceway_diameter),
                "fit.inner_interference_um", "it would strain the inner ring by more than 1 %",
                "give the interference of diameters in micrometres");
  check.require(held(by.outer_raceway.fit, bearing.outer_raceway_diameter),
                "fit.outer_interference_um", "it would strain the outer ring by more than 1 %",
                "give the interference of diameters in micrometres");
  check.require(held(by.inner_raceway.spin, bearing.inner_raceway_diameter) &&
                    held(by.outer_raceway.spin, bearing.outer_raceway_diameter) &&
                    by.cage_spin <= kLargestStrain &&
                    held(by.roller_spin, each(scene.roller.diameter, 0)),
                "speed.inner_rpm", "rotation would strain ring, cage or rollers by more than 1 %",
                "correct speed, diameters, moduli or densities");
}

// A bearing that can be assembled may seize in operation.
void check_in_operation(const Scene& scene, const SceneCheck& check) {
  if (!changes_in_operation(scene)) return;
  check_strains(scene, check);
  const OperatingScene hot = scene;
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const auto& b = hot.bearing;
    const double roller = each(hot.roller.diameter, j),
                 clearance = b.outer_raceway_diameter - b.inner_raceway_diameter - 2 * roller +
                             b.internal_clearance;
    check.require(std::abs(clearance) < roller / 10, "bearing.internal_clearance_um",
                  "in operation (fits, heat, moisture, rotation) it becomes " + in_um(clearance) +
                      ", more than a tenth of the roller's diameter",
                  "correct fits and temperatures");
  }
  const auto say = [](const std::string& what, double clearance) {
    return "in operation (fits, heat, moisture, rotation) " + what + ", by " + in_um(-clearance);
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
    for (const int end : {0, 1})
      check.require(
          !(left.radial[end] <= 0),
          !std::isnan(scene.cage.face_radius) ? "cage.face_radius_mm"
          : end == 0                          ? "cage.retention_width_inner_mm"
                                              : "cage.retention_width_outer_mm",
          say("pocket " + std::to_string(j) + " pinches its roller radially", left.radial[end]),
          "give a wider opening, or correct the temperatures");
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

/// Share of a raceway's curvature that a wave may change: rollers are taken to meet a circle.
constexpr double kFlattest = 0.1;

void check_waviness(const Scene& scene, const SceneCheck& check) {
  const auto& b = scene.bearing;
  for (const bool inner : {true, false}) {
    const double radius = (inner ? b.inner_raceway_diameter : b.outer_raceway_diameter) / 2;
    int n = 0;
    for (const Waviness& waves : inner ? b.inner_waviness : b.outer_waviness) {
      const std::string name =
          std::string(inner ? "waviness.inner_" : "waviness.outer_") + std::to_string(++n);
      const double k = static_cast<double>(waves.count);
      check.require(k * k * std::abs(waves.amplitude) < kFlattest * radius, name + "_um",
                    "with so many waves (" + check.with_value(name + "_count") +
                        ") the waves change the raceway's curvature by more than a tenth",
                    "give a smaller amplitude or fewer waves");
    }
  }
}

}  // namespace

void check_operation(const Scene& scene, const SceneCheck& check) {
  check_fits(scene, check);
  check.require(
      scene.cage.swelling == 0 || is_polymer(scene.cage.material), "cage.swelling_percent",
      "a cage of this material takes up no water (" + check.with_value("cage.material") + ")",
      "set 0, or name a polymer as its material; moduli and strengths may be given");
  check_waviness(scene, check);
  check_in_operation(scene, check);
}

}  // namespace cagetol
