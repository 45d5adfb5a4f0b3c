// Runs of another directory that are samples of this study to the bit: same geometry, same noise,
// same model. They need not be run again.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mc/study/study.hpp"

namespace cagetol {

/// Takes the outcomes stored in the directory `from` over into the journal of an empty `directory`,
/// as far as both studies draw the same samples for the same model and keep the same of them.
/// Returns their number: 0 where `directory` holds anything already. Rank 0 alone calls it, before
/// the sweep. Throws what SweepDirectory and read_study_file throw.
std::size_t adopt_runs(const Study& study, const std::string& directory, const std::string& from);

/// Directories of sweeps below `parent`: PREFIX.../BELOW, the largest study.h5 first.
std::vector<std::filesystem::path> sweeps_like(const std::filesystem::path& parent,
                                               const std::string& prefix,
                                               const std::filesystem::path& below = {});

/// Adopts runs from the first of these directories that has any; that one, or nothing. What cannot
/// be read is passed over.
std::optional<std::filesystem::path> adopt_any(const Study& study, const std::string& directory,
                                               const std::vector<std::filesystem::path>& from);

/// Rows of the study that the directory of a sweep holds; 0 where there is none. Makes good what a
/// process that died in grow_directory() left.
long stored_rows(const std::string& directory);

/// The complete directory of a sweep becomes that of a study with more rows. Its rows keep their
/// runs where the design draws them again; repeats have other ids then, and are run again.
void grow_directory(const Study& study, const std::string& directory);

}  // namespace cagetol
