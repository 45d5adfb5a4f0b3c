#include "mc/study/operating_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "mc/study/study_inputs.hpp"
#include "mc/study/study_keys.hpp"
#include "src/heat_balance.hpp"
#include "src/input/unit.hpp"
#include "src/model/bearing_model.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/quantities/window_times.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostPoints = 50;

/// Whether an operating point may set the key: what the bearing is stays the same at all points.
bool is_about_operation(const std::string& key) {
  static const std::vector<std::string> sections = {"load.",  "speed.",       "duty.",
                                                    "phase.", "window.",      "environment.",
                                                    "start.", "lubrication.", "temperature."};
  static const std::set<std::string> fixed = {"speed.centrifugal_growth", "lubrication.model",
                                              "temperature.growth", "temperature.reference_C",
                                              "window.history_interval_us"};
  return !fixed.contains(key) &&
         std::any_of(sections.begin(), sections.end(),
                     [&](const std::string& section) { return key.starts_with(section); });
}

/// Whether the heat balance writes the key.
bool is_found_temperature(const std::string& key) {
  return key.starts_with("temperature.found_") || key == "lubrication.temperature_C" ||
         key == "temperature.inner_ring_C" || key == "temperature.outer_ring_C";
}

toml::table value_table(const std::string& text) {
  return toml::parse("value = " + text);
}

/// Phases and duties of a point replace those of the scene as a whole.
void read_setting(const std::string& key, const toml::node& node, const std::string& file,
                  Scene& scene) {
  read_key(*find_key(scene_keys(), key), node, file,
           static_cast<std::size_t>(scene.bearing.roller_count), scene);
}

/// A setting as a multiple of what the maker gives, at the point as it is so far.
struct MakersRatio {
  const char *name, *key, *missing;
  double unit;
  double (*base)(const Scene&);  ///< NaN: not given
};

constexpr MakersRatio kMakersRatios[] = {
    {"limiting_speeds", "speed.inner_rpm", "bearing.limiting_speed_rpm", pi / 30,
     [](const Scene& scene) { return scene.bearing.limiting_speed; }},
    {"minimum_loads", "load.radial_N",
     "bearing.minimum_load_factor and bearing.reference_speed_rpm", 1, minimum_load_of}};

/// The value in the unit of the ratio's key, up to the next tenth.
toml::value<double> makers_value(const MakersRatio& ratio, const toml::node& node,
                                 const std::string& file, const Scene& scene) {
  const std::string name = std::string("operating_point.") + ratio.name;
  const double times = number_value(info_of(operating_point_keys(), name), node, file);
  const double value = times * ratio.base(scene) / ratio.unit;
  if (!std::isfinite(value))
    throw InputError(place_of(node, file), name, shown(node),
                     std::string("the scene does not give ") + ratio.missing,
                     std::string("give it, or ") + ratio.key + " in place of the multiple");
  return toml::value<double>(std::ceil(10 * value * (1 - 1e-9)) / 10);
}

void check_points(const std::vector<OperatingPointPlan>& points, const toml::node& node,
                  const std::string& file, const Study& study) {
  const auto refuse = [&](const std::string& why, const std::string& remedy) {
    throw InputError(place_of(node, file), "operating_point", "", why, remedy);
  };
  std::set<std::string> names;
  for (const OperatingPointPlan& point : points)
    if (!names.insert(point.name).second)
      refuse("two points are called " + point.name, "give each a name of its own");
  if (points.size() > kMostPoints)
    refuse(std::to_string(points.size()) + " points are more than " + std::to_string(kMostPoints),
           "join points that hardly differ");
  if (is_flexible(study.scene) && study.scene.operation.centrifugal_growth)
    refuse("a flexible cage that grows by rotation is another one at every speed",
           "set speed.centrifugal_growth = false, or cage.model = \"rigid\"");
  const auto warms = [&](const OperatingPointPlan& point) {
    return cage_temperature(at_operating_point(study.scene, point)) !=
           cage_temperature(study.scene);
  };
  if (is_flexible(study.scene) &&
      (study.scene.temperature.growth || softens(study.scene.cage.material)) &&
      (study.scene.temperature.balance || std::any_of(points.begin(), points.end(), warms)) &&
      std::isnan(study.scene.cage.temperature))
    refuse(
        "a flexible cage that grows or softens with its temperature is another one at every point",
        "give scene.cage.temperature_C, or set cage.model = \"rigid\"");
}

