#include "src/cage/cage_report.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "src/cage/cage_modes.hpp"

namespace cagetol {
namespace {

template <typename Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::variant<CageReport, CageFault> cage_report(const Scene& scene) {
  const CageDimensions cage = cage_dimensions(scene.cage, scene.bearing.roller_count);
  const std::vector<PocketDeviation> deviations = pocket_deviations(scene.cage, cage);
  const CageTable table = make_cage_table(cage, scene.cage.material, cage_stations(scene),
                                          {.density = scene.cage.mesh_density});
  CageModelOptions options;
  options.modes = scene.cage.modes;
  const auto made = make_cage_model(table, deviations, options);
  if (const auto* fault = std::get_if<CageFault>(&made)) return *fault;
  const CageModel& model = std::get<CageModel>(made);

  const auto meshed = make_cage_mesh(cage, deviations, table.counts);
  if (const auto* fault = std::get_if<CageFault>(&meshed)) return *fault;
  const CageMesh& mesh = std::get<CageMesh>(meshed);
  CageReport report;
  report.nodes = mesh.mesh.nodes.cols();
  report.elements = static_cast<long>(mesh.mesh.elements.size());
  report.dofs = 3 * report.nodes;
  report.body = model.body;
  report.seconds_table = table.seconds_table;
  FreeModes full;
  report.seconds_full = seconds_of([&] {
    const BodyMatrices body = assemble_body(mesh.mesh, scene.cage.material);
    const ShiftedFactor factor(body, ring_shift(mesh.mesh, body));
    full = free_modes(mesh.mesh, body, factor, model.frequency.size());
  });
  report.seconds_sample = 1e9;
  for (int i = 0; i < 10; ++i) {
    report.seconds_sample = std::min(
        report.seconds_sample, seconds_of([&] { make_cage_model(table, deviations, options); }));
  }
  for (Eigen::Index i = 0; i < model.frequency.size(); ++i) {
    report.modes.push_back({table.frequency[i], model.frequency[i], full.frequency[i],
                            family_name(table.family[static_cast<std::size_t>(i)])});
    if (full.frequency[i] <= 20e3) {
      report.largest_error =
          std::max(report.largest_error, std::abs(model.frequency[i] / full.frequency[i] - 1));
    }
  }
  return report;
}

}  // namespace cagetol
