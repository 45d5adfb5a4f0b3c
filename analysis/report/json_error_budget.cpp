// The error budget of every quantity that has a mean.
#include <algorithm>

#include "analysis/fidelity/error_budget.hpp"
#include "analysis/report/json_parts.hpp"
#include "analysis/report/refining_ladder.hpp"

namespace cagetol {
namespace {

/// Keys in which two resolved studies differ.
std::vector<std::string> differing_keys(const Json& one, const Json& other) {
  const Json first = one.flatten(), second = other.flatten();
  std::vector<std::string> keys;
  for (const auto& [key, value] : first.items())
    if (!second.contains(key) || second[key] != value) keys.push_back(key);
  for (const auto& [key, value] : second.items())
    if (!first.contains(key)) keys.push_back(key);
  for (std::string& key : keys) {  // "/scene/load/radial_N"
    if (!key.empty()) key.erase(0, 1);
    std::replace(key.begin(), key.end(), '/', '.');
  }
  return keys;
}

Json evidence_json(const ReportBasis& basis, const Json& ladder) {
  const std::string folder = basis.directory + "/" + kRefiningLadderFolder;
  Json evidence{
      {"state", "not measured"},
      {"directory", folder},
      {"command", "cagetol ladder " + basis.directory + "/study.toml --refine -o " + folder}};
  if (ladder.is_null()) return evidence;
  if (!ladder.value("refining", false)) {
    evidence["state"] = "not a refining ladder";
    return evidence;
  }
  if (const Json theirs = ladder.value("resolved_study", Json::object());
      theirs != basis.study.plan.whole) {
    evidence["state"] = "another study";
    evidence["study"] = ladder.value("study", "");
    evidence["differing_keys"] = differing_keys(theirs, basis.study.plan.whole);
    return evidence;
  }
  evidence["state"] = "measured";
  evidence["another_build"] = ladder.value("build", "") != basis.study.provenance.build;
  evidence["samples"] = ladder.at("samples");
  evidence["refined"] = Json::array();
  for (const Json& rung : ladder.at("rungs"))
    if (rung.at("name") != ladder.at("reference"))
      evidence["refined"].push_back({{"setting", rung.at("name")},
                                     {"meaning", rung.at("meaning")},
                                     {"cost_ratio", rung.at("cost_ratio")},
                                     {"runs_ok", rung.at("runs_ok")}});
  return evidence;
}

ReportedMean mean_of(const Json& quantity) {
  const Json& statistics = quantity.at("statistics");
  return {.standard_error = known(statistics.at("standard_error_of_mean")),
          .runs = statistics.at("runs_with_value"),
          .noise_deviation = known(quantity.at("noise").at("standard_deviation")),
          .noise_share = estimate_of(quantity.at("noise").at("share"), "value")};
}

Json source_json(const ErrorSource& source) {
  return {{"source", source.name},
          {"state", error_state_name(source.state)},
          {"error", to_json(source.error)},
          {"bound", number(source.bound)},
          {"standard_errors", number(source.share)},
          {"pairs", source.pairs},
          {"lost", source.lost}};
}

}  // namespace

Json error_budget_json(const ReportBasis& basis, const Json& quantities, const Json& ladder) {
  Json evidence = evidence_json(basis, ladder);
  const bool measured = evidence["state"] == "measured";
  const double confidence = measured ? known(ladder.at("confidence")) : basis.confidence;
  Json list = Json::array();
  for (const Json& quantity : quantities) {
    if (quantity.at("statistics").at("runs_with_value") == 0) continue;
    const auto shifts =
        measured ? refined_shifts(ladder, quantity.at("quantity")) : std::vector<RefinedShift>{};
    const ErrorBudget budget = error_budget(mean_of(quantity), shifts, confidence);
    Json entry{{"quantity", quantity.at("quantity")},
               {"unit", quantity.at("unit")},
               {"limited", !quantity.at("limit").is_null()},
               {"mean", quantity.at("statistics").at("mean").at("value")},
               {"sources", Json::array()},
               {"largest", budget.largest.empty() ? Json() : Json(budget.largest)},
               {"open", budget.open}};
    for (const ErrorSource& source : budget.sources)
      entry["sources"].push_back(source_json(source));
    list.push_back(std::move(entry));
  }
  return {{"evidence", std::move(evidence)},
          {"confidence", confidence},
          {"quantities", std::move(list)}};
}

}  // namespace cagetol
