// Above 400 lines: one class, whose recording and results belong side by side, quantity by
// quantity.
#include "src/quantities/observer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "src/integration/step_control.hpp"
#include "src/quantities/quantity_rows.hpp"

namespace cagetol {
namespace {

constexpr int kStaticsInstants = 64;
constexpr int kDutyInstants = 256;          // likewise under a duty over time
constexpr double kStaticsAccuracy = 1e-6;   // of the balance, over the load
constexpr double kRecordInterval = 20e-6;   // of the thinner record that quantiles use, at most [s]
constexpr double kStressInterval = 100e-6;  // likewise of the cage's stress, which costs more
// Of them between two rollers that pass, at least.
constexpr double kRecordsPerRoller = 95, kStressesPerRoller = 19;
constexpr double kStressAccuracy = 1e-4;     // of it, in shares of the largest so far
constexpr double kEnergyFloor = 1e-3;        // of the stored energy: runs that hardly dissipate
constexpr double kLoadedShare = 0.01;        // of the applied load
constexpr double kResolvedTolerance = 1e-3;  // the default's: of the energy account, at most
constexpr double kTurnsToDrift = 2;          // of the cage: within one its speed goes up and down

/// Whether the motion should repeat itself within the window, and whether it would show.
bool should_be_stationary(const BearingModel& m, double begin, double end) {
  const double turns =
      std::abs(kinematic_cage_speed(m, m.duty.speed)) * (end - begin) / (2 * std::numbers::pi);
  return m.lubricated && !m.duty.over_time() && ramps_end(m.duty) <= begin &&
         turns >= kTurnsToDrift;
}

/// Values by row of quantity_table(); all() throws where one was never set.
class QuantityValues {
 public:
  double& operator[](std::size_t row) {
    set_[row] = true;
    return values_[row];
  }
  std::vector<double> all() const {
    for (std::size_t row = 0; row < set_.size(); ++row)
      if (!set_[row])
        throw std::logic_error(std::string("quantity without a value: ") + kQuantityRows[row].key);
    return {values_.begin(), values_.end()};
  }

