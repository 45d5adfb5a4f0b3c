// All settings of the step control that are not keys of the scene (integration.tolerance,
// integration.max_step_us, integration.step_budget). Bearing model and contacts know none of them.
#pragma once

namespace cagetol {

struct StepControl {
  // One unit of error (error_units in system.hpp). A step is taken while the root mean square of
  // its error over these, lever arms included, is below integration.tolerance. Lengths count by the
  // roller's diameter: bearings that differ in size alone, at the same surface speed and pressure,
  // move alike in times that grow with the size, and their contacts vibrate at the same speeds. So
  // the unit of speed is the same for all sizes. It grows with the raceways' speed where that is
  // high, because errors are then small beside it.
  double lengths_per_diameter = 7500;  ///< 1 um for rollers of 7.5 mm
  double speed_unit = 1e-2;            ///< the least one [m/s]
  double speed_share = 1e-3;           ///< of the fastest raceway surface's speed

  // The largest step by default: so many between two rollers that pass. It is not shortened
  // below largest_step, because in fast bearings the error alone keeps steps short.
  double steps_per_roller = 40;
  double largest_step = 50e-6;  ///< [s]

  double first_step = 1e-7;  ///< of a run [s]; a tenth of a usual step, so that it costs nothing
  double smallest_step = 1e-12;  ///< below which a run fails [s]

  // The next step is h safety (1/error)^(1/order) (last error/error)^memory, within bounds: the
  // last factor, where below 1, foresees an error that grows (Gustafsson's predictive control,
  // Hairer & Wanner II, IV.8).
  double safety = 0.9;
  double memory = 0.08;
  double minimum_error = 1e-2;                       ///< smaller last errors count as this
  double shortest = 0.2, longest = 4;                ///< of the step just taken
  double shortest_again = 0.1, longest_again = 0.7;  ///< of the step just rejected

  // The traction of a thin film under high pressure turns over within 1e-6 m/s of sliding speed. A
  // step that begins beyond sees a slope too small and lands on the other side of rolling; the next
  // one comes back. The error of such steps falls with h alone, so that they neither fail nor grow.
  // So many of them in a row, each shorter than `stalled`, are followed by a dive to where the
  // slope is that of rolling, from which steps grow again.
  int stalled_steps = 30;
  double stalled = 1e-7;  ///< [s]
  double dive = 1e-3;     ///< next step over the last one
};

inline constexpr StepControl kStepControl;
static_assert(kStepControl.smallest_step < kStepControl.first_step);
static_assert(0 < kStepControl.safety && kStepControl.safety < 1);
static_assert(kStepControl.shortest < 1 && 1 < kStepControl.longest);
static_assert(kStepControl.shortest_again < kStepControl.longest_again &&
              kStepControl.longest_again < 1);
static_assert(0 < kStepControl.minimum_error && kStepControl.minimum_error < 1);

}  // namespace cagetol
