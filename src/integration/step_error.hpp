// How a step's error counts in the control of its length.
//
// Unloaded rollers bounce between the races at 20 to 40 kHz, with centimetres a second and an
// energy that no quantity asks for; followed like everything else this alone would set the step. It
// counts in larger units of error as long as the energy which an error moves stays small beside
// what the bearing dissipates: where bouncing is all that happens it counts in full. A shift of
// phase, which is most of what a long step does to an oscillation, moves no energy. What an error
// does to the power that a dashpot takes is moved energy, too, where the dashpot stops the roller
// within the step: x^2/(1 + x^2) of it, x = c h/m. Rocking about
// the tilt, with which rollers lean on flanges, skew and axial motion always count in full; and
// 15-fold the rates of skew and axial motion while a roller that the races do not press is on a
// flange, of the skew also while it is on a bar: what light touches leave behind adds up to the
// skew.
#pragma once

#include "src/integration/system.hpp"

namespace cagetol {

class StepError {
 public:
  /// `bounce_share`: of the estimate that counts where bouncing is spared, for methods whose
  /// estimate tells of a solution with larger errors than the one that is kept.
  explicit StepError(double bounce_share) : bounce_share_(bounce_share) {}

  /// Error of a step of length h [s] from y in units of `tolerance`: a step may be taken up to 1.
  /// Expects system.linearise_at to have been called at y.
  double operator()(const System& system, const double* y, const double* error, double h,
                    double tolerance) const;

  /// To be told of every step taken, before the system is linearised at its end.
  void advance(const System& system, double h);

 private:
  double bounce_share_;
  // Means over the last millisecond, exponentially weighted, as from a start at zero.
  double dissipation_ = 0;  ///< power [W]
  double watched_ = 0;      ///< one, since the start
};

}  // namespace cagetol
