#include "src/integration/step_error.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

// Chosen by measurement (tests/STEP_CONTROL.md): the stability suite, and steps saved.
constexpr double kBounceSpeed = 0.1;       ///< unit of error of bouncing, at most [m/s]
constexpr double kBounceLength = 3e-6;     ///< unit of error of a bouncing roller's place [m]
constexpr double kTouchUnits = 0.065;      ///< of skew rate and axial speed in touches
constexpr double kMovedEnergy = 0.02;      ///< that an error may move, in shares of the dissipated
constexpr double kDissipationTime = 1e-3;  ///< over which the dissipation is averaged [s]

/// What of an error's square counts no longer in a unit so many times as large.
Pack spared_in(Pack unit) {
  return 1.0 - 1.0 / (unit * unit);
}

}  // namespace

double StepError::operator()(const System& s, const double* y, const double* error, double h,
                             double tolerance) const {
  const double strict = error_norm(s, error) / tolerance;
  // Bouncing rollers slide on bars, too: no unit coarser than friction's own speed.
  const double unit = std::min(kBounceSpeed, least_static_speed(s.model)) / speed_scale(s.model);
  if (!std::isfinite(strict)) return strict;
  const StateLayout& l = s.model.layout;
  Pack spared{}, added{}, moved{};
  for (int group = 0; group < l.groups; ++group) {
    const RollerGroup& roller = s.model.groups[static_cast<std::size_t>(group)];
    const int j = group * kLanes;
    const auto position = [&](const double* of, RollerPosition slot) {
      return load(of + l.position(slot, j));
    };
    const auto velocity = [&](const double* of, RollerVelocity slot) {
      return load(of + l.velocity(slot, j));
    };
    const auto spare = [&](Pack wrong, Pack per_scale, double larger) {
      const Pack counted = wrong * per_scale;
      spared += spared_in(splat(larger / bounce_share_)) * counted * counted;
    };
    const GroupLinear& turned = s.linear.groups[static_cast<std::size_t>(group)];
    const auto touching = [&](const PackVector& force) { return load(force.data() + j) > 0.0; };
    const Mask pressed = touching(s.seen.inner_force);  // between the races
    const Mask on_flange = touching(s.seen.flange_force) & ~pressed;
    const Mask on_bar =
        (touching(s.seen.leading_force) | touching(s.seen.trailing_force)) & ~pressed;
    const auto add = [&](Pack wrong, Pack per_scale, Pack smaller) {
      const Pack counted = wrong * per_scale;
      added -= spared_in(smaller) * counted * counted;
    };
    const double* rate = s.rate.data();
    const double* per_scale = s.per_scale.data();
    const Pack wrong_radius = position(error, kRadius);
    spare(velocity(error, kRadialSpeed), velocity(per_scale, kRadialSpeed), unit);
    spare(select(pressed, Pack{}, wrong_radius), position(per_scale, kRadius),
          kBounceLength / kLengthScale);
    const Pack wrong_y = velocity(error, kAxisRateY), wrong_z = velocity(error, kAxisRateZ);
    const Pack touch = splat(kTouchUnits), usual = splat(1.0);
    add(turned.cosine * wrong_z - turned.sine * wrong_y, velocity(per_scale, kAxisRateZ),
        select(on_flange | on_bar, touch, usual));
    add(velocity(error, kAxialSpeed), velocity(per_scale, kAxialSpeed),
        select(on_flange, touch, usual));
    const Pack wrong_speed = velocity(error, kRadialSpeed);
    moved +=
        roller.exists * roller.mass *
        abs(velocity(y, kRadialSpeed) * wrong_speed - velocity(rate, kRadialSpeed) * wrong_radius);
    // A dashpot that stops a roller within a step lets errors move little and dissipate much.
    const Pack stops = turned.velocity[kLr][kLr] * roller.inverse_mass * h;
    const Pack squared = stops * stops;
    moved +=
        roller.exists * h * squared / (1.0 + squared) *
        abs(turned.power_velocity[kLr] * wrong_speed + turned.power_position[kLr] * wrong_radius);
  }
  const auto with = [&](Pack more) {
    return std::sqrt(
        std::max(0.0, strict * strict + sum(more) / (tolerance * tolerance * s.components)));
  };
  const double full = with(added);
  const double allowed = kMovedEnergy * dissipation_ * h;
  if (unit <= 1 || !(allowed > 0)) return full;
  const double energy = bounce_share_ * sum(moved) * watched_ / allowed;
  return std::min(full, std::max(with(added - spared), energy));
}

void StepError::advance(const System& s, double h) {
  const double power = s.seen.friction_power + s.seen.damping_power;
  const double share = -std::expm1(-h / kDissipationTime);
  dissipation_ += (power - dissipation_) * share;
  watched_ += (1 - watched_) * share;
}

}  // namespace cagetol
