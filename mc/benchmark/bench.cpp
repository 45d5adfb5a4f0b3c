#include "mc/benchmark/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "analysis/statistics/median.hpp"
#include "mc/benchmark/setting.hpp"
#include "mc/host/json_number.hpp"
#include "src/integration/system.hpp"
#include "src/newton/newton_matrix.hpp"
#include "src/quantities/observer.hpp"
#include "src/simulate.hpp"

namespace cagetol {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Microseconds of one call: the median of batches.
template <class Call>
double call_time_us(const Call& call) {
  constexpr int kCalls = 20, kBatches = 7;
  std::vector<double> times;
  for (int batch = 0; batch < kBatches; ++batch) {
    const auto began = std::chrono::steady_clock::now();
    for (int k = 0; k < kCalls; ++k) call();
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - began;
    times.push_back(took.count() / kCalls);
  }
  return median(std::move(times));
}

constexpr std::pair<const char*, double KernelTimes::*> kKernels[] = {
    {"rhs", &KernelTimes::rhs_us},
    {"linearise", &KernelTimes::linearise_us},
    {"rhs_without_pockets", &KernelTimes::free_rhs_us},
    {"linearise_without_pockets", &KernelTimes::free_linearise_us},
    {"factorise", &KernelTimes::factorise_us},
    {"solve", &KernelTimes::solve_us},
    {"record", &KernelTimes::record_us}};

/// With pockets that no roller can touch.
BearingModel without_pockets(BearingModel model) {
  constexpr double kFar = 1;  // [m]
  for (RollerGroup& group : model.groups) {
    group.half_width += kFar;
    group.half_length += kFar;
    group.face_low -= kFar;
    group.face_high += kFar;
  }
  return model;
}

KernelTimes kernel_times(double t, const double* y, const System& system, double step) {
  const BearingModel &model = system.model, free_model = without_pockets(model);
  System own(model), free(free_model);
  PackVector rate(static_cast<std::size_t>(system.size)), solution(rate.size());
  NewtonMatrix newton(model);
  Observer observer(model, t, 2 * t);
  KernelTimes times;
  times.rhs_us = call_time_us([&] { own.rates(t, y, rate.data()); });
  times.free_rhs_us = call_time_us([&] { free.rates(t, y, rate.data()); });
  times.free_linearise_us = call_time_us([&] { free.linearise_at(t, y); });
  times.linearise_us = call_time_us([&] { own.linearise_at(t, y); });
  times.factorise_us = call_time_us([&] { newton.factor(own.linear, step); });
  times.solve_us = call_time_us([&] { newton.solve(rate.data(), solution.data()); });
  times.record_us = call_time_us([&] { observer.record(t += step, y, own); });
  return times;
}

/// Kernels, and the start, of the scene's run. The first of the two runs says how many steps there
/// are and warms the caches for what follows.
void measure_kernels(const Scene& scene, SimulateOptions options, BenchResult& result) {
  constexpr long kInstants = 8;
  const long every = std::max(1L, std::lround(simulate(scene, options).run.steps) / 2 / kInstants);
  long state = 0, instants = 0;
  const auto began = std::chrono::steady_clock::now();
  options.on_state = [&](double t, const double* y, const System& system) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
    if (state == 0) result.start_s = passed.count();
    if (++state <= kInstants * every || state % every != 0) return;
    ++instants;
    const KernelTimes here = kernel_times(t, y, system, t / static_cast<double>(state));
    for (const auto& [name, time] : kKernels) result.kernels.*time += here.*time;
  };
  simulate(scene, options);
  for (const auto& [name, time] : kKernels) result.kernels.*time /= static_cast<double>(instants);
}

std::vector<IntegrationMethod> methods_to_run(const Scene& scene, const BenchOptions& options) {
  std::vector<IntegrationMethod> methods = {scene.integration.method};
  const auto add = [&](IntegrationMethod method) {
    if (std::ranges::find(methods, method) == methods.end()) methods.push_back(method);
  };
  for (const IntegrationMethod method : options.methods.empty() ? all_methods() : options.methods)
    add(method);
  return methods;
}

}  // namespace

BenchResult bench(const Scene& scene, const BenchOptions& options) {
  const SimulateOptions shared = with_cage_table(scene);
  BenchResult result{scene.name, {}, 0, {}};
  measure_kernels(scene, shared, result);
  for (const IntegrationMethod method : methods_to_run(scene, options))
    result.methods.push_back({.method = method, .reason = {}, .rtf_runs = {}, .run = {}});
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (MethodCost& cost : result.methods) {
      Scene one = scene;
      one.integration.method = cost.method;
      const Outcome outcome = simulate(one, shared);
      cost.status = outcome.status;
      cost.reason = outcome.reason;
      cost.run = outcome.run;
      if (outcome.run.simulated_s > 0)
        cost.rtf_runs.push_back(outcome.run.wall_s / outcome.run.simulated_s);
    }
  const MethodCost& own = result.methods.front();
  for (MethodCost& cost : result.methods) {
    const bool ok = cost.status == Status::ok;
    cost.rtf = ok ? median(cost.rtf_runs) : kNone;
    std::vector<double> ratios;
    for (std::size_t k = 0; k < std::min(cost.rtf_runs.size(), own.rtf_runs.size()); ++k)
      ratios.push_back(cost.rtf_runs[k] / own.rtf_runs[k]);
    cost.against_default = ok ? median(std::move(ratios)) : kNone;
  }
  return result;
}

