#include "mc/benchmark/replicas.hpp"

#include <gsl/gsl_cdf.h>

#include <atomic>
#include <thread>

#include "distributions/basics/random_stream.hpp"
#include "mc/study/sample.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/scene/pocket_clearances.hpp"

namespace cagetol {
namespace {

constexpr double kOffsetShare = 0.1;  // of the narrowest pocket's clearance

double start_draw(const Study& study, std::uint64_t id, const char* what) {
  return gsl_cdf_ugaussian_Pinv(
      uniform(static_cast<std::uint64_t>(study.seed), Purpose::noise, id, stream_address(what), 0));
}

}  // namespace

std::vector<Scene> replica_scenes(const Study& study, int count) {
  const Sampler sampler(study);
  const auto rows = static_cast<std::uint64_t>(sampler.design().rows());
  std::vector<Scene> scenes;
  for (int k = 0; k < count; ++k) {
    const auto id = static_cast<std::uint64_t>(k) * rows;  // replicate k of row 0
    Scene scene = sampler.draw(id).scene;
    const double offset = kOffsetShare * narrowest_tangential(OperatingScene(scene));
    scene.start.cage_offset_y += offset * start_draw(study, id, "replica.cage_offset_y");
    scene.start.cage_offset_z += offset * start_draw(study, id, "replica.cage_offset_z");
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::vector<Outcome> simulate_all(const std::vector<Scene>& scenes, int threads,
                                  const SimulateOptions& options) {
  std::vector<Outcome> outcomes(scenes.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < scenes.size(); i = next++)
      outcomes[i] = simulate(scenes[i], options);
  };
  std::vector<std::jthread> team;
  for (int k = 1; k < threads; ++k) team.emplace_back(work);
  work();
  team.clear();  // joins
  return outcomes;
}

}  // namespace cagetol
