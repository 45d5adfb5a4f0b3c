// A list of any number of numbers as the value of one key.
#pragma once

#include <cstddef>
#include <vector>

namespace cagetol {

struct NumberList {
  std::vector<double> values;

  bool empty() const { return values.empty(); }
  std::size_t size() const { return values.size(); }
  double operator[](std::size_t i) const { return values[i]; }
};

}  // namespace cagetol
