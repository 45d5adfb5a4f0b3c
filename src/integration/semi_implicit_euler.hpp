// Semi-implicit (symplectic) Euler with a fixed step: the honest explicit baseline. Past its
// stability limit one-sided contacts chatter and the bearing silently turns stiff; only the watch
// on static consistency tells.
#pragma once

#include "src/integration/integrator.hpp"

namespace cagetol {

class SemiImplicitEuler : public Integrator {
 public:
  explicit SemiImplicitEuler(const Integration& keys) : keys_(keys) {}
  StepStatus step(System& system, double& t, double* y, double t_end) override;

 private:
  Integration keys_;
};

}  // namespace cagetol
