#include "analysis/study/study_plan.hpp"

#include <fmt/format.h>

#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

Json part(const Json& object, const char* key) {
  return object.contains(key) ? object.at(key) : Json();
}

std::optional<double> optional_number(const Json& object, const char* key) {
  const Json value = part(object, key);
  if (value.is_null()) return std::nullopt;
  return value.get<double>();
}

/// A value by its name, or by the name that it has in files of older programs.
const Json& either(const Json& object, const char* name, const char* former) {
  return object.at(object.contains(name) ? name : former);
}

std::vector<double> numbers(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_array()) return value.get<std::vector<double>>();
  return {value.get<double>()};
}

InputPlan read_input(const Json& object) {
  InputPlan input;
  input.key = object.at("key").get<std::string>();
  input.unit = object.value("unit", "-");
  input.nominal = numbers(part(object, "nominal"));
  input.lot = part(object, "lot");
  input.pocket = part(object, "pocket");
  input.noise = part(object, "noise");
  return input;
}

Limit read_limit(const Json& object) {
  Limit limit;
  limit.quantity = object.at("quantity").get<std::string>();
  limit.minimum = optional_number(object, "min");
  limit.maximum = optional_number(object, "max");
  limit.source = object.value("source", "");
  limit.cage_revolutions = object.value("cage_revolutions", 0.0);
  return limit;
}

Candidate read_candidate(const Json& object) {
  Candidate candidate{either(object, "tolerance_widths_mm", "bands_mm").get<std::vector<double>>(),
                      object.at("grades").get<std::vector<std::string>>(),
                      object.at("scales").get<std::vector<double>>(),
                      {}};
  candidate.shifts = object.contains("shifts") ? object.at("shifts").get<std::vector<double>>()
                                               : std::vector<double>(candidate.scales.size(), 0.0);
  if (object.contains("middles")) object.at("middles").get_to(candidate.middles);
  return candidate;
}

Correlation read_correlation(const Json& object) {
  const auto between = object.at("between").get<std::vector<std::string>>();
  return {between.at(0), between.at(1), object.at("rho").get<double>()};
}

ToleranceDimension read_dimension(const Json& object) {
  ToleranceDimension dimension;
  dimension.key = object.at("key").get<std::string>();
  dimension.tolerance_width_mm = either(object, "tolerance_width_mm", "band_mm").get<double>();
  for (const Json& candidate : part(object, "candidates"))
    dimension.candidates.push_back(candidate.is_string()
                                       ? candidate.get<std::string>()
                                       : fmt::format("{}", candidate.get<double>()));
  if (object.contains("centres")) object.at("centres").get_to(dimension.centres);
  if (object.contains("cost_table")) object.at("cost_table").get_to(dimension.cost);
  return dimension;
}

CampaignSettings read_campaign(const Json& object) {
  CampaignSettings settings;
  if (object.is_null()) return settings;
  settings.attempts = object.value("attempts", settings.attempts);
  settings.confirm_samples = object.value("confirm_samples", settings.confirm_samples);
  settings.budget_samples = object.value("budget_samples", settings.budget_samples);
  settings.budget_h = object.value("budget_h", settings.budget_h);
  return settings;
}

template <class T>
std::vector<T> read_list(const Json& root, const char* key, T (*read)(const Json&)) {
  std::vector<T> items;
  for (const Json& object : part(root, key)) items.push_back(read(object));
  return items;
}

}  // namespace

nlohmann::ordered_json judgement_of(const StudyPlan& plan) {
  const auto known = [](const std::optional<double>& bound) {
    return bound ? Json(*bound) : Json();
  };
  Json limits = Json::array();
  for (const Limit& limit : plan.limits)
    limits.push_back({{"quantity", limit.quantity},
                      {"min", known(limit.minimum)},
                      {"max", known(limit.maximum)}});
  return {{"limits", limits}, {"target_yield", plan.target_yield}, {"confidence", plan.confidence}};
}

StudyPlan read_study_plan(const std::string& text, const std::string& file) {
  try {
    StudyPlan plan;
    plan.whole = Json::parse(text);
    const Json& root = plan.whole;
    plan.name = root.value("name", "study");
    plan.extra_replicates = root.value("extra_replicates", 0.0);
    plan.campaign = read_campaign(part(root, "recommend"));
    plan.cages_per_lot = root.value("cages_per_lot", 1.0);
    plan.redraw_jams = root.value("redraw_jams", false);
    plan.scale_lots = root.value("scale_lots", true);
    plan.allowed_failure_share = root.value("allowed_failure_share", 0.02);
    plan.scene = part(root, "scene");
    plan.inputs = read_list(root, "inputs", read_input);
    plan.limits = read_list(root, "limit", read_limit);
    plan.candidates = read_list(root, "candidates", read_candidate);
    plan.correlations = read_list(root, "correlation", read_correlation);
    const Json tolerance = part(root, "tolerance");
    if (!tolerance.is_null()) {
      plan.target_yield = tolerance.value("target_yield", 0.95);
      plan.confidence = tolerance.value("confidence", 0.95);
      plan.dimensions = read_list(tolerance, "dimension", read_dimension);
    }
    return plan;
  } catch (const std::exception& error) {
    throw StudyFileError(file, std::string("/study/json cannot be understood: ") + error.what(),
                         "run the study again with the version of the program that reads it");
  }
}

}  // namespace cagetol
