// The pages of a report as the program lays them out.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace cagetol {

/// report.html of this report.json, written by the templates of analysis/pages without figures;
/// what went wrong in place of a page that was not written.
std::string page_of(const nlohmann::ordered_json& report);

/// The same with the figures, which take seconds.
std::string page_with_figures(const nlohmann::ordered_json& report);

/// The part of a page between `<section id="NAME"` and its end; empty without it.
std::string section_of(const std::string& page, const std::string& name);

/// Text of a file, without the marks at which a long word may break.
std::string page_text(const std::filesystem::path& file);

}  // namespace cagetol
