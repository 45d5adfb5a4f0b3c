// Quantities of parts of a study or a run: those of a named phase, or of one of several operating
// points. Each has all quantities of quantity_table() under names of its own, KEY@LABEL; those of
// the whole come first and have no label.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cagetol {

/// "cage_slip_ratio" and "braking" of "cage_slip_ratio@braking"; no label: empty.
struct LabelledKey {
  std::string key, label;
};
LabelledKey labelled_key(std::string_view name);
/// KEY@LABEL; KEY where the label is empty.
std::string labelled_name(std::string_view key, std::string_view label);

/// A quantity under its name, with unit and definition.
struct LabelledQuantity {
  std::string name, unit, definition;
};
/// All of a run with these labels, in the order of Outcome::quantities.
std::vector<LabelledQuantity> labelled_quantities(const std::vector<std::string>& labels);

/// Number of values of a run with these labels.
std::size_t quantity_count(const std::vector<std::string>& labels);
/// Position of a name among them, or -1.
int labelled_index(std::string_view name, const std::vector<std::string>& labels);

}  // namespace cagetol
