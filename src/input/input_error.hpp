// The exception for bad input. It ends the program with exit code 2.
#pragma once

#include <stdexcept>
#include <string>

namespace cagetol {

/// Place of a value in the user's input. `line` counts from 1; 0 for a command line or a whole
/// file.
struct SourcePlace {
  std::string file;
  int line = 0;
};

/// Bad input: what is wrong, where, why it is a problem, and what to do about it.
class InputError : public std::runtime_error {
 public:
  /// Message: "FILE:LINE: KEY = VALUE: PROBLEM\n  remedy: REMEDY", without the parts that are
  /// empty. Control characters are written as \xNN (printable.hpp).
  InputError(const SourcePlace& place, const std::string& key, const std::string& value,
             const std::string& problem, const std::string& remedy);
};

}  // namespace cagetol
