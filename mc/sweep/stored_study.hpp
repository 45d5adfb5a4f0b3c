// study.h5: the result of a sweep, built from outcomes in sample order. RESULTS_FORMAT.md says what
// is in it.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "mc/host/build_info.hpp"
#include "mc/run/stored_outcome.hpp"
#include "mc/sweep/sweep_plan.hpp"

namespace cagetol {

inline constexpr int kStudySchema = 2;

using OutcomesById = std::map<std::uint64_t, StoredOutcome>;

/// The bytes of the study file, sealed (mc/study_file/file_seal.hpp). The same outcomes give the
/// same bytes, wall clock and ranks (below /timing) apart.
std::string make_study_file(const SweepPlan& plan, const OutcomesById& outcomes,
                            const BuildInfo& build);

/// Replaces DIR/study.h5 at once: a reader sees the old file or the new one. Throws WriteError.
void write_study_file(const std::string& path, const SweepPlan& plan, const OutcomesById& outcomes,
                      const BuildInfo& build);

/// What replay and a restart need of a study file.
struct StudyFile {
  std::string study_hash, study_toml;
  std::string build;  ///< build_id() of the program that wrote it
  OutcomesById outcomes;
};

/// Throws StudyFileError when the file is no study file, or damaged.
StudyFile read_study_file(const std::string& path);

}  // namespace cagetol
