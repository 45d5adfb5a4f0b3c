#include "mc/benchmark/chart.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>

#include "analysis/statistics/median.hpp"
#include "mc/benchmark/replicas.hpp"
#include "mc/benchmark/trajectory.hpp"
#include "mc/run/cage_cache.hpp"
#include "src/cage/table/scene_cage.hpp"
#include "src/model/bearing_model.hpp"
#include "src/operation/operating_clearance.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string problem_of(const Outcome& outcome) {
  return outcome.status == Status::ok
             ? ""
             : std::string(status_name(outcome.status)) + ": " + outcome.reason;
}

/// Medians over runs.
class Costs {
 public:
  void add(const Outcome& outcome, double wall_s) {
    if (outcome.status == Status::ok) {
      rtf_.push_back(wall_s / outcome.run.simulated_s);
      rhs_.push_back(outcome.run.rhs_evaluations / outcome.run.simulated_s);
    } else if (problem_.empty()) {
      problem_ = problem_of(outcome);
    }
  }
  ChartCost cost() const { return {median(rtf_), median(rhs_), problem_}; }

 private:
  std::vector<double> rtf_, rhs_;
  std::string problem_;
};

ChartCost cost_of(const std::vector<Outcome>& outcomes) {
  Costs costs;
  for (const Outcome& outcome : outcomes) costs.add(outcome, outcome.run.wall_s);
  return costs.cost();
}

/// Marks the points that no other one beats in cost and error at once. A setting that failed in any
/// run stays off the front: what is left of it would be a choice.
template <class Cost, class Error>
void mark_front(std::vector<ChartPoint>& points, const Cost& cost, const Error& error) {
  for (ChartPoint& p : points) {
    bool beaten =
        !(std::isfinite(cost(p).rtf) && std::isfinite(error(p))) || !cost(p).problem.empty();
    for (ChartPoint& q : points)
      beaten =
          beaten || (cost(q).problem.empty() && cost(q).rtf < cost(p).rtf && error(q) < error(p));
    cost(p).on_front = !beaten;
  }
}

std::vector<Trajectory> follow_all(const std::vector<Scene>& starts, const Setting& setting,
                                   double horizon, const SimulateOptions& options) {
  std::vector<Trajectory> runs;
  for (const Scene& scene : starts)
    runs.push_back(follow(with_setting(scene, setting), horizon, options));
  return runs;
}

/// Of the starts the median: where an impact falls on the instant, a microsecond's delay is
/// centimetres a second, and a mean would be that start's.
double median_error(const std::vector<Trajectory>& runs,
                    const std::vector<Trajectory>& references) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < runs.size(); ++k)
    errors.push_back(trajectory_error(runs[k], references[k]));
  return median_of_whole(std::move(errors));
}

void measure_trajectories(const Scene& scene, const SimulateOptions& options, Chart& chart) {
  const std::vector<Scene> starts = starts_of(scene, chart.options.starts);
  std::map<IntegrationMethod, std::vector<Trajectory>> references;
  for (const IntegrationMethod method : kReferenceMethods) {
    const Setting setting = reference_setting(method);
    references[setting.method] = follow_all(starts, setting, chart.options.horizon, options);
  }
  chart.reference_gap =
      median_error(references[kReferenceMethods[0]], references[kReferenceMethods[1]]);
  for (ChartPoint& p : chart.points) {
    const auto runs = follow_all(starts, p.setting, chart.options.horizon, options);
    p.trajectory_error = median_error(runs, references[reference_setting(p.setting.method).method]);
    Costs costs;
    for (const Trajectory& run : runs) costs.add(run.outcome, run.motion_wall_s);
    p.brief = costs.cost();
  }
  mark_front(
      chart.points, [](ChartPoint& p) -> ChartCost& { return p.brief; },
      [](const ChartPoint& p) { return p.trajectory_error; });
}

/// Values of quantity q in all replicas; NaN where one is not ok or has none.
std::vector<double> values_of(const std::vector<Outcome>& outcomes, std::size_t q) {
  std::vector<double> values;
  for (const Outcome& outcome : outcomes)
    values.push_back(outcome.status == Status::ok ? outcome.quantities[q] : kUnknown);
  return values;
}

/// Number of quantities that count.
int summarise_biases(WindowErrors& p) {
  double bias = 0, noise = 0;
  int count = 0;
  for (const Bias& b : p.biases) {
    if (!(b.deviation > 0) || b.verdict == BiasVerdict::steady) continue;
    bias += std::pow(b.bias / b.deviation, 2);
    noise += std::pow(b.standard_error / b.deviation, 2);
    ++count;
  }
  p.bias_rms = count ? std::sqrt(bias / count) : kUnknown;
  p.bias_noise = count ? std::sqrt(noise / count) : kUnknown;
  return count;
}

