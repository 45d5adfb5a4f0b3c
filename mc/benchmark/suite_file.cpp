#include <filesystem>

#include "mc/benchmark/stability.hpp"
#include "mc/study/sample.hpp"
#include "src/input/toml_file.hpp"

namespace cagetol {
namespace {

constexpr const char* kRemedy =
    "write [[scene]] with name = \"...\", file = \"SCENE.toml\" and, if wanted, set = "
    "[\"key = value\", ...] and fast = true";

std::vector<std::string> settings_of(const toml::table& table, const std::string& path) {
  std::vector<std::string> settings;
  const toml::node* node = table.get("set");
  if (!node) return settings;
  const toml::array* list = node->as_array();
  if (!list)
    throw InputError(place_of(*node, path), "set", shown(*node), "expected an array of texts",
                     kRemedy);
  for (const toml::node& element : *list) {
    const auto text = element.value<std::string>();
    if (!text)
      throw InputError(place_of(element, path), "set", shown(element), "expected a text", kRemedy);
    settings.push_back(*text);
  }
  return settings;
}

std::string text_of(const toml::table& table, const char* key, const std::string& path) {
  const auto text = table[key].value<std::string>();
  if (!text)
    throw InputError(place_of(table, path), std::string("scene.") + key, "", "missing or no text",
                     kRemedy);
  return *text;
}

void refuse_unknown(const toml::table& table, const std::string& path,
                    std::initializer_list<const char*> known) {
  for (const auto& [key, node] : table) {
    bool found = false;
    for (const char* name : known) found = found || key.str() == name;
    if (!found)
      throw InputError(place_of(node, path), std::string(key.str()), shown(node), "no such key",
                       kRemedy);
  }
}

}  // namespace

std::vector<SuiteScene> read_suite(const std::string& path) {
  const toml::table root = read_toml(path);
  refuse_unknown(root, path, {"common", "scene"});
  std::vector<std::string> common;
  if (const toml::table* table = root["common"].as_table()) common = settings_of(*table, path);
  const toml::array* scenes = root["scene"].as_array();
  if (!scenes) throw InputError({path, 0}, "scene", "", "the suite holds no scene", kRemedy);
  std::vector<SuiteScene> suite;
  for (const toml::node& node : *scenes) {
    const toml::table* table = node.as_table();
    if (!table)
      throw InputError(place_of(node, path), "scene", shown(node), "expected a table", kRemedy);
    refuse_unknown(*table, path, {"name", "file", "set", "fast"});
    std::vector<std::string> settings = common;
    for (std::string& setting : settings_of(*table, path)) settings.push_back(std::move(setting));
    const auto file = std::filesystem::path(path).parent_path() / text_of(*table, "file", path);
    const Study study = read_study(file.string(), settings);
    suite.push_back({text_of(*table, "name", path), draw_sample(study, 0).scene,
                     (*table)["fast"].value_or(false)});
  }
  return suite;
}

}  // namespace cagetol
