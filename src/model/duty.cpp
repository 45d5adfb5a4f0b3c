#include "src/model/duty.hpp"

#include <algorithm>
#include <cmath>

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

/// Angle of a ring since t = 0 [rad].
double turned(const Duty& d, double RingSpeeds::*ring, double t) {
  const double from = d.speed_from.*ring, to = d.speed.*ring;
  if (!(d.speed_ramp > 0)) return to * t;
  return from * t + (to - from) * ramped_time(d.speed_ramp, t);
}

void add_force(double force, double angle, RingLoad& load) {
  load.y += force * std::sin(angle);
  load.z -= force * std::cos(angle);
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
  return d;
}

RingSpeeds ring_speeds_at(const Duty& d, double t) {
  if (!(d.speed_ramp > 0)) return d.speed;
  const double share = share_of(d.speed_ramp, t);
  return {d.speed_from.inner + (d.speed.inner - d.speed_from.inner) * share,
          d.speed_from.outer + (d.speed.outer - d.speed_from.outer) * share};
}

RingAngles ring_angles_at(const Duty& d, double t) {
  return {turned(d, &RingSpeeds::inner, t), turned(d, &RingSpeeds::outer, t)};
}

RingLoad load_at(const Duty& d, double t) {
  RingLoad load = d.fixed;
  if (d.load_ramp > 0) {
    const double share = share_of(d.load_ramp, t);
    load = {load.y * share, load.z * share, load.moment_y * share, load.moment_z * share,
            load.axial * share};
  }
  if (!d.load_turns()) return load;
  const double inner = turned(d, &RingSpeeds::inner, t), speed = ring_speeds_at(d, t).inner;
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
  const Way way = way_of(d.fixed);
  const double turning = d.rotating + d.unbalance * speed * speed;
  RingLoad load = d.fixed;
  load.y += turning * way.y;
  load.z += turning * way.z;
  return load;
}

double largest_load(const Duty& d) {
  const RingLoad load = heaviest_load(d);
  return std::hypot(load.y, load.z);
}

RingSpeeds fastest_speeds(const Duty& d) {
  const auto larger = [&](double last, double first) {
    return std::max(std::abs(last), d.speed_ramp > 0 ? std::abs(first) : 0.0);
  };
  return {larger(d.speed.inner, d.speed_from.inner), larger(d.speed.outer, d.speed_from.outer)};
}

}  // namespace cagetol
