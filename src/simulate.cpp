#include "src/simulate.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include "src/cage/scene_cage.hpp"
#include "src/cage/unsolved_cage.hpp"
#include "src/integration/integrator.hpp"
#include "src/quantities/observer.hpp"
#include "src/quantities/plausibility.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/quasi_static.hpp"
#include "src/statics/start_state.hpp"
#include "src/window_times.hpp"

namespace cagetol {
namespace {

constexpr long kStepsBetweenQuestions = 256;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

Outcome jammed(const Jam& jam) {
  Outcome outcome;
  outcome.status = Status::jammed;
  outcome.pocket = jam.pocket;
  outcome.interference_um = 1e6 * jam.interference;
  outcome.reason = "the roller is " + number(outcome.interference_um) +
                   " um too large for pocket " + std::to_string(jam.pocket) +
                   (jam.in_width ? " (width)" : " (length)");
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

/// Of a method without error control [error scales]: past it the stability suite finds wrong
/// trajectories, below it none.
constexpr double kStepErrorMax = 1;

/// Share of the roller positions that statics may miss.
constexpr double kMissedMax = 0.5;

/// Empty, or what still drifts at the end of the window.
std::string find_drift(const Scene& scene, const BearingModel& model, const Observer& observer) {
  if (!observer.stationarity()) return {};
  return observer.stationarity()->find_drift({kinematic_cage_speed(model, model.inner_speed),
                                              scene.watch.cage_drift_max,
                                              scene.watch.power_surplus_max});
}

void judge(const Scene& scene, const BearingModel& model, const WindowTimes& times,
           double step_error, const Observer& observer, Outcome& outcome) {
  const RunRecord& run = outcome.run;
  const double blur = observer.energy_resolution(scene.integration.tolerance),
               statics_blur = observer.static_resolution();
  const double lean = observer.largest_lean(), tilt = observer.largest_tilt();
  const std::string drift = find_drift(scene, model, observer);
  const long positions = observer.static_positions(), missed = observer.static_positions_missed();
  if (!(tilt <= kLeanMax)) {
    outcome.status = Status::failed;
    outcome.reason =
        "the inner ring tilted by " + number(tilt) + " rad, more than " + number(kLeanMax) +
        ": too little holds it; raise bearing.tilt_stiffness_N_m_rad, or "
        "discretisation.race_slices to at least 3, a single slice rights no tilted ring";
  } else if (static_cast<double>(missed) > kMissedMax * static_cast<double>(positions)) {
    outcome.status = Status::failed;
    outcome.reason = "no static equilibrium of ring and rollers was found at " +
                     std::to_string(missed) + " of " + std::to_string(positions) +
                     " roller positions: nothing tells whether the loaded contacts are right; "
                     "remedy: check contact.race (damping this strong, or a restitution this "
                     "small, holds rollers off the races), load.radial_N and "
                     "bearing.internal_clearance_um";
  } else if (!(run.static_consistency_error <= scene.watch.static_consistency_max + statics_blur)) {
    outcome.status = Status::failed;
    outcome.reason =
        "static consistency error " + number(run.static_consistency_error) + " exceeds " +
        number(scene.watch.static_consistency_max + statics_blur) +
        ": the step is too long for the loaded contacts, or the window too short to settle; "
        "remedy: "
        "tighten integration.tolerance (shorten integration.fixed_step_us), or lengthen "
        "window.settle_revolutions and window.measure_revolutions";
  } else if (!(run.energy_residual <= scene.watch.energy_residual_max + blur)) {
    outcome.status = Status::failed;
    outcome.reason = "energy residual " + number(run.energy_residual) + " exceeds " +
                     number(scene.watch.energy_residual_max + blur) +
                     ": steps make or lose energy; remedy: tighten integration.tolerance (shorten "
                     "integration.fixed_step_us)";
  } else if (!drift.empty()) {
    outcome.status = Status::failed;
    outcome.reason =
        "not stationary after " + number(times.settle) + " s of settling: " + drift +
        "; remedy: raise window.longest_settle_revolutions or window.settle_revolutions (a cage "
        "that skids may take hundreds), or start nearer to the steady motion (start.state)";
  } else if (!(lean <= kLeanMax)) {
    outcome.status = Status::failed;
    outcome.reason = "a roller leaned by " + number(lean) + " rad, more than " + number(kLeanMax) +
                     ": rollers tumble; raise discretisation.race_slices to at least 3, a single "
                     "slice rights no tilted roller";
  } else if (!(step_error <= kStepErrorMax)) {
    outcome.status = Status::failed;
    outcome.reason = "a single step was off by " + number(step_error) +
                     " error scales (1 cm/s and kin), more than " + number(kStepErrorMax) +
                     ": shorten integration.fixed_step_us";
  } else {
    const PlausibleReach reach(scene, model,
                               {.begin = times.settle,
                                .end = times.settle + run.measured_s,
                                .revolutions = run.cage_revolutions,
                                .steps = run.steps,
                                .peaks_in_part = times.peaks < run.measured_s});
    outcome.reason = find_implausible(reach, outcome.quantities);
    outcome.status = outcome.reason.empty() ? Status::ok : Status::failed;
  }
}

/// Whether the means of a window that ends by itself are known well enough, and their motion is the
/// one that is meant.
bool has_converged(const Scene& scene, const BearingModel& model, const Observer& observer,
                   double t) {
  return t >= std::max(model.load_ramp, model.speed_ramp) &&
         observer.convergence().worst().share <= scene.window.measure_share &&
         find_drift(scene, model, observer).empty();
}

}  // namespace

Outcome simulate(const Scene& scene, const SimulateOptions& options) {
  const Jam jam = find_jam(scene);
  if (jam.pocket >= 0 && !scene.allow_interference) return jammed(jam);
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };

