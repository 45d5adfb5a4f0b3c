// What a flexible cage has of its own: the error of its per-sample model, the field of the largest
// stress.
#include <algorithm>
#include <cmath>

#include "analysis/report/json_parts.hpp"
#include "mc/study_file/cage_thickness.hpp"

namespace cagetol {
namespace {

// The accuracy that the per-sample model is held to (tests/unit/cage/cage_model_test.cpp).
constexpr double kScatteredTarget = 0.002;  // pockets scattered as shops make them
constexpr double kExtremeTarget = 0.005;    // all pockets at the ends of the covered deviations

bool is_flexible(const Json& scene) {
  return scene.is_object() && scene.contains("cage") &&
         scene.at("cage").value("model", "") == "flexible";
}

Json accuracy_json(const StudyData& study) {
  const auto column = std::find_if(study.run.begin(), study.run.end(), [](const Column& run) {
    return run.name == "cage_frequency_error";
  });
  std::size_t checked = 0;
  double largest = 0, sum = 0;
  if (column != study.run.end())
    for (const double error : column->values) {
      if (std::isnan(error)) continue;
      ++checked;
      largest = std::max(largest, error);
      sum += error;
    }
  return {{"samples_checked", checked},
          {"samples", study.size()},
          {"largest_error", checked > 0 ? Json(largest) : Json()},
          {"mean_error", checked > 0 ? Json(sum / static_cast<double>(checked)) : Json()},
          {"target_scattered", kScatteredTarget},
          {"target_extreme", kExtremeTarget}};
}

/// Largest deviation of the cage's diameters over the samples, as a share of the nominal thickness,
/// and the errors that it leaves; null where they do not vary.
Json thickness_json(const StudyData& study) {
  const InputColumns* surface[] = {find_input(study, "cage.inner_diameter_mm"),
                                   find_input(study, "cage.outer_diameter_mm")};
  const nlohmann::ordered_json& cage = study.plan.scene.at("cage");
  double largest = 0;
  for (std::size_t i = 0; i < study.size(); ++i) {
    double sum = 0;
    for (const InputColumns* input : surface)
      if (input != nullptr) sum += std::abs(input->value[i] - input->nominal[0]);
    largest = std::max(largest, sum);
  }
  if (!(largest > 0)) return {};
  const double share = largest / (cage.at("outer_diameter_mm").get<double>() -
                                  cage.at("inner_diameter_mm").get<double>());
  return {{"largest_share", share},
          {"frequency_error", kFrequencyErrorPerShare * share},
          {"compliance_error", kComplianceErrorPerShare * share},
          {"stress_error", kStressErrorPerShare * share}};
}

}  // namespace

Json cage_json(const ReportBasis& basis, const Json& peak) {
  if (!is_flexible(basis.study.plan.scene)) return {};
  Json cage{{"accuracy", accuracy_json(basis.study)},
            {"thickness", thickness_json(basis.study)},
            {"peak", peak}};
  if (!peak.is_null()) {
    cage["peak"].erase("study_hash");
    cage["peak"].erase("build");
  }
  return cage;
}

}  // namespace cagetol
