// What this program was built from: two runs may only be mixed in one study when this is the same.
#pragma once

#include <string>

namespace cagetol {

struct BuildInfo {
  std::string version;    ///< "0.1.0"
  std::string commit;     ///< commit, with "+changes" when the working tree differed; "unknown"
                          ///< outside a repository
  std::string compiler;   ///< compiler, its version and the flags
  std::string program;    ///< 16 hex digits: hash of the executable file
  std::string libraries;  ///< JSON object: library name -> version in use
};

BuildInfo build_info();

/// One line that names a build in journals and messages; equal lines mean equal programs.
std::string build_id(const BuildInfo& info);

/// 16 hex digits (FNV-1a, 64 bit). Tells texts and files apart; not meant against forgery.
std::string text_hash(const std::string& text);

}  // namespace cagetol
