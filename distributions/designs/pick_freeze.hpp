// Pick-freeze design by groups, for total indices by Jansen's estimator (1999,
// doi:10.1016/S0010-4655(98)00154-4). A base has two independent random points A and B, and for
// each group the point A with the columns of this group taken from B. Rows of a base: A, B, A with
// group 0 from B, A with group 1 from B, ...
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "distributions/designs/layout.hpp"

namespace cagetol {

class PickFreeze {
 public:
  explicit PickFreeze(const DesignSpec& spec);

  static std::uint64_t complete_rows(const DesignSpec& spec);
  static std::string row_rule(const DesignSpec& spec);

  Layout layout() const { return {blocks_, rows_ / blocks_, true}; }
  void point(std::uint64_t row, std::span<double> u) const;

  /// The id at which the group is drawn: 2 base for values of A, 2 base + 1 for values of B.
  std::uint64_t source_of(std::uint64_t row, std::uint32_t group) const;

 private:
  std::uint64_t seed_, rows_, blocks_;
  std::vector<DesignColumn> columns_;
};

}  // namespace cagetol
