#include "src/quantities/whirl_recorder.hpp"

#include <numbers>

namespace cagetol {

void WhirlRecorder::record(const ObservedState& at) {
  const double *q = at.q, *v = at.v;
  double e[2];
  turned_unbalance(model_, std::cos(q[kCagePhi]), std::sin(q[kCagePhi]), e);
  const double y = q[kCageY] - e[0], z = q[kCageZ] - e[1];
  const double speed = std::hypot(v[kCageY] + v[kCagePhi] * e[1], v[kCageZ] - v[kCagePhi] * e[0]);
  const double angle = std::atan2(z, y);
  if (!started_) angle_ = angle;
  started_ = true;
  turned_ += std::remainder(angle - angle_, 2 * std::numbers::pi);
  angle_ = angle;
  whirl_.record(at.t, {y, z, speed, v[kCagePhi]});
  radius_.add(std::hypot(y, z), at.step);
  speed_.add(speed, at.step);
  axial_.add(q[kCageX], at.step);
  lean_y_.add(q[kCageAxisY], at.step);
  lean_z_.add(q[kCageAxisZ], at.step);
}

void WhirlRecorder::write(const Turning& turning, double duration, QuantityValues& q) const {
  const double clearance = model_.guide_clearance;
  q[quantity_row("whirl_radius_ratio_mean")] = radius_.mean() / clearance;
  q[quantity_row("whirl_radius_ratio_p95")] = radius_.quantile(0.95) / clearance;
  q[quantity_row("whirl_radius_ratio_peak")] = radius_.peak() / clearance;
  q[quantity_row("whirl_speed_deviation_ratio")] = speed_.standard_deviation() / speed_.mean();
  const double revolutions = std::max(turning.revolutions(), 1e-12);
  const double frequency = turning.over_time()
                               ? turning.centre_turned() / (2 * std::numbers::pi * revolutions)
                               : turned_ / duration / turning.cage_speed();
  q[quantity_row("whirl_frequency_ratio")] = turning.stands() ? kNoValue : frequency;
  q[quantity_row("whirl_scatter_ratio")] = whirl_.scatter();
  q[quantity_row("whirl_energy_ratio")] =
      turning.turns() ? model_.cage_mass / model_.cage_polar * whirl_.speed_ratio_squared()
                      : kNoValue;
  const auto shares = whirl_.shares();
  const auto share = [&](OrbitClass of) { return shares[static_cast<std::size_t>(of)]; };
  q[quantity_row("whirl_resting_share")] = share(OrbitClass::resting);
  q[quantity_row("whirl_circling_share")] = share(OrbitClass::circling);
  q[quantity_row("whirl_irregular_share")] = share(OrbitClass::irregular);
  q[quantity_row("cage_axial_std_um")] = 1e6 * axial_.standard_deviation();
  q[quantity_row("cage_tilt_std_mrad")] =
      1e3 * std::hypot(lean_y_.standard_deviation(), lean_z_.standard_deviation());
}

}  // namespace cagetol
