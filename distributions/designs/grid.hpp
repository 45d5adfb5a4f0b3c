// Full factorial design: every combination of the groups' levels. The first group varies slowest.
// The columns of a group share its level. Levels are equally spaced and include the ends: level i
// of n lies at
//   u = trim + (1 - 2 trim) i / (n - 1)
// so that a uniform law is covered from its lower to its upper limit. A single level lies at
// u = 1/2, the median.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "distributions/designs/layout.hpp"

namespace cagetol {

class Grid {
 public:
  explicit Grid(const DesignSpec& spec);

  static std::uint64_t complete_rows(const DesignSpec& spec);
  static std::string row_rule(const DesignSpec&) { return "the product of its levels"; }

  void point(std::uint64_t row, std::span<double> u) const;

 private:
  std::uint64_t rows_;
  double trim_;
  std::vector<std::uint64_t> levels_;   ///< for each group
  std::vector<std::uint64_t> strides_;  ///< for each group: rows from one of its levels to the next
  std::vector<std::uint32_t> group_of_column_;
};

}  // namespace cagetol
