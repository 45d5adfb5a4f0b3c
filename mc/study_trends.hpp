// What a source claims about the quantities between two levels of a dimension: the report puts the
// study's own differences beside it.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "mc/sample.hpp"
#include "mc/study.hpp"

namespace cagetol {

/// The [[trend]] entries. `study` holds design and inputs already: trends need a grid, and name an
/// input that varies by lot. Throws InputError.
std::vector<Trend> read_trends(const toml::table& root, const std::string& file,
                               const Study& study);

/// Throws InputError for a trend between levels that the grid does not have.
void check_trend_levels(const Study& study, const Sampler& sampler, const toml::table& root,
                        const std::string& file);

toml::table trend_table(const Trend& trend);

}  // namespace cagetol