  Outcome outcome;
  if (jam.pocket >= 0) {  // the pinch is simulated on request, but never passed over in silence
    outcome.pocket = jam.pocket;
    outcome.interference_um = 1e6 * jam.interference;
  }
  if (is_quasi_static(scene)) {
    Outcome still = quasi_static_outcome(scene);
    still.pocket = outcome.pocket;
    still.interference_um = outcome.interference_um;
    still.run.wall_s = seconds();
    return still;
  }
  std::shared_ptr<const CageModel> cage;
  if (is_flexible(scene)) {
    auto made = elastic_cage(scene, options);
    if (const auto* fault = std::get_if<CageFault>(&made)) return without_cage(*fault);
    cage = std::get<std::shared_ptr<const CageModel>>(made);
  }
  const BearingModel model = make_bearing_model(scene, cage);
  WindowTimes times = window_times(scene, model);
  const std::vector<double> start = start_state(model, scene.start);
  PackVector y(start.begin(), start.end());
  System system(model);
  double t = 0;
  const auto integrator = make_integrator(scene.integration, system, t, y.data());
  double end = times.settle + times.measure;
  std::optional<Observer> observer(std::in_place, model, times);
  const bool open_end = measures_until_converged(scene);
  WindowEnd window_end = WindowEnd::fixed;

  bool finite = system.linearise_at(t, y.data());
  StepStatus status = StepStatus::accepted;
  for (long n = 0; finite && status == StepStatus::accepted; ++n) {
    if (t >= times.settle) observer->record(t, y.data(), system);
    if (t >= end && end <= times.longest_settle && !find_drift(scene, model, *observer).empty()) {
      times.settle = end;
      end += times.measure;
      observer.emplace(model, times);
      observer->record(t, y.data(), system);
      if (options.on_window) options.on_window(times.settle);
    } else if (t >= end && open_end) {
      if (has_converged(scene, model, *observer, t)) {
        window_end = WindowEnd::converged;
      } else if (end < times.settle + (1 - 1e-9) * times.longest) {
        end += times.revolution;
        observer->extend(end);
      } else {
        window_end = WindowEnd::longest;
      }
    }
    if (options.on_state) options.on_state(t, y.data(), system);
    if (t >= end) break;
    if (n % kStepsBetweenQuestions == 0) {
      const bool stop = options.stop_requested && options.stop_requested();
      if (stop ||
          (scene.integration.wall_budget > 0 && seconds() > scene.integration.wall_budget)) {
        outcome.status = Status::not_run;
        outcome.reason = stop ? "stopped on request" : "aborted by the wall-clock limit";
        outcome.run.wall_s = seconds();
        return outcome;
      }
    }
    const double peaks_end = times.settle + times.peaks;
    status = integrator->step(system, t, y.data(),
                              t < times.settle ? times.settle
                              : t < peaks_end  ? std::min(peaks_end, end)
                                               : end);
    if (status == StepStatus::accepted) finite = system.linearise_at(t, y.data());
  }
  RunRecord& run = outcome.run;
  run.simulated_s = t;
  run.steps = static_cast<double>(system.counts.steps);
  run.rejected_steps = static_cast<double>(system.counts.rejected);
  run.rhs_evaluations = static_cast<double>(system.counts.rhs);
  run.jacobian_evaluations = static_cast<double>(system.counts.jacobians);
  run.factorisations = static_cast<double>(system.counts.factorisations);
  run.smallest_step_s = system.counts.smallest_step;
  if (finite && status == StepStatus::accepted) {
    run.measured_s = end - times.settle;
    run.cage_revolutions = observer->cage_revolutions();
    run.window_end = window_end;
    const MeanShare worst = observer->convergence().worst();
    run.mean_share = worst.share;
    outcome.least_known = worst.key;
    run.energy_residual = observer->energy_residual();
    run.static_consistency_error = observer->static_consistency_error();
    run.static_positions_missed = static_cast<double>(observer->static_positions_missed());
    outcome.quantities = observer->quantities();
    outcome.cage_peak = observer->cage_peak();
    judge(scene, model, times, system.counts.largest_step_error, *observer, outcome);
  } else {
    outcome.quantities.assign(quantity_table().size(), std::numeric_limits<double>::quiet_NaN());
    outcome.status = status == StepStatus::out_of_budget ? Status::censored : Status::failed;
    outcome.reason = status == StepStatus::out_of_budget
                         ? "step budget of " + std::to_string(scene.integration.step_budget) +
                               " ran out at t = " + number(t) + " s of " + number(end) + " s"
                     : finite ? integrator->failure()
                              : "a force is not finite at t = " + number(t) + " s";
  }
  run.wall_s = seconds();
  return outcome;
}

}  // namespace cagetol
