// The rows of the table of quantities as a constant: quantity_row("KEY") is an index known at
// compile time, and an unknown key does not compile. Only the code that computes the quantities
// needs this; all other code uses quantity_table.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "src/quantities/quantity_table.hpp"

namespace cagetol {

namespace need {
extern const Need any, motion, loaded, turning, turning_loaded, whole_turns, whirl, tilting,
    flexible, oil, heat;
}
namespace bound {
extern const Bound finite, not_negative, share, slip, circle, lean, whirl, axial, ring_place,
    ring_orbit, ring_acceleration, loss, stress, pocket, station;
}

inline constexpr auto kQuantityRows = std::to_array<Quantity>({
    {"cage_slip_ratio", "-", Kind::mean, need::turning, bound::finite,
     "speed of the cage; moves with a cage that hangs off centre",
     "1 - w_c/w_k: w_c mean speed of the cage, w_k = w_i R_i/(R_i + R_o) its speed without slip, R "
     "radii of the raceways in operation; no value at standstill; under a duty over time both are "
     "means, counted along the turning of rolling without slip"},
    {"driving_slip_ratio", "-", Kind::mean, need::turning_loaded, bound::finite,
     "limit against skidding",
     "1 - w_r/w_k: w_r mean orbital rate of the rollers, weighted by their inner-race force, w_k "
     "the cage's speed without slip (cage_slip_ratio): the slip of those that drive, which a cage "
     "that hangs off centre does not touch"},
    {"roller_slip_ratio_loaded", "-", Kind::mean, need::turning_loaded, bound::slip,
     "comparison with published slip",
     "mean of 1 - |w_s - theta'|/w_kin over rollers whose inner-race force exceeds 1 % of the "
     "load; w_kin = w_i (d_m/2D)(1 - (D/d_m)^2), spin relative to the cage's orbit"},
    {"roller_slip_ratio_all", "-", Kind::mean, need::turning, bound::slip,
     "comparison with published slip",
     "mean over all rollers of 1 - |w_s - theta'|/w_kin (roller_slip_ratio_loaded)"},
    {"race_sliding_speed_rms", "m/s", Kind::mean, need::loaded, bound::not_negative,
     "smearing and wear of races", "rms sliding speed at loaded inner-race contacts",
     "race_sliding_speed_peak"},
    {"race_sliding_speed_peak", "m/s", Kind::peak, need::loaded, bound::not_negative,
     "smearing and wear of races",
     "largest sliding speed at loaded inner-race contacts over every accepted step, and where they "
     "come to bear load or cease to"},
    {"race_friction_peak_W", "W", Kind::peak, need::motion, bound::not_negative,
     "smearing of races",
     "largest value of a roller's power of sliding on the inner race over every accepted step"},
    {"whirl_radius_ratio_mean", "-", Kind::mean, need::motion, bound::whirl,
     "how far the cage uses up its guide clearance; cage stability",
     "mean radius of the cage centre over the radial guide clearance", "whirl_radius_ratio_peak"},
    {"whirl_radius_ratio_p95", "-", Kind::peak, need::motion, bound::not_negative,
     "how far the cage uses up its guide clearance; cage stability",
     "95 % quantile over time of the radius of the cage centre over the radial guide clearance",
     "whirl_radius_ratio_peak"},
    {"whirl_radius_ratio_peak", "-", Kind::peak, need::motion, bound::whirl,
     "how far the cage uses up its guide clearance; cage stability",
     "largest value over every accepted step of the radius of the cage centre over the radial "
     "guide clearance"},
    {"whirl_frequency_ratio", "-", Kind::mean, need::turning, bound::finite,
     "sense and rate of whirl",
     "mean angular rate of the cage centre's orbit about the middle over the mean cage speed: "
     "positive forward, negative backward, near zero where the centre stays on one side"},
    {"whirl_ratio", "-", Kind::mean, need::whirl, bound::not_negative, "limit on cage stability",
     "rms amplitude of the cage centre's motion at beyond 1.5 of the cage's speed, forward and "
     "backward, over the least of guide clearance and half the pockets' clearance of the nominal "
     "bearing (window.whirl_clearance_um); a place at rest and what turns with the cage or with a "
     "turning load are taken off by least squares, and the rest is taken through a Hann window. "
     "Above 0.5 the cage whirls"},
    {"whirl_load_line_ratio", "-", Kind::mean, need::whirl, bound::not_negative,
     "whether whirl can be told from a turning load",
     "the part of whirl_ratio within two lines of the spectrum about the speed of a turning load"},
    {"whirl_circling_ratio", "-", Kind::mean, need::whirl, bound::not_negative,
     "a cage that circles at its own speed: its unbalance, or nothing that holds it",
     "rms amplitude of the cage centre's motion at 0.8 to 1.2 of the cage's speed, forward, over "
     "the "
     "clearance of whirl_ratio"},
    {"whirl_strongest_speed_ratio", "-", Kind::mean, need::whirl, bound::finite,
     "sense and rate of whirl",
     "speed at which the spectrum of whirl_ratio is largest, over the cage's: negative backward"},
    {"whirl_scatter_ratio", "-", Kind::mean, need::motion, bound::whirl,
     "how far the cage's centre moves; stability of dry cages",
     "rms distance of the cage centre from its mean place over the radial guide clearance: near "
     "zero where it rests, on its guide or anywhere, near one where it circles along the guide"},
    {"whirl_resting_share", "-", Kind::mean, need::whole_turns, bound::share,
     "kind of the cage's motion, for comparison with tests",
     "share of the whole cage revolutions in which the centre rests (rms distance from its mean "
     "place of that revolution below a quarter of the clearance); kinds of motion of Schwarz et "
     "al. 2022 (doi 10.1080/10402004.2021.1934618), bounds ours"},
    {"whirl_circling_share", "-", Kind::mean, need::whole_turns, bound::share,
     "kind of the cage's motion, for comparison with tests",
     "share of the whole cage revolutions in which the centre circles (not at rest, round the "
     "middle by more than a tenth of a turn, "
     "standard deviation of its radius below a quarter of the mean)"},
    {"whirl_irregular_share", "-", Kind::mean, need::whole_turns, bound::share,
     "kind of the cage's motion, for comparison with tests",
     "share of the whole cage revolutions in which the centre neither rests nor circles"},
    {"pocket_force_rms_N", "N", Kind::mean, need::motion, bound::not_negative,
     "load of the bars: limit on forces, ranking of cages",
     "rms over time and rollers of the normal force of a roller on its pocket's bars",
     "pocket_force_peak_N"},
    {"pocket_force_p99_N", "N", Kind::peak, need::motion, bound::not_negative,
     "load of the bars: limit on forces, ranking of cages",
     "99 % quantile over time and rollers of the normal force of a roller on its pocket's bars, "
     "zeros included",
     "pocket_force_peak_N"},
    {"pocket_force_peak_N", "N", Kind::peak, need::motion, bound::not_negative,
     "load of the bars: limit on forces, ranking of cages",
     "largest value over every accepted step of the normal force of a roller on its pocket's bars"},
    {"pocket_impacts_per_revolution", "1/rev", Kind::mean, need::motion, bound::not_negative,
     "rattle; how often contacts open", "closings of roller-bar contacts per cage revolution"},
    {"pocket_impulse_N_s", "N s", Kind::mean, need::turning, bound::not_negative,
     "wear of pockets, relative between cages",
     "impulse of a roller on the bars of its pocket in one cage revolution: normal force, films "
     "included, over time; mean over pockets. A measure of wear: that of a traction motor's cage "
     "was found to go with it (Suzuki et al. 2023, doi 10.3390/machines11060594)"},
    {"pocket_friction_work_J", "J", Kind::mean, need::turning, bound::finite,
     "wear of pockets, relative between cages",
     "work of friction between a roller and the bars of its pocket in one cage revolution, mean "
     "over pockets"},
    {"guide_force_rms_N", "N", Kind::mean, need::motion, bound::not_negative,
     "load and wear of lands",
     "rms over time of the normal force between cage lands and guiding ring, both lands; where a "
     "guide film is modelled, of its pressure and the contact's force together",
     "guide_force_peak_N"},
    {"guide_force_p99_N", "N", Kind::peak, need::motion, bound::not_negative,
     "load and wear of lands",
     "99 % quantile over time of the normal force between cage lands and guiding ring, both lands",
     "guide_force_peak_N"},
    {"guide_force_peak_N", "N", Kind::peak, need::motion, bound::not_negative,
     "load and wear of lands",
     "largest value over every accepted step of the normal force between cage lands and guiding "
     "ring, both lands"},
    {"guide_force_unbalance_g_mm", "g mm", Kind::mean, need::turning, bound::not_negative,
     "unbalance that a cage may have",
     "unbalance of the cage whose centrifugal force at the cage's mean speed equals the mean guide "
     "force: a cage with more turns round its guide with its own unbalance"},
    {"guide_impacts_per_revolution", "1/rev", Kind::mean, need::motion, bound::not_negative,
     "rattle; how often contacts open", "closings of land contacts per cage revolution"},
    {"end_force_rms_N", "N", Kind::mean, need::motion, bound::not_negative,
     "whether the pocket's length matters",
     "rms over time and rollers of the force of a roller's ends on its pocket's side ring faces",
     "end_force_peak_N"},
    {"end_force_p99_N", "N", Kind::peak, need::motion, bound::not_negative,
     "whether the pocket's length matters",
     "99 % quantile over time and rollers of the force of a roller's ends on its pocket's side "
     "ring "
     "faces, zeros included",
     "end_force_peak_N"},
    {"end_force_peak_N", "N", Kind::peak, need::motion, bound::not_negative,
     "whether the pocket's length matters",
     "largest value over every accepted step of the force of a roller's ends on its pocket's side "
     "ring faces"},
    {"end_impacts_per_revolution", "1/rev", Kind::mean, need::motion, bound::not_negative,
     "rattle; how often contacts open", "closings of side-ring-face contacts per cage revolution"},
    {"cage_speed_std_ratio", "-", Kind::mean, need::turning, bound::not_negative,
     "smoothness of the cage's rotation",
     "standard deviation over mean of the cage's rotational speed"},
    {"cage_axial_std_um", "um", Kind::mean, need::motion, bound::axial,
     "motion of the cage out of its plane", "standard deviation of the cage's axial place"},
    {"cage_tilt_std_mrad", "mrad", Kind::mean, need::motion, bound::lean,
     "motion of the cage out of its plane",
     "root of the summed variances of the cage axis' two lean angles"},
    {"roller_load_peak_N", "N", Kind::peak, need::motion, bound::not_negative,
     "load distribution, beside that of statics (cagetol check)",
     "largest value of a roller's force on the inner race over every accepted step"},
    {"race_pressure_peak_MPa", "MPa", Kind::peak, need::motion, bound::not_negative,
     "load distribution, beside that of statics (cagetol check)",
     "largest value of the Hertzian pressure of a roller's slice at either race over every "
     "accepted step"},
    {"load_zone_mean_deg", "deg", Kind::mean, need::motion, bound::circle,
     "load distribution, beside that of statics (cagetol check)",
     "mean share of the rollers whose inner-race force exceeds 1 % of the load, as an angle"},
    {"ring_displacement_mean_um", "um", Kind::mean, need::any, bound::ring_place,
     "stiffness of the bearing, place of the shaft",
     "mean displacement of the inner ring along the load"},
    {"ring_displacement_end_um", "um", Kind::mean, need::any, bound::ring_place,
     "stiffness of the bearing, place of the shaft",
     "displacement of the inner ring along the load at the end of the window"},
    {"ring_orbit_p95_um", "um", Kind::peak, need::any, bound::ring_orbit, "running accuracy",
     "95 % quantile over time of the inner ring's distance from its mean place"},
    {"ring_acceleration_rms_m_s2", "m/s2", Kind::mean, need::motion, bound::not_negative,
     "vibration", "rms of the inner ring's acceleration", "ring_acceleration_peak_m_s2"},
    {"ring_acceleration_peak_m_s2", "m/s2", Kind::peak, need::motion, bound::ring_acceleration,
     "vibration", "largest acceleration of the inner ring over every accepted step"},
    {"ring_tilt_mean_mrad", "mrad", Kind::mean, need::any, bound::lean, "misalignment that results",
     "mean angle between the inner ring's centre line and the bearing's axis; the misalignment "
     "where the tilt is prescribed"},
    {"ring_tilt_std_mrad", "mrad", Kind::mean, need::tilting, bound::lean, "wobble of the ring",
     "root of the summed variances of the slopes of the inner ring's centre line"},
    {"roller_speed_std_ratio", "-", Kind::mean, need::turning, bound::not_negative,
     "acceleration of rollers in and out of the load zone",
     "standard deviation over mean of the rollers' absolute spin, over time and rollers"},
    {"roller_skew_rms_mrad", "mrad", Kind::mean, need::motion, bound::lean,
     "end and flange wear, effect of squareness", "rms over time and rollers of the skew a.e_t"},
    {"roller_skew_p95_mrad", "mrad", Kind::peak, need::motion, bound::lean,
     "end and flange wear, effect of squareness", "95 % quantile over time and rollers of |skew|"},
    {"roller_tilt_p95_mrad", "mrad", Kind::peak, need::any, bound::lean, "edge load of rollers",
     "95 % quantile over time and rollers of |tilt|, tilt = a.e_r"},
    {"power_loss_W", "W", Kind::power, need::motion, bound::loss, "heat, and where it arises",
     "mean dissipation of all contacts, films and churning; the sum of the rows that follow"},
    {"power_race_sliding_W", "W", Kind::power, need::motion, bound::finite,
     "heat, and where it arises", "of it, sliding of rollers on races"},
    {"power_rolling_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, hydrodynamic rolling resistance of the races"},
    {"power_pocket_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, sliding and rolling of rollers on the bars of their pockets"},
    {"power_end_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, sliding of roller ends on the side ring faces of their pockets"},
    {"power_flange_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, sliding of roller ends on the ring's flanges"},
    {"power_land_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, friction and guide film of the cage's lands"},
    {"power_churning_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, drag of oil and air on rollers and cage"},
    {"power_squeeze_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, squeezing oil out of contacts"},
    {"power_damping_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, damping in contacts and in a flexible cage"},
    {"power_film_W", "W", Kind::power, need::motion, bound::finite, "heat, and where it arises",
     "of it, what steady films and the bodies' elasticity in series with them take: of either "
     "sign, because a film's force follows the speed of its surfaces"},
    {"friction_torque_Nmm", "N mm", Kind::power, need::motion, bound::finite, "limit on friction",
     "mean torque that drives the inner ring; under a duty over time the mean power of the drive "
     "over the mean speed of one ring against the other: negative where parts that slow down drive "
     "the ring"},
    {"operating_temperature_C", "degC", Kind::power, need::heat, bound::finite, "limit on heat",
     "temperature of outer ring and oil at which the bearing would shed the power that it loses, "
     "by the slopes at the nominal bearing's; the run itself has that of the nominal bearing"},
    {"heat_shed_W", "W", Kind::power, need::heat, bound::finite, "limit on heat",
     "heat that the bearing sheds there"},
    {"cage_stress_peak_MPa", "MPa", Kind::peak, need::flexible, bound::stress,
     "stress of the cage, ranking of cages",
     "largest von Mises stress of a flexible cage over its stress stations and every accepted "
     "step; modes and the static rest of bar forces and turning. Bars and the fillets of pocket "
     "corners (cage.corner_radius_mm) have a fine mesh of their own"},
    {"cage_stress_p99_MPa", "MPa", Kind::peak, need::flexible, bound::not_negative,
     "stress of the cage, ranking of cages",
     "99 % quantile over time (at most 100 us apart) of the largest stress over the cage",
     "cage_stress_peak_MPa"},
    {"cage_stress_rms_MPa", "MPa", Kind::mean, need::flexible, bound::not_negative,
     "stress of the cage, ranking of cages",
     "rms over time (at most 100 us apart) of the largest stress over the cage",
     "cage_stress_peak_MPa"},
    {"cage_stress_peak_pocket", "-", Kind::place, need::flexible, bound::pocket, "where it happens",
     "pocket beside which the peak stress sits, counted from 0 (sector between bar middles)",
     "cage_stress_peak_MPa"},
    {"cage_stress_peak_station", "-", Kind::place, need::flexible, bound::station,
     "where it happens",
     "stress station of the peak in its sector; `cagetol cage` names the stations",
     "cage_stress_peak_MPa"},
    {"cage_fatigue_utilisation", "-", Kind::peak, need::flexible, bound::not_negative,
     "limit on fatigue of the cage: below 1, with the safety asked for",
     "largest utilisation of the cage's fatigue strength over its stress stations, by the modified "
     "Goodman line: sigma_a/sigma_w + sigma_m/R_m; sigma_a: von Mises stress of the amplitudes "
     "+-(max - min)/2 of the stress components over a cage revolution (minus: they swing against "
     "the widest one), its 99 % quantile over revolutions, of fewer than 100 the largest; sigma_m: "
     "largest principal stress of the mean (max + min)/2 of the components, not below zero; taken "
     "at most 100 us apart and where a bar's force peaks"},
    {"cage_fatigue_pocket", "-", Kind::place, need::flexible, bound::pocket, "where it happens",
     "pocket beside which the largest fatigue utilisation sits, counted from 0 (as "
     "cage_stress_peak_pocket)",
     "cage_fatigue_utilisation"},
    {"cage_fatigue_station", "-", Kind::place, need::flexible, bound::station, "where it happens",
     "stress station of the largest value of fatigue utilisation in its sector",
     "cage_fatigue_utilisation"},
    {"cage_strength_utilisation", "-", Kind::peak, need::flexible, bound::not_negative,
     "limit on yielding of the cage",
     "cage_stress_peak_MPa over the yield stress of the cage's material"},
    {"film_min_um", "um", Kind::minimum, need::oil, bound::not_negative, "film thickness",
     "thinnest oil film of loaded race contacts over every accepted step"},
    {"lambda_min_ratio", "-", Kind::minimum, need::oil, bound::not_negative,
     "lubrication regime: mixed below 1 to 3",
     "thinnest oil film (film_min_um) over the composite roughness of roller and race"},
    {"static_consistency_error", "-", Kind::mean, need::motion, bound::not_negative,
     "health of the run",
     "the larger of: mean elastic force on the ring against the quasi-static one (the load, less "
     "what the normal law's damping carries as rollers go round; relative to the load, or to the "
     "couple at the rollers' ends that rights a ring whose tilt is free, or to a roller's mean "
     "force under preload, if that is more); mean ring displacement against the quasi-static one "
     "over equal roller positions (relative; below the centrifugal force of one roller only the "
     "force counts, relative to it)"},
});

/// Row of the quantity whose key is `key` followed by `suffix`.
consteval std::size_t quantity_row(std::string_view key, std::string_view suffix = "") {
  for (std::size_t i = 0; i < kQuantityRows.size(); ++i) {
    const std::string_view known = kQuantityRows[i].key;
    if (known.starts_with(key) && known.substr(key.size()) == suffix) return i;
  }
  throw std::logic_error("no such quantity");
}

}  // namespace cagetol
