#include "src/integration/integrator.hpp"

#include <stdexcept>

#include "src/integration/rosenbrock.hpp"
#include "src/integration/semi_implicit_euler.hpp"
#include "src/integration/sundials_methods.hpp"

namespace cagetol {

const std::vector<MethodName>& integration_methods() {
  static const std::vector<MethodName> methods = {
      {"rodas3", "linearly implicit (Rosenbrock), order 3(2), L-stable, error-controlled step"},
      {"rodasp", "linearly implicit (Rosenbrock), order 4(3), L-stable: for tight tolerances"},
      {"cvode-bdf", "CVODE, BDF with its order capped by integration.max_order"},
      {"arkode-esdirk", "ARKODE, diagonally implicit, order 3, L-stable"},
      {"arkode-erk", "ARKODE, explicit, order 3: limited by stability"},
      {"semi-implicit-euler", "fixed step, order 1: the explicit baseline"},
  };
  return methods;
}

std::unique_ptr<Integrator> make_integrator(const Integration& keys, const System& system,
                                            double t0, const double* y0) {
  if (keys.method == "rodas3") return std::make_unique<Rosenbrock>(kRodas3, keys, system);
  if (keys.method == "rodasp") return std::make_unique<Rosenbrock>(kRodasP, keys, system);
  if (keys.method == "cvode-bdf") return make_cvode_bdf(keys, system, t0, y0);
  if (keys.method == "arkode-esdirk") return make_arkode(true, keys, system, t0, y0);
  if (keys.method == "arkode-erk") return make_arkode(false, keys, system, t0, y0);
  if (keys.method == "semi-implicit-euler") return std::make_unique<SemiImplicitEuler>(keys);
  throw std::domain_error("unknown integration method '" + keys.method + "'");
}

}  // namespace cagetol
