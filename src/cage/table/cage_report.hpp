// The report of `cagetol cage`: size of the model, mass, modes by family, what a force on a bar
// does, accuracy and cost.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "src/cage/table/cage_model.hpp"
#include "src/cage/table/unit_bar_loads.hpp"

namespace cagetol {

struct ReportedMode {
  double undeviated_hz = 0;
  double sample_hz = 0;  ///< per-sample model with deviating pockets
  double full_hz = 0;    ///< full solution with deviating pockets
  std::string family;    ///< of the undeviated cage's mode with the same number
};

struct CageReport {
  long nodes = 0;
  long elements = 0;
  long dofs = 0;
  MassProperties body;  ///< with deviating pockets
  std::vector<ReportedMode> modes;
  std::vector<UnitBarLoad> bar_loads;  ///< of the leading face of the pocket asked for
  double largest_error = 0;  ///< relative, per-sample model against full solution, up to 20 kHz
  double seconds_table = 0;  ///< time to make the table, once per scene
  double seconds_full = 0;   ///< processor time of a full solution of the deviated cage
  double seconds_sample =
      0;  ///< one per-sample model, stress rows included, likewise, median of many
};

/// Solves the cage with these pockets in both ways, with `modes` elastic modes. `deviations` are
/// relative to `table`; forces act on the bar that leads `pocket`. Returns a fault if the pockets
/// leave no valid cage.
std::variant<CageReport, CageFault> cage_report(const CageTable& table,
                                                const std::vector<PocketDeviation>& deviations,
                                                long modes, long pocket = 0);

}  // namespace cagetol
