#include "mc/study/study.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "mc/host/build_info.hpp"
#include "mc/study/assumption_ranges.hpp"
#include "mc/study/nominal_limits.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/study/resolved_study.hpp"
#include "mc/study/sample.hpp"
#include "mc/study/study_inputs.hpp"
#include "mc/study/study_keys.hpp"
#include "mc/study/study_layers.hpp"
#include "mc/study/study_limits.hpp"
#include "mc/study_file/cage_thickness.hpp"
#include "src/input/former_names.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/reading/idle_notes.hpp"
#include "src/reading/oil_keys.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

const toml::table& scene_table(const toml::table& root, const std::string& file) {
  static const toml::table none;
  const auto* scene = root.get("scene");
  if (!scene) return none;
  if (!scene->is_table())
    throw InputError(place_of(*scene, file), "scene", shown(*scene), "this is a section, not a key",
                     "write [scene] and below it file = \"...\"");
  for (const auto& [key, node] : *scene->as_table())
    if (const std::string name(key.str()); is_study_section(name))
      throw InputError(place_of(node, file), name, "", "this is a key of a study, not of a scene",
                       "write it in the study, outside of [scene]; scene.file names a scene");
  return *scene->as_table();
}

// Every key outside the scene that holds one value; the lists are read elsewhere.
void read_plain_keys(const toml::table& root, const std::string& file, Study& study) {
  for (const auto& leaf : toml_leaves(root, {})) {
    if (leaf.name == "scene" || leaf.name.starts_with("scene.") || leaf.name == "limit" ||
        leaf.name == "correlation" || leaf.name == "tolerance.dimension" ||
        leaf.name == "operating_point")
      continue;
    if (leaf.name == "tolerance" && leaf.node->is_table()) continue;
    for (const std::string list :
         {"limit", "correlation", "tolerance.dimension", "assumption", "operating_point"})
      if (leaf.name.starts_with(list + "."))
        throw InputError(place_of(*leaf.node, file), leaf.name, shown(*leaf.node),
                         "there may be several of these: they are a list of tables",
                         "write [[" + list + "]] with two brackets on each side");
    if (const auto* key = find_key(study_keys(), leaf.name)) {
      read_key(*key, *leaf.node, file, 1, study);
    } else if (is_scene_section(leaf.name.substr(0, leaf.name.find('.')))) {
      throw InputError(place_of(*leaf.node, file), leaf.name, "", "this is a key of a scene",
                       "in a study write scene." + leaf.name +
                           ", or its section as [scene.SECTION]; a scene has no keys like samples");
    } else {
      auto known = key_infos(study_keys());
      for (const char* list : {"scene", "limit", "correlation", "tolerance.dimension", "assumption",
                               "operating_point"})
        known.emplace_back(list, any_value(), "", KeyKind::text);
      throw unknown_key(leaf, file, known);
    }
  }
}

void resolve(Study& study) {
  const toml::table table = resolved_table(study);
  std::ostringstream toml_text, json_text;
  toml_text << toml::toml_formatter(table) << '\n';
  json_text << toml::json_formatter(table) << '\n';
  study.resolved_toml = toml_text.str();
  study.resolved_json = json_text.str();
  std::string all = identity_text(study.resolved_toml);
  for (const auto& [name, hash] : study.files) all += name + "\n" + hash + "\n";
  study.hash = text_hash(all);
}

/// Whole rounds of the measured cages as they are, at no candidate.
void take_cages_in_turn(Study& study) {
  std::set<long> counts;
  for (UncertainInput& input : study.inputs) {
    if (!input.measured || !input.measured->is_grouped()) continue;
    MeasuredParts& parts = *input.measured;
    for (double& value : parts.values.values) value += parts.centred ? parts.offset : 0;
    parts.fitted = parts.centred = false;
    const MeasuredLaws laws = laws_of(parts);
    input.lot = laws.lot;
    input.pocket = laws.pocket;
    counts.insert(std::ssize(parts.names));
  }
  if (counts.size() != 1)
    throw InputError({}, "measured_in_turn", "true",
                     counts.empty() ? "no law of the study reads measured cages"
                                    : "its laws read different numbers of measured cages",
                     "give laws of pockets with one file, and column and group of each");
  study.samples = (study.samples + *counts.begin() - 1) / *counts.begin() * *counts.begin();
  study.tolerance.dimensions.clear();
}

