#include "mc/study/resolved_study.hpp"

#include <cmath>
#include <limits>
#include <sstream>

#include "distributions/iso286.hpp"
#include "mc/study/law_reader.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/study/study_keys.hpp"
#include "src/input/toml_file.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

using key_detail::array_of;

toml::table input_table(const UncertainInput& input) {
  toml::table table;
  table.insert("key", input.key);
  table.insert("unit", input.unit);
  if (input.nominal.size() == 1)
    table.insert("nominal", input.nominal[0]);
  else
    table.insert("nominal", array_of(input.nominal));
  if (input.lot) table.insert("lot", law_table(*input.lot));
  if (input.pocket) table.insert("pocket", law_table(*input.pocket));
  if (input.noise) table.insert("noise", law_table(*input.noise));
  toml::table measured;
  for (const auto& key : measured_keys())
    if (input.measured) insert_key(key, *input.measured, measured);
  if (input.measured) table.insert("measured", std::move(measured));
  return table;
}

toml::table limit_table(const Limit& limit) {
  toml::table table;
  table.insert("quantity", limit.quantity);
  if (limit.minimum) table.insert("min", *limit.minimum);
  if (limit.maximum) table.insert("max", *limit.maximum);
  if (limit.minimum_loads) table.insert("max_at_minimum_loads", *limit.minimum_loads);
  table.insert("source", limit.source);
  table.insert("cage_revolutions", limit.cage_revolutions);
  return table;
}

toml::table dimension_table(const ToleranceDimension& dimension) {
  toml::table table;
  table.insert("key", dimension.key);
  table.insert("tolerance_width_mm", dimension.tolerance_width_mm);
  toml::array candidates;
  for (const auto& name : dimension.candidates) {
    if (tolerance_class(name) || deviations_of(name))
      candidates.push_back(name);
    else
      candidates.push_back(std::stod(name));
  }
  table.insert("candidates", std::move(candidates));
  if (!dimension.centres.empty()) table.insert("centres", array_of(dimension.centres));
  toml::array costs;
  for (const auto& [width, cost] : dimension.cost) costs.push_back(toml::array{width, cost});
  if (!costs.empty()) table.insert("cost_table", std::move(costs));
  return table;
}

/// Numbers that are not known are left out.
void insert_known(const char* name, double value, toml::table& table) {
  if (std::isfinite(value)) table.insert(name, value);
}

toml::table decision_table(const FidelityDecision& decision) {
  toml::array shifts;
  for (const auto& shift : decision.shifts) {
    toml::table table{
        {"quantity", shift.quantity}, {"rung", shift.rung}, {"verdict", shift.verdict}};
    insert_known("shift", shift.shift, table);
    insert_known("lower", shift.lower, table);
    insert_known("upper", shift.upper, table);
    insert_known("budget", shift.budget, table);
    if (!shift.limit.empty()) table.insert("limit", shift.limit);
    insert_known("wrong_share", shift.wrong_share, table);
    insert_known("allowed_wrong_share", shift.allowed_wrong_share, table);
    shifts.push_back(std::move(table));
  }
  toml::table table{
      {"rung", decision.rung}, {"reason", decision.reason}, {"shift", std::move(shifts)}};
  if (!decision.assumption.empty()) table.insert("assumption", decision.assumption);
  return table;
}

toml::table candidate_table(const Candidate& candidate) {
  toml::table table;
  table.insert("tolerance_widths_mm", array_of(candidate.tolerance_widths_mm));
  table.insert("grades", array_of(candidate.grades));
  table.insert("scales", array_of(candidate.scales));
  table.insert("shifts", array_of(candidate.shifts));
  if (candidate.all_shifts() != candidate.shifts)
    table.insert("middles", array_of(candidate.middles));
  return table;
}

}  // namespace

