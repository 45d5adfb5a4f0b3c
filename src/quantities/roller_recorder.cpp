#include "src/quantities/roller_recorder.hpp"

namespace cagetol {
namespace {

constexpr double kLoadedShare = 0.01;  // of the applied load

}  // namespace

void RollerRecorder::record(const ObservedState& at) {
  const StateLayout& l = model_.layout;
  const Observation& seen = at.seen;
  const SeenStep& step = at.step;
  thinnest_film_ = std::min(thinnest_film_, seen.thinnest_film);
  inner_slice_ = std::max(inner_slice_, seen.inner_slice);
  outer_slice_ = std::max(outer_slice_, seen.outer_slice);
  const bool over_time = model_.duty.over_time();
  const double ratio = model_.nominal_diameter / (2 * model_.pitch_radius);
  const double rolling = (at.rings.inner - at.rings.outer) / (2 * ratio) * (1 - ratio * ratio);
  const double way = way_of_turning(at.rolling);
  const RingLoad load_now = load_at(model_.duty, at.t);
  const double threshold =
      kLoadedShare *
      (over_time ? std::max(std::hypot(load_now.y, load_now.z), 1.0) : largest_load(model_.duty));
  const double rolls = rolling != 0 ? 1 / std::abs(rolling) : 0;
  if (over_time) spun_.add(std::abs(rolling), step);
  for (int group = 0; group < l.groups; ++group) {
    const int j = group * kLanes;
    const auto k = static_cast<std::size_t>(group);
    const Mask here = model_.groups[k].exists > 0.0;
    const GroupLinear& linear = at.system.linear.groups[k];
    const auto force = [&](const PackVector& of) { return load(of.data() + j); };
    const Pack spin = load(at.y + l.velocity(kSpin, j)),
               orbit = load(at.y + l.velocity(kOrbitRate, j));
    const Pack ay = load(at.y + l.position(kAxisY, j)), az = load(at.y + l.position(kAxisZ, j));
    largest_lean_squared_ =
        std::max(largest_lean_squared_, largest(select(here, ay * ay + az * az, Pack{})));
    skew_.add(k, abs(linear.cosine * az - linear.sine * ay), here, step);
    tilt_.add(k, abs(linear.cosine * ay + linear.sine * az), here, step);
    speed_.add(k, over_time ? way * spin : spin, here, step);
    const Pack slip = over_time   ? std::abs(rolling) - abs(spin - orbit)
                      : rolls > 0 ? 1.0 - abs(spin - orbit) * rolls
                                  : Pack{};
    slip_all_.add(k, slip, here, step);
    const Pack carried = force(seen.inner_force);
    const Mask loaded = here & (carried > threshold);
    slip_loaded_.add(k, slip, loaded, step);
    load_ = std::max(load_, largest(select(here, carried, Pack{})));
    carried_.add(k, carried, here, step);
    carried_orbit_.add(k, carried * (over_time ? way * orbit : orbit), here, step);
    if (over_time) {
      spun_loaded_.add(k, splat(std::abs(rolling)), loaded, step);
      carried_rolling_.add(k, carried * std::abs(at.rolling), here, step);
    }
    rubbing_ = std::max(rubbing_, largest(select(here, force(seen.inner_rubbing), Pack{})));
    sliding_.add_above(k, force(seen.inner_sliding), carried, threshold, here, step);
  }
}

void RollerRecorder::write(const Turning& turning, QuantityValues& q) const {
  const bool over_time = turning.over_time(), turns = turning.turns();
  const double carried = carried_.all().mean();
  const double rolling = over_time ? carried_rolling_.all().mean() / carried : turning.rolling();
  q[quantity_row("driving_slip_ratio")] =
      turns && carried > 0 ? 1 - carried_orbit_.all().mean() / carried / rolling : kNoValue;
  const auto of_rolling = [&](double slip, const auto& spun) {
    return !over_time ? slip : turns ? slip / spun() : kNoValue;
  };
  q[quantity_row("roller_slip_ratio_loaded")] =
      of_rolling(slip_loaded_.all().mean(), [&] { return spun_loaded_.all().mean(); });
  q[quantity_row("roller_slip_ratio_all")] =
      of_rolling(slip_all_.all().mean(), [&] { return spun_.mean(); });
  const Series sliding = sliding_.all(), skew = skew_.all(), speeds = speed_.all();
  q[quantity_row("race_sliding_speed_rms")] = sliding.rms();
  q[quantity_row("race_sliding_speed_peak")] = sliding.peak();
  q[quantity_row("race_friction_peak_W")] = rubbing_;
  q[quantity_row("roller_load_peak_N")] = load_;
  q[quantity_row("race_pressure_peak_MPa")] =
      1e-6 * race_pressure(model_, inner_slice_, outer_slice_);
  q[quantity_row("load_zone_mean_deg")] =
      360 * slip_loaded_.sums().weight / slip_all_.sums().weight;
  q[quantity_row("roller_speed_std_ratio")] =
      turning.stands() ? kNoValue : speeds.standard_deviation() / std::abs(speeds.mean());
  q[quantity_row("roller_skew_rms_mrad")] = 1e3 * skew.rms();
  q[quantity_row("roller_skew_p95_mrad")] = 1e3 * skew.quantile(0.95);
  q[quantity_row("roller_tilt_p95_mrad")] = 1e3 * tilt_.all().quantile(0.95);
  const bool filmed = model_.lubricated && thinnest_film_ < kNoFilm;
  q[quantity_row("film_min_um")] = filmed ? 1e6 * thinnest_film_ : kNoValue;
  q[quantity_row("lambda_min_ratio")] =
      filmed ? thinnest_film_ / model_.inner_line.traction.roughness : kNoValue;
}

}  // namespace cagetol
