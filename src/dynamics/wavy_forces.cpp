// The right-hand side of bearings whose raceways have waves.
#include "src/dynamics/evaluate.hpp"

namespace cagetol {

Evaluation wavy_rates(const BearingModel& model) {
  return model.lubricated ? evaluation_as<false, true, true>(model)
                          : evaluation_as<false, false, true>(model);
}

Evaluation wavy_linearisation(const BearingModel& model) {
  return model.lubricated ? evaluation_as<true, true, true>(model)
                          : evaluation_as<true, false, true>(model);
}

}  // namespace cagetol
