// Figures drawn by Python from the JSON file of a command.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace cagetol {

struct FigureSet {
  std::map<std::string, std::string> svg;  ///< text of each figure drawn, by name
  std::string problem;                     ///< why figures are missing; empty when all was drawn
};

/// Runs `python draw.py REPORT_JSON OUTPUT_DIR` from `scripts`. Never throws for want of Python:
/// `problem` says what happened.
FigureSet draw_figures(const std::string& python, const std::filesystem::path& scripts,
                       const std::filesystem::path& report_json,
                       const std::filesystem::path& output_dir);

}  // namespace cagetol
