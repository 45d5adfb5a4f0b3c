// The values of a run's quantities, set one by one by whoever recorded them.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "src/quantities/quantity_rows.hpp"

namespace cagetol {

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Values by row of quantity_table(); all() throws where one was never set.
class QuantityValues {
 public:
  double& operator[](std::size_t row) {
    set_[row] = true;
    return values_[row];
  }
  std::vector<double> all() const {
    for (std::size_t row = 0; row < set_.size(); ++row)
      if (!set_[row])
        throw std::logic_error(std::string("quantity without a value: ") + kQuantityRows[row].key);
    return {values_.begin(), values_.end()};
  }

 private:
  std::array<double, kQuantityRows.size()> values_{};
  std::array<bool, kQuantityRows.size()> set_{};
};

}  // namespace cagetol
