// Laws as the study states them (mc/README.md, "law object").
#pragma once

#include <nlohmann/json.hpp>

#include "distributions/law.hpp"

namespace cagetol {

/// Throws StudyFileError for an unknown name, a missing key or parameters that make no law; `where`
/// names the input.
Law read_law(const nlohmann::json& object, const std::string& where);

}  // namespace cagetol
