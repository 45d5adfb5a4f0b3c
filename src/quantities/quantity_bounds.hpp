// Impossible values of quantities: a run that gives one has failed, even if all watches are
// satisfied. Bounds follow from definitions, from geometry and from the energy that a bearing
// holds; they are wide on purpose.
#pragma once

#include "src/model/bearing_model.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {

/// Largest angle of rollers, rings and cage for which the equations of motion hold [rad]. Supported
/// parts lean by some mrad, unsupported ones by radians.
inline constexpr double kLeanMax = 0.1;

struct JudgedRun {
  const Scene& scene;
  const BearingModel& model;
  double begin, end;                      ///< of the window [s]
  const std::vector<double>& quantities;  ///< in the order of quantity_table()
  bool peaks_in_part = false;             ///< peaks are taken over a part of the window
};

/// A message about the first impossible value with name, value, bound, reason and remedy; empty if
/// all values are possible.
std::string find_impossible(const JudgedRun& run);

}  // namespace cagetol
