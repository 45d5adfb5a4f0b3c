#include "mc/benchmark/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/statistics/median.hpp"
#include "mc/benchmark/replicas.hpp"
#include "mc/benchmark/setting.hpp"
#include "mc/benchmark/trajectory.hpp"
#include "mc/host/json_number.hpp"

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
           : o.reason.starts_with("not stationary") ? "drifts"
           : o.reason.starts_with("energy") ? fmt::format("energy {:.2g}", o.run.energy_residual)
                                            : "stopped";
  return std::isfinite(cell.trajectory_error) ? fmt::format("{:.1g}", cell.trajectory_error) : "-";
}

/// A setting of a method on a scene of the suite: the default tolerance, the default step.
Scene by_method(const Scene& scene, IntegrationMethod method) {
  Scene set = scene;
  set.integration.method = method;
  return set;
}

// Shares of the horizon. An impact just at an instant makes centimetres a second of a microsecond's
// delay: the median of three instants tells how far a trajectory is off.
constexpr double kInstants[] = {0.92, 0.96, 1};

/// How far a start's trajectories are apart.
struct StartErrors {
  double reference_gap = 0;
  std::map<IntegrationMethod, double> by_method;
};

StartErrors errors_from(const Scene& start, const std::vector<IntegrationMethod>& methods,
                        const SimulateOptions& options) {
  std::vector<double> gaps;
  std::map<IntegrationMethod, std::vector<double>> errors;
  for (const double share : kInstants) {
    const double horizon = share * kSuiteHorizon;
    std::map<IntegrationMethod, Trajectory> references;
    for (const IntegrationMethod method : kReferenceMethods) {
      const Setting setting = reference_setting(method);
      references[setting.method] = follow(with_setting(start, setting), horizon, options);
    }
    gaps.push_back(
        trajectory_error(references[kReferenceMethods[0]], references[kReferenceMethods[1]]));
    for (const IntegrationMethod method : methods)
      errors[method].push_back(trajectory_error(follow(by_method(start, method), horizon, options),
                                                references[reference_setting(method).method]));
  }
  StartErrors middle{median_of_whole(gaps), {}};
  for (const auto& [method, values] : errors) middle.by_method[method] = median_of_whole(values);
  return middle;
}

/// From one start alone chance decides: where rollers rattle, a step that ends otherwise moves the
/// error of the rest of the horizon two- to tenfold.
void judge_trajectories(const std::vector<Scene>& starts,
                        const std::vector<IntegrationMethod>& methods,
                        const SimulateOptions& options, SuiteRow& row) {
  std::vector<double> gaps;
  std::map<IntegrationMethod, std::vector<double>> errors;
  for (const Scene& start : starts) {
    const StartErrors from = errors_from(start, methods, options);
    gaps.push_back(from.reference_gap);
    for (const auto& [method, error] : from.by_method) errors[method].push_back(error);
  }
  row.reference_gap = median_of_whole(gaps);
  for (auto& [method, cell] : row.cells) {
    cell.trajectory_error = median_of_whole(errors[method]);
    cell.soundness = judge_soundness(cell.outcome.status, cell.trajectory_error, row.reference_gap);
  }
}

/// The outcome that speaks for all: of the first run that failed, else of the first that did not
/// end well, else of the first.
Outcome speaking_for(std::vector<Outcome> outcomes) {
  const auto failed = std::ranges::find_if(outcomes, [](const Outcome& o) {
    return o.status != Status::ok && o.status != Status::jammed;
  });
  if (failed != outcomes.end()) return std::move(*failed);
  const auto jammed = std::ranges::find(outcomes, Status::jammed, &Outcome::status);
  return std::move(jammed != outcomes.end() ? *jammed : outcomes.front());
}

}  // namespace

const char* soundness_name(Soundness soundness) {
  constexpr const char* kNames[] = {"right", "degraded", "wrong", "unresolved", "failed"};
  return kNames[static_cast<int>(soundness)];
}