std::vector<CostPart> run_parts(const BenchResult& result) {
  const MethodCost& own = result.methods.front();
  const KernelTimes& k = result.kernels;
  const double wall_us = 1e6 * own.rtf * own.run.simulated_s;
  const auto rates = static_cast<double>(own.run.rhs_evaluations),
             derivatives = static_cast<double>(own.run.jacobian_evaluations),
             factored = static_cast<double>(own.run.factorisations);
  // A stage evaluates once and solves once; the first has its rates with the derivatives.
  const double pockets = (rates - derivatives) * (k.rhs_us - k.free_rhs_us) +
                         derivatives * (k.linearise_us - k.free_linearise_us);
  std::vector<CostPart> parts = {
      {"right-hand sides", (rates - derivatives) * k.free_rhs_us / wall_us},
      {"with derivatives", derivatives * k.free_linearise_us / wall_us},
      {"pockets in both", pockets / wall_us},
      {"Newton matrix", factored * k.factorise_us / wall_us},
      {"solutions", (factored > 0 ? rates : 0) * k.solve_us / wall_us},
      {"quantities",
       derivatives * k.record_us * own.run.measured_s / own.run.simulated_s / wall_us},
      {"start", 1e6 * result.start_s / wall_us}};
  double rest = 1;
  for (const CostPart& part : parts) rest -= part.share;
  parts.push_back({"sums of stages, step control", rest});
  return parts;
}

nlohmann::ordered_json bench_json(const BenchResult& result) {
  nlohmann::ordered_json json = {{"scene", result.scene}};
  for (const auto& [name, time] : kKernels)
    json["kernels_us"][name] = json_number(result.kernels.*time);
  for (const CostPart& part : run_parts(result))
    json["run_shares"][part.name] = json_number(part.share);
  auto& methods = json["methods"] = nlohmann::ordered_json::array();
  for (const MethodCost& cost : result.methods) {
    const double simulated = cost.run.simulated_s;
    methods.push_back(
        {{"method", spelled(cost.method)},
         {"status", status_name(cost.status)},
         {"reason", cost.reason},
         {"rtf", json_number(cost.rtf)},
         {"rtf_over_default", json_number(cost.against_default)},
         {"rtf_runs", cost.rtf_runs},
         {"simulated_s", simulated},
         {"steps_per_s", json_number(cost.run.steps / simulated)},
         {"rejected_steps_per_s", json_number(cost.run.rejected_steps / simulated)},
         {"rhs_evaluations_per_s", json_number(cost.run.rhs_evaluations / simulated)},
         {"jacobian_evaluations_per_s", json_number(cost.run.jacobian_evaluations / simulated)},
         {"factorisations_per_s", json_number(cost.run.factorisations / simulated)}});
  }
  return json;
}

std::string bench_text(const BenchResult& result) {
  std::string text = fmt::format(
      "scene {}: one right-hand side {:.2f} us, with derivatives {:.2f} us, factorisation {:.2f} "
      "us, solve {:.2f} us\n"
      "RTF: wall seconds per simulated second. Counts are per simulated second.\n\n"
      "{:<22}{:>9}{:>12}{:>11}{:>11}{:>12}{:>12}\n",
      result.scene, result.kernels.rhs_us, result.kernels.linearise_us, result.kernels.factorise_us,
      result.kernels.solve_us, "method", "RTF", "/ default", "steps", "rejected", "rhs",
      "factored");
  for (const MethodCost& cost : result.methods) {
    const std::string name =
        std::string(spelled(cost.method)) + (&cost == &result.methods.front() ? " (default)" : "");
    if (cost.status != Status::ok) {
      text += fmt::format("{:<22} {}: {}\n", name, status_name(cost.status), cost.reason);
      continue;
    }
    const double s = cost.run.simulated_s;
    text +=
        fmt::format("{:<22}{:>9.3f}{:>12.3f}{:>11.4g}{:>11.4g}{:>12.4g}{:>12.4g}\n", name, cost.rtf,
                    cost.against_default, cost.run.steps / s, cost.run.rejected_steps / s,
                    cost.run.rhs_evaluations / s, cost.run.factorisations / s);
  }
  std::string shares;
  for (const CostPart& part : run_parts(result))
    if (std::isfinite(part.share))
      shares +=
          fmt::format("{} {} {:.0f} %", shares.empty() ? "" : ",", part.name, 100 * part.share);
  return shares.empty() ? text : text + "\nwall time of the default:" + shares + "\n";
}

}  // namespace cagetol
