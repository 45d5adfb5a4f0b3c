// Where the numbers come from: study, program, design, assumptions.
#include <algorithm>

#include "analysis/report/json_parts.hpp"
#include "analysis/sensitivity/features.hpp"

namespace cagetol {
namespace {

/// Assumptions that have a range, with their value in the scene; null where that is no number.
Json ranged_json(const Json& stated, const Json& scene) {
  Json list = Json::array();
  if (!stated.is_array()) return list;
  for (const Json& entry : stated) {
    if (!entry.is_object() || !entry.contains("low") || !entry.contains("high")) continue;
    const std::string key = entry.value("key", "");
    const std::size_t dot = key.rfind('.');
    if (dot == std::string::npos) continue;
    std::string section = "/" + key.substr(0, dot);
    std::replace(section.begin(), section.end(), '.', '/');
    const Json::json_pointer place(section + "/" + key.substr(dot + 1));
    const Json value = scene.contains(place) ? scene.at(place) : Json();
    list.push_back({{"key", key},
                    {"name", plain_name(key)},
                    {"value", value.is_number() ? value : Json()},
                    {"low", entry.at("low")},
                    {"high", entry.at("high")}});
  }
  return list;
}

}  // namespace

Json provenance_json(const StudyData& study) {
  const Provenance& from = study.provenance;
  Json libraries = Json::parse(from.libraries, nullptr, false);
  if (libraries.is_discarded()) libraries = from.libraries;
  Json inputs = Json::array();
  for (const InputPlan& input : study.plan.inputs)
    inputs.push_back({{"key", input.key},
                      {"unit", input.unit},
                      {"nominal", input.nominal},
                      {"lot", input.lot},
                      {"pocket", input.pocket},
                      {"noise", input.noise}});
  return {{"study_name", from.study_name},
          {"study_hash", from.study_hash},
          {"seed", from.seed},
          {"tool_version", from.tool_version},
          {"tool_commit", from.tool_commit},
          {"build", from.build},
          {"libraries", libraries},
          {"files", from.files},
          {"design", study.design.kind},
          {"cages_per_lot", study.plan.cages_per_lot},
          {"pockets", study.pockets},
          {"inputs", inputs},
          {"scene", study.plan.scene}};
}

Json document_json(const StudyData& study) {
  const Json& plan = study.plan.whole;
  Json document = plan.is_object() ? plan.value("document", Json::object()) : Json::object();
  document["number"] =
      study.provenance.study_hash.substr(0, 8) + "-" + study.provenance.tool_commit.substr(0, 7);
  return document;
}

Json assumptions_json(const StudyData& study) {
  const Json& scene = study.plan.scene;
  Json stated = scene.is_object() && scene.contains("assumption") ? scene.at("assumption") : Json();
  Json speeds = Json::object();
  if (scene.is_object() && scene.contains("friction"))
    for (const auto& [key, value] : scene.at("friction").items()) speeds["friction." + key] = value;
  const Json model = scene.is_object() ? scene.value("model", Json::object()) : Json::object();
  return {{"stated", stated},
          {"ranged", ranged_json(stated, scene)},
          {"friction", speeds},
          {"model", model}};
}

Json fidelity_json(const StudyData& study) {
  const Json& plan = study.plan.whole;
  return plan.is_object() ? plan.value("fidelity_decision", Json()) : Json();
}

}  // namespace cagetol
