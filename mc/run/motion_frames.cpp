#include "mc/run/motion_frames.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mc/host/json_number.hpp"
#include "src/quantities/window_times.hpp"

namespace cagetol {
namespace {

constexpr double kFramesPerRevolution = 180;
constexpr double kTurn = 2 * std::numbers::pi;

/// A number with so many digits as a picture shows.
nlohmann::ordered_json drawn(double value, int digits = 4) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

double interval_of(const Scene& scene, const BearingModel& model) {
  const WindowTimes times = window_times(scene, model);
  const double run = times.settle + times.measure;
  if (!std::isfinite(times.revolution)) return run / MotionFrames::kMost;
  return std::min(times.revolution / kFramesPerRevolution, run / 20);
}

}  // namespace

void MotionFrames::begin(const Instant& at) {
  const BearingModel& model = at.system.model;
  frames_.clear();
  next_time_ = 0;
  interval_ = interval_of(scene_, model);
  pitch_radius_ = model.pitch_radius;
  pocket_angle_.clear();
  nlohmann::ordered_json radius, clearance, angle;
  const auto count = static_cast<std::size_t>(model.layout.rollers);
  for (std::size_t j = 0; j < count; ++j) {
    const RollerGroup& group = model.groups[j / kLanes];
    const auto lane = static_cast<int>(j % kLanes);
    pocket_angle_.push_back(std::atan2(group.pocket_sin[lane], group.pocket_cos[lane]));
    radius.push_back(drawn(1e3 * group.radius[lane], 6));
    clearance.push_back(drawn(2e6 * (group.half_width[lane] - group.radius[lane])));
    angle.push_back(drawn(pocket_angle_.back() * 360 / kTurn, 6));
  }
  geometry_ = {{"rollers", count},
               {"inner_race_radius_mm", drawn(1e3 * model.inner_radius, 6)},
               {"outer_race_radius_mm", drawn(1e3 * model.outer_radius, 6)},
               {"pitch_radius_mm", drawn(1e3 * model.pitch_radius, 6)},
               {"roller_radius_mm", radius},
               {"pocket_clearance_um", clearance},
               {"pocket_angle_deg", angle},
               {"cage_inner_radius_mm", drawn(500 * scene_.cage.inner_diameter, 6)},
               {"cage_outer_radius_mm", drawn(500 * scene_.cage.outer_diameter, 6)},
               {"guide_clearance_um", drawn(1e6 * model.guide_clearance)}};
}

void MotionFrames::record(const Instant& at) {
  if (frames_.empty() || at.t < frames_.back().time) begin(at);
  if (at.t < next_time_) return;
  next_time_ = at.t + interval_;
  const BearingModel& model = at.system.model;
  const double* border = at.y + model.layout.border_position(0);
  const double phi = border[kCagePhi], c = std::cos(phi), s = std::sin(phi);
  Frame frame{.time = at.t,
              .cage_y = border[kCageY] - (c * model.unbalance_y - s * model.unbalance_z),
              .cage_z = border[kCageZ] - (s * model.unbalance_y + c * model.unbalance_z),
              .cage_angle = phi,
              .inner_angle = ring_angles_at(model.duty, at.t).inner,
              .stress = at.stress ? at.stress
                                        ->largest(border + kModes, at.system.seen.bar_force,
                                                  at.system.seen.centrifugal_spin)
                                        .stress
                                  : std::nan(""),
              .place = {},
              .race_force = {},
              .leading_force = {},
              .trailing_force = {}};
  const Observation& seen = at.system.seen;
  for (std::size_t j = 0; j < pocket_angle_.size(); ++j) {
    const double angle = at.y[model.layout.position(kAngle, static_cast<int>(j))];
    frame.place.push_back(pitch_radius_ * std::remainder(angle - phi - pocket_angle_[j], kTurn));
    frame.race_force.push_back(std::max(seen.inner_force[j], seen.outer_force[j]));
    frame.leading_force.push_back(seen.leading_force[j]);
    frame.trailing_force.push_back(seen.trailing_force[j]);
  }
  frames_.push_back(std::move(frame));
  if (frames_.size() > kMost) frames_.pop_front();
}

nlohmann::ordered_json MotionFrames::json() const {
  if (frames_.empty()) return nullptr;
  nlohmann::ordered_json json{{"scene", scene_.name}, {"geometry", geometry_}};
  const auto column = [&](const char* name, auto value) {
    for (const Frame& frame : frames_) json[name].push_back(value(frame));
  };
  const auto degrees = [](double angle) { return drawn(std::fmod(angle, kTurn) * 360 / kTurn, 6); };
  column("time_ms", [](const Frame& f) { return drawn(1e3 * f.time, 7); });
  column("cage_y_um", [](const Frame& f) { return drawn(1e6 * f.cage_y); });
  column("cage_z_um", [](const Frame& f) { return drawn(1e6 * f.cage_z); });
  column("cage_angle_deg", [&](const Frame& f) { return degrees(f.cage_angle); });
  column("inner_angle_deg", [&](const Frame& f) { return degrees(f.inner_angle); });
  if (std::isfinite(frames_.front().stress))
    column("cage_stress_MPa", [](const Frame& f) { return drawn(1e-6 * f.stress); });
  const auto of_rollers = [&](const char* name, std::vector<double> Frame::*values, double unit) {
    for (const Frame& frame : frames_)
      for (const double value : frame.*values) json[name].push_back(drawn(value / unit, 3));
  };
  of_rollers("place_um", &Frame::place, 1e-6);
  of_rollers("race_force_N", &Frame::race_force, 1);
  of_rollers("leading_force_N", &Frame::leading_force, 1);
  of_rollers("trailing_force_N", &Frame::trailing_force, 1);
  return json;
}

}  // namespace cagetol
