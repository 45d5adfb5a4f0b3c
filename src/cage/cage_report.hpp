// What `cagetol cage` tells about a cage: size of the model, mass, modes by family, accuracy and
// cost.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "src/cage/cage_model.hpp"

namespace cagetol {

struct ReportedMode {
  double undeviated_hz = 0;
  double sample_hz = 0;  ///< by the per-sample model, with deviating pockets
  double full_hz = 0;    ///< by a full solve with deviating pockets
  std::string family;    ///< of the undeviated cage's mode of the same number
};

struct CageReport {
  long nodes = 0;
  long elements = 0;
  long dofs = 0;
  MassProperties body;  ///< with deviating pockets
  std::vector<ReportedMode> modes;
  double largest_error = 0;  ///< relative, sample against full, up to 20 kHz
  double seconds_table = 0;  ///< once per scene, when the table was made
  double seconds_full = 0;   ///< one full solve of the deviated cage, processor time
  double seconds_sample =
      0;  ///< one per-sample model, stress rows included, likewise, median of many
};

/// Solves the cage with these pockets both ways and keeps `modes` elastic modes. `undeviated` is
/// the table of the scene, `table` the one that serves the cage, from which `deviations` are. A
/// fault where the pockets leave no valid cage.
std::variant<CageReport, CageFault> cage_report(const CageTable& undeviated, const CageTable& table,
                                                const std::vector<PocketDeviation>& deviations,
                                                long modes);

}  // namespace cagetol
