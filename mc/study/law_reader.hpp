// Probability laws between study files and the distributions room: { law = "normal", sigma = 0.009
// } and kin. The parameters are in the unit of the scene key whose deviation they describe;
// mc/README.md lists them.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "distributions/law.hpp"
#include "mc/study/measured_parts.hpp"

namespace cagetol {

/// What laws were read from.
using MeasurementFiles = std::vector<MeasuredParts>;

/// Reads a law. `key` names it in messages ("cage.pocket_width_mm.lot"); `unit` is the suffix of
/// the scene key's unit ("mm"), into which measurements are converted; `of` is what they are
/// held against; `file` is the file in which the law stands, measurements are looked for beside it
/// and added to `measurements`. A `nominal` beside the law belongs to the distribution and is
/// passed over. Throws InputError with file, line, key, value, reason and remedy.
Law read_law(const toml::table& table, const std::string& key, const std::string& unit,
             const std::string& file, MeasurementFiles& measurements, const MeasuredKey& of = {});

/// The law with all its parameters, measured values instead of the name of their file: reads back
/// to the same law.
toml::table law_table(const Law& law);

}  // namespace cagetol