/// The point with the largest value of a quantity; -1: none has one.
long largest_of(const std::vector<Outcome>& outcomes, const std::string& key) {
  const auto row = static_cast<std::size_t>(quantity_index(key));
  long at = -1;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < outcomes.size(); ++p)
    if (const double value = outcomes[p].quantities[row]; value > most) {
      at = static_cast<long>(p);
      most = value;
    }
  return at;
}

void add_run(const RunRecord& from, RunRecord& to) {
  for (double RunRecord::*sum :
       {&RunRecord::simulated_s, &RunRecord::measured_s, &RunRecord::cage_revolutions,
        &RunRecord::windows_cut, &RunRecord::steps, &RunRecord::rejected_steps,
        &RunRecord::rhs_evaluations, &RunRecord::jacobian_evaluations, &RunRecord::factorisations,
        &RunRecord::static_positions_missed, &RunRecord::wall_s})
    to.*sum += from.*sum;
  for (double RunRecord::*largest :
       {&RunRecord::energy_residual, &RunRecord::static_consistency_error,
        &RunRecord::cage_frequency_error})
    if (std::isnan(to.*largest) || from.*largest > to.*largest) to.*largest = from.*largest;
  if (to.smallest_step_s == 0 || from.smallest_step_s < to.smallest_step_s)
    to.smallest_step_s = from.smallest_step_s;
}

}  // namespace

std::vector<std::string> quantity_labels(const Study& study) {
  if (study.points.empty()) return study.scene.phase.name;
  std::vector<std::string> labels;
  for (const OperatingPointPlan& point : study.points) {
    labels.push_back(point.name);
    for (const std::string& phase : at_operating_point(study.scene, point).phase.name)
      labels.push_back(point.name + "." + phase);
  }
  return labels;
}

OperatingPointPlan read_operating_point(const toml::table& entry, const std::string& file,
                                        const Study& study) {
  OperatingPointPlan point;
  const auto* name = entry.get("name");
  if (!name || !name->is_string())
    throw InputError(place_of(entry, file), "operating_point", shown(entry),
                     "the operating point has no name", "add name = \"full-load\"");
  point.name = name->value<std::string>().value();
  if (!is_label(point.name))
    throw InputError(place_of(*name, file), "operating_point.name", shown(*name),
                     "this is no name of a point", "use up to 40 letters, digits, _ and -");
  if (const auto* weight = entry.get("weight"))
    point.weight =
        number_value(info_of(operating_point_keys(), "operating_point.weight"), *weight, file);
  Scene scene = study.scene;
  const auto known = key_infos(scene_keys());
  std::vector<TomlLeaf> leaves = toml_leaves(entry);
  // The minimum load follows from the speed.
  std::stable_partition(leaves.begin(), leaves.end(),
                        [](const TomlLeaf& leaf) { return leaf.name != "minimum_loads"; });
  for (const TomlLeaf& given : leaves) {
    if (given.name == "name" || given.name == "weight") continue;
    const auto* ratio = std::find_if(std::begin(kMakersRatios), std::end(kMakersRatios),
                                     [&](const MakersRatio& r) { return given.name == r.name; });
    toml::value<double> absolute(0);
    TomlLeaf leaf = given;
    if (ratio != std::end(kMakersRatios)) {
      absolute = makers_value(*ratio, *given.node, file, scene);
      leaf = {ratio->key, &absolute};
    }
    const auto* key = find_key(scene_keys(), leaf.name);
    if (!key) throw unknown_key(leaf, file, known);
    const auto refuse = [&](const std::string& why, const std::string& remedy) {
      return InputError(place_of(*given.node, file), given.name, shown(*given.node), why, remedy);
    };
    if (std::any_of(point.settings.begin(), point.settings.end(),
                    [&](const auto& setting) { return setting.first == leaf.name; }))
      throw refuse(leaf.name + " is given as well", "keep one of the two");
    if (!is_about_operation(leaf.name) || leaf.name == "duty.file")
      throw refuse(
          "an operating point changes load, speed, duty, oil, temperatures, window and "
          "surroundings, nothing that the bearing is",
          "set it below [scene]; a duty in its columns (duty.time_s ...)");
    if (std::any_of(study.inputs.begin(), study.inputs.end(),
                    [&](const UncertainInput& input) { return input.key == leaf.name; }))
      throw refuse("this key varies in the study", "leave it out here, or give it one value there");
    read_setting(leaf.name, *leaf.node, file, scene);
    point.settings.emplace_back(leaf.name, key_text(*key, scene));
  }
  try {
    check_scene(scene, file);
  } catch (const InputError& problem) {
    throw InputError(place_of(entry, file), "operating_point", point.name, problem.what(),
                     "correct the point or the scene");
  }
  return point;
}

