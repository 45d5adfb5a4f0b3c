#include "src/quantities/quantity_labels.hpp"

#include <algorithm>

#include "src/quantities/quantity_table.hpp"

namespace cagetol {

LabelledKey labelled_key(std::string_view name) {
  const auto at = name.find('@');
  if (at == std::string_view::npos) return {std::string(name), ""};
  return {std::string(name.substr(0, at)), std::string(name.substr(at + 1))};
}

std::string labelled_name(std::string_view key, std::string_view label) {
  return std::string(key) + (label.empty() ? "" : "@" + std::string(label));
}

std::vector<LabelledQuantity> labelled_quantities(const std::vector<std::string>& labels) {
  std::vector<LabelledQuantity> all;
  for (const Quantity& row : quantity_table()) all.push_back({row.key, row.unit, row.definition});
  for (const std::string& label : labels)
    for (const Quantity& row : quantity_table())
      all.push_back(
          {labelled_name(row.key, label), row.unit, "of " + label + " alone: " + row.definition});
  return all;
}

std::size_t quantity_count(const std::vector<std::string>& labels) {
  return quantity_table().size() * (1 + labels.size());
}

int labelled_index(std::string_view name, const std::vector<std::string>& labels) {
  const auto [key, label] = labelled_key(name);
  const int row = quantity_index(key);
  if (row < 0 || label.empty()) return name.find('@') == std::string_view::npos ? row : -1;
  const auto found = std::find(labels.begin(), labels.end(), label);
  if (found == labels.end()) return -1;
  const auto part = static_cast<int>(found - labels.begin()) + 1;
  return part * static_cast<int>(quantity_table().size()) + row;
}

}  // namespace cagetol