toml::table resolved_table(const Study& study) {
  toml::table root;
  for (const auto& key : study_keys()) insert_key(key, study, root);
  toml::table scene;
  for (const auto& key : scene_keys()) insert_key(key, study.scene, scene);
  toml::array assumptions;
  for (const auto& assumption : study.scene.assumptions) {
    toml::table entry{{"key", assumption.key}, {"note", assumption.note}};
    insert_known("low", assumption.low, entry);
    insert_known("high", assumption.high, entry);
    assumptions.push_back(std::move(entry));
  }
  if (!assumptions.empty()) scene.insert("assumption", std::move(assumptions));
  root.insert("scene", std::move(scene));
  toml::array inputs, correlations, limits, dimensions, candidates;
  for (const auto& input : study.inputs) inputs.push_back(input_table(input));
  for (const auto& correlation : study.correlations)
    correlations.push_back(toml::table{
        {"between", toml::array{correlation.first, correlation.second}}, {"rho", correlation.rho}});
  for (const auto& limit : study.limits) limits.push_back(limit_table(limit));
  for (const auto& dimension : study.tolerance.dimensions)
    dimensions.push_back(dimension_table(dimension));
  for (const auto& candidate : study.candidates) candidates.push_back(candidate_table(candidate));
  root.insert("inputs", std::move(inputs));
  root.insert("correlation", std::move(correlations));
  root.insert("limit", std::move(limits));
  toml::array points;
  for (const auto& point : study.points) points.push_back(operating_point_table(point));
  if (!points.empty()) root.insert("operating_point", std::move(points));
  root.get("tolerance")->as_table()->insert("dimension", std::move(dimensions));
  root.insert("candidates", std::move(candidates));
  if (!study.fidelity_decision.rung.empty())
    root.insert("fidelity_decision", decision_table(study.fidelity_decision));
  return root;
}

std::string identity_text(const std::string& resolved_toml) {
  toml::table root = parse_toml(resolved_toml, "study.toml");
  const auto erase = [](toml::table* from, std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (from) from->erase(name);
  };
  erase(&root,
        {"name", "limit", "recommend", "allowed_failure_share", "fidelity", "fidelity_samples",
         "fidelity_budget", "fidelity_decision", "screen", "map", "rare", "document"});
  erase(root["scene"].as_table(), {"assumption"});
  erase(root["tolerance"].as_table(), {"target_yield", "confidence"});
  if (auto* dimensions = root["tolerance"]["dimension"].as_array())
    for (auto& dimension : *dimensions) erase(dimension.as_table(), {"cost_table"});
  std::ostringstream text;
  text << toml::toml_formatter(root) << '\n';
  return text.str();
}

FidelityDecision take_fidelity_decision(toml::table& root) {
  FidelityDecision decision;
  if (!root.contains("inputs")) return decision;  // not resolved: nothing of the kind is known
  const auto stored = root["fidelity_decision"];
  decision.rung = stored["rung"].value_or("");
  decision.reason = stored["reason"].value_or("");
  decision.assumption = stored["assumption"].value_or("");
  auto* shifts = stored["shift"].as_array();
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; shifts && k < shifts->size(); ++k) {
    const toml::node_view<toml::node> shift((*shifts)[k]);
    decision.shifts.push_back(
        {.quantity = shift["quantity"].value_or(""),
         .rung = shift["rung"].value_or(""),
         .shift = shift["shift"].value_or(unknown),
         .lower = shift["lower"].value_or(unknown),
         .upper = shift["upper"].value_or(unknown),
         .budget = shift["budget"].value_or(unknown),
         .verdict = shift["verdict"].value_or(""),
         .limit = shift["limit"].value_or(""),
         .wrong_share = shift["wrong_share"].value_or(unknown),
         .allowed_wrong_share = shift["allowed_wrong_share"].value_or(unknown)});
  }
  root.erase("fidelity_decision");
  return decision;
}

void unresolve(toml::table& root, const std::string& file) {
  auto* inputs = root.get("inputs");
  auto* scene = root.get_as<toml::table>("scene");
  if (!inputs) return;
  const auto wrong = [&](const toml::node& node) {
    return InputError(place_of(node, file), "inputs", shown(node),
                      "this is not the list of inputs of a resolved study",
                      "give distributions below [scene] instead");
  };
  if (!inputs->is_array() || !scene) throw wrong(*inputs);
  for (auto& element : *inputs->as_array()) {
    auto* input = element.as_table();
    const auto* name = input ? input->get_as<std::string>("key") : nullptr;
    const auto dot = name ? name->get().find('.') : std::string::npos;
    if (dot == std::string::npos || !find_key(scene_keys(), name->get())) throw wrong(element);
    const auto [section, key] = key_detail::section_of(*scene, name->get());
    if (!section) continue;  // read_scene refuses what stands there
    input->erase("key");
    input->erase("unit");
    section->insert_or_assign(key, std::move(*input));
  }
  root.erase("inputs");
  root.erase("candidates");
  // A resolved study has every key of its time: this one is older than lubrication, hence dry.
  const auto [lubrication, model] = key_detail::section_of(*scene, "lubrication.model");
  if (lubrication) lubrication->insert(model, "none");
}

}  // namespace cagetol
