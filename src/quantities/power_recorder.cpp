#include "src/quantities/power_recorder.hpp"

#include <algorithm>

#include "src/integration/step_control.hpp"

namespace cagetol {
namespace {

constexpr double kEnergyFloor = 1e-3;        // of the stored energy: runs that hardly dissipate
constexpr double kResolvedTolerance = 1e-3;  // the default's: of the energy account, at most

}  // namespace

void PowerRecorder::record(const ObservedState& at) {
  const Observation& seen = at.seen;
  last_energy_ = at.moving + seen.elastic_energy;
  if (!started_) first_energy_ = last_energy_;
  started_ = true;
  last_time_ = at.t;
  const double net = seen.drive_power + seen.load_power - seen.friction_power - seen.damping_power;
  if (rate_known_)
    net_work_.add(at.t, net, seen.net_power_rate);
  else
    net_power_.add(net, at.step);
  drive_.add(seen.drive_power, at.step);
  dissipation_.add(seen.friction_power + seen.damping_power, at.step);
  for (std::size_t k = 0; k < kMechanisms; ++k) lost_[k].add(seen.lost[k], at.step);
}

double PowerRecorder::energy_scale(double begin) const {
  const double lost = dissipation_.mean() * (last_time_ - begin);
  return std::max(std::abs(lost), kEnergyFloor * std::abs(first_energy_));
}

double PowerRecorder::energy_residual(double begin) const {
  const double net_work = rate_known_ ? net_work_.integral() : net_power_.sums().integral();
  return std::abs(net_work - (last_energy_ - first_energy_)) / energy_scale(begin);
}

double PowerRecorder::energy_resolution(double begin, double tolerance, double carried) const {
  const StateLayout& l = model_.layout;
  double mass = model_.ring_mass + model_.cage_mass;
  for (const RollerGroup& g : model_.groups) mass += sum(g.exists * g.mass);
  const double force = std::max(largest_load(model_.duty), carried);
  // Momentum is at most the root of twice mass times energy.
  const double energy = std::max(std::abs(first_energy_), std::abs(last_energy_));
  const ErrorUnits unit = error_units(model_);
  const double by_scale = force * unit.length + std::sqrt(2 * mass * energy) * unit.speed;
  const double components =
      (int{kRollerPositions} + int{kRollerVelocities}) * l.rollers + 2 * l.border();
  // A tolerance looser than the default's is what the watch is there to find.
  return std::min(tolerance, kResolvedTolerance) * std::sqrt(components) * by_scale /
         energy_scale(begin);
}

void PowerRecorder::write(const Turning& turning, double duration, QuantityValues& q) const {
  const auto lost = [&](Mechanism of) { return lost_[of].mean(); };
  const double per_turn =
      turning.turns() ? duration / std::max(turning.revolutions(), 1e-12) : kNoValue;
  q[quantity_row("pocket_friction_work_J")] =
      lost(kPocketFriction) * per_turn / model_.layout.rollers;
  q[quantity_row("power_loss_W")] = dissipation_.mean();
  q[quantity_row("power_race_sliding_W")] = lost(kRaceSliding);
  q[quantity_row("power_rolling_W")] = lost(kRollingResistance);
  q[quantity_row("power_pocket_W")] = lost(kPocketFriction);
  q[quantity_row("power_end_W")] = lost(kEndFriction);
  q[quantity_row("power_flange_W")] = lost(kFlangeFriction);
  q[quantity_row("power_land_W")] = lost(kLandFriction);
  q[quantity_row("power_churning_W")] = lost(kChurning);
  q[quantity_row("power_squeeze_W")] = lost(kSqueeze);
  q[quantity_row("power_damping_W")] = lost(kDamping);
  q[quantity_row("power_film_W")] = lost(kFilm);
  const HeatAccount& heat = model_.heat;
  const double warmer =
      heat.on ? (dissipation_.mean() - heat.power) / heat.slope : kNoValue;  // [K]
  q[quantity_row("operating_temperature_C")] = heat.found + warmer;
  q[quantity_row("heat_shed_W")] = heat.power + heat.shed_slope * warmer;
  const double apart = turning.between_rings();
  q[quantity_row("friction_torque_Nmm")] = apart != 0 ? 1e3 * drive_.mean() / apart : 0;
}

}  // namespace cagetol
