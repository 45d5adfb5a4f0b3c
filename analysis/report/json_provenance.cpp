// Where the numbers come from: study, program, design, assumptions.
#include <algorithm>

#include "analysis/report/json_parts.hpp"

namespace cagetol {

Json provenance_json(const StudyData& study) {
  const Provenance& from = study.provenance;
  Json libraries = Json::parse(from.libraries, nullptr, false);
  if (libraries.is_discarded()) libraries = from.libraries;
  Json inputs = Json::array();
  for (const InputPlan& input : study.plan.inputs)
    inputs.push_back({{"key", input.key}, {"unit", input.unit}, {"nominal", input.nominal},
                      {"lot", input.lot}, {"pocket", input.pocket}, {"noise", input.noise}});
  Json correlations = Json::array();
  for (const CorrelationPlan& pair : study.plan.correlations)
    correlations.push_back({{"first", pair.first}, {"second", pair.second}, {"rho", pair.rho}});
  return {{"study_name", from.study_name},
          {"study_hash", from.study_hash},
          {"seed", from.seed},
          {"schema_version", from.schema_version},
          {"tool_version", from.tool_version},
          {"tool_commit", from.tool_commit},
          {"build", from.build},
          {"libraries", libraries},
          {"files", from.files},
          {"design", study.design.kind},
          {"scrambles", study.design.scrambles},
          {"cages_per_lot", study.plan.cages_per_lot},
          {"pockets", study.pockets},
          {"inputs", inputs},
          {"correlations", correlations},
          {"scene", study.plan.scene}};
}

Json assumptions_json(const StudyData& study) {
  const Json& whole = study.plan.whole;
  Json stated = whole.contains("assumptions") ? whole.at("assumptions") : Json();
  Json speeds = Json::object();
  if (study.plan.scene.is_object() && study.plan.scene.contains("contact"))
    for (const auto& [key, value] : study.plan.scene.at("contact").items())
      if (key.find("speed") != std::string::npos || key.find("friction") != std::string::npos)
        speeds["contact." + key] = value;
  return {{"stated", stated}, {"friction", speeds}};
}

}  // namespace cagetol
