// Scenes that ship with the program, and single quantities of an outcome, for tests.
#pragma once

#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "src/input/toml_file.hpp"
#include "src/quantities/outcome.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/reading/scene_keys.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {

inline Scene shipped_scene(const std::string& name) {
  const std::string path = shipped("scenes/" + name + ".toml");
  return read_scene(read_toml(path), path);
}

/// The same with dry contacts.
inline Scene dry_scene(const std::string& name) {
  Scene scene = shipped_scene(name);
  scene.lubrication.model = LubricationModel::none;
  return scene;
}

inline double quantity(const Outcome& outcome, const std::string& key) {
  const int index = quantity_index(key);
  if (index < 0 || outcome.quantities.empty()) {
    ADD_FAILURE() << "no quantity " << key;
    return std::numeric_limits<double>::quiet_NaN();
  }
  return outcome.quantities[static_cast<std::size_t>(index)];
}

}  // namespace cagetol
