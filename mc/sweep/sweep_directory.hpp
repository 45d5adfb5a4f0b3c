// The output directory of a sweep: DIR/study.toml (the resolved study), DIR/journal/ and
// DIR/study.h5. It belongs to one study, whatever its runs are judged by (identity_text), and one
// build; anything else is refused with the difference named.
#pragma once

#include <string>
#include <vector>

#include "mc/host/file_write.hpp"
#include "mc/sweep/journal.hpp"
#include "mc/sweep/stored_study.hpp"

namespace cagetol {

class SweepDirectory {
 public:
  /// Creates the directory, or opens one that holds this study. Keeps other sweeps out while it
  /// lives. study.h5 is opened only where journals lack a sample; a damaged study.toml is written
  /// again where journals or study.h5 carry the study's hash. Throws InputError when it holds
  /// another study, was written by another build, is in use, or a damaged study.h5 is all that it
  /// has; WriteError when it cannot be used.
  SweepDirectory(const std::string& directory, const Study& study, const BuildInfo& build);

  /// What is stored: outcomes of all journals and, where journals were lost, of study.h5.
  const JournalSet& stored() const { return stored_; }
  /// Outcomes that only study.h5 has: to be written to a journal again.
  const std::vector<StoredOutcome>& only_in_study_file() const { return only_in_study_file_; }
  /// Frees what stored() and only_in_study_file() hold, for those who need the lock alone.
  void forget_outcomes();

 private:
  void lock();
  void check_journals(const Study& study, const BuildInfo& build) const;
  void read_study_h5(const Study& study, const BuildInfo& build);
  void take_over(const OutcomesById& outcomes);
  void check_study_toml(const Study& study);

  std::string directory_;
  FileDescriptor lock_;
  JournalSet stored_;
  bool is_this_study_ = false;  ///< journals or study.h5 carry its hash
  std::vector<StoredOutcome> only_in_study_file_;
};

/// A directory holds a sweep or a recommendation, never both. Throws InputError where `folder`,
/// which the other kind makes, is in `directory`; `what` names that kind.
void require_no_other(const std::string& directory, const std::string& folder,
                      const std::string& what);

std::string journal_directory(const std::string& directory);
std::string study_file_path(const std::string& directory);
std::string stored_study_path(const std::string& directory);

/// Keys with other values, "scene.load.radial_N: 1000 stored, 2000 now", of two resolved studies in
/// TOML. `pattern` may word it otherwise: {0} is the key, {1} and {2} are its values.
std::vector<std::string> study_differences(const std::string& stored_toml,
                                           const std::string& new_toml,
                                           const std::string& pattern = "{0}: {1} stored, {2} now");

}  // namespace cagetol
