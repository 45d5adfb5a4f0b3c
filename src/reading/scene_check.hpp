// What the checks of a scene share (check_scene.cpp, check_operation.cpp).
#pragma once

#include <cmath>
#include <string>

#include "src/reading/scene_keys.hpp"

namespace cagetol {

/// Writes the errors: where the key stands, what it disagrees with.
class SceneCheck {
 public:
  SceneCheck(const Scene& scene, const std::string& file, const toml::table* root)
      : scene_(scene), file_(file), root_(root) {}

  /// Throws, naming `key` with its value, unless `condition` holds.
  void require(bool condition, const std::string& key, const std::string& problem,
               const std::string& remedy) const {
    if (condition) return;
    const auto* node = root_ ? find_node(*root_, key) : nullptr;
    throw InputError(node ? place_of(*node, file_) : SourcePlace{file_, 0}, key, value(key),
                     problem, remedy);
  }

  /// "roller.diameter_mm = 7.5".
  std::string with_value(const std::string& key) const { return key + " = " + value(key); }

 private:
  std::string value(const std::string& key) const {
    constexpr std::size_t longest = 60;
    const std::string text = key_text(*find_key(scene_keys(), key), scene_);
    return text.size() > longest ? text.substr(0, longest - 3) + "..." : text;
  }

  const Scene& scene_;
  const std::string& file_;
  const toml::table* root_;
};

inline std::string in_mm(double length) {
  return number_text(std::round(1e6 * length) / 1e3) + " mm";
}

inline std::string in_um(double length) {
  return number_text(std::round(1e7 * length) / 10) + " um";
}

/// Tables over time and phases.
void check_duty(const Scene& scene, const SceneCheck& check);

/// Shafts, housings and temperatures, and whether the bearing turns in operation.
void check_operation(const Scene& scene, const SceneCheck& check);
/// Flanges hold the rollers on both sides, meet their ends and carry an axial load.
void check_flanges(const Scene& scene, const SceneCheck& check);

}  // namespace cagetol
