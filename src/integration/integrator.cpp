#include "src/integration/integrator.hpp"

#include <stdexcept>

#include "src/integration/rosenbrock.hpp"
#include "src/integration/semi_implicit_euler.hpp"

namespace cagetol {

const std::vector<MethodName>& integration_methods() {
  static const std::vector<MethodName> methods = {
      {"rodas3", "linearly implicit, order 3(2), L-stable, touch-aware error-controlled step"},
      {"rodas4", "the same of order 4(3)"},
      {"semi-implicit-euler", "fixed step, order 1: the explicit baseline"},
  };
  return methods;
}

std::unique_ptr<Integrator> make_integrator(const Integration& keys, const System& system, double, const double*) {
  if (keys.method == "rodas3") return std::make_unique<Rosenbrock>(kRodas3, keys, system);
  if (keys.method == "rodas4") return std::make_unique<Rosenbrock>(kRodas4, keys, system);
  if (keys.method == "semi-implicit-euler") return std::make_unique<SemiImplicitEuler>(keys);
  throw std::domain_error("unknown integration method '" + keys.method + "'");
}

}  // namespace cagetol
