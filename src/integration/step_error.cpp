#include "src/integration/step_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cagetol {
namespace {

// Chosen by measurement (tests/ACCURACY.md): the stability suite, and steps saved.
constexpr double kBounceSpeed = 0.07;      ///< unit of error of bouncing speeds, at most [m/s]
constexpr double kMovedEnergy = 0.01;      ///< that an error may move, in shares of the dissipated
constexpr double kDissipationTime = 1e-3;  ///< over which the dissipation is averaged [s]

struct Bounce {
  RollerPosition place;
  RollerVelocity speed;
  Pack RollerGroup::*inertia;
};
constexpr std::array<Bounce, 4> kBounces{{{kRadius, kRadialSpeed, &RollerGroup::mass},
                                          {kAxial, kAxialSpeed, &RollerGroup::mass},
                                          {kAxisY, kAxisRateY, &RollerGroup::transverse},
                                          {kAxisZ, kAxisRateZ, &RollerGroup::transverse}}};

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
    for (const Bounce& bounce : kBounces) {
      const int place = l.position(bounce.place, j), speed = l.velocity(bounce.speed, j);
      const Pack e = load(error + speed), counted = e * load(s.per_scale.data() + speed);
      squares += counted * counted;
      energy += roller.exists * (roller.*bounce.inertia) *
                (magnitude(load(y + speed) * e) +
                 magnitude(load(s.rate.data() + speed) * load(error + place)));
    }
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
