// The exception for a cage whose finite elements have no reliable solution. The cause is the cage
// or its mesh, which the user can change, not the program.
#pragma once

#include <stdexcept>

namespace cagetol {

class UnsolvedCage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cagetol
