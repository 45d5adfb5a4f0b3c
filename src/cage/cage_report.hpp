// What `cagetol cage` tells about a scene's cage: size of the model, mass, modes by family,
// accuracy and cost.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "src/cage/cage_model.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct ReportedMode {
  double undeviated_hz = 0;
  double sample_hz = 0;  ///< by the per-sample model, with the scene's pockets
  double full_hz = 0;    ///< by a full solve with the scene's pockets
  std::string family;    ///< of the undeviated cage's mode of the same number
};

struct CageReport {
  long nodes = 0;
  long elements = 0;
  long dofs = 0;
  MassProperties body;  ///< with the scene's pockets
  std::vector<ReportedMode> modes;
  double largest_error = 0;   ///< relative, sample against full, up to 20 kHz
  double seconds_table = 0;   ///< once per scene
  double seconds_full = 0;    ///< one full solve of the deviated cage
  double seconds_sample = 0;  ///< one per-sample model, stress rows included, best of several
};

/// Solves the scene's cage both ways. A fault where its pockets leave no valid cage.
std::variant<CageReport, CageFault> cage_report(const Scene& scene);

}  // namespace cagetol
