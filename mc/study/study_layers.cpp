#include "mc/study/study_layers.hpp"

#include <algorithm>
#include <filesystem>

#include "mc/study/study_keys.hpp"
#include "src/reading/assumptions.hpp"
#include "src/reading/oil_keys.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

std::string first_part(const std::string& key) {
  return key.substr(0, key.find('.'));
}

bool is_study(const toml::table& root) {
  return std::any_of(root.begin(), root.end(), [](const auto& item) {
    return is_study_section(std::string(item.first.str()));
  });
}

toml::table study_of_scene(toml::table scene) {
  toml::table study;
  if (const auto* name = scene.get_as<std::string>("name")) study.insert("name", name->get());
  study.insert("samples", 1);
  study.insert("scene", std::move(scene));
  return study;
}

// A setting may name a scene key without "scene."; a misspelt one belongs to where its nearest key
// is.
std::string with_scene_prefix(const std::string& setting) {
  const std::string key = setting_key(setting);
  const std::string section = first_part(key);
  if (section == "name" || section == "assumption" || is_study_section(section)) return setting;
  if (is_scene_section(section)) return "scene." + setting;
  std::vector<std::string> names;
  for (const auto& known : study_keys()) names.push_back(known.name);
  for (const auto& known : scene_keys()) names.push_back(known.name);
  return find_key(scene_keys(), nearest_name(key, names)) ? "scene." + setting : setting;
}

// A distribution that names no nominal value keeps the one that stands in the file below it.
void inherit_nominals(toml::table& base, toml::table& overrides) {
  for (auto&& [key, node] : overrides) {
    auto* upper = node.as_table();
    auto* lower = base.get(key.str());
    if (!upper || !lower) continue;
    auto* lower_table = lower->as_table();
    if (is_distribution(*upper)) {
      if (upper->contains("nominal")) continue;
      auto* nominal = lower_table ? lower_table->get("nominal") : lower;
      if (nominal)
        std::move(*nominal).visit(
            [&](auto&& value) { upper->insert("nominal", std::forward<decltype(value)>(value)); });
    } else if (lower_table) {
      inherit_nominals(*lower_table, *upper);
    }
  }
}

// Entries of an upper layer replace those for the same keys below it and leave the others.
void inherit_assumptions(toml::table& base, toml::table& overrides) {
  auto* lower = base.get_as<toml::array>("assumption");
  auto* upper = overrides.get_as<toml::array>("assumption");
  if (lower && upper) add_assumptions(std::move(*lower), *upper);
}

// Those of the study itself belong to its scene.
void move_assumptions(toml::table& root) {
  auto* own = root.get_as<toml::array>("assumption");
  if (!own) return;
  toml::table overrides;
  overrides.insert("assumption", std::move(*own));
  root.erase("assumption");
  auto* scene = root.get_as<toml::table>("scene");
  if (!scene) scene = root.insert("scene", toml::table{}).first->second.as_table();
  inherit_assumptions(*scene, overrides);
  scene->insert_or_assign("assumption", std::move(*overrides.get_as<toml::array>("assumption")));
}

void load_scene_file(toml::table& root, const std::string& path) {
  auto* scene = root.get_as<toml::table>("scene");
  const auto* file = scene ? scene->get("file") : nullptr;
  if (!file) return;
  const auto name = file->value<std::string>();
  const auto place = place_of(*file, path);
  if (!name)
    throw InputError(place, "scene.file", shown(*file), "this is not the name of a file",
                     "give the path of a scene file in quotes, relative to this file");
  const auto folder = std::filesystem::path(place.file).parent_path();  // of "--set": here
  const auto scene_path = (folder / *name).lexically_normal().string();
  toml::table base;
  try {
    base = read_toml(scene_path);
  } catch (const InputError& error) {
    if (std::filesystem::is_regular_file(scene_path)) throw;
    throw InputError(place, "scene.file", shown(*file), error.what(),
                     "give the path of a scene file, relative to the file that names it");
  }
  toml::table overrides = std::move(*scene);
  overrides.erase("file");
  inherit_nominals(base, overrides);
  inherit_assumptions(base, overrides);
  leave_temperatures_to_balance(base, overrides);
  merge_tables(base, std::move(overrides), is_distribution);
  root.insert_or_assign("scene", std::move(base));
}

}  // namespace

toml::table study_layers(const std::string& path, const std::vector<std::string>& settings) {
  return study_layers(read_toml(path), path, settings);
}

toml::table study_layers(toml::table root, const std::string& path,
                         const std::vector<std::string>& settings) {
  if (!is_study(root)) root = study_of_scene(std::move(root));
  std::vector<std::string> later;
  for (const auto& setting : settings) {
    const std::string complete = with_scene_prefix(setting);
    if (setting_key(complete) == "scene.file")
      apply_setting(root, complete);
    else
      later.push_back(complete);
  }
  if (root.contains("scene") && !root.get("scene")->is_table()) return root;
  load_scene_file(root, path);
  move_assumptions(root);
  // Settings are a layer too: a distribution set from the command line keeps the nominal value
  // below it.
  toml::table set;
  for (const auto& setting : later) apply_setting(set, setting);
  inherit_nominals(root, set);
  move_assumptions(set);
  if (auto* scene = root.get_as<toml::table>("scene"), *upper = set.get_as<toml::table>("scene");
      scene && upper) {
    inherit_assumptions(*scene, *upper);
    leave_temperatures_to_balance(*scene, *upper);
  }
  merge_tables(root, std::move(set), [&](const toml::table& table) {
    return is_distribution(table) && table.contains("law");
  });
  return root;
}

}  // namespace cagetol
