// Runs one of the Python scripts of this room: figures and pages.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cagetol {

struct PythonRun {
  int code = -1;        ///< exit code; -1 where the script did not run or was stopped
  std::string problem;  ///< why it did not run, or the last line it printed; empty: all well
};

/// Runs `python SCRIPT ARGUMENTS` isolated, so that neither PYTHONPATH nor the user's own packages
/// decide what is run, with its output in `log`, which is removed where it is empty. Never throws
/// for want of Python.
PythonRun run_python(const std::string& python, const std::filesystem::path& script,
                     const std::vector<std::string>& arguments, const std::filesystem::path& log);

/// Text of a file; empty where it cannot be read.
std::string file_text(const std::filesystem::path& path);

}  // namespace cagetol
