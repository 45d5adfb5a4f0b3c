// The finite elements of a cage have no solution that can be trusted: a property of the cage and
// its mesh, which the user can change, not of the program.
#pragma once

#include <stdexcept>

namespace cagetol {

class UnsolvedCage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cagetol