std::vector<OperatingPointPlan> read_operating_points(const toml::table& root,
                                                      const std::string& file, const Study& study) {
  const auto* node = root.get("operating_point");
  if (!node) return {};
  const auto* array = node->as_array();
  std::vector<OperatingPointPlan> points;
  for (std::size_t i = 0; array && i < array->size(); ++i)
    if (const auto* entry = (*array)[i].as_table())
      points.push_back(read_operating_point(*entry, file, study));
  if (!array || points.size() != array->size())
    throw InputError(place_of(*node, file), "operating_point", shown(*node),
                     "operating points are a list of tables",
                     "write each one below a line [[operating_point]]");
  if (!points.empty()) check_points(points, *node, file, study);
  return points;
}

toml::table operating_point_table(const OperatingPointPlan& point) {
  toml::table entry{{"name", point.name}, {"weight", point.weight}};
  for (const auto& [key, text] : point.settings) {
    toml::table value = value_table(text);
    std::move(*value.get("value")).visit([&, &key = key](auto&& node) {
      entry.insert_or_assign(key, std::forward<decltype(node)>(node));
    });
  }
  return entry;
}

void find_temperatures(Study& study) {
  study.scene = with_temperature_found(study.scene);
  for (OperatingPointPlan& point : study.points) {
    const auto gives = [&](const std::string& key) {
      return std::any_of(point.settings.begin(), point.settings.end(),
                         [&](const auto& setting) { return setting.first == key; });
    };
    Scene scene = at_operating_point(study.scene, point);
    if (!study.scene.temperature.balance && !scene.temperature.balance) continue;
    if (!scene.temperature.balance) {  // rings as warm as the oil that the point gives
      scene.temperature.inner_ring = scene.temperature.outer_ring = kAuto;
    } else if (!gives("temperature.found_C")) {  // what was found of the scene is of another load
      scene.temperature.found = kAuto;
      scene = with_temperature_found(scene);
    }
    for (const Key<Scene>& key : scene_keys())
      if (is_found_temperature(key.name) && !gives(key.name))
        point.settings.emplace_back(key.name, key_text(key, scene));
  }
}

void find_whirl_clearance(Study& study) {
  double& clearance = study.scene.window.whirl_clearance;
  const Need& whirl = quantity_named("whirl_ratio").need;
  const bool measured =
      whirl.met(study.scene) ||
      std::any_of(study.points.begin(), study.points.end(), [&](const OperatingPointPlan& point) {
        return whirl.met(at_operating_point(study.scene, point));
      });
  if (!measured || !std::isnan(clearance)) return;
  const double left = whirl_clearance(make_bearing_model(OperatingScene(study.scene)));
  // To a nanometre: as it is read again from the study's own text.
  if (left > 0) clearance = to_si(std::round(1e3 * from_si(left, 1e-6)) / 1e3, 1e-6);
}

void forget_temperatures(Study& study) {
  study.scene.temperature.found = kAuto;
  for (OperatingPointPlan& point : study.points)
    if (at_operating_point(study.scene, point).temperature.balance)  // others give theirs
      std::erase_if(point.settings,
                    [](const auto& setting) { return is_found_temperature(setting.first); });
}

