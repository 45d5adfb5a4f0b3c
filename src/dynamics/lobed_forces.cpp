// The right-hand side of bearings whose raceways have lobes.
#include "src/dynamics/evaluate.hpp"

namespace cagetol {

Evaluation lobed_rates(const BearingModel& model) {
  return model.lubricated ? evaluation_as<false, true, true>(model)
                          : evaluation_as<false, false, true>(model);
}

Evaluation lobed_linearisation(const BearingModel& model) {
  return model.lubricated ? evaluation_as<true, true, true>(model)
                          : evaluation_as<true, false, true>(model);
}

}  // namespace cagetol
