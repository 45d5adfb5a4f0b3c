#include "mc/study/key_documentation.hpp"

#include <fmt/format.h>

#include "mc/study/study_keys.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

constexpr const char* kExamples = R"(
# Any number of the scene may be a distribution of deviations from a nominal value:
#   pocket_width_mm = { nominal = 7.65, lot = { law = "normal", sigma = 0.009 }, pocket = { law = "normal", sigma = 0.009 } }
# What a cage must meet, as often as needed:
#   [[limit]]
#   quantity = "whirl_radius_ratio_p95"
#   max = 1.1
#   source = "drawing"
#   cage_revolutions = 6
# A tolerance in question: the width to which the laws belong, and the widths to choose from:
#   [[tolerance.dimension]]
#   key = "cage.pocket_width_mm"
#   tolerance_width_mm = 0.1
#   candidates = ["IT9", "H10", "+0.05/-0.02", 0.08]
# Several operating points, at each of which every sample runs:
#   [[operating_point]]
#   name = "idle"
#   weight = 0.2
#   "load.radial_N" = 150
# Two inputs that deviate together:
#   [[correlation]]
#   between = ["cage.pocket_width_mm:lot", "cage.pocket_length_mm:lot"]
#   rho = 0.5
# What nobody measured, and between which ends it may lie:
#   [[assumption]]
#   key = "lubrication.pocket_layer_um"
#   note = "nobody measured it"
#   low = 5
#   high = 50
)";

// Keys of list entries have no default; the dots of their lists are shown as users write them.
std::string list_rows(const std::vector<KeyInfo>& keys, const std::string& required) {
  std::string text = "| key | unit | range | meaning |\n|---|---|---|---|\n";
  for (const auto& key : keys)
    text += "| `" + key.name + "` | " + key.unit + " | " +
            (key.kind == KeyKind::text ? "text" : range_text(key)) + " | " + key.meaning + " |\n";
  return text + "\n" + required + "\n";
}

std::string young_text(const MaterialPreset& preset) {
  if (preset.young.empty()) return fmt::format("{:g}", 1e-9 * preset.at_room.young);
  std::string text;
  for (const auto& [temperature, young] : preset.young)
    text += fmt::format("{}{:g} at {:g} degC", text.empty() ? "" : ", ", 1e-9 * young, temperature);
  return text;
}

std::string tensile_text(const MaterialPreset& preset) {
  if (preset.softer.empty()) return fmt::format("{:g}", 1e-6 * preset.strength.tensile);
  std::string text;
  for (const auto& [temperature, share] : preset.softer)
    text += fmt::format("{}{:.0f} at {:g} degC", text.empty() ? "" : ", ",
                        1e-6 * share * preset.strength.tensile, temperature);
  return text;
}

std::string material_table() {
  std::string text =
      "| material | Young's modulus, GPa | Poisson's ratio | density, kg/m^3 | expansion, 1e-6/K | "
      "yield stress, MPa | tensile strength, MPa | fatigue strength, MPa | loss factor | source |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const MaterialPreset& preset : material_presets())
    text +=
        fmt::format("| `{}` | {} | {:g} | {:g} | {:g} | {:g} | {} | {:g} | {:g} | {} |\n",
                    preset.name, young_text(preset), preset.at_room.poisson, preset.at_room.density,
                    1e6 * preset.expansion, 1e-6 * preset.strength.yield, tensile_text(preset),
                    1e-6 * preset.strength.fatigue, preset.loss_factor, preset.source);
  return text;
}

}  // namespace

std::string default_scene_text() {
  return "# A scene with every key: the reference bearing NU 205. Keys marked as required must be "
         "given,\n# others keep the value shown here when they are left out.\n" +
         dump_keys(scene_keys(), example_scene());
}

std::string default_study_text() {
  Study study;
  std::string text =
      "# A study with every key at its default. Keys left out keep their default; those of the "
      "scene "
      "that are\n# marked as required must be given, here or in the scene's file.\n";
  text += dump_keys(study_keys(), study) + kExamples;
  return text +
         "\n# The scene. file = \"../scenes/nu205.toml\" below [scene] reads a scene file; keys "
         "given "
         "here replace its keys.\n" +
         dump_keys(scene_keys(), example_scene(), "scene.");
}

std::string key_documentation() {
  std::string text = "## Keys of a scene\n\n" + key_table_markdown(scene_keys(), example_scene());
  text +=
      "\n## Materials\n\nValues of `bearing.ring_material`, `roller.material` and `cage.material`, "
      "for the keys "
      "of the material that are left to auto. They are typical: deliveries scatter, polymers by a "
      "tenth, and "
      "by a third with moisture. Yield stress is the proof stress of metals, the stress at break "
      "of polymers and "
      "ceramics; fatigue strength the amplitude endured fully reversed, of steels 0.45 of the "
      "tensile "
      "strength. At other temperatures yield stress and fatigue strength fall as the tensile "
      "strength "
      "does. Loss factors of metal cages stand for their seats and "
      "joints (assumption).\n\n";
  text += material_table();
  text +=
      "\n## Keys of a study\n\nA study holds its scene below `[scene]`: `file` names a scene file, "
      "relative to "
      "the study; every key of a scene may be given again there, and any number may be a "
      "distribution.\n\n";
  text += key_table_markdown(study_keys(), Study{});
  text += "| `scene.file` | - | none | a path | scene file on which the study builds |\n";
  text += "\n### `[[limit]]`: what a cage must meet\n\n" +
          list_rows(limit_keys(), "`quantity`, `source` and one of `min` and `max` must be given.");
  text += "\n### `[[tolerance.dimension]]`: a tolerance in question\n\n" +
          list_rows(dimension_keys(),
                    "`key`, `tolerance_width_mm` and `candidates` must be given. Costs: for every "
                    "dimension or "
                    "for none; then the cheapest tolerance that meets the target is chosen instead "
                    "of the widest. A candidate scales the laws, which belong to a tolerance that "
                    "lies about the nominal value, and moves them to the middle of its zone.");
  text +=
      "\n### `[[operating_point]]`: where every sample runs\n\n" +
      list_rows(operating_point_keys(),
                "`name` must be given. Keys of the scene stand in quotes (\"load.radial_N\") or "
                "as load.radial_N; a duty in its columns, not as duty.file.");
  text += "\n### `[[correlation]]`: inputs that deviate together\n\n" +
          list_rows(correlation_keys(), "Both must be given.");
  text += "\n### `[[assumption]]`: what nobody measured\n\n" +
          list_rows(assumption_keys(),
                    "`key` and `note` must be given, `low` and `high` both or none. In scenes and "
                    "in studies; an entry of a study replaces its scene's for the same key.");
  return text;
}

}  // namespace cagetol