Scene at_operating_point(Scene scene, const OperatingPointPlan& point) {
  for (const auto& [key, text] : point.settings)
    read_setting(key, *value_table(text).get("value"), "operating point " + point.name, scene);
  return scene;
}

std::vector<Limit> limits_at_points(std::vector<Limit> limits,
                                    const std::vector<OperatingPointPlan>& points) {
  if (points.empty()) return limits;
  std::vector<Limit> expanded;
  for (const Limit& limit : limits) {
    if (!labelled_key(limit.quantity).label.empty()) {
      expanded.push_back(limit);
      continue;
    }
    for (const OperatingPointPlan& point : points) {
      expanded.push_back(limit);
      expanded.back().quantity = labelled_name(limit.quantity, point.name);
    }
  }
  return expanded;
}

double over_points(const Quantity& quantity, std::size_t row, const Study& study,
                   const std::vector<Outcome>& outcomes) {
  double sum = 0, weights = 0, minimum = kNone, peak = kNone;
  for (std::size_t p = 0; p < outcomes.size(); ++p) {
    const double value = outcomes[p].quantities[row], weight = study.points[p].weight;
    sum += weight * value;
    weights += weight;
    minimum = std::fmin(minimum, value);
    peak = std::fmax(peak, value);
  }
  const Kind kind = quantity.kind;
  const long at = kind == Kind::place ? largest_of(outcomes, quantity.peak) : -1;
  if (at >= 0) return outcomes[static_cast<std::size_t>(at)].quantities[row];
  return kind == Kind::power     ? sum / weights
         : kind == Kind::peak    ? peak
         : kind == Kind::minimum ? minimum
                                 : kNone;
}

Outcome join_points(const Study& study, const std::vector<Outcome>& outcomes) {
  const auto& table = quantity_table();
  Outcome joined;
  joined.labels = quantity_labels(study);
  joined.quantities.assign(table.size(), kNone);
  const Outcome& last = outcomes.back();
  joined.status = last.status;
  joined.pocket = last.pocket;
  joined.interference_um = last.interference_um;
  const std::string& name = study.points[outcomes.size() - 1].name;
  if (last.status != Status::ok)
    joined.reason = last.reason.empty() ? "" : "operating point " + name + ": " + last.reason;
  else if (outcomes.size() == study.points.size())
    for (std::size_t row = 0; row < table.size(); ++row)
      joined.quantities[row] = over_points(table[row], row, study, outcomes);
  joined.run = outcomes.front().run;
  for (std::size_t p = 1; p < outcomes.size(); ++p) add_run(outcomes[p].run, joined.run);
  for (const Outcome& of_point : outcomes)
    joined.quantities.insert(joined.quantities.end(), of_point.quantities.begin(),
                             of_point.quantities.end());
  joined.quantities.resize(quantity_count(joined.labels), kNone);
  if (const long at = largest_of(outcomes, "cage_stress_peak_MPa"); at >= 0)
    joined.cage_peak = outcomes[static_cast<std::size_t>(at)].cage_peak;
  return joined;
}

std::string operating_points_text(const Study& study) {
  if (study.points.empty()) return "";
  double motion = 0, weights = 0;
  std::string points;
  for (const OperatingPointPlan& point : study.points) weights += point.weight;
  for (const OperatingPointPlan& point : study.points) {
    const Scene scene = at_operating_point(study.scene, point);
    points += fmt::format("  {}, weight {:.3g}", point.name, point.weight / weights);
    for (const auto& [key, text] : point.settings)
      points += ", " + key + " = " + (text.size() > 40 ? text.substr(0, 37) + "..." : text);
    points += "\n";
    if (is_quasi_static(scene)) continue;
    const WindowTimes times = window_times(scene, make_bearing_model(scene));
    motion += times.settle + times.measure;
  }
  return fmt::format(
      "{} operating points, each sample runs at all of them: {} runs\n{}a sample takes {:.3g} s of "
      "motion\n",
      study.points.size(), sample_count(study) * study.points.size(), points, motion);
}

}  // namespace cagetol
