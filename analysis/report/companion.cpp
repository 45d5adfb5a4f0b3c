#include "analysis/report/companion.hpp"

#include <algorithm>

namespace cagetol {

std::optional<StudyData> read_companion(const std::filesystem::path& sweep_directory) {
  const auto file = sweep_directory / kCompanionFolder / "study.h5";
  if (!std::filesystem::exists(file)) return std::nullopt;
  StudyData companion = read_study_data(file);
  if (static_cast<std::int64_t>(companion.size()) < companion.design.samples_planned)
    return std::nullopt;
  return companion;
}

std::string companion_problem(const StudyData& runs, const StudyData& companion) {
  if (companion.provenance.build != runs.provenance.build) return "it comes from another build";
  if (static_cast<std::int64_t>(runs.size()) < runs.design.rows_planned)
    return "the study has rows without an outcome";
  if (companion.size() < runs.size() || companion.inputs.size() != runs.inputs.size() ||
      !std::equal(runs.id.begin(), runs.id.end(), companion.id.begin()))
    return "its samples are not those of the study";
  for (const InputColumns& input : runs.inputs) {
    const InputColumns* other = find_input(companion, input.key);
    if (other == nullptr || other->value.size() < input.value.size() ||
        !std::equal(input.value.begin(), input.value.end(), other->value.begin()))
      return "its samples differ from the study's in " + input.key;
  }
  return "";
}

}  // namespace cagetol
