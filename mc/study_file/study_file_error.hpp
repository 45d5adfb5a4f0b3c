// One type for everything that keeps a study file from being read.
#pragma once

#include <stdexcept>
#include <string>

namespace cagetol {

/// The remedy for every damaged study.h5.
inline constexpr const char* kRebuildRemedy =
    "start the same `cagetol sweep` again: it builds study.h5 anew from DIR/journal";

/// A study file that cannot be used. Message: "FILE: REASON\n  remedy: REMEDY".
class StudyFileError : public std::runtime_error {
 public:
  StudyFileError(const std::string& file, const std::string& reason, const std::string& remedy)
      : std::runtime_error(file + ": " + reason + "\n  remedy: " + remedy), reason_(reason) {}
  /// Without file and remedy, for those who know a better remedy.
  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

/// A file of results could not be written for a reason that passes (a full disk): the same command
/// goes on later.
class UnfinishedWrite : public StudyFileError {
 public:
  using StudyFileError::StudyFileError;
};

}  // namespace cagetol
