#include "src/quasi_static.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/quantities/quantity_bounds.hpp"
#include "src/quantities/quantity_rows.hpp"
#include "src/quantities/series.hpp"
#include "src/quantities/window_times.hpp"
#include "src/statics/start_state.hpp"
#include "src/statics/static_equilibrium.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

// The ring's displacement repeats with the pitch of the rollers and is smooth but where a roller
// enters or leaves the load zone: 8 positions a pitch give its mean to 4e-5 (16: 2e-5), the 95 %
// quantile of its orbit to some per cent, and cost a fiftieth of the motion.
constexpr double kPositionsPerPitch = 8;

constexpr double kDutyAccuracy = 1e-6;  // of the balance under a duty over time, share of the load

/// An instant at which equilibrium is sought.
struct Instant {
  double time = 0;        ///< [s]
  double angle = 0;       ///< of the cage [rad]
  double cage_speed = 0;  ///< kinematic [rad/s]
  RingSpeeds rings;
};

/// The cage's angles, equally spaced, up to the end of the window and over a turn at most.
std::vector<Instant> instants_of_turn(const Scene& scene, const BearingModel& model,
                                      const WindowTimes& window) {
  const double cage_speed = kinematic_cage_speed(model, model.duty.speed);
  const double span = std::min(std::abs(cage_speed) * window.measure, 2 * pi);
  const double pitch = 2 * pi / model.layout.rollers;
  const long count = std::max(1L, std::lround(std::ceil(kPositionsPerPitch * span / pitch)));
  const double end = window.settle + window.measure, every = span / static_cast<double>(count);
  const double last = scene.start.cage_phase + cage_speed * end,
               spacing = std::copysign(every, cage_speed),
               interval = cage_speed != 0 ? every / std::abs(cage_speed) : 0;
  std::vector<Instant> instants;
  for (long k = 0; k < count; ++k) {
    const auto before_end = static_cast<double>(count - 1 - k);
    instants.push_back(
        {end - interval * before_end, last - spacing * before_end, cage_speed, model.duty.speed});
  }
  return instants;
}

/// Instants over the whole window of a duty over time, equally spaced.
std::vector<Instant> instants_of_duty(const Scene& scene, const BearingModel& model,
                                      const WindowTimes& window) {
  constexpr int count = 512;
  std::vector<Instant> instants;
  for (int k = 1; k <= count; ++k) {
    const double t = window.settle + window.measure * k / count;
    const RingAngles turned = ring_angles_at(model.duty, t);
    const RingSpeeds rings = ring_speeds_at(model.duty, t);
    instants.push_back(
        {t, scene.start.cage_phase + kinematic_cage_speed(model, {turned.inner, turned.outer}),
         kinematic_cage_speed(model, rings), rings});
  }
  return instants;
}

/// Turned by the cage from before the first instant to the last one [revolutions].
double revolutions_over(const std::vector<Instant>& instants) {
  if (instants.size() < 2) return 0;
  double turned = 0;
  for (std::size_t k = 1; k < instants.size(); ++k)
    turned += std::abs(instants[k].angle - instants[k - 1].angle);
  const auto count = static_cast<double>(instants.size());
  return turned * count / (count - 1) / (2 * pi);
}

}  // namespace

Outcome quasi_static_outcome(const OperatingScene& scene) {
  const BearingModel model = make_bearing_model(scene);
  Outcome outcome;
  outcome.quantities.assign(quantity_table().size(), std::numeric_limits<double>::quiet_NaN());
  outcome.run.energy_residual = outcome.run.static_consistency_error =
      std::numeric_limits<double>::quiet_NaN();  // nothing to watch
  const WindowTimes window = window_times(scene, model);
  const std::vector<Instant> instants = model.duty.over_time()
                                            ? instants_of_duty(scene, model, window)
                                            : instants_of_turn(scene, model, window);
  // Many instants ask for less of each: some share of them rounds worse than the default.
  const bool over_time = model.duty.over_time();
  StaticEquilibrium equilibrium =
      over_time ? StaticEquilibrium(model, kDutyAccuracy) : StaticEquilibrium(model);
  Duty full = model.duty;
  full.load_ramp = full.speed_ramp = 0;
  Series ring_y, ring_z, sunk, ring_tilt, tilt;
  double sunk_at_end = 0;
  for (const Instant& at : instants) {
    const std::vector<double> angle = roller_angles(model, at.angle);
    const RingLoad load = load_at(full, at.time);
    equilibrium.turn_outer(at.rings.outer);
    equilibrium.turn_rings(ring_angles_at(full, at.time));
    const StaticState& rest =
        equilibrium.solve(angle.data(), at.cage_speed, load, RollerMotion::orbiting);
    ++outcome.run.steps;
    if (!rest.converged) {
      outcome.status = Status::failed;
      outcome.reason = "no equilibrium of ring and rollers found at a cage angle of " +
                       std::to_string(at.angle * 180 / pi) +
                       " degrees: the rollers' damping or clearance leaves the ring no place; "
                       "remedy: check contact.race (damping, restitution), load.radial_N, "
                       "bearing.internal_clearance_um and roller.diameter_mm";
      return outcome;
    }
    ring_y.add(rest.ring_y, 1, 1);
    ring_z.add(rest.ring_z, 1, 1);
    sunk_at_end = way_of(load).along(rest.ring_y, rest.ring_z);
    sunk.add(sunk_at_end, 1);
    ring_tilt.add(std::hypot(rest.tilt_y, rest.tilt_z), 1);
    for (int j = 0; j < model.layout.rollers; ++j)
      tilt.add(std::abs(rest.tilt[static_cast<std::size_t>(j)]), 1, 1);
  }
  std::vector<double>& q = outcome.quantities;
  q[quantity_row("ring_displacement_mean_um")] = 1e6 * sunk.mean();
  q[quantity_row("ring_displacement_end_um")] = 1e6 * sunk_at_end;
  q[quantity_row("ring_orbit_p95_um")] = 1e6 * distance_quantile(ring_y, ring_z, 0.95);
  q[quantity_row("ring_tilt_mean_mrad")] = 1e3 * ring_tilt.mean();
  q[quantity_row("roller_tilt_p95_mrad")] = 1e3 * tilt.quantile(0.95);
  outcome.run.cage_revolutions = revolutions_over(instants);
  outcome.reason =
      find_impossible({scene, model, window.settle, window.settle + window.measure, q});
  outcome.status = outcome.reason.empty() ? Status::ok : Status::failed;
  return outcome;
}

}  // namespace cagetol