 private:
  std::array<double, kQuantityRows.size()> values_{};
  std::array<bool, kQuantityRows.size()> set_{};
};

/// Rows of the quantities of one contact kind's force.
struct ForceRows {
  std::size_t rms, p99, peak, impacts;
};
consteval ForceRows force_rows(std::string_view kind) {
  return {quantity_row(kind, "_force_rms_N"), quantity_row(kind, "_force_p99_N"),
          quantity_row(kind, "_force_peak_N"), quantity_row(kind, "_impacts_per_revolution")};
}

/// Rows of an extrapolated peak and its interval.
struct ExtrapolatedRows {
  std::size_t median, low, high;
};

}  // namespace

void Observer::Impacts::see(std::size_t pack, Mask touching) {
  if (open.size() <= pack) open.resize(pack + 1);
  const Mask begun = open[pack] & touching;
  if (any(begun))
    for (int i = 0; i < kLanes; ++i) count -= begun[i];  // set lanes are -1
  open[pack] = ~touching;
}

Observer::Observer(const BearingModel& model, double begin, double end)
    : model_(model),
      over_time_(model.duty.over_time()),
      rate_known_(!over_time_ && !model.lubricated),
      begin_(begin),
      end_(end),
      statics_(model, kStaticsAccuracy),
      angles_(static_cast<std::size_t>(model.layout.padded())),
      next_statics_(begin),
      statics_interval_((end - begin) / (over_time_ ? kDutyInstants : kStaticsInstants)),
      clock_(begin, std::min(kRecordInterval, roller_interval(model) / kRecordsPerRoller)),
      stress_interval_(std::min(kStressInterval, roller_interval(model) / kStressesPerRoller)),
      whirl_(model.guide_clearance) {
  if (const auto& cage = model.flexible.model) {
    stress_.emplace(*cage);
    fatigue_.emplace(cage->stress_stations, model.layout.rollers);
    bar_peaks_.emplace(cage->bar_stations, model.layout.modes);
  }
  if (should_be_stationary(model, begin, end)) stationarity_.emplace(begin, end);
}

Observer::Observer(const BearingModel& model, const WindowTimes& times)
    : Observer(model, times.settle, times.settle + times.measure) {
  revolution_ = times.revolution;
  extrapolate_ = times.extrapolate;
  if (times.peaks < times.measure) peaks_end_ = begin_ + times.peaks;
}

bool Observer::revolution_ended(double t) const {
  const auto ended = static_cast<double>(ended_revolutions_ + 1);
  if (over_time_) return along_.rolled() >= 2 * std::numbers::pi * ended;
  // Rounding may put the end of a revolution after the state that is meant to be there.
  return t >= begin_ + (ended - 1e-9) * revolution_;
}

void Observer::record_revolution(double t) {
  if (!revolution_ended(t)) return;
  ++ended_revolutions_;
  whirl_.end_revolution();
  for (BlockPeaks* blocks : {&pocket_blocks_, &guide_blocks_, &stress_blocks_}) blocks->end();
  if (fatigue_) {
    fatigue_->end_revolution();
    bar_peaks_->begin_revolution();
  }
}

void Observer::record(double t, const double* y, const System& system) {
  const StateLayout& l = model_.layout;
  const double *q = y + l.border_position(0), *v = y + l.border_velocity(0);
  const double* dv = system.rate.data() + l.border_velocity(0);
  const Observation& seen = system.seen;
  const bool first = last_time_ < 0;
  const SeenStep step = clock_.advance(t);

  thinnest_film_ = std::min(thinnest_film_, seen.thinnest_film);
  inner_slice_ = std::max(inner_slice_, seen.inner_slice);
  outer_slice_ = std::max(outer_slice_, seen.outer_slice);

  const double c = std::cos(q[kCagePhi]), s = std::sin(q[kCagePhi]);
  double e[2];
  turned_unbalance(model_, c, s, e);
  const double cage_y = q[kCageY] - e[0], cage_z = q[kCageZ] - e[1];
  const double cage_vy = v[kCageY] + v[kCagePhi] * e[1], cage_vz = v[kCageZ] - v[kCagePhi] * e[0];

  const double moving = body_energy(model_, y), energy = moving + seen.elastic_energy;
  if (first) {
    first_energy_ = energy;
    std::copy(v + kRingY, v + kRingZ + 1, first_ring_speed_);
    start_phase_ = q[kCagePhi];
    last_stress_ = t;
    orbit_angle_ = std::atan2(cage_z, cage_y);
  }
  last_energy_ = energy;
  std::copy(v + kRingY, v + kRingZ + 1, last_ring_speed_);
  const double net_power =
      seen.drive_power + seen.load_power - seen.friction_power - seen.damping_power;
  if (rate_known_)
    net_work_.add(t, net_power, seen.net_power_rate);
  else
    net_power_.add(net_power, step);
  drive_.add(seen.drive_power, step);
  const double lost = seen.friction_power + seen.damping_power;
  dissipation_.add(lost, step);
  for (std::size_t k = 0; k < kMechanisms; ++k) lost_[k].add(seen.lost[k], step);
  if (stationarity_)
    stationarity_->record(
        t, {y[l.border_velocity(kCagePhi)], moving, seen.drive_power + seen.load_power, lost});

  whirl_.record(t, {cage_y, cage_z, std::hypot(cage_vy, cage_vz), v[kCagePhi]});
  const double angle = std::atan2(cage_z, cage_y);
  orbit_turned_ += std::remainder(angle - orbit_angle_, 2 * std::numbers::pi);
  orbit_angle_ = angle;
  revolutions_ = std::abs(q[kCagePhi] - start_phase_) / (2 * std::numbers::pi);

  const RingSpeeds rings = ring_speeds_at(model_.duty, t);
  const double rolling = kinematic_cage_speed(model_, rings);
  const double* angles = y + l.position(kAngle, 0);
  const double rollers = std::accumulate(angles, angles + l.rollers, 0.0) / l.rollers;
  if (over_time_) {
    along_.record(t, rolling, q[kCagePhi], rollers, orbit_turned_);
    revolutions_ = along_.travelled() / (2 * std::numbers::pi);
    const double way = rolling > 0 ? 1 : rolling < 0 ? -1 : 0;
    cage_speed_.add(way * v[kCagePhi], step);
    rolling_.add(std::abs(rolling), step);
    apart_.add(std::abs(rings.inner - rings.outer), step);
    const RingLoad imposed = ring_force_at(model_, t);
    imposed_.add(std::hypot(imposed.y, imposed.z), step);
    orbit_slip_.record(t, along_.cage(), along_.rollers(), std::abs(rolling));
  } else {
    cage_speed_.add(v[kCagePhi], step);
    rolling_.add(rolling, step);
    apart_.add(rings.inner - rings.outer, step);
    orbit_slip_.record(t, q[kCagePhi], rollers, rolling);
  }
  whirl_radius_.add(std::hypot(cage_y, cage_z), step);
  whirl_speed_.add(std::hypot(cage_vy, cage_vz), step);
  cage_axial_.add(q[kCageX], step);
  cage_lean_y_.add(q[kCageAxisY], step);
  cage_lean_z_.add(q[kCageAxisZ], step);
  ring_y_.add(q[kRingY], step);
  ring_z_.add(q[kRingZ], step);
  ring_acceleration_.add({dv[kRingY], dv[kRingZ]}, {v[kRingY], v[kRingZ]}, {q[kRingY], q[kRingZ]},
                         step);
  const Way down = way_of(ring_force_at(model_, t));
  sunk_.add(down.along(q[kRingY], q[kRingZ]), step);
  ring_elastic_.add(-down.along(seen.ring_elastic_y, seen.ring_elastic_z), step);
  if (l.ring_tilt > 0) {
    const double tilt_y = q[l.ring_tilt_slot()], tilt_z = q[l.ring_tilt_slot() + 1];
    ring_tilt_.add(std::hypot(tilt_y, tilt_z), step);
    tilt_y_.add(tilt_y, step);
    tilt_z_.add(tilt_z, step);
  }
  guide_force_.add(seen.land_force[0] + seen.land_force[1], step);
  guide_blocks_.see(seen.land_force[0] + seen.land_force[1]);
  guide_impacts_.see(0, Mask{-seen.land_touching[0], -seen.land_touching[1]});
  end_displacement_ = down.along(q[kRingY], q[kRingZ]);
  record_rollers(t, y, system, step);
  record_statics(t, y);
  if (stress_) record_stress(t, y, seen);
  last_time_ = t;
  record_revolution(t);
  if (t >= peaks_end_ && extremes_.empty()) {
    extremes_ = quantities_so_far();
    extreme_peak_ = cage_peak_;
  }
}

void Observer::record_stress(double t, const double* y, const Observation& seen) {
  const bool keep = t >= next_stress_;
  if (keep) next_stress_ = std::max(next_stress_ + stress_interval_, t);
  const double* q = y + model_.layout.border_position(kModes);
  const double spin = seen.centrifugal_spin;
  if (bar_peaks_->pass(q, seen.bar_force, spin)) {
    const BarPeaks::State& at = bar_peaks_->peak();
    fatigue_->add(stress_->components(at.modes.data(), at.bar_force, at.spin));
    stress_blocks_.see(stress_->largest_of_components().stress);
  }
  const double peak = cage_stress_.peak();
  const double change = stress_->change_bound(q, seen.bar_force, spin);
  const bool changed = !(change <= kStressAccuracy * peak);
  if (!keep) {
    if (!changed || stress_->last().stress + change <= peak) return;
    if (stress_->bound(q, seen.bar_force, spin) <= peak) return;
  }
  const CageStress::Largest largest =
      changed ? stress_->largest(q, seen.bar_force, spin) : stress_->last();
  if (changed) fatigue_->add(stress_->components());
  stress_blocks_.see(largest.stress);
  if (largest.stress > cage_stress_.peak() || cage_peak_.modes.empty()) {
    cage_peak_.time = t;
    cage_peak_.pocket = static_cast<int>(largest.sector);
    cage_peak_.station = static_cast<int>(largest.station);
    cage_peak_.modes.assign(q, q + model_.layout.modes);
    cage_peak_.bar_force.assign(seen.bar_force.begin(), seen.bar_force.end());
    cage_peak_.spin = spin;
  }
  cage_stress_.add(largest.stress, keep ? t - last_stress_ : 0, keep);
  if (keep) last_stress_ = t;
}

void Observer::record_rollers(double t, const double* y, const System& system,
                              const SeenStep& step) {
  const StateLayout& l = model_.layout;
  const Observation& seen = system.seen;
  const double ratio = model_.nominal_diameter / (2 * model_.pitch_radius);
  const RingSpeeds rings = ring_speeds_at(model_.duty, t);
  const double rolling = (rings.inner - rings.outer) / (2 * ratio) * (1 - ratio * ratio);
  const double cage = kinematic_cage_speed(model_, rings), way = cage > 0 ? 1 : cage < 0 ? -1 : 0;
  const RingLoad load_now = load_at(model_.duty, t);
  const double threshold =
      kLoadedShare *
      (over_time_ ? std::max(std::hypot(load_now.y, load_now.z), 1.0) : largest_load(model_.duty));
  const double rolls = rolling != 0 ? 1 / std::abs(rolling) : 0;
  if (over_time_) spun_.add(std::abs(rolling), step);
  for (int group = 0; group < l.groups; ++group) {
    const int j = group * kLanes;
    const auto k = static_cast<std::size_t>(group);
    const Mask here = model_.groups[k].exists > 0.0;
    const GroupLinear& linear = system.linear.groups[k];
    const auto force = [&](const PackVector& of) { return load(of.data() + j); };
    const Pack spin = load(y + l.velocity(kSpin, j)), orbit = load(y + l.velocity(kOrbitRate, j));
    const Pack ay = load(y + l.position(kAxisY, j)), az = load(y + l.position(kAxisZ, j));
    largest_lean_squared_ =
        std::max(largest_lean_squared_, largest(select(here, ay * ay + az * az, Pack{})));
    skew_.add(k, abs(linear.cosine * az - linear.sine * ay), here, step);
    tilt_.add(k, abs(linear.cosine * ay + linear.sine * az), here, step);
    roller_speed_.add(k, over_time_ ? way * spin : spin, here, step);
    const Pack slip = over_time_  ? std::abs(rolling) - abs(spin - orbit)
                      : rolls > 0 ? 1.0 - abs(spin - orbit) * rolls
                                  : Pack{};
    slip_all_.add(k, slip, here, step);
    const Pack carried = force(seen.inner_force);
    const Mask loaded = here & (carried > threshold);
    slip_loaded_.add(k, slip, loaded, step);
    roller_load_ = std::max(roller_load_, largest(select(here, carried, Pack{})));
    carried_.add(k, carried, here, step);
    carried_orbit_.add(k, carried * (over_time_ ? way * orbit : orbit), here, step);
    if (over_time_) {
      spun_loaded_.add(k, splat(std::abs(rolling)), loaded, step);
      carried_rolling_.add(k, carried * std::abs(cage), here, step);
    }
    sliding_.add_above(k, force(seen.inner_sliding), force(seen.inner_force), threshold, here,
                       step);
    const Pack leading = force(seen.leading_force), trailing = force(seen.trailing_force),
               wall = force(seen.wall_force);
    pocket_force_.add(k, leading + trailing, here, step);
    pocket_blocks_.see(largest(select(here, leading + trailing, Pack{})));
    pocket_impacts_.see(2 * k, leading > 0.0);
    pocket_impacts_.see(2 * k + 1, trailing > 0.0);
    wall_force_.add(k, wall, here, step);
    wall_impacts_.see(k, wall > 0.0);
  }
}

void Observer::record_statics(double t, const double* y) {
  if (t < next_statics_) return;
  while (next_statics_ <= t) next_statics_ += statics_interval_;
  const StateLayout& l = model_.layout;
  std::copy(y + l.position(kAngle, 0), y + l.position(kAngle, 0) + l.padded(), angles_.begin());
  if (over_time_) statics_.turn_outer(ring_speeds_at(model_.duty, t).outer);
  if (model_.lubricated) statics_.spin(y + l.velocity(kSpin, 0), ring_speeds_at(model_.duty, t));
  statics_.turn_rings(ring_angles_at(model_.duty, t));
  const StaticState& rest = statics_.solve(angles_.data(), y[l.border_velocity(kCagePhi)],
                                           load_at(model_.duty, t), RollerMotion::orbiting);
  ++static_positions_;
  if (!rest.converged) {
    ++static_positions_missed_;
    return;
  }
  const Way down = way_of(ring_force_at(model_, t));
  const double* ring = y + l.border_position(kRingY);
  dynamic_displacement_.add(down.along(ring[0], ring[1]), 1);
  static_displacement_.add(down.along(rest.ring_y, rest.ring_z), 1);
  static_elastic_.add(-down.along(rest.ring_elastic[0], rest.ring_elastic[1]), 1);
  static_carried_.add(
      std::accumulate(rest.inner_force.begin(), rest.inner_force.begin() + l.rollers, 0.0) /
          l.rollers,
      1);
}

double Observer::energy_scale() const {
  const double lost = dissipation_.mean() * (last_time_ - begin_);
  return std::max(std::abs(lost), kEnergyFloor * std::abs(first_energy_));
}

double Observer::energy_residual() const {
  const double net_work = rate_known_ ? net_work_.integral() : net_power_.sums().integral();
  return std::abs(net_work - (last_energy_ - first_energy_)) / energy_scale();
}

double Observer::energy_resolution(double tolerance) const {
  const StateLayout& l = model_.layout;
  double mass = model_.ring_mass + model_.cage_mass;
  for (const RollerGroup& g : model_.groups) mass += sum(g.exists * g.mass);
  const double carried = static_carried_.empty() ? 0 : static_carried_.mean() * l.rollers;
  const double force = std::max(largest_load(model_.duty), carried);
  // Momentum is at most the root of twice mass times energy.
  const double energy = std::max(std::abs(first_energy_), std::abs(last_energy_));
  const ErrorUnits unit = error_units(model_);
  const double by_scale = force * unit.length + std::sqrt(2 * mass * energy) * unit.speed;
  const double components =
      (int{kRollerPositions} + int{kRollerVelocities}) * l.rollers + 2 * l.border();
  // A tolerance looser than the default's is what the watch is there to find.
  return std::min(tolerance, kResolvedTolerance) * std::sqrt(components) * by_scale /
         energy_scale();
}

ExtrapolatedPeak Observer::extrapolated(const BlockPeaks& of) const {
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (std::isnan(extrapolate_)) return {none, none, none};
  ExtrapolatedPeak peak = extrapolate_peak(of.ended, extrapolate_);
  for (double* value : {&peak.median, &peak.low, &peak.high})
    if (*value < 0) *value = 0;  // a magnitude
  return peak;
}

double Observer::rollers_couple(const RingLoad& load) const {
  if (model_.layout.ring_tilt == 0) return 0;
  const double k = model_.tilt_stiffness;
  return std::hypot(load.moment_y - k * (tilt_y_.mean() - model_.misalignment_y),
                    load.moment_z - k * (tilt_z_.mean() - model_.misalignment_z)) /
         model_.roller_half_length;
}

double Observer::light_force() const {
  const double cage_speed = cage_speed_.mean();
  return std::max(1.0,
                  model_.groups.front().mass[0] * model_.pitch_radius * cage_speed * cage_speed);
}

double Observer::mean_imposed() const {
  if (over_time_) return imposed_.mean();
  const RingLoad load = ring_force_at(model_, end_);
  return std::hypot(load.y, load.z);
}

double Observer::static_scale() const {
  const RingLoad load = ring_force_at(model_, end_);
  // Rollers that are pressed without a load rub: statics leaves that out.
  const double carried = static_carried_.empty() ? 0 : static_carried_.mean();
  return std::max({mean_imposed(), light_force(), rollers_couple(load), carried});
}

double Observer::static_resolution() const {
  const double momentum = model_.ring_mass * std::hypot(last_ring_speed_[0] - first_ring_speed_[0],
                                                        last_ring_speed_[1] - first_ring_speed_[1]);
  const double cage = model_.guidance == Guidance::outer ? 0 : guide_force_.mean();
  return (momentum / (last_time_ - begin_) + cage) / static_scale();
}

double Observer::static_consistency_error() const {
  const double weight = mean_imposed();
  const double expected_force = static_elastic_.empty() ? weight : static_elastic_.mean();
  const double force = std::abs(ring_elastic_.mean() - expected_force) / static_scale();
  // Below the centrifugal force of one roller the ring bounces within its clearance: its mean place
  // says nothing.
  if (dynamic_displacement_.empty() || weight < light_force()) return force;
  const double expected = static_displacement_.mean();
  return std::max(force, std::abs(dynamic_displacement_.mean() - expected) /
                             std::max(std::abs(expected), error_units(model_).length));
}

std::vector<double> Observer::quantities() const {
  std::vector<double> values = quantities_so_far();
  for (std::size_t i = 0; i < extremes_.size(); ++i)
    if (is_extreme(kQuantityRows[i].kind)) values[i] = extremes_[i];
  return values;
}

std::vector<double> Observer::quantities_so_far() const {
  const double none = std::numeric_limits<double>::quiet_NaN();
  QuantityValues q;
  const double cage_speed = cage_speed_.mean(), rolling = rolling_.mean(), apart = apart_.mean();
  const bool turns = rolling != 0;
  const double clearance = model_.guide_clearance, duration = end_ - begin_;
  const double revolutions = std::max(revolutions_, 1e-12);
  q[quantity_row("cage_slip_ratio")] = turns ? 1 - cage_speed / rolling : none;
  q[quantity_row("orbit_slip_ratio")] = turns ? 1 - orbit_slip_.rate_ratio() : none;
  const double carried = carried_.all().mean();
  const double rolling_weight = over_time_ ? carried_rolling_.all().mean() / carried : rolling;
  q[quantity_row("orbit_slip_ratio_loaded")] =
      turns && carried > 0 ? 1 - carried_orbit_.all().mean() / carried / rolling_weight : none;
  const auto of_rolling = [&](double slip, const auto& spun) {
    return !over_time_ ? slip : turns ? slip / spun() : none;
  };
  q[quantity_row("roller_slip_ratio_loaded")] =
      of_rolling(slip_loaded_.all().mean(), [&] { return spun_loaded_.all().mean(); });
  q[quantity_row("roller_slip_ratio_all")] =
      of_rolling(slip_all_.all().mean(), [&] { return spun_.mean(); });
  const Series sliding = sliding_.all(), skew = skew_.all(), speeds = roller_speed_.all();
  q[quantity_row("race_sliding_speed_rms")] = sliding.rms();
  q[quantity_row("race_sliding_speed_peak")] = sliding.peak();
  q[quantity_row("whirl_radius_ratio_mean")] = whirl_radius_.mean() / clearance;
  q[quantity_row("whirl_radius_ratio_p95")] = whirl_radius_.quantile(0.95) / clearance;
  q[quantity_row("whirl_radius_ratio_peak")] = whirl_radius_.peak() / clearance;
  q[quantity_row("whirl_speed_deviation_ratio")] =
      whirl_speed_.standard_deviation() / whirl_speed_.mean();
  const bool stands = over_time_ && !turns;
  const double frequency = over_time_ ? along_.centre() / (2 * std::numbers::pi * revolutions)
                                      : orbit_turned_ / duration / cage_speed;
  q[quantity_row("whirl_frequency_ratio")] = stands ? none : frequency;
  q[quantity_row("whirl_scatter_ratio")] = whirl_.scatter();
  q[quantity_row("whirl_energy_ratio")] =
      turns ? model_.cage_mass / model_.cage_polar * whirl_.speed_ratio_squared() : none;
  const auto shares = whirl_.shares();
  const auto share = [&](OrbitClass of) { return shares[static_cast<std::size_t>(of)]; };
  q[quantity_row("whirl_resting_share")] = share(OrbitClass::resting);
  q[quantity_row("whirl_circling_share")] = share(OrbitClass::circling);
  q[quantity_row("whirl_irregular_share")] = share(OrbitClass::irregular);
  const auto force = [&](const ForceRows& rows, const Series& series, const Impacts& impacts) {
    q[rows.rms] = series.rms();
    q[rows.p99] = series.quantile(0.99);
    q[rows.peak] = series.peak();
    q[rows.impacts] = static_cast<double>(impacts.count) / revolutions;
  };
  force(force_rows("pocket"), pocket_force_.all(), pocket_impacts_);
  force(force_rows("guide"), guide_force_, guide_impacts_);
  force(force_rows("end"), wall_force_.all(), wall_impacts_);
  const double per_turn = turns ? duration / revolutions : none;
  const Series::Sums pressed = pocket_force_.sums();
  q[quantity_row("pocket_impulse_N_s")] = pressed.integral() / pressed.weight * per_turn;
  q[quantity_row("pocket_friction_work_J")] =
      lost_[kPocketFriction].mean() * per_turn / model_.layout.rollers;
  q[quantity_row("cage_speed_std_ratio")] =
      stands ? none : cage_speed_.standard_deviation() / std::abs(cage_speed);
  q[quantity_row("cage_axial_std_um")] = 1e6 * cage_axial_.standard_deviation();
  q[quantity_row("cage_tilt_std_mrad")] =
      1e3 * std::hypot(cage_lean_y_.standard_deviation(), cage_lean_z_.standard_deviation());
  q[quantity_row("roller_load_peak_N")] = roller_load_;
  q[quantity_row("race_pressure_peak_MPa")] =
      1e-6 * race_pressure(model_, inner_slice_, outer_slice_);
  q[quantity_row("load_zone_mean_deg")] =
      360 * slip_loaded_.sums().weight / slip_all_.sums().weight;
  q[quantity_row("ring_displacement_mean_um")] = 1e6 * sunk_.mean();
  q[quantity_row("ring_displacement_end_um")] = 1e6 * end_displacement_;
  q[quantity_row("ring_orbit_p95_um")] = 1e6 * distance_quantile(ring_y_, ring_z_, 0.95);
  q[quantity_row("ring_acceleration_rms_m_s2")] = ring_acceleration_.rms();
  q[quantity_row("ring_acceleration_peak_m_s2")] = ring_acceleration_.peak();
  const bool tilts = model_.layout.ring_tilt > 0;
  const double held = std::hypot(model_.misalignment_y, model_.misalignment_z);
  q[quantity_row("ring_tilt_mean_mrad")] = 1e3 * (tilts ? ring_tilt_.mean() : held);
  q[quantity_row("ring_tilt_std_mrad")] =
      tilts ? 1e3 * std::hypot(tilt_y_.standard_deviation(), tilt_z_.standard_deviation()) : none;
  q[quantity_row("roller_speed_std_ratio")] =
      stands ? none : speeds.standard_deviation() / std::abs(speeds.mean());
  q[quantity_row("roller_skew_rms_mrad")] = 1e3 * skew.rms();
  q[quantity_row("roller_skew_p95_mrad")] = 1e3 * skew.quantile(0.95);
  q[quantity_row("roller_tilt_p95_mrad")] = 1e3 * tilt_.all().quantile(0.95);
  q[quantity_row("power_loss_W")] = dissipation_.mean();
  const auto lost = [&](Mechanism of) { return lost_[of].mean(); };
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
  q[quantity_row("friction_torque_Nmm")] = apart != 0 ? 1e3 * drive_.mean() / apart : 0;
  q[quantity_row("cage_stress_peak_MPa")] = stress_ ? 1e-6 * cage_stress_.peak() : none;
  q[quantity_row("cage_stress_p99_MPa")] = stress_ ? 1e-6 * cage_stress_.quantile(0.99) : none;
  q[quantity_row("cage_stress_rms_MPa")] = stress_ ? 1e-6 * cage_stress_.rms() : none;
  q[quantity_row("cage_stress_peak_pocket")] = stress_ ? cage_peak_.pocket : none;
  q[quantity_row("cage_stress_peak_station")] = stress_ ? cage_peak_.station : none;
  const CageFatigue::Place fatigue =
      fatigue_ ? fatigue_->worst(model_.cage_strength) : CageFatigue::Place{};
  q[quantity_row("cage_fatigue_utilisation")] = stress_ ? fatigue.utilisation : none;
  q[quantity_row("cage_fatigue_pocket")] = stress_ ? static_cast<double>(fatigue.sector) : none;
  q[quantity_row("cage_fatigue_station")] = stress_ ? static_cast<double>(fatigue.station) : none;
  q[quantity_row("cage_strength_utilisation")] =
      stress_ ? cage_stress_.peak() / model_.cage_strength.yield : none;
  const auto extrapolate = [&](const ExtrapolatedRows& rows, const BlockPeaks& blocks,
                               double scale) {
    const ExtrapolatedPeak peak = extrapolated(blocks);
    q[rows.median] = scale * peak.median;
    q[rows.low] = scale * peak.low;
    q[rows.high] = scale * peak.high;
  };
  extrapolate({quantity_row("pocket_force_peak_extrapolated_N"),
               quantity_row("pocket_force_peak_extrapolated_low_N"),
               quantity_row("pocket_force_peak_extrapolated_high_N")},
              pocket_blocks_, 1);
  extrapolate({quantity_row("guide_force_peak_extrapolated_N"),
               quantity_row("guide_force_peak_extrapolated_low_N"),
               quantity_row("guide_force_peak_extrapolated_high_N")},
              guide_blocks_, 1);
  extrapolate({quantity_row("cage_stress_peak_extrapolated_MPa"),
               quantity_row("cage_stress_peak_extrapolated_low_MPa"),
               quantity_row("cage_stress_peak_extrapolated_high_MPa")},
              stress_blocks_, stress_ ? 1e-6 : none);
  const bool filmed = (model_.inner_film.on || model_.lubricated) && thinnest_film_ < kNoFilm;
  q[quantity_row("film_min_um")] = filmed ? 1e6 * thinnest_film_ : none;
  q[quantity_row("lambda_min_ratio")] =
      filmed && model_.lubricated ? thinnest_film_ / model_.inner_line.traction.roughness : none;
  q[quantity_row("static_consistency_error")] = static_consistency_error();
  return q.all();
}

}  // namespace cagetol
