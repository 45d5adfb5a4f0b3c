#include "src/quantities/outcome.hpp"

namespace cagetol {

const char* status_name(Status status) {
  constexpr const char* kNames[] = {"ok", "jammed", "failed", "censored", "not_run", "poisoned"};
  return kNames[static_cast<int>(status)];
}

const std::vector<RunField>& run_fields() {
  static const std::vector<RunField> fields = {
      {"simulated_s", "s", "length of the run, settling included"},
      {"measured_s", "s", "length of the measuring window; quasi-static: 0"},
      {"cage_revolutions", "1", "revolutions of the cage in the measuring window"},
      {"windows_cut", "1",
       "windows that ended, at three times window.measure_revolutions without slip, before the "
       "cage, which skids, had made so many turns"},
      {"steps", "1", "accepted integration steps; quasi-static: positions"},
      {"rejected_steps", "1", "steps tried and rejected"},
      {"rhs_evaluations", "1", "evaluations of all forces"},
      {"jacobian_evaluations", "1", "of these, with derivatives"},
      {"factorisations", "1", "factorisations of the Newton matrix"},
      {"smallest_step_s", "s", "smallest accepted step"},
      {"energy_residual", "-",
       "|work in - dissipation - change of stored energy| over the dissipation (at least 1/1000 of "
       "the stored energy); quasi-static: NaN"},
      {"static_consistency_error", "-",
       "elastic ring force and mean ring displacement against statics; quasi-static: NaN"},
      {"static_positions_missed", "1",
       "roller positions at which no static solution was found to compare with, of 64 and at most "
       "one a step"},
      {"cage_frequency_error", "-",
       "flexible cage: largest relative error of its frequencies up to 20 kHz against a full "
       "solve; NaN where not "
       "checked"},
  };
  return fields;
}

std::vector<double> run_values(const RunRecord& r) {
  return {r.simulated_s,
          r.measured_s,
          r.cage_revolutions,
          r.windows_cut,
          r.steps,
          r.rejected_steps,
          r.rhs_evaluations,
          r.jacobian_evaluations,
          r.factorisations,
          r.smallest_step_s,
          r.energy_residual,
          r.static_consistency_error,
          r.static_positions_missed,
          r.cage_frequency_error};
}

}  // namespace cagetol
