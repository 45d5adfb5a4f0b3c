// Checks the per-sample model of one cage against a full finite element solution.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/table/cage_model.hpp"

namespace cagetol {

/// Highest frequency for which the per-sample model is checked [Hz].
inline constexpr double kCheckedFrequency = 20e3;

struct CageCheck {
  long nodes = 0;
  long elements = 0;
  Eigen::VectorXd frequency;  ///< of the full solution, as many as the model has [Hz]
  double largest_error = 0;   ///< relative error of the model's frequencies up to kCheckedFrequency
  double seconds = 0;         ///< processor time of the full solution, from deviations to modes [s]
};

/// Meshes and solves the deviated cage from which `model` was made. The result has the same bits
/// every time, except for `seconds`. Throws UnsolvedCage if there is no valid mesh or no solution,
/// which does not happen for a cage that has a model.
CageCheck check_cage_model(const CageTable& table, const std::vector<PocketDeviation>& deviations,
                           const CageModel& model);

}  // namespace cagetol
