// Runs one sample of a finished or interrupted sweep again, from what its study.h5 says alone, and
// compares it to the bit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mc/run/stored_outcome.hpp"
#include "mc/study/sample.hpp"

namespace cagetol {

/// A sample as it was stored, ready to run again.
struct StoredSample {
  Study study;
  Sample sample;
  std::optional<StoredOutcome> stored;  ///< nothing when it has not been run yet
  std::string stored_build;             ///< build_id() of the program that wrote study.h5
  std::vector<std::string> notes;       ///< another build, a study that reads differently now
};

/// Throws StudyFileError when DIR has no readable study.h5, InputError when the study has no such
/// sample.
StoredSample read_stored_sample(const std::string& directory, std::uint64_t id);

}  // namespace cagetol
