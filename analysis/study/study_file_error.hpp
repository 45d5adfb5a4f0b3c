// One type for everything that keeps a study file from being read, and one for estimators that
// decline.
#pragma once

#include <stdexcept>
#include <string>

namespace cagetol {

/// A study file that cannot be used. Message: "FILE: REASON\n  remedy: REMEDY".
class StudyFileError : public std::runtime_error {
 public:
  StudyFileError(const std::string& file, const std::string& reason, const std::string& remedy)
      : std::runtime_error(file + ": " + reason + "\n  remedy: " + remedy) {}
};

/// An estimator whose assumptions the design of the study does not meet. The report prints the
/// reason instead of a number.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cagetol
