// One type for estimators that decline.
#pragma once

#include <stdexcept>

namespace cagetol {

/// An estimator whose assumptions the design of the study does not meet. The report prints the
/// reason instead of a number.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cagetol
