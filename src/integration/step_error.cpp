#include "src/integration/step_error.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

// Chosen by measurement (tests/ACCURACY.md): the stability suite, and steps saved.
constexpr double kBounceSpeed = 0.07;      ///< unit of error of bouncing speeds, at most [m/s]
constexpr double kMovedEnergy = 0.01;      ///< that an error may move, in shares of the dissipated
constexpr double kDissipationTime = 1e-3;  ///< over which the dissipation is averaged [s]

Pack magnitude(Pack x) {
  return max(x, -x);
}

}  // namespace

double StepError::operator()(const System& s, const double* y, const double* error, double h,
                             double tolerance) const {
  const double strict = error_norm(s, error) / tolerance;
  // These speeds slide on bars, races and flanges, too: no unit coarser than friction's own speed.
  const double unit = std::min(kBounceSpeed, s.model.friction.static_speed) / kSpeedScale;
  if (unit <= 1 || !std::isfinite(strict)) return strict;
  const StateLayout& l = s.model.layout;
  Pack squares{}, energy{};
  for (int group = 0; group < l.groups; ++group) {
    const RollerGroup& roller = s.model.groups[static_cast<std::size_t>(group)];
    const int j = group * kLanes;
    const auto position = [&](const double* of, RollerPosition slot) {
      return load(of + l.position(slot, j));
    };
    const auto velocity = [&](const double* of, RollerVelocity slot) {
      return load(of + l.velocity(slot, j));
    };
    const auto count = [&](Pack inertia, Pack speed, Pack acceleration, Pack wrong_speed,
                           Pack wrong_place, RollerVelocity scale) {
      const Pack counted = wrong_speed * velocity(s.per_scale.data(), scale);
      squares += counted * counted;
      energy += roller.exists * inertia *
                (magnitude(speed * wrong_speed) + magnitude(acceleration * wrong_place));
    };
    const double* rate = s.rate.data();
    count(roller.mass, velocity(y, kRadialSpeed), velocity(rate, kRadialSpeed),
          velocity(error, kRadialSpeed), position(error, kRadius), kRadialSpeed);
    Pack sine, cosine;
    sine_cosine(position(y, kAngle), sine, cosine);
    const auto tilt = [&](Pack along_y, Pack along_z) { return cosine * along_y + sine * along_z; };
    count(roller.transverse, tilt(velocity(y, kAxisRateY), velocity(y, kAxisRateZ)),
          tilt(velocity(rate, kAxisRateY), velocity(rate, kAxisRateZ)),
          tilt(velocity(error, kAxisRateY), velocity(error, kAxisRateZ)),
          tilt(position(error, kAxisY), position(error, kAxisZ)), kAxisRateY);
  }
  const double spared = sum(squares) * (1 - 1 / (unit * unit)) / (tolerance * tolerance);
  const double coarse = std::sqrt(std::max(0.0, strict * strict - spared / s.components));
  const double moved = sum(energy) / (kMovedEnergy * dissipation_ * h);
  return std::min(strict, std::max(coarse, moved));
}

void StepError::advance(const System& s, double h) {
  const double power = s.seen.friction_power + s.seen.damping_power;
  dissipation_ += (power - dissipation_) * -std::expm1(-h / kDissipationTime);
}

}  // namespace cagetol
