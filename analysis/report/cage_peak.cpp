#include "analysis/report/cage_peak.hpp"

#include <cmath>
#include <fstream>

namespace cagetol {

std::optional<std::int64_t> most_stressed_sample(const StudyData& study) {
  const Column* stress = find_quantity(study, "cage_stress_peak_MPa");
  if (stress == nullptr) return std::nullopt;
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < study.size(); ++i) {
    if (study.status[i] != RunStatus::ok || std::isnan(stress->values[i])) continue;
    if (!worst || stress->values[i] > stress->values[*worst]) worst = i;
  }
  if (!worst) return std::nullopt;
  return study.id[*worst];
}

std::filesystem::path cage_peak_file(const std::filesystem::path& sweep_directory) {
  return sweep_directory / "cage_peak.json";
}

Json read_cage_peak(const std::filesystem::path& sweep_directory, const StudyData& study) {
  std::ifstream file(cage_peak_file(sweep_directory));
  const Json peak = file ? Json::parse(file, nullptr, false) : Json();
  const auto sample = most_stressed_sample(study);
  const bool current = peak.is_object() && sample &&
                       peak.value("study_hash", "") == study.provenance.study_hash &&
                       peak.value("build", "") == study.provenance.build &&
                       peak.value("sample", std::int64_t{-1}) == *sample;
  return current ? peak : Json();
}

}  // namespace cagetol
