#include "src/quantities/quantity_table.hpp"

#include "src/quantities/quantity_rows.hpp"

namespace cagetol {

const std::vector<Quantity>& quantity_table() {
  static const std::vector<Quantity> table(kQuantityRows.begin(), kQuantityRows.end());
  return table;
}

bool is_extreme(const std::string& name) {
  const std::string key = name.substr(0, name.find('@'));
  for (const char* part : {"_peak", "_p95", "_p99", "_min_", "_fatigue_", "_utilisation"})
    if (key.find(part) != std::string::npos) return true;
  return false;
}

int quantity_index(const std::string& key) {
  const auto& table = quantity_table();
  for (std::size_t i = 0; i < table.size(); ++i)
    if (table[i].key == key) return static_cast<int>(i);
  return -1;
}

}  // namespace cagetol
