// Gaussian-copula correlation between two inputs of one scope.
#pragma once

#include <string>

namespace cagetol {

struct Correlation {
  std::string first, second;  ///< "KEY:lot" or "KEY:pocket"
  double rho = 0;
};

}  // namespace cagetol
