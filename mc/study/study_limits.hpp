// What a study asks of its samples: limits on quantities of interest, the tolerances in question
// and their candidates.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "mc/study/study.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {

/// The error for a node that names a quantity which is not in quantity_table(), or a label that is
/// none of `labels`.
InputError no_such_quantity(const toml::node& node, const std::string& key,
                            const std::string& quantity, const std::string& file,
                            const std::vector<std::string>& labels);

/// The [[limit]] entries. Throws InputError, for instance for a quantity that is not in
/// quantity_table(), or whose label is none of `labels` (src/quantities/quantity_labels.hpp).
std::vector<Limit> read_limits(const toml::table& root, const std::string& file,
                               const std::vector<std::string>& labels = {});

/// The [[tolerance.dimension]] entries: each names an uncertain length. `inputs` must be read
/// already.
std::vector<ToleranceDimension> read_dimensions(const toml::table& root, const std::string& file,
                                                const std::vector<UncertainInput>& inputs);

/// All combinations of the dimensions' candidates, the first dimension slowest. Grades become
/// tolerances by ISO 286 for the nominal size of their key. Throws InputError for grades that it
/// does not have, and for tolerances wider than the size.
std::vector<Candidate> make_candidates(const Study& study, const toml::table& root,
                                       const std::string& file);

}  // namespace cagetol