Study study_of(toml::table root, const std::string& file) {
  Study study;
  study.fidelity_decision = take_fidelity_decision(root);
  unresolve(root, file);
  read_plain_keys(root, file, study);
  const auto& scene = scene_table(root, file);
  study.scene = read_scene(scene, file);
  study.names_lubrication = find_node(scene, "lubrication.model") != nullptr;
  if (study.fidelity == "auto") require_word_of_oil(study, file);
  MeasurementFiles measurements;
  study.inputs = read_inputs(scene, file, study.scene, measurements);
  for (const UncertainInput& input : study.inputs)
    if (input.measured) study.files.emplace_back(input.measured->file, input.measured->hash);
  study.correlations = read_correlations(root, file, study.inputs);
  study.points = read_operating_points(root, file, study);
  study.limits = limits_at_points(read_limits(root, file, quantity_labels(study)), study.points);
  study.tolerance.dimensions = read_dimensions(root, file, study.inputs);
  if (study.measured_in_turn) take_cages_in_turn(study);
  study.candidates = make_candidates(study, root, file);
  check_drawn_range(study, scene, file);
  check_flexible_cage(study, scene, file);
  check_assumption_ranges(study, scene, file);
  const Sampler sampler(study);  // refuses what makes no design
  if (study.redraw_jams && study.candidates.empty())
    throw InputError({}, "redraw_jams", "true",
                     "the share of cages that fit is known of candidate tolerances alone",
                     "leave it out, or give [[tolerance.dimension]]");
  find_temperatures(study);
  find_whirl_clearance(study);
  find_nominal_limits(study);
  resolve(study);
  return study;
}

}  // namespace

std::uint64_t sample_count(const Study& study) {
  return static_cast<std::uint64_t>(study.samples) +
         static_cast<std::uint64_t>(
             std::llround(study.extra_replicates * static_cast<double>(study.samples)));
}

Study read_study(const std::string& path, const std::vector<std::string>& settings) {
  return study_of(study_layers(path, settings), path);
}

Study read_measured_study(const std::string& path, std::vector<std::string> settings,
                          const std::string& measured) {
  const toml::table root = study_layers(path, settings);
  for (const auto& leaf : toml_leaves(root)) {
    const std::string law = leaf.name.substr(0, leaf.name.rfind('.'));
    if (leaf.name == law + ".file" && find_node(root, law + ".column"))
      settings.push_back(leaf.name + " = \"" + measured + "\"");
  }
  settings.insert(settings.end(), {"measured_in_turn = true", "design = \"random\""});
  return read_study(path, settings);
}

/// Leaves out, with a warning, what an earlier program knew and this one has no successor for.
void leave_out_gone_keys(toml::table& table, const std::string& section, const std::string& file) {
  for (auto at = table.begin(); at != table.end();) {
    const std::string name = section + std::string(at->first.str());
    const FormerName* row = former_name(name);
    if (!row) row = former_name(name, at->second.value_or(std::string()));
    const bool gone = row && row->now.empty();
    if (gone) spdlog::warn("{}: {} is left out: {}", file, name, former_problem(*row));
    if (auto* below = at->second.as_table(); below && !gone)
      leave_out_gone_keys(*below, name + ".", file);
    at = gone ? table.erase(at) : std::next(at);
  }
}

Study read_resolved_study(const std::string& resolved_toml, const std::string& name) {
  toml::table root = parse_toml(resolved_toml, name);
  leave_out_gone_keys(root, "", name);
  return study_of(std::move(root), name);
}

