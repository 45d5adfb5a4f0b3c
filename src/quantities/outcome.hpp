// The outcome of one simulated bearing. Its status says what the numbers are worth.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace cagetol {

/// How a run ended, numbered as in study.h5.
enum class Status : int {
  ok = 0,        ///< simulated, every watch within its bound
  jammed = 1,    ///< not simulated: a roller does not fit its pocket, or impossible geometry
  failed = 2,    ///< the integration failed, a watch (static consistency, energy) is outside its
                 ///< bound, or a quantity is impossible
  censored = 3,  ///< the step budget ran out before the window was complete
  not_run = 4,   ///< stopped by a wall-clock limit or an interruption; not counted as an outcome
  poisoned = 5,  ///< the sample killed its process twice while it ran alone
};

/// "ok", "jammed", ... as printed in reports and --json output.
const char* status_name(Status status);

/// Numbers about the run itself. Only `wall_s` depends on the machine.
struct RunRecord {
  double simulated_s = 0;
  double measured_s = 0;        ///< length of the measuring window
  double cage_revolutions = 0;  ///< revolutions of the cage in the measuring window
  double windows_cut = 0;       ///< windows that ended before the cage had made its turns
  double steps = 0;
  double rejected_steps = 0;
  double rhs_evaluations = 0;
  double jacobian_evaluations = 0;
  double factorisations = 0;
  double smallest_step_s = 0;
  double energy_residual = 0;  ///< |work in - dissipation - change of stored energy| / dissipation
  double static_consistency_error = 0;  ///< see quantities/
  /// Roller positions of the static comparison that have no static solution.
  double static_positions_missed = 0;
  /// Largest relative frequency error of the flexible cage's model against a full solve; NaN if not
  /// checked.
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

/// The state of a flexible cage at the instant of its largest stress, from which src/cage recovers
/// the whole stress field. Without one the vectors are empty.
struct CagePeak {
  double time = 0;                ///< [s]
  int pocket = -1, station = -1;  ///< as in cage_stress_peak_pocket and cage_stress_peak_station
  std::vector<double> modes;      ///< modal coordinates
  std::vector<double> bar_force;  ///< on the cage towards larger theta, per pocket the stations of
                                  ///< the trailing face, then of the leading face [N]
  double spin = 0;                ///< spin of the centrifugal load, 0: none [rad/s]
};

/// Result of one sample. `quantities` are in the order of quantity_table()
/// (src/quantities/quantity_table.hpp), then again those of each label. NaN: the scene does not
/// define the quantity (stress of a rigid cage) or the run has no value (jammed).
struct Outcome {
  Status status = Status::not_run;
  std::string reason;  ///< what happened, with numbers and units; empty when ok
  int pocket = -1;     ///< pocket that jams (with allow_interference: pinches), from 0; -1: none
  double interference_um = 0;  ///< excess of the roller over that pocket, in width or length
  std::vector<double> quantities;
  /// Phases with quantities of their own (src/quantities/quantity_labels.hpp).
  std::vector<std::string> labels;
  RunRecord run;
  CagePeak cage_peak;
};

}  // namespace cagetol
