// report.html, report.pdf and appendix.pdf: Python lays report.json out with the templates of
// analysis/pages.
#pragma once

#include <filesystem>
#include <string>

namespace cagetol {

struct PageWriter {
  std::filesystem::path pages_dir;    ///< analysis/pages
  std::filesystem::path figures_dir;  ///< analysis/figures
  std::string python;
  bool figures = true;  ///< draw figures and place them on the pages
  bool pdf = false;     ///< report.pdf and appendix.pdf, too
};

/// Removes the pages of an earlier report, so that none stands beside newer numbers.
void remove_pages(const std::filesystem::path& directory);

/// Writes report.html (and the PDFs) and figures/ beside `report_json`, each whole or not at all;
/// beside KIND.json of `cagetol rig`, `history` and `map` KIND.html, and map.pdf.
/// Returns what went wrong, with the package to install where one is missing; empty when nothing
/// did. Never throws for want of Python; throws UnfinishedWrite where the disk is full.
std::string write_pages(const PageWriter& writer, const std::filesystem::path& report_json);

}  // namespace cagetol
