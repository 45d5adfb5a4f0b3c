// One narrow door to every integration method: take one accepted step.
#pragma once

#include <memory>
#include <string>

#include "src/integration/system.hpp"

namespace cagetol {

enum class StepStatus { accepted, failed, out_of_budget };

class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Takes one accepted step from (t, y) to at most t_end and updates both. Expects
  /// system.linearise_at(t, y) to have been called for this very state. Counts steps and rejections
  /// in system.counts.
  virtual StepStatus step(System& system, double& t, double* y, double t_end) = 0;

  /// Why the last step failed, for people.
  const std::string& failure() const { return failure_; }

 protected:
  std::string failure_;
};

/// Makes the method named in the scene's integration keys.
std::unique_ptr<Integrator> make_integrator(const Integration& keys, const System& system,
                                            double t0, const double* y0);

}  // namespace cagetol
