#include "src/quantities/quantity_guide.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace cagetol {
namespace {

constexpr double kBlocks = 5;  // revolutions from which peaks are extrapolated, at least

bool moves(const Scene& s) {
  return !is_quasi_static(s);
}
bool turns(const Scene& s) {
  return moves(s) &&
         (largest_inner_speed(s.operation) != 0 || largest_outer_speed(s.operation) != 0);
}
bool extrapolates(const Scene& s) {
  return moves(s) && !std::isnan(s.window.extrapolate_revolutions) &&
         s.window.measure_revolutions >= kBlocks;
}

struct Need {
  const char* text;
  bool (*met)(const Scene&);
};
constexpr Need kAny{"any model", [](const Scene&) { return true; }};
constexpr Need kMotion{"model.motion = \"dynamic\"", moves};
constexpr Need kTurning{"model.motion = \"dynamic\"; speed.inner_rpm not zero", turns};
constexpr Need kWholeTurns{
    "model.motion = \"dynamic\"; at least one whole cage revolution measured",
    [](const Scene& s) { return turns(s) && s.window.measure_revolutions >= 1; }};
constexpr Need kSpatial{"model.rollers = \"spatial\"",
                        [](const Scene& s) { return !has_planar_rollers(s); }};
constexpr Need kLeaning{"model.motion = \"dynamic\"; model.rollers = \"spatial\"",
                        [](const Scene& s) { return moves(s) && !has_planar_rollers(s); }};
constexpr Need kTilting{
    "model.motion = \"dynamic\"; model.ring_tilt = \"free\"; model.rollers = \"spatial\"",
    [](const Scene& s) { return moves(s) && has_free_ring_tilt(s); }};
constexpr Need kFlexible{"cage.model = \"flexible\"", is_flexible};
constexpr Need kFilm{
    "model.motion = \"dynamic\"; lubrication.model = \"film\" or a film.model; loaded contacts",
    [](const Scene& s) {
      return moves(s) && (is_lubricated(s) || s.film.model != FilmModel::none);
    }};
constexpr Need kOil{"model.motion = \"dynamic\"; lubrication.model = \"film\"; loaded contacts",
                    [](const Scene& s) { return moves(s) && is_lubricated(s); }};
constexpr Need kExtrapolated{
    "model.motion = \"dynamic\"; window.extrapolate_revolutions; at least 5 revolutions measured",
    extrapolates};
constexpr Need kExtrapolatedStress{
    "cage.model = \"flexible\"; window.extrapolate_revolutions; at least 5 revolutions measured",
    [](const Scene& s) { return extrapolates(s) && is_flexible(s); }};

/// Keys, beginnings of keys ("end_*") or parts of keys ("*_part_*"). The first that fits counts.
struct Row {
  std::vector<std::string_view> keys;
  Need need;
  const char* use;
};

// clang-format off
const std::vector<Row>& rows() {
  static const std::vector<Row> all = {
      {{"cage_slip_ratio"}, kTurning, "speed of the cage; moves with a cage that hangs off centre"},
      {{"orbit_slip_ratio"}, kTurning, "limit against skidding"},
      {{"orbit_slip_ratio_loaded"}, kTurning, "skidding of the rollers that drive the cage"},
      {{"roller_slip_ratio_*"}, kTurning, "comparison with published slip"},
      {{"race_sliding_speed_*"}, kMotion, "smearing and wear of races"},
      {{"whirl_resting_share", "whirl_circling_share", "whirl_irregular_share"}, kWholeTurns, "kind of the cage's motion, for comparison with tests"},
      {{"whirl_scatter_ratio"}, kMotion, "limit on cage stability"},
      {{"whirl_speed_deviation_ratio", "whirl_energy_ratio"}, kTurning, "cage stability as the literature measures it"},
      {{"whirl_frequency_ratio"}, kTurning, "sense and rate of whirl"},
      {{"whirl_*"}, kMotion, "how far the cage uses up its guide clearance; cage stability"},
      {{"*_peak_extrapolated_*"}, kExtrapolated, "limit on a peak over more revolutions than a run measures"},
      {{"pocket_force_*"}, kMotion, "load of the bars: limit on forces, ranking of cages"},
      {{"pocket_impulse_N_s", "pocket_friction_work_J"}, kTurning, "wear of pockets, relative between cages"},
      {{"pocket_impacts_per_revolution", "guide_impacts_per_revolution", "end_impacts_per_revolution"}, kMotion, "rattle; how often contacts open"},
      {{"guide_force_*"}, kMotion, "load and wear of lands"},
      {{"end_force_*"}, kMotion, "whether the pocket's length matters"},
      {{"cage_speed_std_ratio"}, kTurning, "smoothness of the cage's rotation"},
      {{"cage_axial_std_um", "cage_tilt_std_mrad"}, kMotion, "motion of the cage out of its plane"},
      {{"roller_load_peak_N", "race_pressure_peak_MPa", "load_zone_mean_deg"}, kMotion, "load distribution, beside that of statics (cagetol check)"},
      {{"ring_displacement_*"}, kAny, "stiffness of the bearing, place of the shaft"},
      {{"ring_orbit_p95_um"}, kAny, "running accuracy"},
      {{"ring_acceleration_*"}, kMotion, "vibration"},
      {{"ring_tilt_mean_mrad"}, kSpatial, "misalignment that results"},
      {{"ring_tilt_std_mrad"}, kTilting, "wobble of the ring"},
      {{"roller_speed_std_ratio"}, kTurning, "acceleration of rollers in and out of the load zone"},
      {{"roller_skew_*"}, kLeaning, "end and flange wear, effect of squareness"},
      {{"roller_tilt_p95_mrad"}, kSpatial, "edge load of rollers"},
      {{"power_pocket_W", "power_end_W", "power_land_W"}, kMotion, "heat, and where it arises"},
      {{"power_*"}, kMotion, "heat, and where it arises"},
      {{"friction_torque_Nmm"}, kMotion, "limit on friction"},
      {{"cage_fatigue_utilisation"}, kFlexible, "limit on fatigue of the cage: below 1, with the safety asked for"},
      {{"cage_yield_utilisation"}, kFlexible, "limit on yielding of the cage"},
      {{"cage_stress_peak_pocket", "cage_stress_peak_station", "cage_fatigue_pocket", "cage_fatigue_station"}, kFlexible, "where it happens"},
      {{"cage_stress_*"}, kFlexible, "stress of the cage, ranking of cages"},
      {{"film_min_um"}, kFilm, "film thickness"},
      {{"lambda_min_ratio"}, kOil, "lubrication regime: mixed below 1 to 3"},
      {{"static_consistency_error"}, kMotion, "health of the run"},
  };
  return all;
}
// clang-format on

bool fits(std::string_view pattern, std::string_view key) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return key == pattern;
  if (star == 0) return key.find(pattern.substr(1, pattern.size() - 2)) != std::string_view::npos;
  return key.starts_with(pattern.substr(0, star));
}

}  // namespace

QuantityGuide quantity_guide(const std::string& key) {
  for (const Row& row : rows())
    for (const std::string_view pattern : row.keys) {
      if (!fits(pattern, key)) continue;
      const bool stress = row.need.met == kExtrapolated.met && key.starts_with("cage_stress");
      const Need& need = stress ? kExtrapolatedStress : row.need;
      return {need.text, need.met, row.use};
    }
  throw std::logic_error("no guide to the quantity " + key);
}

}  // namespace cagetol
