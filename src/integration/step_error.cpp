#include "src/integration/step_error.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

// Chosen by measurement (tests/ACCURACY.md): the stability suite, and steps saved.
constexpr double kBounceSpeed = 0.1;       ///< unit of error of bouncing, at most [m/s]
constexpr double kBounceLength = 3e-6;     ///< unit of error of a bouncing roller's place [m]
constexpr double kTiltSpeed = 0.02;        ///< unit of error of rocking, at most [m/s]
constexpr double kMovedEnergy = 0.01;      ///< that an error may move, in shares of the dissipated
constexpr double kDissipationTime = 1e-3;  ///< over which the dissipation is averaged [s]

/// What of an error's square counts no longer in a unit so many times as large.
double spared_in(double unit) {
  return 1 - 1 / (unit * unit);
}

Pack magnitude(Pack x) {
  return max(x, -x);
}

}  // namespace

double StepError::operator()(const System& s, const double* y, const double* error, double h,
                             double tolerance) const {
  const double strict = error_norm(s, error) / tolerance;
  // These speeds slide on bars, races and flanges, too: no unit coarser than friction's own speed.
  const double most = s.model.friction.static_speed;
  const double bounce = std::min(kBounceSpeed, most) / kSpeedScale,
               tilting = std::min(kTiltSpeed, most) / kSpeedScale;
  if (tilting <= 1 || !std::isfinite(strict)) return strict;
  const StateLayout& l = s.model.layout;
  Pack spared{}, energy{};
  for (int group = 0; group < l.groups; ++group) {
    const RollerGroup& roller = s.model.groups[static_cast<std::size_t>(group)];
    const int j = group * kLanes;
    const auto position = [&](const double* of, RollerPosition slot) {
      return load(of + l.position(slot, j));
    };
    const auto velocity = [&](const double* of, RollerVelocity slot) {
      return load(of + l.velocity(slot, j));
    };
    const auto spare = [&](Pack wrong, Pack per_scale, double unit) {
      const Pack counted = wrong * per_scale;
      spared += spared_in(unit) * counted * counted;
    };
    const auto move = [&](Pack inertia, Pack speed, Pack acceleration, Pack wrong_speed,
                          Pack wrong_place) {
      energy +=
          roller.exists * inertia * magnitude(speed * wrong_speed - acceleration * wrong_place);
    };
    const double* rate = s.rate.data();
    const double* per_scale = s.per_scale.data();
    const Pack wrong_radius = position(error, kRadius);
    const Pack pressed = load(s.seen.inner_force.data() + j);  // between the races
    spare(velocity(error, kRadialSpeed), velocity(per_scale, kRadialSpeed), bounce);
    spare(select(pressed > 0.0, Pack{}, wrong_radius), position(per_scale, kRadius),
          kBounceLength / kLengthScale);
    move(roller.mass, velocity(y, kRadialSpeed), velocity(rate, kRadialSpeed),
         velocity(error, kRadialSpeed), wrong_radius);
    Pack sine, cosine;
    sine_cosine(position(y, kAngle), sine, cosine);
    const auto tilt = [&](Pack along_y, Pack along_z) { return cosine * along_y + sine * along_z; };
    const Pack wrong_tilt_rate = tilt(velocity(error, kAxisRateY), velocity(error, kAxisRateZ));
    spare(wrong_tilt_rate, velocity(per_scale, kAxisRateY), tilting);
    move(roller.transverse, tilt(velocity(y, kAxisRateY), velocity(y, kAxisRateZ)),
         tilt(velocity(rate, kAxisRateY), velocity(rate, kAxisRateZ)), wrong_tilt_rate,
         tilt(position(error, kAxisY), position(error, kAxisZ)));
  }
  const double coarse = std::sqrt(
      std::max(0.0, strict * strict - sum(spared) / (tolerance * tolerance * s.components)));
  const double moved = sum(energy) / (kMovedEnergy * dissipation_ * h);
  return std::min(strict, std::max(coarse, moved));
}

void StepError::advance(const System& s, double h) {
  const double power = s.seen.friction_power + s.seen.damping_power;
  dissipation_ += (power - dissipation_) * -std::expm1(-h / kDissipationTime);
}

}  // namespace cagetol