Study changed_study(Study study, const std::function<void(Study&)>& change) {
  change(study);
  std::ostringstream text;
  text << toml::toml_formatter(resolved_table(study)) << '\n';
  return read_resolved_study(text.str(), study.name);
}

void require_word_of_oil(const Study& study, const std::string& file) {
  if (!study.names_lubrication)
    throw no_word_of_oil("the model ladder sets this scene in motion, and a dynamic scene must say",
                         file);
}

std::vector<std::string> model_notes(const Study& study) {
  const auto varies = [&](const std::string& key) {
    return std::any_of(study.inputs.begin(), study.inputs.end(),
                       [&](const auto& input) { return input.key == key; });
  };
  std::vector<std::string> notes = scene_doubts(study.scene);
  for (const std::string& idle : idle_notes(study.scene, varies)) notes.push_back(idle);
  if (is_quasi_static(study.scene))
    notes.emplace_back(
        "quasi-static: the ring's displacement and the tilt of rollers are computed; slip and the "
        "cage are not (scene.model.motion)");
  return notes;
}

/// What scattering diameters of a flexible cage leave wrong.
std::string thickness_note(double share) {
  const auto percent = [&](double error) { return number_text(std::round(1e4 * error) / 100); };
  return "bore and outside of the flexible cage deviate together by up to " + percent(share) +
         " % of its thickness: contacts, clearances and mass follow them, its elasticity stays the "
         "nominal one (errors up to " +
         percent(kFrequencyErrorPerShare * share) + " % of frequencies, " +
         percent(kComplianceErrorPerShare * share) + " % of the bars' compliance, " +
         percent(kStressErrorPerShare * share) + " % of stress)";
}

std::vector<std::string> study_notes(const Study& study) {
  std::vector<std::string> notes = model_notes(study);
  const auto& window = study.scene.window;
  for (const auto& limit : study.limits) {
    if (changes_over_time(study.scene.operation) || !study.points.empty()) break;
    const bool extreme = is_extreme(quantity_named(limit.quantity).kind);
    const bool in_part = extreme && !std::isnan(window.peak_revolutions);
    const double measured = in_part ? window.peak_revolutions : window.measure_revolutions;
    if (limit.cage_revolutions > 0 && std::isnan(window.measure_time) &&
        limit.cage_revolutions != measured)
      notes.push_back(
          "limit on " + limit.quantity + " is for " + number_text(limit.cage_revolutions) +
          " cage revolutions, the window measures " + number_text(measured) + " (scene.window." +
          (in_part ? "peak_revolutions" : "measure_revolutions") + ")");
  }
  if (!study.correlations.empty() && study.design == DesignKind::lhs)
    notes.push_back(std::string("design = \"") + design_name(study.design) +
                    "\": of two correlated inputs the second is drawn given the first and fills no "
                    "strata of its own");
  if (const double share = is_flexible(study.scene) ? thickness_scatter(study) : 0; share > 0)
    notes.push_back(thickness_note(share));
  for (const std::string& idle : idle_range_notes(study)) notes.push_back(idle);
  for (const UncertainInput& input : study.inputs)
    if (input.measured)
      for (const std::string& note : measured_notes(*input.measured, input.key, input.unit))
        notes.push_back(note);
  if (study.inputs.empty())
    notes.push_back("nothing varies: no key of the scene is a distribution");
  else if (design_columns(study) == 0)
    notes.push_back("only noise varies: no input by lot or pocket");
  return notes;
}

std::vector<std::string> sweep_notes(const Study& study) {
  std::vector<std::string> notes = study_notes(study);
  const auto candidates = static_cast<long>(study.candidates.size());
  if (candidates > 0 && study.samples < 100 * candidates)
    notes.push_back(
        std::to_string(study.samples) + " rows for " + std::to_string(candidates) +
        " candidate tolerances: fewer than 100 each, which decides few of them; `cagetol "
        "recommend` spends its runs where they decide");
  return notes;
}

}  // namespace cagetol