Soundness judge_soundness(Status status, double trajectory_error, double reference_gap) {
  if (status == Status::jammed) return Soundness::right;
  if (status != Status::ok) return Soundness::failed;
  if (!(reference_gap <= kRightError)) return Soundness::unresolved;
  if (trajectory_error <= kRightError) return Soundness::right;
  return trajectory_error <= kDegradedError ? Soundness::degraded : Soundness::wrong;
}

StabilityMap run_stability(const std::vector<SuiteScene>& suite,
                           const std::vector<IntegrationMethod>& methods, int threads,
                           const std::function<void(const SuiteRow&)>& on_row) {
  StabilityMap map{Integration{}.method, methods.empty() ? all_methods() : methods, {}};
  for (const SuiteScene& entry : suite) {
    const std::vector<Scene> starts = starts_of(entry.scene, kSuiteStarts);
    const SimulateOptions shared = with_cage_table(entry.scene);
    SuiteRow row{entry.name, 0, {}};
    for (const IntegrationMethod method : map.methods) {
      std::vector<Scene> scenes;
      for (const Scene& start : starts) scenes.push_back(by_method(start, method));
      row.cells[method].outcome = speaking_for(simulate_all(scenes, threads, shared));
    }
    judge_trajectories(starts, map.methods, shared, row);
    if (on_row) on_row(row);
    map.rows.push_back(std::move(row));
  }
  return map;
}

bool is_sound(const StabilityMap& map) {
  for (const SuiteRow& row : map.rows)
    for (const auto& [method, cell] : row.cells) {
      const bool right = cell.soundness == Soundness::right;
      if (cell.soundness == Soundness::wrong || (method == map.default_method && !right))
        return false;
    }
  return true;
}

Json stability_json(const StabilityMap& map) {
  Json methods = Json::array();
  for (const IntegrationMethod method : map.methods) methods.push_back(spelled(method));
  Json json = {{"kind", "stability"},
               {"default_method", spelled(map.default_method)},
               {"methods", methods},
               {"horizon_s", kSuiteHorizon},
               {"starts", kSuiteStarts}};
  Json& scenes = json["scenes"] = Json::array();
  for (const SuiteRow& row : map.rows) {
    Json results;
    for (const auto& [method, cell] : row.cells) {
      const RunRecord& run = cell.outcome.run;
      results[spelled(method)] = {
          {"verdict", soundness_name(cell.soundness)},
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
  std::vector<std::vector<std::string>> columns = {{"scene"}};  // heading first
  for (const SuiteRow& row : map.rows) columns.front().push_back(row.scene);
  for (const IntegrationMethod method : map.methods) {
    columns.push_back({spelled(method)});
    for (const SuiteRow& row : map.rows) {
      const SuiteCell& cell = row.cells.at(method);
      columns.back().push_back(std::string(soundness_name(cell.soundness)) + " " + brief(cell));
    }
  }
  std::string text;
  for (std::size_t line = 0; line <= map.rows.size(); ++line) {
    for (const auto& column : columns) {
      std::size_t width = 0;
      for (const std::string& entry : column) width = std::max(width, entry.size());
      text += fmt::format("{:<{}}", column[line], width + 2);
    }
    text += "\n";
  }
  text += fmt::format(
      "\nNumbers: trajectory error after {:g} ms in error scales, median of {} starts, or the "
      "watch that spoke.\n",
      1e3 * kSuiteHorizon, kSuiteStarts);
  for (const SuiteRow& row : map.rows)
    for (const IntegrationMethod method : map.methods) {
      const SuiteCell& cell = row.cells.at(method);
      if (cell.soundness == Soundness::wrong)
        text += fmt::format("SILENTLY WRONG: {} on {}, off by {:.3g} error scales\n",
                            spelled(method), row.scene, cell.trajectory_error);
      else if (method == map.default_method && cell.soundness != Soundness::right)
        text +=
            fmt::format("the default is {} on {}{}{}\n", soundness_name(cell.soundness), row.scene,
                        cell.outcome.reason.empty() ? "" : ": ", cell.outcome.reason);
    }
  return text;
}

}  // namespace cagetol
