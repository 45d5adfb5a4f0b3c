// What the readers ask of the physics, so that fuzzing them compiles no physics.
#include <sundials/sundials_version.h>

#include "src/integration/integrator.hpp"
#include "src/quasi_static.hpp"

namespace cagetol {

const std::vector<MethodName>& integration_methods() {
  static const std::vector<MethodName> methods = {
      {"rodas4s", ""},   {"rodasp", ""},        {"rodas4f", ""},    {"rodas3", ""},
      {"cvode-bdf", ""}, {"arkode-esdirk", ""}, {"arkode-erk", ""}, {"semi-implicit-euler", ""},
  };
  return methods;
}

bool is_quasi_static_quantity(const std::string& key) {
  return key == "ring_displacement_mean_um";
}

}  // namespace cagetol

int SUNDIALSGetVersion(char* version, int length) {
  if (length > 0) version[0] = '\0';
  return 0;
}
