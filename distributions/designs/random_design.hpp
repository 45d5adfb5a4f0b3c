// Independent points. Every coordinate is the uniform number at its own address. The id is the row,
// or the lot for columns of Purpose::lot, whose values the cages of a lot share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "distributions/designs/layout.hpp"

namespace cagetol {

class RandomDesign {
 public:
  explicit RandomDesign(const DesignSpec& spec);

  void point(std::uint64_t row, std::span<double> u) const;

 private:
  std::uint64_t seed_, rows_, cages_per_lot_;
  std::vector<DesignColumn> columns_;
};

}  // namespace cagetol
