// Files that ship with the program, for tests.
#pragma once

#include <string>

namespace cagetol {

/// Path of a file in inputs/.
inline std::string shipped(const std::string& path) {
  return std::string(CAGETOL_SOURCE_DIR) + "/inputs/" + path;
}

}  // namespace cagetol
