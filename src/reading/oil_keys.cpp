#include "src/reading/oil_keys.hpp"

#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr const char* kGivenTemperatures[] = {
    "lubrication.temperature_C", "cage.temperature_C",    "temperature.inner_ring_C",
    "temperature.outer_ring_C",  "temperature.rollers_C", "temperature.shaft_C",
    "temperature.housing_C"};

}  // namespace

InputError no_word_of_oil(const std::string& who, const std::string& file) {
  return {{file, 0},
          "lubrication.model",
          "",
          who +
              " whether there is oil in the bearing: friction, slip and pocket forces depend on it "
              "more than on any tolerance",
          "give lubrication.model = \"film\" for a bearing with oil, or \"none\" for a dry one "
          "(in a study below [scene], or in the scene file that its scene.file names)"};
}

void leave_temperatures_to_balance(toml::table& below, const toml::table& above) {
  const auto* balance = find_node(above, "temperature.balance");
  if (!balance || !balance->value_or(false) || find_node(below, "temperature.found_C")) return;
  for (const std::string key : kGivenTemperatures) {
    const auto dot = key.find('.');
    if (auto* section = below.get_as<toml::table>(key.substr(0, dot)))
      section->erase(key.substr(dot + 1));
  }
}

void refuse_given_temperatures(const Scene& scene, const toml::table& root,
                               const std::string& file) {
  // What the program writes has all keys.
  if (!scene.temperature.balance || find_node(root, "temperature.found_C")) return;
  for (const char* key : kGivenTemperatures)
    if (const auto* node = find_node(root, key); node && !node->is_string())
      throw InputError(place_of(*node, file), key, shown(*node),
                       "temperature.balance = true finds the temperatures of oil and parts",
                       "leave this key out, or set temperature.balance = false");
}

}  // namespace cagetol
