// Runs under alternatives of assumptions: DIR/assumptions.json and the sweeps that it names.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/study/study_data.hpp"
#include "analysis/tolerance/assumption_plan.hpp"

namespace cagetol {

inline constexpr const char* kAssumptionsFile = "assumptions.json";

/// Nothing where there is no such file, or none that can be read.
std::optional<AssumptionPlan> stored_assumption_plan(const std::filesystem::path& file);

struct AssumptionRuns {
  AssumptionPlan plan;
  std::vector<AssumedValue> alternatives;  ///< those that were run to the end
  std::vector<StudyData> runs;             ///< of each of them
};

/// Nothing where there is no such file, none that can be read, or no alternative. Left out are
/// sweeps that are not complete and those of other cages, another tolerance or another build than
/// the attempt's.
std::optional<AssumptionRuns> read_assumption_runs(const std::filesystem::path& directory,
                                                   const std::vector<StudyData>& confirmations);

}  // namespace cagetol
