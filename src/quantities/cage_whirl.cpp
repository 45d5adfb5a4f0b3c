#include "src/quantities/cage_whirl.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace cagetol {

void CageWhirl::Orbit::add(double step, const Seen& from, const Seen& to) {
  const double half = step / 2;
  const double from_square = from.y * from.y + from.z * from.z,
               to_square = to.y * to.y + to.z * to.z;
  duration += step;
  y += half * (from.y + to.y);
  z += half * (from.z + to.z);
  square += half * (from_square + to_square);
  radius += half * (std::sqrt(from_square) + std::sqrt(to_square));
  turned +=
      std::remainder(std::atan2(to.z, to.y) - std::atan2(from.z, from.y), 2 * std::numbers::pi);
}

double CageWhirl::Orbit::scatter() const {
  const double mean_y = y / duration, mean_z = z / duration;
  return std::sqrt(std::max(square / duration - mean_y * mean_y - mean_z * mean_z, 0.0));
}

double CageWhirl::Orbit::radius_scatter() const {
  const double mean = radius / duration;
  return std::sqrt(std::max(square / duration - mean * mean, 0.0)) / mean;
}

void CageWhirl::record(double t, const Seen& seen) {
  if (started_) {
    const double step = t - time_;
    all_.add(step, last_, seen);
    revolution_.add(step, last_, seen);
  }
  started_ = true;
  time_ = t;
  last_ = seen;
}

OrbitClass CageWhirl::orbit_class() const {
  if (revolution_.scatter() < kRestingScatter * clearance_) return OrbitClass::resting;
  const bool round = std::abs(revolution_.turned) > 2 * std::numbers::pi * kCirclingTurns;
  return round && revolution_.radius_scatter() < kCirclingScatter ? OrbitClass::circling
                                                                  : OrbitClass::irregular;
}

void CageWhirl::end_revolution() {
  if (revolution_.duration == 0) return;
  ++revolutions_[static_cast<std::size_t>(orbit_class())];
  revolution_ = {};
}

std::array<double, kOrbitClasses> CageWhirl::shares() const {
  double all = 0;
  for (const long count : revolutions_) all += static_cast<double>(count);
  // A centre that rocks to and fro goes some way round within a revolution, and comes back.
  const bool winds = std::abs(all_.turned) > 2 * std::numbers::pi;
  const auto circling = static_cast<std::size_t>(OrbitClass::circling),
             irregular = static_cast<std::size_t>(OrbitClass::irregular);
  std::array<double, kOrbitClasses> shares{};
  for (std::size_t k = 0; k < shares.size(); ++k)
    shares[k] = all > 0 ? static_cast<double>(revolutions_[k]) / all
                        : std::numeric_limits<double>::quiet_NaN();
  if (!winds) shares[irregular] += std::exchange(shares[circling], 0 * shares[circling]);
  return shares;
}

}  // namespace cagetol
