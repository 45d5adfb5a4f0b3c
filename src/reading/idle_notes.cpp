#include "src/reading/idle_notes.hpp"

#include <algorithm>
#include <utility>

#include "src/reading/scene_conditions.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {

std::vector<std::string> idle_notes(const Scene& scene,
                                    const std::function<bool(const std::string& key)>& varies) {
  static const Scene plain;
  std::vector<std::pair<std::string, std::string>> keys_by_reason;
  for (const auto& key : scene_keys()) {
    const std::string why(why_idle(scene_keys(), key, scene));
    if (why.empty()) continue;
    const bool told = why != idle::kCatalogue.why && why != idle::kTemperatureFound.why &&
                      !key.range.required && key_text(key, scene) != key_text(key, plain);
    if (!told && !(varies && varies(key.name))) continue;
    const auto known = std::find_if(keys_by_reason.begin(), keys_by_reason.end(),
                                    [&](const auto& entry) { return entry.first == why; });
    if (known == keys_by_reason.end())
      keys_by_reason.emplace_back(why, key.name);
    else
      known->second += ", " + key.name;
  }
  std::vector<std::string> notes;
  for (const auto& [why, keys] : keys_by_reason)
    notes.push_back("without effect (" + why + "): " + keys);
  return notes;
}

}  // namespace cagetol
