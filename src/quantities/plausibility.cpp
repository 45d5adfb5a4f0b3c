#include "src/quantities/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "src/quantities/quantity_rows.hpp"

namespace cagetol {
namespace {

using Reach = const PlausibleReach&;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Means are integrals over, and values between states lie on, parabolas through three states, which
// pass the largest state a little where steps grow quickly.
constexpr double kOrderMargin = 2;

constexpr double kFullCircle = 360 * (1 + 1e-9);  // rounding allowed [deg]

bool moving(Reach r) {
  return !r.quasi_static;
}
bool turning(Reach r) {
  return moving(r) && r.turns;
}
bool bent(Reach r) {
  return moving(r) && r.flexible;
}
bool leaning(Reach r) {
  return moving(r) && !r.planar;
}
bool always(Reach) {
  return true;
}
bool spatial(Reach r) {
  return !r.planar;
}
bool tilting(Reach r) {
  return moving(r) && r.tilts;
}
bool never(Reach) {
  return false;
}

PlausibleRange within(double low, double high) {
  return {low, high};
}
PlausibleRange magnitude(double most) {
  return {0, most};
}
PlausibleRange either_way(double most) {
  return {-most, most};
}

PlausibleRange whirl(Reach r) {
  return magnitude(r.whirl / r.guide_clearance);
}
PlausibleRange roller_slip(Reach r) {
  // Spin relative to the orbit, over that of rolling: about 1; 4 where a roller spun at the largest
  // speed of any surface.
  return within(r.apart > 0 ? 1 - 4 * r.fastest / r.apart : -kInfinite, 1);
}
PlausibleRange cage_slip(Reach r) {
  const double most = r.slowest > 0 ? 2 * r.fastest / r.slowest : kInfinite;
  return within(1 - most, 1 + most);
}
PlausibleRange orbit_slip(Reach r) {
  const double most = r.slowest > 0 ? r.orbit_rate / r.slowest : kInfinite;
  return within(1 - most, 1 + most);
}
double turned(Reach r) {
  return 2 * std::numbers::pi * r.revolutions;
}
/// Time of one revolution of the cage [s].
double turn_time(Reach r) {
  return r.duration / std::max(r.revolutions, 1e-12);
}
PlausibleRange touches(Reach r, double contacts) {
  return magnitude(contacts * r.touch_rate * turn_time(r));
}
/// That any mechanism dissipates [W].
double most_power(Reach r) {
  return r.power + r.torque * r.fastest;
}
PlausibleRange one_power(Reach r) {
  return either_way(most_power(r));
}
PlausibleRange lean(Reach) {
  return magnitude(1e3 * kLeanMax);
}

constexpr const char* kTighten =
    "tighten integration.tolerance, and check the scene's stiffnesses and speeds";
constexpr const char* kGuide =
    "set cage.guidance = \"outer\" or \"inner\", or give the pockets of a cage that rollers guide "
    "lips that hold it (cage.retention_width_outer_mm); else tighten integration.tolerance and "
    "check cage.guide_clearance_mm, contact.land and start.cage_offset";
constexpr const char* kRingRemedy =
    "check bearing.internal_clearance_um, roller.diameter_mm, the load and contact.race, and "
    "tighten "
    "integration.tolerance";
constexpr const char* kLeanRemedy =
    "raise discretisation.race_slices to at least 3, check the end and flange clearances, and "
    "tighten integration.tolerance";
constexpr const char* kStressRemedy =
    "make the cage table again (remove the cage cache), check cage.young_GPa and the bar forces, "
    "and tighten integration.tolerance";

constexpr const char* kSlipReason =
    "only friction drives a roller, so its spin relative to the orbit is between zero and that of "
    "the fastest surface it touches";
constexpr const char* kCageSlipReason =
    "nothing drives the cage faster than the inner ring turns, forwards or backwards";
constexpr const char* kOrbitSlipReason =
    "rollers go round no faster than the inner race and a free fall through the bearing move them";
constexpr const char* kSlidingReason =
    "surfaces slide no faster than the inner race and a free fall through the bearing move them";
constexpr const char* kWhirlReason =
    "the cage would have left its guide: its centre moves no farther than 1.05 of the guide "
    "clearance and what the guide gives way to all the energy in the bearing";
constexpr const char* kForceReason =
    "the elastic force of a contact that holds all the energy of the bearing (every part at twice "
    "the race's speed, load and weight over the ring's way), damping at that speed added, is less";
constexpr const char* kTouchReason =
    "a contact closes at most once in half a period of its own oscillation, at its stiffest";
constexpr const char* kScatterReason = "a standard deviation and a mean speed are not negative";
constexpr const char* kRingReason =
    "the inner ring moves no farther than the clearance and the elastic approach of one roller "
    "under four times all that presses on it";
constexpr const char* kAccelerationReason =
    "all races that hold the energy of the bearing, and the load, give the ring's mass less";
constexpr const char* kPowerReason =
    "no mechanism takes more than drive, load and the bearing held at the start give to all";
constexpr const char* kLeanReason =
    "the equations hold for small angles, up to 0.1 rad; beyond, parts tumble";
constexpr const char* kExtrapolatedReason = "a largest magnitude is not negative";
constexpr const char* kStressReason =
    "it would strain the cage by more than 5 %, where no cage is elastic";

}  // namespace

// clang-format off
const std::vector<PlausibleRow>& plausible_rows() {
  static const std::vector<PlausibleRow> rows = {
      {"cage_slip_ratio", turning, cage_slip, kCageSlipReason, kTighten},
      {"orbit_slip_ratio", turning, orbit_slip, kOrbitSlipReason, kTighten},
      {"orbit_slip_ratio_loaded", never, orbit_slip, kOrbitSlipReason, kTighten},
      {"roller_slip_ratio_loaded", never, roller_slip, kSlipReason, kTighten},
      {"roller_slip_ratio_all", [](Reach r) { return moving(r) && !r.over_time; }, roller_slip, kSlipReason, kTighten},
      {"race_sliding_speed_rms", never, [](Reach r) { return magnitude(r.speed); }, kSlidingReason, kTighten},
      {"race_sliding_speed_peak", never, [](Reach r) { return magnitude(r.speed); }, kSlidingReason, kTighten},
      {"whirl_radius_ratio_mean", moving, whirl, kWhirlReason, kGuide},
      {"whirl_radius_ratio_p95", moving, whirl, kWhirlReason, kGuide},
      {"whirl_radius_ratio_peak", moving, whirl, kWhirlReason, kGuide},
      {"whirl_speed_deviation_ratio", turning, [](Reach) { return magnitude(kInfinite); }, kScatterReason, kTighten},
      {"whirl_frequency_ratio", turning, [](Reach r) { return either_way(std::numbers::pi * r.steps / turned(r)); }, "between two states the cage's centre is seen to turn by half a turn at most", kTighten},
      {"whirl_scatter_ratio", moving, whirl, kWhirlReason, kGuide},
      {"whirl_energy_ratio", turning, [](Reach) { return magnitude(kInfinite); }, "energies are not negative", kTighten},
      {"whirl_resting_share", never, [](Reach) { return within(0, 1); }, "a share lies between 0 and 1", kTighten},
      {"whirl_circling_share", never, [](Reach) { return within(0, 1); }, "a share lies between 0 and 1", kTighten},
      {"whirl_irregular_share", never, [](Reach) { return within(0, 1); }, "a share lies between 0 and 1", kTighten},
      {"pocket_force_rms_N", moving, [](Reach r) { return magnitude(r.pocket_force); }, kForceReason, kTighten},
      {"pocket_force_p99_N", moving, [](Reach r) { return magnitude(r.pocket_force); }, kForceReason, kTighten},
      {"pocket_force_peak_N", moving, [](Reach r) { return magnitude(r.pocket_force); }, kForceReason, kTighten},
      {"pocket_impacts_per_revolution", moving, [](Reach r) { return touches(r, 2.0 * r.rollers); }, kTouchReason, kTighten},
      {"pocket_impulse_N_s", turning, [](Reach r) { return magnitude(r.pocket_force * turn_time(r)); }, kForceReason, kTighten},
      {"pocket_friction_work_J", turning, [](Reach r) { return either_way(most_power(r) * turn_time(r)); }, kPowerReason, kTighten},
      {"guide_force_rms_N", moving, [](Reach r) { return magnitude(r.guide_force); }, kForceReason, kTighten},
      {"guide_force_p99_N", moving, [](Reach r) { return magnitude(r.guide_force); }, kForceReason, kTighten},
      {"guide_force_peak_N", moving, [](Reach r) { return magnitude(r.guide_force); }, kForceReason, kTighten},
      {"guide_impacts_per_revolution", moving, [](Reach r) { return touches(r, 2); }, kTouchReason, kTighten},
      {"end_force_rms_N", moving, [](Reach r) { return magnitude(r.end_force); }, kForceReason, kTighten},
      {"end_force_p99_N", moving, [](Reach r) { return magnitude(r.end_force); }, kForceReason, kTighten},
      {"end_force_peak_N", moving, [](Reach r) { return magnitude(r.end_force); }, kForceReason, kTighten},
      {"end_impacts_per_revolution", moving, [](Reach r) { return touches(r, r.rollers); }, kTouchReason, kTighten},
      {"cage_speed_std_ratio", turning, [](Reach r) { return magnitude(r.turns ? 3 * r.fastest * r.duration / turned(r) : kInfinite); }, kCageSlipReason, kTighten},
      {"cage_axial_std_um", moving, [](Reach r) { return magnitude(1e6 * r.axial); }, "the rollers' ends and the flanges leave the cage less axial play", "check cage.pocket_length_mm, bearing.flange_clearance_mm and contact.end, and tighten integration.tolerance"},
      {"cage_tilt_std_mrad", moving, lean, kLeanReason, kLeanRemedy},
      {"roller_load_peak_N", moving, [](Reach r) { return magnitude(r.race_force); }, kForceReason, kTighten},
      {"race_pressure_peak_MPa", moving, [](Reach r) { return magnitude(1e-6 * r.race_pressure); }, kForceReason, kTighten},
      {"load_zone_mean_deg", moving, [](Reach) { return magnitude(kFullCircle); }, "rollers are loaded at most all round", kTighten},
      {"ring_displacement_mean_um", always, [](Reach r) { return either_way(1e6 * r.ring_move); }, kRingReason, kRingRemedy},
      {"ring_displacement_end_um", always, [](Reach r) { return either_way(1e6 * r.ring_move); }, kRingReason, kRingRemedy},
      {"ring_orbit_p95_um", always, [](Reach r) { return magnitude(2e6 * r.ring_move); }, kRingReason, kRingRemedy},
      {"ring_acceleration_rms_m_s2", moving, [](Reach r) { return magnitude(r.ring_acceleration); }, kAccelerationReason, kRingRemedy},
      {"ring_acceleration_peak_m_s2", moving, [](Reach r) { return magnitude(r.ring_acceleration); }, kAccelerationReason, kRingRemedy},
      {"ring_tilt_mean_mrad", spatial, lean, kLeanReason, "raise bearing.tilt_stiffness_N_m_rad or discretisation.race_slices"},
      {"ring_tilt_std_mrad", tilting, lean, kLeanReason, "raise bearing.tilt_stiffness_N_m_rad or discretisation.race_slices"},
      {"roller_speed_std_ratio", turning, [](Reach) { return magnitude(kInfinite); }, kScatterReason, kTighten},
      {"roller_skew_rms_mrad", leaning, lean, kLeanReason, kLeanRemedy},
      {"roller_skew_p95_mrad", leaning, lean, kLeanReason, kLeanRemedy},
      {"roller_tilt_p95_mrad", spatial, lean, kLeanReason, kLeanRemedy},
      {"power_loss_W", moving, [](Reach r) { return within(-r.power, most_power(r)); }, "contacts dissipate what drive and load give, and no more than the bearing held at the start", kTighten},
      {"power_race_sliding_W", moving, one_power, kPowerReason, kTighten},
      {"power_rolling_W", moving, one_power, kPowerReason, kTighten},
      {"power_pocket_W", moving, one_power, kPowerReason, kTighten},
      {"power_end_W", moving, one_power, kPowerReason, kTighten},
      {"power_flange_W", moving, one_power, kPowerReason, kTighten},
      {"power_land_W", moving, one_power, kPowerReason, kTighten},
      {"power_churning_W", moving, one_power, kPowerReason, kTighten},
      {"power_squeeze_W", moving, one_power, kPowerReason, kTighten},
      {"power_damping_W", moving, one_power, kPowerReason, kTighten},
      {"power_film_W", moving, one_power, kPowerReason, kTighten},
      {"friction_torque_Nmm", moving, [](Reach r) { return either_way(1e3 * r.torque); }, "friction of all races, each pressed by all the energy of the bearing, holds less", kTighten},
      {"cage_stress_peak_MPa", bent, [](Reach r) { return magnitude(1e-6 * r.stress); }, kStressReason, kStressRemedy},
      {"cage_stress_p99_MPa", bent, [](Reach r) { return magnitude(1e-6 * r.stress); }, kStressReason, kStressRemedy},
      {"cage_stress_rms_MPa", bent, [](Reach r) { return magnitude(1e-6 * r.stress); }, kStressReason, kStressRemedy},
      {"cage_stress_peak_pocket", bent, [](Reach r) { return within(0, r.rollers - 1); }, "the cage has no such pocket", kStressRemedy},
      {"cage_stress_peak_station", bent, [](Reach r) { return within(0, r.stations - 1); }, "the cage has no such stress station", kStressRemedy},
      {"cage_fatigue_utilisation", bent, [](Reach r) { return magnitude(r.fatigue); }, kStressReason, kStressRemedy},
      {"cage_fatigue_pocket", bent, [](Reach r) { return within(0, r.rollers - 1); }, "the cage has no such pocket", kStressRemedy},
      {"cage_fatigue_station", bent, [](Reach r) { return within(0, r.stations - 1); }, "the cage has no such stress station", kStressRemedy},
      {"cage_yield_utilisation", bent, [](Reach r) { return magnitude(r.yield); }, kStressReason, kStressRemedy},
      {"pocket_force_peak_extrapolated_N", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"pocket_force_peak_extrapolated_low_N", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"pocket_force_peak_extrapolated_high_N", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"guide_force_peak_extrapolated_N", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"guide_force_peak_extrapolated_low_N", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"guide_force_peak_extrapolated_high_N", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"cage_stress_peak_extrapolated_MPa", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"cage_stress_peak_extrapolated_low_MPa", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"cage_stress_peak_extrapolated_high_MPa", never, [](Reach) { return magnitude(kInfinite); }, kExtrapolatedReason, kTighten},
      {"film_min_um", never, [](Reach r) { return magnitude(1e6 * r.film_thickest); }, "a film between rolling surfaces is thin against the roller: a hundredth of its radius at most", "check film.viscosity_Pa_s and the speed"},
      {"lambda_min_ratio", never, [](Reach r) { return magnitude(r.lambda_thickest); }, "a film between rolling surfaces is thin against the roller: a hundredth of its radius at most", "check the lubricant, lubrication.race_roughness_um and the speed"},
      {"static_consistency_error", moving, [](Reach) { return magnitude(kInfinite); }, "a relative error is not negative", kTighten},
  };
  return rows;
}
// clang-format on

const std::vector<PlausibleOrder>& plausible_orders() {
  static constexpr const char* mean = "a mean does not exceed the largest value";
  static constexpr const char* part = "a quantile does not exceed the largest value";
  static const std::vector<PlausibleOrder> orders = {
      {"race_sliding_speed_rms", "race_sliding_speed_peak", mean},
      {"whirl_radius_ratio_mean", "whirl_radius_ratio_peak", mean},
      {"whirl_radius_ratio_p95", "whirl_radius_ratio_peak", part},
      {"pocket_force_rms_N", "pocket_force_peak_N", mean},
      {"pocket_force_p99_N", "pocket_force_peak_N", part},
      {"guide_force_rms_N", "guide_force_peak_N", mean},
      {"guide_force_p99_N", "guide_force_peak_N", part},
      {"end_force_rms_N", "end_force_peak_N", mean},
      {"end_force_p99_N", "end_force_peak_N", part},
      {"ring_acceleration_rms_m_s2", "ring_acceleration_peak_m_s2", mean},
      {"cage_stress_rms_MPa", "cage_stress_peak_MPa", mean},
      {"cage_stress_p99_MPa", "cage_stress_peak_MPa", part},
  };
  return orders;
}

std::string find_implausible(const PlausibleReach& reach, const std::vector<double>& quantities) {
  const auto number = [](double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", x);
    return std::string(text);
  };
  const auto value = [&](const char* key) {
    return quantities[static_cast<std::size_t>(quantity_index(key))];
  };
  const auto said = [&](const char* key, double x) {
    const std::string unit = quantity_table()[static_cast<std::size_t>(quantity_index(key))].unit;
    return std::string(key) + " = " + number(x) + (unit == "-" ? "" : " " + unit);
  };
  for (const PlausibleRow& row : plausible_rows()) {
    const double x = value(row.key);
    const bool given = std::isfinite(x);
    if (!given && !std::isnan(x) && !reach.turns && !reach.quasi_static) continue;
    const bool expected = row.expected(reach);
    if (!given && (std::isinf(x) || expected))
      return std::string(row.key) + " is " + (std::isnan(x) ? "no number" : "infinite") +
             " where the run must give one, which is impossible: a state or a contact is not "
             "finite; remedy: " +
             row.remedy;
    if (!given) continue;
    const auto [low, high] = row.range(reach);
    if (x >= low && x <= high) continue;
    return said(row.key, x) + " is " + (x < low ? "below " : "beyond ") +
           number(x < low ? low : high) + ", which is impossible: " + row.reason +
           "; remedy: " + row.remedy;
  }
  const double whirl = value("whirl_radius_ratio_peak"),
               held = reach.whirl_under(value("guide_force_peak_N"), value("pocket_force_peak_N")) /
                      reach.guide_clearance;
  if (whirl > held)
    return said("whirl_radius_ratio_peak", whirl) + " is beyond " + number(held) +
           ", which is impossible: the cage would have left its guide, which gives way less under "
           "the forces of this run; remedy: " +
           kGuide;
  for (const PlausibleOrder& order : plausible_orders()) {
    if (reach.peaks_in_part && !is_extreme(order.lesser)) continue;  // a mean goes on
    const double x = value(order.lesser), most = value(order.greater);
    if (std::isfinite(x) && std::isfinite(most) && x > kOrderMargin * most)
      return said(order.lesser, x) + " is beyond " + said(order.greater, most) +
             ", which is impossible: " + order.reason + "; remedy: " + kTighten;
  }
  return {};
}

}  // namespace cagetol
