#include "src/quantities/ring_recorder.hpp"

#include <algorithm>
#include <numeric>

#include "src/integration/step_control.hpp"

namespace cagetol {
namespace {

constexpr int kStaticsInstants = 64;
constexpr int kDutyInstants = 256;         // likewise under a duty over time
constexpr double kStaticsAccuracy = 1e-6;  // of the balance, over the load

}  // namespace

RingRecorder::RingRecorder(const BearingModel& model, double begin, double end)
    : model_(model),
      over_time_(model.duty.over_time()),
      begin_(begin),
      end_(end),
      statics_(model, kStaticsAccuracy),
      angles_(static_cast<std::size_t>(model.layout.padded())),
      next_comparison_(begin),
      comparison_interval_((end - begin) / (over_time_ ? kDutyInstants : kStaticsInstants)) {}

void RingRecorder::record(const ObservedState& at) {
  const StateLayout& l = model_.layout;
  const double *q = at.q, *v = at.v, *dv = at.dv;
  if (!started_) std::copy(v + kRingY, v + kRingZ + 1, first_speed_);
  started_ = true;
  std::copy(v + kRingY, v + kRingZ + 1, last_speed_);
  last_time_ = at.t;
  if (over_time_) imposed_.add(std::hypot(at.imposed.y, at.imposed.z), at.step);
  y_.add(q[kRingY], at.step);
  z_.add(q[kRingZ], at.step);
  acceleration_.add({dv[kRingY], dv[kRingZ]}, {v[kRingY], v[kRingZ]}, {q[kRingY], q[kRingZ]},
                    at.step);
  const Way down = way_of(at.imposed);
  end_displacement_ = down.along(q[kRingY], q[kRingZ]);
  along_load_.add(end_displacement_, at.step);
  elastic_.add(-down.along(at.seen.ring_elastic_y, at.seen.ring_elastic_z), at.step);
  if (l.ring_tilt > 0) {
    const double tilt_y = q[l.ring_tilt_slot()], tilt_z = q[l.ring_tilt_slot() + 1];
    tilt_.add(std::hypot(tilt_y, tilt_z), at.step);
    tilt_y_.add(tilt_y, at.step);
    tilt_z_.add(tilt_z, at.step);
  }
  compare_with_statics(at);
}

void RingRecorder::compare_with_statics(const ObservedState& at) {
  if (at.t < next_comparison_) return;
  while (next_comparison_ <= at.t) {
    const double next = next_comparison_ + comparison_interval_;
    next_comparison_ = next > next_comparison_ ? next : std::numeric_limits<double>::infinity();
  }
  const StateLayout& l = model_.layout;
  const double* angles = at.y + l.position(kAngle, 0);
  std::copy(angles, angles + l.padded(), angles_.begin());
  if (over_time_) statics_.turn_outer(at.rings.outer);
  if (model_.lubricated) statics_.spin(at.y + l.velocity(kSpin, 0), at.rings);
  statics_.turn_rings(ring_angles_at(model_.duty, at.t));
  const StaticState& rest = statics_.solve(angles_.data(), at.v[kCagePhi],
                                           load_at(model_.duty, at.t), RollerMotion::orbiting);
  ++positions_;
  if (!rest.converged) {
    ++positions_missed_;
    return;
  }
  const Way down = way_of(at.imposed);
  displacement_.add(down.along(at.q[kRingY], at.q[kRingZ]), 1);
  rest_displacement_.add(down.along(rest.ring_y, rest.ring_z), 1);
  rest_elastic_.add(-down.along(rest.ring_elastic[0], rest.ring_elastic[1]), 1);
  rest_carried_.add(
      std::accumulate(rest.inner_force.begin(), rest.inner_force.begin() + l.rollers, 0.0) /
          l.rollers,
      1);
}

double RingRecorder::rollers_couple(const RingLoad& load) const {
  if (model_.layout.ring_tilt == 0) return 0;
  const double k = model_.tilt_stiffness;
  return std::hypot(load.moment_y - k * (tilt_y_.mean() - model_.misalignment_y),
                    load.moment_z - k * (tilt_z_.mean() - model_.misalignment_z)) /
         model_.roller_half_length;
}

double RingRecorder::light_force(double cage_speed) const {
  return std::max(1.0,
                  model_.groups.front().mass[0] * model_.pitch_radius * cage_speed * cage_speed);
}

double RingRecorder::mean_imposed() const {
  if (over_time_) return imposed_.mean();
  const RingLoad load = ring_force_at(model_, end_);
  return std::hypot(load.y, load.z);
}

double RingRecorder::reference_force(double cage_speed) const {
  // Rollers that are pressed without a load rub: statics leaves that out.
  return std::max({mean_imposed(), light_force(cage_speed),
                   rollers_couple(ring_force_at(model_, end_)), carried_at_rest()});
}

double RingRecorder::consistency_resolution(double cage_speed, double guide) const {
  const double momentum = model_.ring_mass * std::hypot(last_speed_[0] - first_speed_[0],
                                                        last_speed_[1] - first_speed_[1]);
  const double cage = model_.guidance == Guidance::outer ? 0 : guide;
  return (momentum / (last_time_ - begin_) + cage) / reference_force(cage_speed);
}

double RingRecorder::consistency_error(double cage_speed) const {
  const double weight = mean_imposed();
  const double expected_force = rest_elastic_.empty() ? weight : rest_elastic_.mean();
  const double force = std::abs(elastic_.mean() - expected_force) / reference_force(cage_speed);
  // Below the centrifugal force of one roller the ring bounces within its clearance: its mean place
  // says nothing.
  if (displacement_.empty() || weight < light_force(cage_speed)) return force;
  const double expected = rest_displacement_.mean();
  return std::max(force, std::abs(displacement_.mean() - expected) /
                             std::max(std::abs(expected), error_units(model_).length));
}

void RingRecorder::write(QuantityValues& q) const {
  q[quantity_row("ring_displacement_mean_um")] = 1e6 * along_load_.mean();
  q[quantity_row("ring_displacement_end_um")] = 1e6 * end_displacement_;
  q[quantity_row("ring_orbit_p95_um")] = 1e6 * distance_quantile(y_, z_, 0.95);
  q[quantity_row("ring_acceleration_rms_m_s2")] = acceleration_.rms();
  q[quantity_row("ring_acceleration_peak_m_s2")] = acceleration_.peak();
  const bool tilts = model_.layout.ring_tilt > 0;
  const double held = std::hypot(model_.misalignment_y, model_.misalignment_z);
  q[quantity_row("ring_tilt_mean_mrad")] = 1e3 * (tilts ? tilt_.mean() : held);
  q[quantity_row("ring_tilt_std_mrad")] =
      tilts ? 1e3 * std::hypot(tilt_y_.standard_deviation(), tilt_z_.standard_deviation())
            : kNoValue;
}

}  // namespace cagetol
