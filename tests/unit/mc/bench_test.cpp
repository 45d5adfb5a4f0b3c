// The bench measures `simulate` itself: its RTF is that of a run beside it, and failures are said.
#include "mc/benchmark/bench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/statistics/median.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

Scene short_scene() {
  Scene scene = shipped_scene("speed-z16");
  scene.window.settle_time = 4e-3;
  scene.window.measure_time = 2e-3;
  return scene;
}

// Not a second clock beside it: the very time that a run states, per simulated second.
TEST(Bench, MeasuresSimulateItself) {
  const BenchResult result =
      bench(short_scene(), {.methods = {IntegrationMethod::rodas3}, .repeats = 3});
  for (const MethodCost& cost : result.methods) {
    ASSERT_EQ(cost.rtf_runs.size(), 3u);
    EXPECT_EQ(cost.rtf, median(cost.rtf_runs));
    EXPECT_DOUBLE_EQ(cost.rtf_runs.back() * cost.run.simulated_s, cost.run.wall_s);
    EXPECT_NEAR(cost.run.simulated_s, 6e-3, 1e-12);
  }
}

TEST(Bench, CountsAndKernelsAreThoseOfTheRun) {
  const Scene scene = short_scene();
  const BenchResult result = bench(scene, {.methods = {IntegrationMethod::rodas3}, .repeats = 1});
  ASSERT_EQ(result.methods.size(), 2u);  // the scene's own, the one asked for
  EXPECT_EQ(result.methods[0].method, IntegrationMethod::rodasp);
  EXPECT_EQ(result.methods[0].run.steps, simulate(scene).run.steps);
  const KernelTimes& k = result.kernels;
  for (double time : {k.rhs_us, k.linearise_us, k.factorise_us, k.solve_us}) EXPECT_GT(time, 0.01);
  EXPECT_GT(k.linearise_us, k.rhs_us);
  const auto json = bench_json(result);
  EXPECT_EQ(json["methods"][0]["method"], "rodasp");
  EXPECT_EQ(json["methods"][0]["rtf"].get<double>(), result.methods[0].rtf);
  EXPECT_EQ(json["methods"][1]["method"], "rodas3");
  EXPECT_NEAR(json["methods"][0]["steps_per_s"].get<double>() * 6e-3, result.methods[0].run.steps,
              1e-6);
}

TEST(Bench, SharesAreOfTheWholeRun) {
  Scene scene = shipped_scene("nu205");
  scene.window.settle_time = 2e-3;
  scene.window.measure_time = 2e-3;
  const BenchResult oiled = bench(scene, {.methods = {IntegrationMethod::rodas3}, .repeats = 1});
  double sum = 0;
  for (const CostPart& part : run_parts(oiled)) sum += part.share;
  EXPECT_NEAR(sum, 1, 1e-12);
  const KernelTimes& k = oiled.kernels;
  for (double time : {k.free_rhs_us, k.free_linearise_us, k.record_us}) EXPECT_GT(time, 0.01);
  EXPECT_GT(oiled.start_s, 0);
  EXPECT_THAT(bench_text(oiled), testing::HasSubstr("wall time of the default: right-hand sides "));
}

TEST(Bench, AMethodThatFailsSaysSo) {
  Scene scene = short_scene();
  scene.integration.step_budget = static_cast<long>(2 * simulate(scene).run.steps);
  const BenchResult result =
      bench(scene, {.methods = {IntegrationMethod::arkode_erk}, .repeats = 1});
  const MethodCost& explicit_steps = result.methods[1];
  EXPECT_EQ(explicit_steps.method, IntegrationMethod::arkode_erk);
  EXPECT_EQ(explicit_steps.status, Status::censored);
  EXPECT_TRUE(std::isnan(explicit_steps.rtf));
  EXPECT_THAT(bench_text(result), testing::HasSubstr("arkode-erk             censored: "));
  const auto json = bench_json(result);
  EXPECT_TRUE(json["methods"][1]["rtf"].is_null());
  EXPECT_FALSE(json["methods"][0]["rtf"].is_null());
}

}  // namespace
}  // namespace cagetol
