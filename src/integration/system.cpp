#include "src/integration/system.hpp"

#include <algorithm>
#include <cmath>

#include "src/integration/step_control.hpp"

namespace cagetol {
namespace {

constexpr double kNever = 1e30;

bool all_finite(const double* x, int n) {
  // A sum of zero times each is not a number exactly if one of them is not finite. By four sums:
  // none waits for the others.
  constexpr int together = 4;
  Pack sums[together] = {};
  int i = 0;
  for (; i + together * kLanes <= n; i += together * kLanes)
    for (int k = 0; k < together; ++k) sums[k] += 0.0 * load(x + i + k * kLanes);
  for (; i < n; i += kLanes) sums[0] += 0.0 * load(x + i);
  return sum((sums[0] + sums[1]) + (sums[2] + sums[3])) == 0;
}

}  // namespace

System::System(const BearingModel& m)
    : model(m),
      size(m.layout.size()),
      components((int{kRollerPositions} + int{kRollerVelocities}) * m.layout.rollers +
                 2 * m.layout.border()),
      scale(error_scales(m)),
      per_scale(scale.size()),
      rate(static_cast<std::size_t>(size)),
      linear(m.layout),
      seen(m) {
  for (std::size_t i = 0; i < scale.size(); ++i) per_scale[i] = 1 / scale[i];
}

bool System::rates(double t, const double* y, double* out) {
  ++counts.rhs;
  evaluate_rates(model, t, y, out);
  return all_finite(out, size);
}

bool System::linearise_at(double t, const double* y) {
  ++counts.rhs;
  ++counts.jacobians;
  linearise(model, t, y, rate.data(), linear, seen);
  return all_finite(rate.data(), size);
}

/// Whether a raceway that is no circle turns.
static bool waviness_turns(const BearingModel& m) {
  const auto wavy = [](const auto& form, double speed, double from) {
    return (speed != 0 || from != 0) && !is_round(form);
  };
  const Duty& d = m.duty;
  return wavy(m.forms.inner, d.speed.inner, d.speed_from.inner) ||
         wavy(m.forms.outer, d.speed.outer, d.speed_from.outer);
}

bool System::driven_by_time(double t) const {
  return duty_changes(model.duty, t) || waviness_turns(model);
}

namespace {

/// Time over which the faster surface changes its speed by 1e-10 m/s [s]. The traction of a thin
/// film under pressure turns over within 1e-8 m/s: a difference over more is no derivative, and
/// Rosenbrock methods without one chatter about rolling in steps a thousand times too short.
double difference_time(const BearingModel& m, double t) {
  constexpr double change = 1e-10, longest = 1e-9, shortest = 1e-13;
  const RingSpeeds rate = ring_accelerations_at(m.duty, t);
  const double surface =
      std::max(std::abs(rate.inner) * m.inner_radius, std::abs(rate.outer) * m.outer_radius);
  const double dt = std::clamp(change / std::max(surface, 1e-9), shortest, longest);
  return std::max((t + dt) - t, std::nextafter(t, t + 1) - t);  // as time resolves it
}

}  // namespace

void System::rates_by_time(double t, const double* y, double* out) {
  const bool speeds = speeds_change(model.duty, t);
  if (speeds || waviness_turns(model)) {
    const double dt = speeds ? difference_time(model, t) : 1e-7;
    rates(t + dt, y, out);
    for (int i = 0; i < size; ++i) out[i] = (out[i] - rate[static_cast<std::size_t>(i)]) / dt;
    return;
  }
  // The load acts on the ring and nowhere else.
  constexpr double dt = 1e-7;
  std::fill(out, out + size, 0.0);
  const RingLoad now = load_at(model.duty, t), soon = load_at(model.duty, t + dt);
  double* ring = out + model.layout.border_velocity(0);
  ring[kRingY] = (soon.y - now.y) / dt / model.ring_mass;
  ring[kRingZ] = (soon.z - now.z) / dt / model.ring_mass;
  if (model.layout.ring_axial > 0)
    ring[model.layout.ring_axial_slot()] = (soon.axial - now.axial) / dt / model.ring_mass;
  if (model.layout.ring_tilt == 0) return;
  double* tilt = ring + model.layout.ring_tilt_slot();
  tilt[0] = (soon.moment_y - now.moment_y) / dt / model.ring_transverse;
  tilt[1] = (soon.moment_z - now.moment_z) / dt / model.ring_transverse;
}

/// Speed of the fastest raceway surface over the duty [m/s].
static double fastest_surface(const BearingModel& m) {
  const RingSpeeds rings = fastest_speeds(m.duty);
  return std::max(rings.inner * m.inner_radius, rings.outer * m.outer_radius);
}

ErrorUnits error_units(const BearingModel& m) {
  const double speed =
      std::max(kStepControl.speed_unit, kStepControl.speed_share * fastest_surface(m));
  // In whole nanometres: rollers that scatter leave it as it is.
  const double nanometres = 1e9 * m.nominal_diameter / kStepControl.lengths_per_diameter;
  return {std::max(std::round(nanometres), 1.0) / 1e9, std::min(speed, minimum_static_speed(m))};
}

double largest_step(const BearingModel& m, const Integration& keys) {
  if (!std::isnan(keys.max_step)) return keys.max_step;
  const double share = roller_interval(m) / kStepControl.steps_per_roller;
  const bool steady = !m.duty.over_time() && ramps_end(m.duty) == 0;
  return steady && std::isfinite(share) ? std::max(kStepControl.largest_step, share)
                                        : kStepControl.largest_step;
}

PackVector error_scales(const BearingModel& m) {
  const StateLayout& l = m.layout;
  PackVector scale(static_cast<std::size_t>(l.size()), kNever);
  const auto set = [&](int slot, double value) { scale[static_cast<std::size_t>(slot)] = value; };
  const auto [length, speed] = error_units(m);
  const double half = m.roller_half_length;
  for (int j = 0; j < l.rollers; ++j) {
    const double lever[kRollerPositions] = {1, m.pitch_radius, 1, half, half};
    for (int slot = 0; slot < kRollerPositions; ++slot) {
      set(l.position(static_cast<RollerPosition>(slot), j), length / lever[slot]);
      set(l.velocity(static_cast<RollerVelocity>(slot), j), speed / lever[slot]);
    }
    set(l.velocity(kSpin, j), speed / (m.nominal_diameter / 2));
  }
  const double lever[kRigidBorder] = {1, 1, 1, 1, 1, m.pitch_radius, m.land_offset, m.land_offset};
  for (int i = 0; i < kRigidBorder; ++i) {
    set(l.border_position(i), length / lever[i]);
    set(l.border_velocity(i), speed / lever[i]);
  }
  if (l.ring_axial > 0) {
    set(l.border_position(l.ring_axial_slot()), length);
    set(l.border_velocity(l.ring_axial_slot()), speed);
  }
  for (int k = 0; k < l.ring_tilt; ++k) {
    set(l.border_position(l.ring_tilt_slot() + k), length / half);
    set(l.border_velocity(l.ring_tilt_slot() + k), speed / half);
  }
  for (int k = 0; k < l.modes; ++k) {
    const double moved = m.flexible.scale[static_cast<std::size_t>(k)];
    set(l.border_position(kModes + k), length / moved);
    set(l.border_velocity(kModes + k), speed / moved);
  }
  return scale;
}

double error_norm(const System& s, const double* error) {
  const double* per_scale = s.per_scale.data();
  Pack sums{};
  for (int i = 0; i < s.size; i += kLanes) {
    const Pack e = load(error + i) * load(per_scale + i);
    sums += e * e;
  }
  return std::sqrt(sum(sums) / s.components);
}

}  // namespace cagetol
