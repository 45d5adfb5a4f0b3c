#include "src/integration/integrator.hpp"

#include <stdexcept>

#include "src/integration/rosenbrock.hpp"
#include "src/integration/sundials_methods.hpp"

namespace cagetol {

std::unique_ptr<Integrator> make_integrator(const Integration& given, const System& system,
                                            double t0, const double* y0) {
  Integration keys = given;
  keys.max_step = largest_step(system.model, given);
  switch (keys.method) {
    case IntegrationMethod::rodasp:
      return std::make_unique<Rosenbrock>(kRodasP, keys, system);
    case IntegrationMethod::rodas3:
      return std::make_unique<Rosenbrock>(kRodas3, keys, system);
    case IntegrationMethod::cvode_bdf:
      return make_cvode_bdf(keys, system, t0, y0);
    case IntegrationMethod::arkode_esdirk:
      return make_arkode(true, keys, system, t0, y0);
    case IntegrationMethod::arkode_erk:
      return make_arkode(false, keys, system, t0, y0);
  }
  throw std::logic_error("no such integration method");
}

}  // namespace cagetol
