// Files that the program needs beside itself: scripts of figures and pages, the stability suite.
#pragma once

#include <filesystem>
#include <string>

namespace cagetol {

/// Where `path` (relative to the project's root, "analysis/figures") is: below ../share/cagetol as
/// seen from the program, wherever an installed one was moved to; else in the tree that it was
/// built from.
std::filesystem::path shipped_file(const std::string& path);

}  // namespace cagetol
