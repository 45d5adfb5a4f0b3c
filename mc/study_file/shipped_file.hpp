// Files that the program needs beside itself: scripts of figures and pages, the stability suite.
#pragma once

#include <filesystem>
#include <string>

namespace cagetol {

/// Where `path` (relative to the project's root, "analysis/figures") is: of a program that still
/// stands where it was built, in the tree that it was built from; else below ../share/cagetol as
/// seen from it, wherever it was moved to.
std::filesystem::path shipped_file(const std::string& path);

}  // namespace cagetol
