// Scenes of the reference bearing with some keys changed, for tests: a scene file must give its
// geometry, and a test wants to show only what it is about.
#pragma once

#include <sstream>
#include <string>

#include "src/reading/scene_keys.hpp"

namespace cagetol {

/// The required keys of the reference bearing, those of dynamic scenes included, and those of
/// `text` as that says. Nodes of `text`
/// keep their places as lines of `name`.
inline toml::table reference_scene_table(const std::string& text, const std::string& name) {
  KeyTable<Scene> keys;
  for (const auto& key : scene_keys())
    if (key.range.required || !key.range.required_where.empty()) keys.push_back(key);
  toml::table root = parse_toml(dump_keys(keys, example_scene()), "reference scene");
  merge_tables(root, parse_toml(text, name), is_distribution);
  return root;
}

/// The same as the text of a file.
inline std::string reference_scene_text(const std::string& text = "") {
  std::ostringstream out;
  out << toml::toml_formatter(reference_scene_table(text, "test")) << '\n';
  return out.str();
}

/// The reference bearing without its section [lubrication], and with `text` in front.
inline std::string reference_scene_without_oil(const std::string& text = "") {
  toml::table root = reference_scene_table(text, "test");
  root.erase("lubrication");
  std::ostringstream out;
  out << toml::toml_formatter(root) << '\n';
  return out.str();
}

}  // namespace cagetol
