// A full finite element solve of one sample's cage, to see what the per-sample model leaves out.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/cage_model.hpp"

namespace cagetol {

/// Up to this frequency the per-sample model answers for its accuracy [Hz].
inline constexpr double kCheckedFrequency = 20e3;

struct CageCheck {
  long nodes = 0;
  long elements = 0;
  Eigen::VectorXd frequency;  ///< by the full solve, as many as the model keeps [Hz]
  double largest_error = 0;   ///< relative, model against full solve, up to kCheckedFrequency
  double seconds = 0;         ///< the full solve, from deviations to modes, processor time
};

/// Meshes and solves the deviated cage from which `model` was made. The same bits every time, but
/// for the seconds. Throws UnsolvedCage where no valid mesh or no solution exists, which a
/// cage with a model never meets.
CageCheck check_cage_model(const CageTable& table, const std::vector<PocketDeviation>& deviations,
                           const CageModel& model);

}  // namespace cagetol
