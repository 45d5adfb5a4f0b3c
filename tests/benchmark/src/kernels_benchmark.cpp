// The kernels of a step: forces, derivatives, factors, solution, and a whole step of the default
// method, on the speed scene a millisecond after its start.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "src/input/toml_file.hpp"
#include "src/integration/integrator.hpp"
#include "src/newton/newton_matrix.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/statics/start_state.hpp"

namespace cagetol {
namespace {

constexpr double kStart = 1e-3, kStep = 10e-6;

Scene speed_scene(long slices) {
  const std::string path = std::string(CAGETOL_SOURCE_DIR) + "/inputs/scenes/speed-z16.toml";
  Scene scene = read_scene(read_toml(path), path);
  scene.discretisation.race_slices = slices;
  return scene;
}

/// The speed scene with as many slices as the benchmark's argument, loaded and linearised.
struct Loaded {
  explicit Loaded(const benchmark::State& state)
      : scene(speed_scene(state.range(0))),
        model(make_bearing_model(scene)),
        system(model),
        y(start_state(model, scene.start)) {
    const auto integrator = make_integrator(scene.integration, system, t, y.data());
    system.linearise_at(t, y.data());
    while (t < kStart) {
      integrator->step(system, t, y.data(), kStart);
      system.linearise_at(t, y.data());
    }
  }
  Scene scene;
  BearingModel model;
  System system;
  double t = 0;
  std::vector<double> y;
};

void rates(benchmark::State& state) {
  Loaded bearing(state);
  std::vector<double> rate(bearing.y.size());
  for (auto _ : state) evaluate_rates(bearing.model, bearing.t, bearing.y.data(), rate.data());
}
BENCHMARK(rates)->Arg(1)->Arg(5)->ArgName("slices");

void derivatives(benchmark::State& state) {
  Loaded bearing(state);
  for (auto _ : state) bearing.system.linearise_at(bearing.t, bearing.y.data());
}
BENCHMARK(derivatives)->Arg(1)->Arg(5)->ArgName("slices");

void factorisation(benchmark::State& state) {
  Loaded bearing(state);
  NewtonMatrix newton(bearing.model);
  for (auto _ : state) benchmark::DoNotOptimize(newton.factor(bearing.system.linear, kStep));
}
BENCHMARK(factorisation)->Arg(5)->ArgName("slices");

void solution(benchmark::State& state) {
  Loaded bearing(state);
  NewtonMatrix newton(bearing.model);
  newton.factor(bearing.system.linear, kStep);
  std::vector<double> x(bearing.y.size());
  for (auto _ : state) newton.solve(bearing.system.rate.data(), x.data());
}
BENCHMARK(solution)->Arg(5)->ArgName("slices");

void step(benchmark::State& state, IntegrationMethod method) {
  Loaded bearing(state);
  Integration keys = bearing.scene.integration;
  keys.method = method;
  System& system = bearing.system;
  auto integrator = make_integrator(keys, system, bearing.t, bearing.y.data());
  for (auto _ : state) {
    integrator->step(system, bearing.t, bearing.y.data(), 1e3);
    system.linearise_at(bearing.t, bearing.y.data());
  }
}
BENCHMARK_CAPTURE(step, rodas3, IntegrationMethod::rodas3)->Arg(5)->ArgName("slices");
BENCHMARK_CAPTURE(step, cvode_bdf, IntegrationMethod::cvode_bdf)->Arg(5)->ArgName("slices");
BENCHMARK_CAPTURE(step, arkode_erk, IntegrationMethod::arkode_erk)->Arg(5)->ArgName("slices");

}  // namespace
}  // namespace cagetol

BENCHMARK_MAIN();
