// The right-hand side of lubricated bearings.
#include "src/dynamics/evaluate.hpp"

namespace cagetol {

Evaluation lubricated_rates(const BearingModel& model) {
  return evaluation_as<false, true>(model);
}

Evaluation lubricated_linearisation(const BearingModel& model) {
  return evaluation_as<true, true>(model);
}

}  // namespace cagetol
