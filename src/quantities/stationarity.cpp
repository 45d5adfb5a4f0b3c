#include "src/quantities/stationarity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cagetol {
namespace {

constexpr double kBlocks = kDriftBlocks;

/// From which multiple of its scatter a drift is more than chance: by measurement
/// (src/DECISIONS.md, Watches).
constexpr double kChance = 5;

std::string number(double x) {
  return fmt::format("{:.3g}", x);
}
std::string percent(double share) {
  return number(100 * share) + " %";
}

}  // namespace

bool Drift::exceeds(double most) const {
  return std::abs(value) > std::max(most, kChance * scatter);
}

Drift block_drift(const std::array<double, kDriftBlocks>& means) {
  double slope = 0, weight = 0;
  for (std::size_t i = 0; i < kDriftBlocks; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / kBlocks - 0.5;
    slope += place * means[i];
    weight += place * place;
  }
  std::array<double, kDriftBlocks - 1> changes;
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i] = std::abs(means[i + 1] - means[i]);
  auto* const middle = changes.data() + changes.size() / 2;
  std::nth_element(changes.data(), middle, changes.data() + changes.size());
  // The median of the magnitude of a difference of two normal values is 0.9539 standard deviations.
  return {slope / weight, *middle / 0.9539 / std::sqrt(weight)};
}

void Stationarity::record(double t, const Seen& now) {
  // The chord between both states, cut where a part ends.
  for (double from = time_; started_ && from < t;) {
    auto index = static_cast<std::size_t>(std::max((from - begin_) / part_, 0.0));
    double to = begin_ + static_cast<double>(index + 1) * part_;
    // Rounding may put the end of a part into it.
    if (to <= from) to = begin_ + static_cast<double>(++index + 1) * part_;
    to = std::min(to, t);
    if (parts_.size() <= index) parts_.resize(index + 1);
    const double middle = ((from + to) / 2 - time_) / (t - time_);
    for (const auto of : {&Seen::cage_speed, &Seen::energy, &Seen::drive, &Seen::loss})
      parts_[index].*of += (to - from) * (last_.*of + middle * (now.*of - last_.*of));
    from = to;
  }
  started_ = true;
  time_ = t;
  last_ = now;
}

Stationarity::Means Stationarity::means(double Seen::*of) const {
  // Parts lie in the blocks by their share; the last one reaches to the end of the window.
  Means values{};
  const double block = length() / kBlocks;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const double from = part_ * static_cast<double>(p), to = std::min(from + part_, length());
    for (std::size_t i = 0; i < kDriftBlocks; ++i) {
      const double start = block * static_cast<double>(i),
                   inside = std::min(to, start + block) - std::max(from, start);
      if (inside > 0) values[i] += parts_[p].*of * inside / (to - from) / block;
    }
  }
  return values;
}

Drift Stationarity::speed_drift() const {
  return block_drift(means(&Seen::cage_speed));
}

Drift Stationarity::energy_drift() const {
  return block_drift(means(&Seen::energy));
}

Stationarity::Seen Stationarity::mean() const {
  Seen all;
  for (const auto of : {&Seen::cage_speed, &Seen::energy, &Seen::drive, &Seen::loss}) {
    const Means blocks = means(of);
    all.*of = std::accumulate(blocks.begin(), blocks.end(), 0.0) / kBlocks;
  }
  return all;
}

std::string Stationarity::find_drift(const DriftBounds& bounds) const {
  const Seen all = mean();
  const Drift speed = speed_drift(), energy = energy_drift();
  const double kinematic = std::abs(bounds.kinematic_speed);
  if (speed.exceeds(bounds.cage_drift_max * kinematic))
    return "the mean speed of the cage changes by " +
           percent(speed.value / bounds.kinematic_speed) +
           " of the kinematic speed over the window, more than " + percent(bounds.cage_drift_max) +
           " and than chance";
  // Energy goes with the square of speed.
  const double share = 2 * bounds.cage_drift_max * kinematic / std::abs(all.cage_speed);
  if (energy.exceeds(share * all.energy))
    return "the energy of motion changes by " + percent(energy.value / all.energy) +
           " over the window, more than " + percent(share) + " and than chance";
  const double lost = std::abs(all.loss) * length();
  if (energy.exceeds(bounds.power_surplus_max * lost))
    return "drive and load give " + number(all.drive) + " W, " + number(all.loss) +
           " W are dissipated: the energy of motion changes by " + percent(energy.value / lost) +
           " of that, more than " + percent(bounds.power_surplus_max) + " and than chance";
  return {};
}

}  // namespace cagetol
