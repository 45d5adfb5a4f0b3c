// The quantities of interest of a run, in the order of all files and tables.
#pragma once

#include <string>
#include <vector>

namespace cagetol {

struct Quantity {
  const char* key;         ///< name in study.h5 and --json output, unit as suffix
  const char* unit;        ///< "-" for a ratio
  const char* definition;  ///< one sentence, printed in reports
};

const std::vector<Quantity>& quantity_table();

/// Whether a quantity is a peak, a minimum or a quantile, by its name: it depends on the time that
/// it is taken over (window.peak_revolutions). The name may have a label (quantity_labels.hpp).
bool is_extreme(const std::string& name);

/// Position of `key` in quantity_table(), or -1.
int quantity_index(const std::string& key);

}  // namespace cagetol
