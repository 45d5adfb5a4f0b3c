#include "src/quantities/convergence.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

constexpr double kLeastSlip = 1e-3;          // a slip below is none
constexpr double kLeastDisplacement = 1e-6;  // [m]

}  // namespace

const std::array<WatchedQuantity, kWatchedMeans>& watched_quantities() {
  static const std::array<WatchedQuantity, kWatchedMeans> watched = {{
      {"cage_slip_ratio", false, kLeastSlip},
      {"orbit_slip_ratio", false, kLeastSlip},
      {"race_sliding_speed_rms", true, 0},
      {"pocket_force_rms_N", true, 0},
      {"guide_force_rms_N", true, 0},
      {"ring_displacement_mean_um", false, kLeastDisplacement},
      {"friction_torque_Nmm", false, 0},
      {"cage_stress_rms_MPa", true, 0},
  }};
  return watched;
}

void Convergence::add(const Integrals& since_begin) {
  ends_.push_back(since_begin);
}

double Convergence::share(std::size_t of) const {
  const auto count = static_cast<double>(ends_.size());
  const MeanIntegral& all = ends_.back()[of];
  if (all.weight == 0 || all.value == 0) return 0;
  const double mean = all.value / all.weight;
  // Revolutions weigh what they hold: a ratio of sums, and its residuals.
  double squares = 0;
  MeanIntegral before;
  for (const Integrals& end : ends_) {
    const double residual = end[of].value - before.value - mean * (end[of].weight - before.weight);
    squares += residual * residual;
    before = end[of];
  }
  const double error = std::sqrt(squares * count / (count - 1)) / std::abs(all.weight);
  const WatchedQuantity& quantity = watched_quantities()[of];
  return gsl_cdf_tdist_Pinv(0.975, count - 1) * error / std::max(std::abs(mean), quantity.floor) /
         (quantity.root ? 2 : 1);
}

MeanShare Convergence::worst() const {
  MeanShare worst;
  if (ends_.size() < 2) return worst;
  worst.share = 0;
  for (std::size_t k = 0; k < kWatchedMeans; ++k)
    if (const double s = share(k); !(s <= worst.share)) worst = {s, watched_quantities()[k].key};
  return worst;
}

}  // namespace cagetol
