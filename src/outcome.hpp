// What one simulated bearing gives back: an outcome of a stated kind, never a silent number.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace cagetol {

/// How a run ended. Numbers are those stored in study.h5.
enum class Status : int {
  ok = 0,        ///< simulated, every watch within its bound
  jammed = 1,    ///< a roller does not fit its pocket, or the geometry is impossible: not simulated
  failed = 2,    ///< the integration failed, a watch (static consistency, energy) is outside its
                 ///< bound, or a quantity is impossible
  censored = 3,  ///< the step budget ran out before the window was complete
  not_run = 4,   ///< aborted by a wall-clock limit or an interruption; never counted as an outcome
  poisoned = 5,  ///< the process running this sample died of it, alone, twice
};

/// "ok", "jammed", ... as printed in reports and --json output.
const char* status_name(Status status);

/// Why the measuring window ended. Numbers are those stored in study.h5.
enum class WindowEnd : int {
  fixed = 0,      ///< as long as the scene says
  converged = 1,  ///< its means had converged (window.measure = "auto")
  longest = 2,    ///< at its longest, its means had not
};

/// Numbers about the run itself. Only `wall_s` depends on the machine.
struct RunRecord {
  double simulated_s = 0;
  double measured_s = 0;        ///< length of the measuring window
  double cage_revolutions = 0;  ///< revolutions of the cage in the measuring window
  WindowEnd window_end = WindowEnd::fixed;
  /// Of the watched mean that is known least (quantities/convergence.hpp); NaN where a window has
  /// less than two revolutions.
  double mean_share = std::numeric_limits<double>::quiet_NaN();
  double steps = 0;
  double rejected_steps = 0;
  double rhs_evaluations = 0;
  double jacobian_evaluations = 0;
  double factorisations = 0;
  double smallest_step_s = 0;
  double energy_residual = 0;  ///< |work in - dissipation - change of stored energy| / dissipation
  double static_consistency_error = 0;  ///< see quantities/
  /// Of the roller positions at which it was to be measured: without a static solution.
  double static_positions_missed = 0;
  /// Of the flexible cage's model against a full solve, largest relative; NaN where not checked.
  double cage_frequency_error = std::numeric_limits<double>::quiet_NaN();
  double wall_s = 0;
};

/// Names of the fields of RunRecord in the order of `run_values`, with unit and meaning.
struct RunField {
  const char* key;
  const char* unit;
  const char* meaning;
};
const std::vector<RunField>& run_fields();
std::vector<double> run_values(const RunRecord& run);

/// The instant of the largest stress in a flexible cage, enough to recover the whole field
/// (src/cage). Empty vectors where there is none.
struct CagePeak {
  double time = 0;                ///< [s]
  int pocket = -1, station = -1;  ///< where, as in cage_stress_peak_pocket and _station
  std::vector<double> modes;      ///< modal coordinates
  std::vector<double> bar_force;  ///< on the cage: per pocket the stations of the trailing, then of
                                  ///< the leading face, towards larger theta [N]
  double spin = 0;                ///< whose centrifugal load acts, 0: none [rad/s]
};

/// Result of one sample. `quantities` follows the order of quantity_table()
/// (src/quantities/quantity_table.hpp); NaN where the scene does not define a quantity (no cage
/// stress on a rigid cage) or the run has none (jammed).
struct Outcome {
  Status status = Status::not_run;
  std::string
      reason;  ///< empty when ok; otherwise what happened, with numbers and units, for people
  int pocket =
      -1;  ///< the pocket that jams (or, with allow_interference, pinches), 0-based; -1: none
  double interference_um = 0;  ///< how much the roller is too large for it
  std::string least_known;     ///< key of the watched mean that is known least, for people
  std::vector<double> quantities;
  RunRecord run;
  CagePeak cage_peak;
};

}  // namespace cagetol
