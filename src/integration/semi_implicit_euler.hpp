// Semi-implicit (symplectic) Euler with a fixed step: the honest explicit baseline. Past its
// stability limit one-sided contacts chatter and the bearing silently turns stiff; only the watches
// on static consistency and on the error of single steps tell.
#pragma once

#include "src/integration/integrator.hpp"

namespace cagetol {

class SemiImplicitEuler : public Integrator {
 public:
  explicit SemiImplicitEuler(const Integration& keys) : keys_(keys) {}
  StepStatus step(System& system, double& t, double* y, double t_end) override;

 private:
  /// Velocities are off by h/2 times the change of their rates over the step before.
  void watch_error(System& system, double h);

  Integration keys_;
  PackVector past_rate_, error_;
};

}  // namespace cagetol
