#include "src/model/duty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/contact_laws/step.hpp"

namespace cagetol {
namespace {

double share_of(double ramp, double t) {
  return ramp > 0 ? smooth_step(t / ramp) : 1;
}

/// Integral of STEP from 0 to t/ramp, times the ramp [s].
double ramped_time(double ramp, double t) {
  const double s = std::clamp(t / ramp, 0.0, 1.0);
  return ramp * s * s * s * (1 - s / 2) + std::max(0.0, t - ramp);
}

double ramped_angle(double from, double to, double ramp, double t) {
  if (!(ramp > 0)) return to * t;
  return from * t + (to - from) * ramped_time(ramp, t);
}

void add_force(double force, double angle, RingLoad& load) {
  load.y += force * std::sin(angle);
  load.z -= force * std::cos(angle);
}

RingLoad load_of(const DutyCourse::Row& row) {
  RingLoad load{0, 0, row.moment_y, row.moment_z, row.axial};
  add_force(row.radial, row.direction, load);
  return load;
}

}  // namespace

Way way_of(const RingLoad& load) {
  const double size = std::hypot(load.y, load.z);
  return size > 0 ? Way{load.y / size, load.z / size} : Way{};
}

Duty make_duty(const Operation& o) {
  Duty d;
  d.fixed = {0, 0, o.tilting_moment_y, o.tilting_moment_z, o.axial_load};
  add_force(o.radial_load, o.load_direction, d.fixed);
  d.load_ramp = o.load_ramp;
  d.rotating = o.rotating_load;
  d.with_inner = std::isnan(o.rotating_speed);
  d.rotating_speed = given_or(o.rotating_speed, 0);
  d.phase = o.rotating_phase;
  d.unbalance = o.unbalance;
  d.speed = {o.inner_speed, o.outer_speed};
  d.speed_from = {given_or(o.speed_ramp_from, o.inner_speed),
                  given_or(o.outer_ramp_from, o.outer_speed)};
  const bool ramps = !std::isnan(o.speed_ramp_from) || !std::isnan(o.outer_ramp_from);
  d.speed_ramp = ramps ? o.speed_ramp : 0;
  d.course = DutyCourse(o);
  const auto relative = [](const RingSpeeds& of) { return std::abs(of.inner - of.outer); };
  if (!d.course.empty()) d.speed = {d.course.rows().front().inner, d.course.rows().front().outer};
  for (const DutyCourse::Row& row : d.course.rows())
    if (relative({row.inner, row.outer}) > relative(d.speed)) d.speed = {row.inner, row.outer};
  return d;
}

RingSpeeds ring_speeds_at(const Duty& d, double t) {
  if (d.over_time()) {
    const DutyCourse::Row now = d.course.at(t);
    return {now.inner, now.outer};
  }
  if (!(d.speed_ramp > 0)) return d.speed;
  const double share = share_of(d.speed_ramp, t);
  return {d.speed_from.inner + (d.speed.inner - d.speed_from.inner) * share,
          d.speed_from.outer + (d.speed.outer - d.speed_from.outer) * share};
}

RingSpeeds ring_accelerations_at(const Duty& d, double t) {
  if (!speeds_change(d, t)) return {};
  const double dt = (t + 1e-8) - t;
  const RingSpeeds now = ring_speeds_at(d, t), soon = ring_speeds_at(d, t + dt);
  return {(soon.inner - now.inner) / dt, (soon.outer - now.outer) / dt};
}

RingAngles ring_angles_at(const Duty& d, double t) {
  if (!d.over_time())
    return {ramped_angle(d.speed_from.inner, d.speed.inner, d.speed_ramp, t),
            ramped_angle(d.speed_from.outer, d.speed.outer, d.speed_ramp, t)};
  const DutyCourse::Row now = d.course.at(t);
  return {now.inner_turned, now.outer_turned};
}

bool speeds_change(const Duty& d, double t) {
  return t < d.speed_ramp || (d.course.drives() && t < d.course.end());
}

bool duty_changes(const Duty& d, double t) {
  return d.load_turns() || t < ramps_end(d) || (!d.course.empty() && t < d.course.end());
}

double next_corner(const Duty& d, double t) {
  return d.course.empty() ? std::numeric_limits<double>::infinity() : d.course.next_corner(t);
}

RingLoad load_at(const Duty& d, double t) {
  RingLoad load = d.course.empty() ? d.fixed : load_of(d.course.at(t));
  if (d.load_ramp > 0) {
    const double share = share_of(d.load_ramp, t);
    load = {load.y * share, load.z * share, load.moment_y * share, load.moment_z * share,
            load.axial * share};
  }
  if (!d.load_turns()) return load;
  const double inner = ring_angles_at(d, t).inner, speed = ring_speeds_at(d, t).inner;
  add_force(d.rotating * share_of(d.load_ramp, t),
            d.phase + (d.with_inner ? inner : d.rotating_speed * t), load);
  add_force(d.unbalance * speed * speed, d.phase + inner, load);
  return load;
}

double ramps_end(const Duty& d) {
  return std::max(d.load_ramp, d.speed_ramp);
}

RingLoad heaviest_load(const Duty& d) {
  const double speed = fastest_speeds(d).inner;
  RingLoad load = d.course.empty() ? d.fixed : load_of(d.course.rows().front());
  const auto larger = [](double value, double than) {
    return std::abs(value) > std::abs(than) ? value : than;
  };
  for (const DutyCourse::Row& row : d.course.rows()) {
    const RingLoad other = load_of(row);
    if (std::hypot(other.y, other.z) > std::hypot(load.y, load.z))
      load.y = other.y, load.z = other.z;
    load.axial = larger(other.axial, load.axial);
    load.moment_y = larger(other.moment_y, load.moment_y);
    load.moment_z = larger(other.moment_z, load.moment_z);
  }
  const Way way = way_of(load);
  const double turning = d.rotating + d.unbalance * speed * speed;
  load.y += turning * way.y;
  load.z += turning * way.z;
  return load;
}

double largest_load(const Duty& d) {
  const RingLoad load = heaviest_load(d);
  return std::hypot(load.y, load.z);
}

RingSpeeds fastest_speeds(const Duty& d) {
  if (d.over_time()) {
    RingSpeeds fastest;
    for (const DutyCourse::Row& row : d.course.rows()) {
      fastest.inner = std::max(fastest.inner, std::abs(row.inner));
      fastest.outer = std::max(fastest.outer, std::abs(row.outer));
    }
    return fastest;
  }
  const auto larger = [&](double last, double first) {
    return std::max(std::abs(last), d.speed_ramp > 0 ? std::abs(first) : 0.0);
  };
  return {larger(d.speed.inner, d.speed_from.inner), larger(d.speed.outer, d.speed_from.outer)};
}

}  // namespace cagetol
