#include "src/quasi_static.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "src/quantities/plausibility.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/quantities/series.hpp"
#include "src/statics/start_state.hpp"
#include "src/statics/static_equilibrium.hpp"
#include "src/window_times.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

// The ring's displacement repeats with the pitch of the rollers and is smooth but where a roller
// enters or leaves the load zone: 8 positions a pitch give its mean to 4e-5 (16: 2e-5), the 95 %
// quantile of its orbit to some per cent, and cost a fiftieth of the motion.
constexpr double kPositionsPerPitch = 8;

constexpr const char* kDefined[] = {"ring_displacement_mean_um", "ring_displacement_end_um",
                                    "ring_orbit_p95_um", "ring_tilt_mean_mrad",
                                    "roller_tilt_p95_mrad"};

/// The cage's angles, equally spaced, up to the end of the window and over a turn at most [rad].
struct Positions {
  long count;
  double end, spacing;
  double time_end, interval;  ///< [s]
  double angle(long k) const { return end - spacing * static_cast<double>(count - 1 - k); }
  double time(long k) const { return time_end - interval * static_cast<double>(count - 1 - k); }
};
Positions positions_in_window(const Scene& scene, const BearingModel& model, double cage_speed) {
  const WindowTimes window = window_times(scene, model);
  const double span = std::min(std::abs(cage_speed) * window.measure, 2 * pi);
  const double pitch = 2 * pi / model.layout.rollers;
  const long count = std::max(1L, std::lround(std::ceil(kPositionsPerPitch * span / pitch)));
  const double end = window.settle + window.measure, every = span / static_cast<double>(count);
  return {count, scene.start.cage_phase + cage_speed * end, std::copysign(every, cage_speed), end,
          cage_speed != 0 ? every / std::abs(cage_speed) : 0};
}

}  // namespace

Outcome quasi_static_outcome(const Scene& scene) {
  Scene dry = scene;
  dry.film.model = FilmModel::none;
  const BearingModel model = make_bearing_model(dry);
  Outcome outcome;
  outcome.quantities.assign(quantity_table().size(), std::numeric_limits<double>::quiet_NaN());
  outcome.run.energy_residual = outcome.run.static_consistency_error =
      std::numeric_limits<double>::quiet_NaN();  // nothing to watch
  const double cage_speed = kinematic_cage_speed(model, model.duty.speed);
  const Positions positions = positions_in_window(scene, model, cage_speed);
  StaticEquilibrium equilibrium(model);
  Duty full = model.duty;
  full.load_ramp = full.speed_ramp = 0;
  Series ring_y, ring_z, sunk, ring_tilt, tilt;
  double sunk_at_end = 0;
  for (long k = 0; k < positions.count; ++k) {
    const std::vector<double> angle = roller_angles(model, positions.angle(k));
    const RingLoad load = load_at(full, positions.time(k));
    equilibrium.turn_rings(ring_angles_at(full, positions.time(k)));
    const StaticState& rest =
        equilibrium.solve(angle.data(), cage_speed, load, RollerMotion::orbiting);
    ++outcome.run.steps;
    if (!rest.converged) {
      outcome.status = Status::failed;
      outcome.reason = "no equilibrium of ring and rollers found at a cage angle of " +
                       std::to_string(positions.angle(k) * 180 / pi) +
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
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const double values[] = {1e6 * sunk.mean(), 1e6 * sunk_at_end,
                           1e6 * distance_quantile(ring_y, ring_z, 0.95),
                           model.planar ? none : 1e3 * ring_tilt.mean(),
                           model.planar ? none : 1e3 * tilt.quantile(0.95)};
  static_assert(std::size(values) == std::size(kDefined));
  for (std::size_t k = 0; k < std::size(kDefined); ++k)
    outcome.quantities[static_cast<std::size_t>(quantity_index(kDefined[k]))] = values[k];
  outcome.run.cage_revolutions =
      std::abs(positions.spacing) * static_cast<double>(positions.count) / (2 * pi);
  const WindowTimes window = window_times(scene, model);
  const PlausibleReach reach(dry, model,
                             {.begin = window.settle,
                              .end = window.settle + window.measure,
                              .revolutions = outcome.run.cage_revolutions,
                              .steps = outcome.run.steps,
                              .quasi_static = true});
  outcome.reason = find_implausible(reach, outcome.quantities);
  outcome.status = outcome.reason.empty() ? Status::ok : Status::failed;
  return outcome;
}

bool is_quasi_static_quantity(const std::string& key) {
  return std::find(std::begin(kDefined), std::end(kDefined), key) != std::end(kDefined);
}

}  // namespace cagetol
