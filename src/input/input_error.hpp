// One type for everything that is wrong with what the user gave: it ends the program with exit
// code 2.
#pragma once

#include <stdexcept>
#include <string>

namespace cagetol {

/// Where in a user's file a value stands. `line` is 1-based, 0 where the text has no lines (command
/// line, whole file).
struct SourcePlace {
  std::string file;
  int line = 0;
};

/// Bad input: what is wrong, where, why it is a problem, and what to do about it.
class InputError : public std::runtime_error {
 public:
  /// Message reads "FILE:LINE: KEY = VALUE: PROBLEM\n  remedy: REMEDY"; empty parts are left out.
  /// What would act on a terminal is written as \xNN (printable.hpp).
  InputError(const SourcePlace& place, const std::string& key, const std::string& value,
             const std::string& problem, const std::string& remedy);
};

}  // namespace cagetol
