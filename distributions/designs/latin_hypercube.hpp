// Latin hypercube (McKay, Beckman, Conover 1979, doi:10.1080/00401706.1979.10489755). Each column
// divides [0,1] into as many equal cells as there are rows and has one point at a random position
// in each cell. Every column has its own permutation of the cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "distributions/designs/layout.hpp"

namespace cagetol {

class LatinHypercube {
 public:
  explicit LatinHypercube(const DesignSpec& spec);

  void point(std::uint64_t row, std::span<double> u) const;

 private:
  std::uint64_t rows_;
  std::vector<PhiloxKey> keys_;
};

}  // namespace cagetol