/// What the runs say against those of the reference, which is called `name`.
int compare_runs(const std::vector<Outcome>& outcomes, const std::vector<Outcome>& reference,
                 const std::string& name, WindowErrors& p) {
  p.window = cost_of(outcomes);
  for (std::size_t q = 0; q < quantity_table().size(); ++q)
    p.biases.push_back(compare_pairs(values_of(outcomes, q), values_of(reference, q)));
  if (const ChartCost cost = cost_of(reference); p.window.problem.empty() && !cost.problem.empty())
    p.window.problem = "reference " + name + ": " + cost.problem;
  return summarise_biases(p);
}

std::vector<Outcome> run_replicas(const std::vector<Scene>& scenes, const Setting& setting,
                                  int threads, const SimulateOptions& options) {
  std::vector<Scene> set;
  for (const Scene& scene : scenes) set.push_back(with_setting(scene, setting));
  return simulate_all(set, threads, options);
}

void measure_biases(const Study& study, const SimulateOptions& options, Chart& chart,
                    const std::function<void(const std::string&)>& say) {
  // Settings and references see the same replicas: what their deviations do to a quantity cancels.
  const std::vector<Scene> scenes = replica_scenes(study, chart.options.replicas);
  std::map<IntegrationMethod, std::vector<Outcome>> references;
  for (ChartPoint& p : chart.points) {
    const Setting reference = reference_setting(p.setting.method);
    auto& known = references[reference.method];
    if (known.empty()) {
      say("reference " + setting_label(reference));
      known = run_replicas(scenes, reference, chart.options.threads, options);
    }
    say(setting_label(p.setting));
    const auto outcomes = run_replicas(scenes, p.setting, chart.options.threads, options);
    compare_runs(outcomes, known, setting_label(reference), p);
  }
  mark_front(
      chart.points, [](ChartPoint& p) -> ChartCost& { return p.window; },
      [](const ChartPoint& p) { return p.bias_rms; });
}

std::vector<Outcome> run_rung(const std::vector<Scene>& scenes, const Rung& rung, int threads) {
  std::vector<Scene> set;
  for (const Scene& scene : scenes) set.push_back(on_rung(scene, rung));
  SimulateOptions options;
  if (is_flexible(set.front())) options.cage_table = CageTables(set.front()).of(set.front());
  return simulate_all(set, threads, options);
}

/// The highest rung, integrated tightly by a method of another kind.
Rung tight(Rung rung) {
  const Setting setting = reference_setting(setting_of(on_rung({}, rung)).method);
  rung.settings.push_back(fmt::format("integration.method='{}'", spelled(setting.method)));
  rung.settings.push_back("integration.tolerance=" + fmt::format("{}", setting.tolerance));
  return rung;
}

void measure_rungs(const Study& study, Chart& chart,
                   const std::function<void(const std::string&)>& say) {
  const int threads = chart.options.threads;
  const std::vector<Scene> scenes = replica_scenes(study, chart.options.replicas);
  const Rung& highest = climbing_rungs().back();
  say("reference of the rungs");
  const auto reference = run_rung(scenes, tight(highest), threads);
  for (const Rung& rung : rungs_for(study.scene, climbing_rungs())) {
    say("rung " + rung.name);
    RungPoint& p = chart.rungs.emplace_back();
    p.rung = rung;
    auto outcomes = run_rung(scenes, rung, threads);
    // Equilibria simulate no time; they stand for the same window as the motion.
    for (Outcome& outcome : outcomes)
      if (outcome.run.simulated_s == 0) outcome.run.simulated_s = reference.front().run.simulated_s;
    p.quantities = compare_runs(outcomes, reference, "of " + highest.name, p);
  }
}

/// A roller comes and a roller goes, whatever the bearing's size and speed [s].
double usual_horizon(const Scene& scene) {
  const double between = roller_interval(make_bearing_model(scene));
  return std::isfinite(between) ? between : 2e-3;
}

}  // namespace

Chart make_chart(const Study& study, const ChartOptions& options,
                 const std::function<void(const std::string&)>& say) {
  const Scene scene = replica_scenes(study, 1).front();
  Chart chart{scene.name, options, kUnknown, {}, {}};
  if (std::isnan(options.horizon)) chart.options.horizon = usual_horizon(scene);
  for (const Setting& setting : setting_ladder(scene, options.methods)) {
    ChartPoint point;
    point.setting = setting;
    point.bias_rms = point.bias_noise = kUnknown;
    chart.points.push_back(std::move(point));
  }
  say("trajectories");
  const SimulateOptions shared = with_cage_table(scene);
  measure_trajectories(scene, shared, chart);
  if (options.replicas > 0) measure_biases(study, shared, chart, say);
  if (options.replicas > 0 && options.rungs) measure_rungs(study, chart, say);
  return chart;
}

}  // namespace cagetol
