#include "src/simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include "src/cage/solve/unsolved_cage.hpp"
#include "src/cage/table/scene_cage.hpp"
#include "src/integration/integrator.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/quantities/observer.hpp"
#include "src/quantities/quantity_bounds.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/quantities/window_times.hpp"
#include "src/quasi_static.hpp"
#include "src/scene/pocket_clearances.hpp"
#include "src/statics/start_state.hpp"

namespace cagetol {
namespace {

constexpr long kStepsBetweenQuestions = 256;

std::string number(double x) {
  return fmt::format("{:.4g}", x);
}

Outcome jammed(const Jam& jam) {
  Outcome outcome;
  outcome.status = Status::jammed;
  outcome.pocket = jam.pocket;
  outcome.interference_um = 1e6 * jam.interference;
  outcome.reason = "the roller is " + number(outcome.interference_um) +
                   " um too large for pocket " + std::to_string(jam.pocket) + " (" + jam.where +
                   ")";
  outcome.quantities.assign(quantity_table().size(), std::numeric_limits<double>::quiet_NaN());
  return outcome;
}

/// A cage that a ring holds fast: drawn too large, or grown too large in operation.
std::optional<Outcome> seized(const Scene& scene) {
  const PocketClearances left = pocket_clearances(scene, 0);
  const int ring = left.ring[0] < left.ring[1] ? 0 : 1;
  if (left.ring[ring] > 0) return {};
  Outcome outcome;
  outcome.status = Status::jammed;
  outcome.interference_um = -1e6 * left.ring[ring];
  outcome.reason = std::string(ring == 0 ? "the cage's bore is " : "the cage's outside is ") +
                   number(outcome.interference_um) + " um (of radii) too " +
                   (ring == 0 ? "small for the inner ring" : "large for the outer ring");
  outcome.quantities.assign(quantity_table().size(), std::numeric_limits<double>::quiet_NaN());
  return outcome;
}

/// A cage that cannot be: impossible geometry is a kind of jam, a cage beyond the table a failure.
Outcome without_cage(const CageFault& fault) {
  Outcome outcome;
  const bool impossible = fault.kind == CageFaultKind::geometry;
  outcome.status = impossible ? Status::jammed : Status::failed;
  outcome.pocket = fault.pocket;
  outcome.reason = "flexible cage: " +
                   (fault.pocket >= 0 ? "pocket " + std::to_string(fault.pocket) + ": " : "") +
                   fault.reason;
  outcome.quantities.assign(quantity_table().size(), std::numeric_limits<double>::quiet_NaN());
  return outcome;
}

/// The elastic cage of a run, or why there is none.
std::variant<std::shared_ptr<const CageModel>, CageFault> elastic_cage(
    const Scene& scene, const SimulateOptions& options) {
  const auto unsolved = [](const std::string& why) {
    return CageFault{CageFaultKind::outside_table, -1,
                     "its finite elements cannot be solved: " + why +
                         "; choose another cage.mesh_density, or a cage less slender"};
  };
  if (options.cage_model) return options.cage_model;
  if (options.cage_table) return scene_cage_model(scene, *options.cage_table);
  if (!options.why_no_cage.empty()) return unsolved(options.why_no_cage);
  try {
    return scene_cage_model(scene, *make_scene_cage_table(scene));
  } catch (const UnsolvedCage& problem) {
    return unsolved(problem.what());
  }
}

/// Share of the roller positions that statics may miss.
constexpr double kMissedMax = 0.5;

/// Empty, or what still drifts at the end of the window.
std::string find_drift(const Scene& scene, const BearingModel& model, const Observer& observer) {
  if (!observer.stationarity()) return {};
  return observer.stationarity()->find_drift({kinematic_cage_speed(model, model.duty.speed),
                                              scene.watch.cage_drift_max,
                                              scene.watch.power_surplus_max});
}

/// The watches of a run that came to its end, one after the other: why it has failed, or empty.
std::string find_fault(const Scene& scene, const BearingModel& model, const WindowTimes& times,
                       const Observer& observer, const Outcome& outcome) {
  const RunRecord& run = outcome.run;
  const double blur = observer.energy_resolution(scene.integration.tolerance),
               statics_blur = observer.static_resolution();
  const double lean = observer.rollers().largest_lean(), tilt = observer.ring().largest_tilt();
  const std::string drift = find_drift(scene, model, observer);
  const long positions = observer.ring().positions(), missed = observer.ring().positions_missed();
  if (!(tilt <= kLeanMax))
    return "the inner ring tilted by " + number(tilt) + " rad, more than " + number(kLeanMax) +
           ": too little holds it; raise bearing.tilt_stiffness_N_m_rad, or "
           "discretisation.race_slices to at least 3, a single slice rights no tilted ring";
  if (static_cast<double>(missed) > kMissedMax * static_cast<double>(positions))
    return "no static equilibrium of ring and rollers was found at " + std::to_string(missed) +
           " of " + std::to_string(positions) +
           " roller positions: nothing tells whether the loaded contacts are right; "
           "remedy: check contact.race (damping this strong, or a restitution this "
           "small, holds rollers off the races), load.radial_N and "
           "bearing.internal_clearance_um";
  if (!(run.static_consistency_error <= scene.watch.static_consistency_max + statics_blur))
    return "static consistency error " + number(run.static_consistency_error) + " exceeds " +
           number(scene.watch.static_consistency_max + statics_blur) +
           ": the step is too long for the loaded contacts, or the window too short to settle; "
           "remedy: tighten integration.tolerance, or lengthen window.settle_revolutions and "
           "window.measure_revolutions";
  if (!(run.energy_residual <= scene.watch.energy_residual_max + blur))
    return "energy residual " + number(run.energy_residual) + " exceeds " +
           number(scene.watch.energy_residual_max + blur) +
           ": steps make or lose energy; remedy: tighten integration.tolerance";
  if (!drift.empty())
    return "not stationary after " + number(times.settle) + " s of settling: " + drift +
           "; remedy: raise window.longest_settle_revolutions or window.settle_revolutions (a cage "
           "that skids may take hundreds), or start nearer to the steady motion (start.state)";
  if (!(lean <= kLeanMax))
    return "a roller leaned by " + number(lean) + " rad, more than " + number(kLeanMax) +
           ": rollers tumble; raise discretisation.race_slices to at least 3, a single "
           "slice rights no tilted roller";
  return find_impossible({scene, model, times.settle, times.settle + run.measured_s,
                          outcome.quantities, times.peak_turns < run.cage_revolutions});
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

/// A run in time on its way: bearing, state, method and window.
struct Motion {
  Motion(const Scene& scene, std::shared_ptr<const CageModel> cage)
      : model(make_bearing_model(scene, std::move(cage))),
        times(window_times(scene, model)),
        system(model),
        observer(std::in_place, model, times),
        end(times.settle + times.longest) {
    for (std::size_t i = 0; i < scene.phase.name.size(); ++i)
      phases.push_back({scene.phase.from[i], scene.phase.to[i],
                        Observer(model, scene.phase.from[i], scene.phase.to[i])});
    const std::vector<double> start = start_state(model, scene.start);
    y.assign(start.begin(), start.end());
    integrator = make_integrator(scene.integration, system, t, y.data());
    set_step_budget(scene.integration);
  }

  /// What is given; otherwise some twenty times what shipped scenes take to the end of the window:
  /// a run that needs more cannot be followed, and ends at the same step on any machine.
  void set_step_budget(const Integration& keys) {
    system.step_budget =
        given_or(keys.step_budget, std::ceil(1e5 * (1 + end / times.revolution) + 1e6 * end));
  }

  const BearingModel model;
  WindowTimes times;
  System system;
  std::optional<Observer> observer;
  struct Phase {
    double from, to;  ///< [s]
    Observer observer;
  };
  /// Whether the window has ended: a cage that does not skid makes its turns in it.
  bool has_ended() const {
    return t >= end || (t >= times.settle + times.measure && observer->has_turned());
  }

  std::vector<Phase> phases;
  PackVector y;
  double t = 0, end;  ///< now, and where the window ends at the latest [s]
  std::unique_ptr<Integrator> integrator;
  StepStatus status = StepStatus::accepted;
  bool finite = true;
};

/// At the end of the window: settles longer where the motion drifts.
void extend_window(const Scene& scene, Motion& run) {
  WindowTimes& times = run.times;
  if (run.t > times.longest_settle || find_drift(scene, run.model, *run.observer).empty()) return;
  times.settle = run.t;
  run.end = run.t + times.longest;
  run.set_step_budget(scene.integration);
  run.observer.emplace(run.model, times);
  run.observer->record(run.t, run.y.data(), run.system);
}

/// Why the run ends before its time; empty if it does not.
std::string stop_reason(const Scene& scene, const SimulateOptions& options,
                        Clock::time_point began) {
  if (options.stop_requested && options.stop_requested()) return "stopped on request";
  const double budget = scene.integration.wall_budget;
  return budget > 0 && seconds_since(began) > budget ? "aborted by the wall-clock limit" : "";
}

/// Instants this close are one [s].
constexpr double kSame = 1e-10;

/// Where the next step ends at the latest: a bound of the window or of a phase, a corner of the
/// duty.
double next_stop(const Motion& run) {
  double stop = run.t < run.times.settle ? run.times.settle : run.end;
  if (!run.model.duty.over_time()) return stop;
  std::vector<double> due = {stop, next_corner(run.model.duty, run.t)};
  for (const Motion::Phase& phase : run.phases)
    for (const double bound : {phase.from, phase.to})
      if (bound > run.t + kSame) due.push_back(bound);
  std::sort(due.begin(), due.end());
  stop = due.front();
  for (const double other : due)
    if (other < due.front() + kSame) stop = other;
  return stop;
}

void record(Motion& run) {
  if (run.t >= run.times.settle) run.observer->record(run.t, run.y.data(), run.system);
  for (Motion::Phase& phase : run.phases)
    if (run.t > phase.from - kSame && run.t < phase.to + kSame)
      phase.observer.record(run.t, run.y.data(), run.system);
}

/// Steps to the end of the window. Returns why the run was stopped; empty if it was not.
std::string integrate(const Scene& scene, const SimulateOptions& options, Clock::time_point began,
                      Motion& run) {
  run.finite = run.system.linearise_at(run.t, run.y.data());
  for (long n = 0; run.finite && run.status == StepStatus::accepted; ++n) {
    record(run);
    if (run.has_ended()) extend_window(scene, run);
    if (options.on_state) options.on_state(run.t, run.y.data(), run.system);
    if (run.has_ended()) break;
    if (n % kStepsBetweenQuestions == 0)
      if (std::string reason = stop_reason(scene, options, began); !reason.empty()) return reason;
    run.status = run.integrator->step(run.system, run.t, run.y.data(), next_stop(run));
    if (run.status == StepStatus::accepted)
      run.finite = run.system.linearise_at(run.t, run.y.data());
  }
  return {};
}

/// The quantities of a phase into the outcome, which fails where one is impossible.
void add_phase(const Scene& scene, const Motion& run, std::size_t i, Outcome& outcome) {
  const Motion::Phase& phase = run.phases[i];
  const std::vector<double> quantities = phase.observer.quantities();
  outcome.quantities.insert(outcome.quantities.end(), quantities.begin(), quantities.end());
  if (outcome.status != Status::ok) return;
  const std::string problem = find_impossible({scene, run.model, phase.from, phase.to, quantities});
  if (problem.empty()) return;
  outcome.status = Status::failed;
  outcome.reason = "phase " + scene.phase.name[i] + ": " + problem;
}

/// What the run amounts to, into the outcome, and whether it can be trusted.
void conclude(const Scene& scene, const Motion& run, Outcome& outcome) {
  RunRecord& record = outcome.run;
  const Counts& counts = run.system.counts;
  record.simulated_s = run.t;
  record.steps = static_cast<double>(counts.steps);
  record.rejected_steps = static_cast<double>(counts.rejected);
  record.rhs_evaluations = static_cast<double>(counts.rhs);
  record.jacobian_evaluations = static_cast<double>(counts.jacobians);
  record.factorisations = static_cast<double>(counts.factorisations);
  record.smallest_step_s = counts.smallest_step;
  if (!run.finite || run.status != StepStatus::accepted) {
    const bool out_of_budget = run.status == StepStatus::out_of_budget;
    outcome.quantities.assign(quantity_table().size(), std::numeric_limits<double>::quiet_NaN());
    outcome.status = out_of_budget ? Status::censored : Status::failed;
    outcome.reason = out_of_budget
                         ? "the budget of " + number(run.system.step_budget) +
                               " steps (integration.step_budget) ran out at t = " + number(run.t) +
                               " s of " + number(run.end) + " s"
                     : run.finite ? run.integrator->failure()
                                  : "a force is not finite at t = " + number(run.t) + " s";
    return;
  }
  const Observer& observer = *run.observer;
  record.measured_s = run.t - run.times.settle;
  record.windows_cut = observer.has_turned() ? 0 : 1;
  record.cage_revolutions = observer.cage_revolutions();
  record.energy_residual = observer.energy_residual();
  record.static_consistency_error = observer.static_consistency_error();
  record.static_positions_missed = static_cast<double>(observer.ring().positions_missed());
  outcome.quantities = observer.quantities();
  outcome.cage_peak = observer.cage_peak();
  outcome.reason = find_fault(scene, run.model, run.times, observer, outcome);
  outcome.status = outcome.reason.empty() ? Status::ok : Status::failed;
  for (std::size_t i = 0; i < run.phases.size(); ++i) add_phase(scene, run, i, outcome);
}

/// The run in time of a bearing whose rollers fit, or may pinch.
Outcome motion_outcome(const Scene& scene, const SimulateOptions& options,
                       Clock::time_point began) {
  std::shared_ptr<const CageModel> cage;
  if (is_flexible(scene)) {
    auto made = elastic_cage(scene, options);
    if (const auto* fault = std::get_if<CageFault>(&made)) return without_cage(*fault);
    cage = std::get<std::shared_ptr<const CageModel>>(made);
  }
  Motion run(scene, cage);
  Outcome outcome;
  if (const std::string stopped = integrate(scene, options, began, run); !stopped.empty()) {
    outcome.status = Status::not_run;
    outcome.reason = stopped;
    return outcome;
  }
  conclude(scene, run, outcome);
  return outcome;
}

/// With a value, or none, for each phase.
Outcome complete(const Scene& scene, Outcome outcome) {
  outcome.labels = scene.phase.name;
  outcome.quantities.resize(quantity_count(outcome.labels),
                            std::numeric_limits<double>::quiet_NaN());
  return outcome;
}

}  // namespace

Outcome simulate(const OperatingScene& scene, const SimulateOptions& options) {
  const Clock::time_point began = Clock::now();
  if (needs_temperature(scene.temperature) && !is_quasi_static(scene))
    throw std::logic_error("simulate: with_temperature_found() comes first");
  const Jam jam = find_jam(scene);
  if (jam.pocket >= 0 && !scene.allow_interference) return complete(scene, jammed(jam));
  if (!is_quasi_static(scene))
    if (const std::optional<Outcome> held = seized(scene)) return complete(scene, *held);
  Outcome outcome =
      is_quasi_static(scene) ? quasi_static_outcome(scene) : motion_outcome(scene, options, began);
  if (jam.pocket >= 0 &&
      outcome.pocket < 0) {  // the pinch is simulated on request, but never passed over in silence
    outcome.pocket = jam.pocket;
    outcome.interference_um = 1e6 * jam.interference;
  }
  outcome = complete(scene, std::move(outcome));
  outcome.run.wall_s = seconds_since(began);
  return outcome;
}

}  // namespace cagetol
