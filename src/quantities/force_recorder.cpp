#include "src/quantities/force_recorder.hpp"

#include <string_view>

namespace cagetol {
namespace {

/// Rows of the quantities of one contact kind's force.
struct ForceRows {
  std::size_t rms, p99, peak, impacts;
};
consteval ForceRows force_rows(std::string_view kind) {
  return {quantity_row(kind, "_force_rms_N"), quantity_row(kind, "_force_p99_N"),
          quantity_row(kind, "_force_peak_N"), quantity_row(kind, "_impacts_per_revolution")};
}

}  // namespace

void ForceRecorder::Impacts::see(std::size_t pack, Mask touching) {
  if (open.size() <= pack) open.resize(pack + 1);
  const Mask begun = open[pack] & touching;
  if (any(begun))
    for (int i = 0; i < kLanes; ++i) count -= begun[i];  // set lanes are -1
  open[pack] = ~touching;
}

void ForceRecorder::record(const ObservedState& at) {
  const double guide = at.seen.land_force[0] + at.seen.land_force[1];
  guide_.add(guide, at.step);
  guide_impacts_.see(0, Mask{-at.seen.land_touching[0], -at.seen.land_touching[1]});
  for (std::size_t k = 0; k < model_.groups.size(); ++k) {
    const Mask here = model_.groups[k].exists > 0.0;
    const auto force = [&](const PackVector& of) { return load(of.data() + k * kLanes); };
    const Pack leading = force(at.seen.leading_force), trailing = force(at.seen.trailing_force),
               end = force(at.seen.wall_force);
    pocket_.add(k, leading + trailing, here, at.step);
    pocket_impacts_.see(2 * k, leading > 0.0);
    pocket_impacts_.see(2 * k + 1, trailing > 0.0);
    end_.add(k, end, here, at.step);
    end_impacts_.see(k, end > 0.0);
  }
}

void ForceRecorder::write(const Turning& turning, double duration, QuantityValues& q) const {
  const double revolutions = std::max(turning.revolutions(), 1e-12);
  const auto force = [&](const ForceRows& rows, const Series& series, const Impacts& impacts) {
    q[rows.rms] = series.rms();
    q[rows.p99] = series.quantile(0.99);
    q[rows.peak] = series.peak();
    q[rows.impacts] = static_cast<double>(impacts.count) / revolutions;
  };
  force(force_rows("pocket"), pocket_.all(), pocket_impacts_);
  force(force_rows("guide"), guide_, guide_impacts_);
  force(force_rows("end"), end_.all(), end_impacts_);
  const double spin = turning.cage_speed();
  q[quantity_row("guide_force_unbalance_g_mm")] =
      turning.turns() ? 1e6 * guide_.mean() / (spin * spin) : kNoValue;
  const double per_turn = turning.turns() ? duration / revolutions : kNoValue;
  const Series::Sums pressed = pocket_.sums();
  q[quantity_row("pocket_impulse_N_s")] = pressed.integral() / pressed.weight * per_turn;
}

}  // namespace cagetol
