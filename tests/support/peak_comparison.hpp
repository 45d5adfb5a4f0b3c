// Largest stress of a cage by the stations of its model, and by the whole field.
#pragma once

#include <algorithm>
#include <numeric>
#include <variant>
#include <vector>

#include "src/cage/stress/field_recovery.hpp"
#include "src/cage/table/cage_recovery.hpp"

namespace cagetol {

/// Largest von Mises stress of a state [Pa].
struct PeakStress {
  double stations = 0;  ///< station_stress() of the per-sample model
  double full = 0;      ///< over all nodes of the full recovery
};

/// One entry for each state.
inline std::vector<PeakStress> compare_peak_stress(const CageTable& table,
                                                   const std::vector<PocketDeviation>& deviations,
                                                   const CageStates& states) {
  constexpr Eigen::Index kFieldsAtOnce = 16;  // by the same matrices of each element
  const auto recovery = std::get<CageRecovery>(recover_cage(table, deviations, states));
  const auto model = std::get<CageModel>(
      make_cage_model(table, deviations,
                      {.modes = states.q.rows() - (states.bar_modes ? table.turn.sectors : 0),
                       .bar_modes = states.bar_modes,
                       .stress = true}));
  const HexMesh& mesh = recovery.mesh.mesh;
  std::vector<int> nodes(static_cast<std::size_t>(mesh.nodes.cols()));
  std::iota(nodes.begin(), nodes.end(), 0);
  std::vector<PeakStress> peaks(static_cast<std::size_t>(states.q.cols()));
  Eigen::MatrixXd stress;
  for (Eigen::Index i = 0; i < states.q.cols(); ++i) {
    const Eigen::Index field = i % kFieldsAtOnce;
    if (field == 0) {
      const Eigen::Index fields = std::min(kFieldsAtOnce, states.q.cols() - i);
      stress =
          nodal_stress(mesh, table.material, recovery.displacement.middleCols(i, fields), nodes);
    }
    PeakStress& peak = peaks[static_cast<std::size_t>(i)];
    peak.stations =
        station_stress(model, states.q.col(i), states.bar_force.col(i), states.spin[i]).maxCoeff();
    for (Eigen::Index n = 0; n < mesh.nodes.cols(); ++n)
      peak.full = std::max(peak.full, von_mises(stress.col(field).segment<6>(6 * n)));
  }
  return peaks;
}

}  // namespace cagetol
