#include "mc/engine/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mc/engine/replicas.hpp"
#include "mc/engine/setting.hpp"
#include "mc/engine/statistics.hpp"
#include "mc/engine/trajectory.hpp"
#include "mc/json_number.hpp"
#include "src/integration/integrator.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

/// A few characters for the map.
std::string brief(const SuiteCell& cell) {
  const Outcome& o = cell.outcome;
  if (o.status == Status::jammed) return "jam";
  if (o.status == Status::censored) return "budget";
  if (o.status != Status::ok)
    return o.reason.starts_with("static")
               ? fmt::format("statics {:.2g}", o.run.static_consistency_error)
           : o.reason.starts_with("energy") ? fmt::format("energy {:.2g}", o.run.energy_residual)
                                            : "stopped";
  return std::isfinite(cell.trajectory_error) ? fmt::format("{:.1g}", cell.trajectory_error) : "-";
}

/// A setting of a method on a scene of the suite: the default tolerance, the default step.
Scene by_method(const Scene& scene, const std::string& method) {
  Scene set = scene;
  set.integration.method = method;
  return set;
}

// Shares of the horizon. An impact just at an instant makes centimetres a second of a microsecond's
// delay: the median of three instants tells how far a trajectory is off.
constexpr double kInstants[] = {0.92, 0.96, 1};

void judge_trajectories(const Scene& scene, const SimulateOptions& options, SuiteRow& row) {
  std::vector<double> gaps;
  std::map<std::string, std::vector<double>> errors;
  for (const double share : kInstants) {
    const double horizon = share * kSuiteHorizon;
    std::map<std::string, Trajectory> references;
    for (const char* method : {"rodasp", "arkode-erk"}) {
      const Setting setting = reference_setting(method);
      references[setting.method] = follow(with_setting(scene, setting), horizon, options);
    }
    gaps.push_back(trajectory_error(references["rodasp"], references["arkode-erk"])[1]);
    for (const auto& [method, cell] : row.cells)
      errors[method].push_back(trajectory_error(follow(by_method(scene, method), horizon, options),
                                                references[reference_setting(method).method])[1]);
  }
  row.reference_gap = median_of_whole(gaps);
  for (auto& [method, cell] : row.cells) {
    cell.trajectory_error = median_of_whole(errors[method]);
    cell.soundness = judge_soundness(cell.outcome.status, cell.trajectory_error, row.reference_gap);
  }
}

}  // namespace

const char* soundness_name(Soundness soundness) {
  switch (soundness) {
    case Soundness::right:
      return "right";
    case Soundness::degraded:
      return "degraded";
    case Soundness::wrong:
      return "wrong";
    case Soundness::unresolved:
      return "unresolved";
    case Soundness::failed:
      break;
  }
  return "failed";
}

Soundness judge_soundness(Status status, double trajectory_error, double reference_gap) {
  if (status == Status::jammed) return Soundness::right;
  if (status != Status::ok) return Soundness::failed;
  if (!(reference_gap <= kRightError)) return Soundness::unresolved;
  if (trajectory_error <= kRightError) return Soundness::right;
  return trajectory_error <= kDegradedError ? Soundness::degraded : Soundness::wrong;
}

StabilityMap run_stability(const std::vector<SuiteScene>& suite,
                           const std::vector<std::string>& methods, int threads,
                           const std::function<void(const SuiteRow&)>& on_row) {
  StabilityMap map{Scene{}.integration.method, methods, {}};
  if (methods.empty())
    for (const MethodName& known : integration_methods()) map.methods.push_back(known.name);
  for (const SuiteScene& entry : suite) {
    std::vector<Scene> scenes;
    for (const std::string& method : map.methods) scenes.push_back(by_method(entry.scene, method));
    const SimulateOptions shared = with_cage_table(entry.scene);
    std::vector<Outcome> outcomes = simulate_all(scenes, threads, shared);
    SuiteRow row{entry.name, 0, {}};
    for (std::size_t m = 0; m < map.methods.size(); ++m)
      row.cells[map.methods[m]].outcome = std::move(outcomes[m]);
    judge_trajectories(entry.scene, shared, row);
    if (on_row) on_row(row);
    map.rows.push_back(std::move(row));
  }
  return map;
}

Json stability_json(const StabilityMap& map) {
  Json json = {{"kind", "stability"},        {"default_method", map.default_method},
               {"methods", map.methods},     {"horizon_s", kSuiteHorizon},
               {"right_error", kRightError}, {"degraded_error", kDegradedError}};
  Json& scenes = json["scenes"] = Json::array();
  for (const SuiteRow& row : map.rows) {
    Json results;
    for (const auto& [method, cell] : row.cells) {
      const RunRecord& run = cell.outcome.run;
      results[method] = {{"verdict", soundness_name(cell.soundness)},
                         {"brief", brief(cell)},
                         {"status", status_name(cell.outcome.status)},
                         {"reason", cell.outcome.reason},
                         {"trajectory_error", json_number(cell.trajectory_error)},
                         {"static_consistency_error", json_number(run.static_consistency_error)},
                         {"energy_residual", json_number(run.energy_residual)},
                         {"rtf", json_number(run.wall_s / run.simulated_s)}};
    }
    scenes.push_back({{"name", row.scene},
                      {"reference_gap", json_number(row.reference_gap)},
                      {"results", results}});
  }
  return json;
}

std::string stability_text(const StabilityMap& map) {
  std::string text = fmt::format("{:<26}", "scene");
  for (const std::string& method : map.methods) text += fmt::format("{:<21}", method);
  text += "\n";
  for (const SuiteRow& row : map.rows) {
    text += fmt::format("{:<26}", row.scene);
    for (const std::string& method : map.methods) {
      const SuiteCell& cell = row.cells.at(method);
      text +=
          fmt::format("{:<21}", std::string(soundness_name(cell.soundness)) + " " + brief(cell));
    }
    text += "\n";
  }
  text += fmt::format(
      "\nNumbers: trajectory error after {:g} ms in error scales, or the watch that spoke.\n",
      1e3 * kSuiteHorizon);
  for (const SuiteRow& row : map.rows)
    for (const std::string& method : map.methods) {
      const SuiteCell& cell = row.cells.at(method);
      if (cell.soundness == Soundness::wrong)
        text += fmt::format("SILENTLY WRONG: {} on {}, off by {:.3g} error scales\n", method,
                            row.scene, cell.trajectory_error);
      else if (method == map.default_method && cell.soundness != Soundness::right)
        text +=
            fmt::format("the default is {} on {}{}{}\n", soundness_name(cell.soundness), row.scene,
                        cell.outcome.reason.empty() ? "" : ": ", cell.outcome.reason);
    }
  return text;
}

}  // namespace cagetol
