#include "src/cage/table/cage_check.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "src/cage/solve/cage_modes.hpp"
#include "src/cage/solve/unsolved_cage.hpp"

namespace cagetol {

CageCheck check_cage_model(const CageTable& table, const std::vector<PocketDeviation>& deviations,
                           const CageModel& model) {
  const std::clock_t start = std::clock();
  const auto meshed = make_cage_mesh(table.cage, deviations, table.counts);
  if (const auto* fault = std::get_if<CageFault>(&meshed)) {
    throw UnsolvedCage("no mesh for the full solve: " + fault->reason);
  }
  const HexMesh& mesh = std::get<CageMesh>(meshed).mesh;
  const BodyMatrices body = assemble_body(mesh, table.material);
  const HeldFactor factor(body.stiffness, rigid_motions(mesh.nodes));
  CageCheck check;
  check.nodes = mesh.nodes.cols();
  check.elements = static_cast<long>(mesh.elements.size());
  const Eigen::Index kept = model.elastic_modes();
  check.frequency = free_modes(mesh, body, factor, std::max<long>(1, kept)).frequency.head(kept);
  for (Eigen::Index i = 0; i < check.frequency.size(); ++i) {
    if (check.frequency[i] > kCheckedFrequency) break;
    check.largest_error =
        std::max(check.largest_error, std::abs(model.frequency[i] / check.frequency[i] - 1));
  }
  check.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return check;
}

}  // namespace cagetol
