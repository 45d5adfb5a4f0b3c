// Power of drive and load, losses by mechanism, and the account of energy.
#pragma once

#include <array>

#include "src/quantities/turning.hpp"

namespace cagetol {

class PowerRecorder {
 public:
  explicit PowerRecorder(const BearingModel& model)
      : model_(model), rate_known_(!model.duty.over_time() && !model.lubricated) {}

  void record(const ObservedState& at);
  /// `duration` of the window [s].
  void write(const Turning& turning, double duration, QuantityValues& q) const;

  /// Relative error of the energy account from the window's beginning [s]:
  ///   |work in - dissipation - change of stored energy| / max(dissipation, stored energy/1000)
  double energy_residual(double begin) const;
  /// The part of it that steps with this tolerance cannot resolve: the energy difference of two
  /// states that differ by the largest error of a step. The error norm is a mean over n components,
  /// so a single component may be sqrt(n) times larger. `carried` by the rollers at rest [N].
  double energy_resolution(double begin, double tolerance, double carried) const;

 private:
  double energy_scale(double begin) const;  ///< reference of energy_residual() [J]

  const BearingModel& model_;
  /// Whether net_power_rate tells how the power changes over a step: not under a duty over time,
  /// whose share of it is left out, nor under oil. There the traction of loaded contacts follows
  /// sliding within 1e-8 m/s, and its rate at one state is that state's own error, much enlarged.
  bool rate_known_;
  HermiteQuadrature net_work_;      ///< where the power's rate is known [J]
  StepSeries net_power_;            ///< where it is not [W]
  StepSeries dissipation_, drive_;  ///< powers [W]
  std::array<StepSeries, kMechanisms> lost_;
  bool started_ = false;
  double first_energy_ = 0, last_energy_ = 0, last_time_ = 0;
};

}  // namespace cagetol
