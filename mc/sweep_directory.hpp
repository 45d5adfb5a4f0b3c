// The output directory of a sweep: DIR/study.toml (the resolved study), DIR/journal/ and
// DIR/study.h5. It belongs to one study and one build; anything else is refused with the difference
// named.
#pragma once

#include <string>
#include <vector>

#include "mc/file_write.hpp"
#include "mc/journal.hpp"
#include "mc/study_file.hpp"

namespace cagetol {

class SweepDirectory {
 public:
  /// Creates the directory, or opens one that holds this study. Keeps other sweeps out while it
  /// lives. Throws InputError when it holds another study, was written by another build or is in
  /// use; WriteError when it cannot be used.
  SweepDirectory(const std::string& directory, const Study& study, const BuildInfo& build);

  /// What is stored: outcomes of all journals and, where journals were lost, of study.h5.
  const JournalSet& stored() const { return stored_; }
  /// Outcomes that only study.h5 has: to be written to a journal again.
  const std::vector<StoredOutcome>& only_in_study_file() const { return only_in_study_file_; }

 private:
  void lock();
  void check_study(const Study& study, const BuildInfo& build) const;
  void read_study_h5(const Study& study, const BuildInfo& build);

  std::string directory_;
  FileDescriptor lock_;
  JournalSet stored_;
  std::vector<StoredOutcome> only_in_study_file_;
};

std::string journal_directory(const std::string& directory);
std::string study_file_path(const std::string& directory);
std::string stored_study_path(const std::string& directory);

/// Keys with other values, "scene.load.radial_N: 1000 stored, 2000 now", of two resolved studies in
/// TOML. `pattern` may word it otherwise: {0} is the key, {1} and {2} are its values.
std::vector<std::string> study_differences(const std::string& stored_toml,
                                           const std::string& new_toml,
                                           const std::string& pattern = "{0}: {1} stored, {2} now");

}  // namespace cagetol
