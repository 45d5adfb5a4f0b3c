#include "src/quantities/quantity_table.hpp"

#include "src/quantities/quantity_rows.hpp"

namespace cagetol {

const std::vector<Quantity>& quantity_table() {
  static const std::vector<Quantity> table(kQuantityRows.begin(), kQuantityRows.end());
  return table;
}

int quantity_index(const std::string& key) {
  const auto& table = quantity_table();
  for (std::size_t i = 0; i < table.size(); ++i)
    if (table[i].key == key) return static_cast<int>(i);
  return -1;
}

const Quantity& quantity_named(const std::string& name) {
  const int index = quantity_index(name.substr(0, name.find('@')));
  return quantity_table().at(static_cast<std::size_t>(index));
}

}  // namespace cagetol
