#include "mc/run_history.hpp"

#include <cmath>
#include <numbers>

#include "mc/file_write.hpp"
#include "mc/h5.hpp"

namespace cagetol {
namespace {

constexpr double kRpm = 30 / std::numbers::pi;

// Order of the series below.
enum SeriesIndex : std::size_t {
  kRingYUm,
  kRingZUm,
  kCageXUm,
  kCageYUm,
  kCageZUm,
  kCageRpm,
  kGuideForce,
  kRollerSpinRpm,
  kRollerOrbitRpm,
  kRollerSkew,
  kRollerTilt,
  kInnerForce,
  kOuterForce,
  kLeadingForce,
  kTrailingForce,
  kWallForce,
  kFlangeForce,
};

}  // namespace

RunHistory::RunHistory(const Scene& scene)
    : scene_name_(scene.name),
      interval_(scene.history_interval),
      rollers_(static_cast<std::size_t>(scene.bearing.roller_count)),
      series_{
          {"ring_y", "um", "inner ring, y", false, {}},
          {"ring_z", "um", "inner ring, z (the load acts along -z)", false, {}},
          {"cage_x", "um", "cage centre, axial", false, {}},
          {"cage_y", "um", "geometric centre of the cage, y", false, {}},
          {"cage_z", "um", "geometric centre of the cage, z", false, {}},
          {"cage_speed", "rpm", "speed of the cage", false, {}},
          {"guide_force",
           "N",
           "normal force between the cage's lands and the guiding ring",
           false,
           {}},
          {"roller_spin", "rpm", "absolute spin of a roller about its own axis", true, {}},
          {"roller_orbit_speed", "rpm", "speed of a roller about the bearing axis", true, {}},
          {"roller_skew", "mrad", "skew of a roller, a . e_t", true, {}},
          {"roller_tilt", "mrad", "tilt of a roller, a . e_r", true, {}},
          {"inner_force", "N", "normal force on the inner raceway", true, {}},
          {"outer_force", "N", "normal force on the outer raceway", true, {}},
          {"leading_force", "N", "normal force on the pocket's bar ahead of the roller", true, {}},
          {"trailing_force", "N", "normal force on the pocket's bar behind the roller", true, {}},
          {"end_force", "N", "normal force on both end walls of the pocket", true, {}},
          {"flange_force", "N", "normal force on the ring's flanges", true, {}},
      } {}

void RunHistory::record(double t, const double* y, const System& system) {
  if (t < next_time_) return;
  next_time_ = t + interval_;
  time_.push_back(t);
  const StateLayout& l = system.model.layout;
  const Observation& seen = system.seen;
  const double *q = y + l.border_position(0), *v = y + l.border_velocity(0);
  const double c = std::cos(q[kCagePhi]), s = std::sin(q[kCagePhi]);
  add(kRingYUm, 1e6 * q[kRingY]);
  add(kRingZUm, 1e6 * q[kRingZ]);
  add(kCageXUm, 1e6 * q[kCageX]);
  add(kCageYUm, 1e6 * (q[kCageY] - c * system.model.unbalance_y + s * system.model.unbalance_z));
  add(kCageZUm, 1e6 * (q[kCageZ] - s * system.model.unbalance_y - c * system.model.unbalance_z));
  add(kCageRpm, kRpm * v[kCagePhi]);
  add(kGuideForce, seen.land_force[0] + seen.land_force[1]);
  for (int j = 0; j < l.rollers; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const double angle = y[l.position(kAngle, j)];
    const double ay = y[l.position(kAxisY, j)], az = y[l.position(kAxisZ, j)];
    add(kRollerSpinRpm, kRpm * y[l.velocity(kSpin, j)]);
    add(kRollerOrbitRpm, kRpm * y[l.velocity(kOrbitRate, j)]);
    add(kRollerSkew, 1e3 * (std::cos(angle) * az - std::sin(angle) * ay));
    add(kRollerTilt, 1e3 * (std::cos(angle) * ay + std::sin(angle) * az));
    add(kInnerForce, seen.inner_force[k]);
    add(kOuterForce, seen.outer_force[k]);
    add(kLeadingForce, seen.leading_force[k]);
    add(kTrailingForce, seen.trailing_force[k]);
    add(kWallForce, seen.wall_force[k]);
    add(kFlangeForce, seen.flange_force[k]);
  }
}

void RunHistory::write(const std::string& path) const {
  const H5Handle file = make_h5_memory_file();
  write_h5_attribute(file, "schema_version", std::int64_t{1});
  write_h5_attribute(file, "scene", scene_name_);
  write_h5(file, "time", time_, {"s", "time of each state"});
  for (const auto& series : series_)
    write_h5(file, series.name, series.values, {series.unit, series.description},
             series.per_roller ? rollers_ : 0);
  replace_file(path, h5_image(file));
}

}  // namespace cagetol
