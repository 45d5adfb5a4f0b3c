// What time histories hold: motions, speeds and forces that can be read off one accepted state. The
// histories of one run (run_history.hpp) and of a sweep's samples (sample_history.hpp) share them.
#pragma once

#include <vector>

#include "src/integration/system.hpp"
#include "src/quantities/cage_stress.hpp"

namespace cagetol {

/// An accepted state, linearised.
struct Instant {
  double t;  ///< since the start of the run [s]
  const double* y;
  const System& system;
  CageStress* stress;  ///< of a flexible cage; nullptr: rigid
};

/// A number of the bearing at an instant.
struct BearingChannel {
  const char *name, *unit, *description;
  double (*value)(const Instant&);
};

/// A number of each roller at an instant.
struct RollerChannel {
  const char *name, *unit, *description;
  double (*value)(const Instant&, int roller);
};

const std::vector<BearingChannel>& bearing_channels();
const std::vector<RollerChannel>& roller_channels();

}  // namespace cagetol
