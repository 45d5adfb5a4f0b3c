// The [[assumption]] entries of a scene: which values nobody measured, why they were taken, and
// between which ends they may lie.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "src/scene/scene.hpp"

namespace cagetol {

/// Reads a list of tables with `key` and `note`, and either both of `low` and `high` or none, in
/// the key's unit. Throws InputError where there is no such key, where one of two entries for a key
/// has a range, and for ranges that are none: ends that are no numbers or outside the range of the
/// key, low above high, a key that holds no number with a unit.
std::vector<Assumption> read_assumptions(const toml::node& node, const std::string& file);

/// Makes of `replacing` the entries of `base`, those for the same keys replaced at their place, and
/// then its other ones. Both are lists of tables; what is none of it is left to read_assumptions.
void add_assumptions(toml::array&& base, toml::array& replacing);

}  // namespace cagetol
