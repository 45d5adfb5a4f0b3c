#include "src/quantities/whirl_recorder.hpp"

#include <numbers>

#include "src/scene/whirl_window.hpp"

namespace cagetol {
namespace {

constexpr double kSamplesPerTurn = 256;  // of the centre's path

}  // namespace

void WhirlRecorder::follow(const WindowTimes& times) {
  if (times.turns >= kWhirlTurns) path_.emplace(times.revolution / kSamplesPerTurn);
  clearance_ = times.whirl_clearance;
}

void WhirlRecorder::record(const ObservedState& at) {
  const double* q = at.q;
  double e[2];
  turned_unbalance(model_, std::cos(q[kCagePhi]), std::sin(q[kCagePhi]), e);
  const double y = q[kCageY] - e[0], z = q[kCageZ] - e[1];
  const double angle = std::atan2(z, y);
  if (!started_) angle_ = angle;
  started_ = true;
  turned_ += std::remainder(angle - angle_, 2 * std::numbers::pi);
  angle_ = angle;
  whirl_.record(at.t, {y, z});
  radius_.add(std::hypot(y, z), at.step);
  axial_.add(q[kCageX], at.step);
  if (path_) path_->record(at.t, {{y, z}, q[kCagePhi]});
  lean_y_.add(q[kCageAxisY], at.step);
  lean_z_.add(q[kCageAxisZ], at.step);
}

void WhirlRecorder::write(const Turning& turning, double duration, QuantityValues& q) const {
  const double clearance = model_.guide_clearance;
  q[quantity_row("whirl_radius_ratio_mean")] = radius_.mean() / clearance;
  q[quantity_row("whirl_radius_ratio_p95")] = radius_.quantile(0.95) / clearance;
  q[quantity_row("whirl_radius_ratio_peak")] = radius_.peak() / clearance;
  const double revolutions = std::max(turning.revolutions(), 1e-12);
  const double frequency = turning.over_time()
                               ? turning.centre_turned() / (2 * std::numbers::pi * revolutions)
                               : turned_ / duration / turning.cage_speed();
  q[quantity_row("whirl_frequency_ratio")] = turning.stands() ? kNoValue : frequency;
  q[quantity_row("whirl_scatter_ratio")] = whirl_.scatter();
  write_path(turning, q);
  const auto shares = whirl_.shares();
  const auto share = [&](OrbitClass of) { return shares[static_cast<std::size_t>(of)]; };
  q[quantity_row("whirl_resting_share")] = share(OrbitClass::resting);
  q[quantity_row("whirl_circling_share")] = share(OrbitClass::circling);
  q[quantity_row("whirl_irregular_share")] = share(OrbitClass::irregular);
  q[quantity_row("cage_axial_std_um")] = 1e6 * axial_.standard_deviation();
  q[quantity_row("cage_tilt_std_mrad")] =
      1e3 * std::hypot(lean_y_.standard_deviation(), lean_z_.standard_deviation());
}

void WhirlRecorder::write_path(const Turning& turning, QuantityValues& q) const {
  const Duty& duty = model_.duty;
  const double load_speed = duty.rotating != 0 && !duty.with_inner ? duty.rotating_speed
                            : duty.load_turns()                    ? duty.speed.inner
                                                                   : 0,
               turns = load_speed != 0 ? kWhirlTurnsBesideLoad : kWhirlTurns;
  const bool known = path_ && clearance_ > 0 && turning.has_ended(turns);
  const CentreMotion motion =
      known ? path_->motion(load_speed) : CentreMotion{kNoValue, kNoValue, kNoValue, kNoValue};
  q[quantity_row("whirl_ratio")] = motion.whirl / clearance_;
  q[quantity_row("whirl_load_line_ratio")] = motion.load_line / clearance_;
  q[quantity_row("whirl_circling_ratio")] = motion.circling / clearance_;
  q[quantity_row("whirl_strongest_speed_ratio")] = motion.strongest;
}

}  // namespace cagetol
