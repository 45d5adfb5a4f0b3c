#include "mc/study/assumption_ranges.hpp"

#include <algorithm>
#include <map>

#include "mc/study/operating_points.hpp"
#include "mc/study/study_inputs.hpp"
#include "src/input/unit.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

/// Why the key does nothing in this scene; empty if it does something.
std::string idle_reason(const Scene& scene, const std::string& key) {
  return std::string(why_idle(scene_keys(), *find_key(scene_keys(), key), scene));
}

/// The entry of the file that gives this range; nullptr where it comes from elsewhere.
const toml::table* entry_of(const toml::table& scene, const std::string& key) {
  const auto* list = scene.get_as<toml::array>("assumption");
  for (std::size_t k = 0; list && k < list->size(); ++k)
    if (const auto* entry = list->get(k)->as_table();
        entry && (*entry)["key"].value<std::string>() == key)
      return entry;
  return nullptr;
}

}  // namespace

std::vector<Alternative> alternatives_of(const Study& study) {
  std::vector<Alternative> alternatives;
  for (const Assumption& assumption : study.scene.assumptions) {
    if (!assumption.has_range() || !idle_reason(study.scene, assumption.key).empty()) continue;
    const auto& key = *find_key(scene_keys(), assumption.key);
    Alternative alternative{.key = key.name,
                            .unit = key.unit,
                            .note = assumption.note,
                            .low = assumption.low,
                            .high = assumption.high,
                            .value = assumption.low,
                            .nominal = key_numbers(key, study.scene)};
    const auto is_nominal = [&](double value) {
      return std::all_of(alternative.nominal.begin(), alternative.nominal.end(),
                         [&](double nominal) { return nominal == value; });
    };
    if (!is_nominal(assumption.low)) alternatives.push_back(alternative);
    alternative.value = assumption.high;
    if (assumption.high != assumption.low && !is_nominal(assumption.high))
      alternatives.push_back(alternative);
  }
  return alternatives;
}

void apply_alternative(const Alternative& alternative, Study& study) {
  const std::vector<double> values(alternative.nominal.size(), alternative.value);
  set_key_numbers(*find_key(scene_keys(), alternative.key), values, study.scene);
  for (UncertainInput& input : study.inputs)
    if (input.key == alternative.key) input.nominal = values;
  forget_temperatures(study);
}

void check_assumption_ranges(const Study& study, const toml::table& scene,
                             const std::string& file) {
  for (const Alternative& alternative : alternatives_of(study)) {
    Study changed = study;
    apply_alternative(alternative, changed);
    try {
      check_scene(changed.scene, file);
      check_drawn_range(changed, {}, file);
      check_flexible_cage(changed, {}, file);
    } catch (const InputError& error) {
      const std::string problem = error.what();
      const bool low = alternative.value == alternative.low;
      const auto* entry = entry_of(scene, alternative.key);
      const auto* end = entry ? entry->get(low ? "low" : "high") : nullptr;
      throw InputError(end ? place_of(*end, file) : SourcePlace{file, 0},
                       low ? "assumption.low" : "assumption.high", number_text(alternative.value),
                       "no bearing has " + alternative.key + " = " +
                           number_text(alternative.value) +
                           " here: " + problem.substr(0, problem.find('\n')),
                       "narrow the range of " + alternative.key);
    }
  }
}

std::vector<std::string> idle_range_notes(const Study& study) {
  std::map<std::string, std::string> keys_by_reason;
  if (study.candidates.empty()) return {};
  for (const Assumption& assumption : study.scene.assumptions) {
    const std::string why = idle_reason(study.scene, assumption.key);
    if (!assumption.has_range() || why.empty()) continue;
    std::string& keys = keys_by_reason[why];
    keys += (keys.empty() ? "" : ", ") + assumption.key;
  }
  std::vector<std::string> notes;
  for (const auto& [why, keys] : keys_by_reason)
    notes.push_back("ranges that are not judged, for their keys do nothing (" + why + "): " + keys);
  return notes;
}

}  // namespace cagetol
