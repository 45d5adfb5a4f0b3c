#include "src/quantities/operating_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/input/unit.hpp"
#include "src/model/bearing_model.hpp"
#include "src/quantities/load_rating.hpp"
#include "src/statics/start_state.hpp"
#include "src/statics/static_equilibrium.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kRpm = pi / 30;                // [rad/s]
constexpr int kPositionsPerPitch = 32;          // the load zone is resolved to this part of a pitch
constexpr double kLoadedShare = 0.01;           // of the load: a roller in the load zone
constexpr double kFastest = 3e6 * 1e-3 * kRpm;  // n d_m of the fastest bearings in service [m/s]
constexpr double kLifeShare = 0.5;              // of C: the largest load of ISO 281

/// Of the nominal rollers.
RatedRollers rated_rollers(const Scene& scene) {
  double diameter = 0;
  for (long j = 0; j < scene.bearing.roller_count; ++j) diameter += each(scene.roller.diameter, j);
  return {scene.bearing.roller_count, diameter / static_cast<double>(scene.bearing.roller_count),
          scene.roller.length, 2 * pitch_radius(scene.bearing)};
}

/// All that needs neither model nor equilibrium.
OperatingPoint rated_point(const Scene& scene) {
  const BearingGeometry& b = scene.bearing;
  const RatedRollers rollers = rated_rollers(scene);
  OperatingPoint at{};
  at.dynamic_rating = given_or(b.dynamic_rating, dynamic_rating(rollers));
  at.static_rating = given_or(b.static_rating, static_rating(rollers));
  const Duty duty = make_duty(scene.operation);
  at.load = largest_load(duty);
  at.speed = std::abs(duty.speed.inner - duty.speed.outer);
  at.life = rating_life(at.dynamic_rating, at.load);
  at.life_time = 2 * pi * at.life / at.speed;
  at.least_load_schaeffler = least_load_schaeffler(at.static_rating);
  at.least_load_skf = least_load_skf(b.least_load_factor, at.speed / b.reference_speed,
                                     (b.bore_diameter + b.outside_diameter) / 2);
  at.pitch_diameter = rollers.pitch_diameter;
  at.limiting_speed = b.limiting_speed;
  at.flange_clearance = b.flange_clearance;
  return at;
}

void add_clearances(const Scene& scene, const BearingModel& m, OperatingPoint& at) {
  at.internal_clearance = at.pocket_width_clearance = at.pocket_length_clearance =
      std::numeric_limits<double>::infinity();
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const double roller = each(scene.roller.diameter, j);
    at.internal_clearance =
        std::min(at.internal_clearance, 2 * (m.outer_radius - m.inner_radius - roller));
    at.pocket_width_clearance =
        std::min(at.pocket_width_clearance, each(scene.cage.pocket_width, j) - roller);
    at.pocket_length_clearance = std::min(at.pocket_length_clearance,
                                          each(scene.cage.pocket_length, j) - scene.roller.length);
  }
  at.guide_clearance = m.guide_clearance;
  at.cage_mass = m.cage_mass;
  at.roller_mass = m.groups.front().mass[0];
}

void add_kinematics(const BearingModel& m, OperatingPoint& at) {
  at.cage_speed = kinematic_cage_speed(m, m.duty.speed);
  const double rolling = (m.duty.speed.inner - at.cage_speed) * m.inner_radius;
  at.roller_speed = 2 * rolling / m.nominal_diameter;
  at.roller_spin = at.cage_speed - at.roller_speed;
  at.entrainment = std::abs(rolling);
}

/// Load zone, heaviest roller and contacts over one pitch of the rollers.
void add_load_distribution(const BearingModel& m, OperatingPoint& at) {
  at.roller_load = at.race_pressure = at.load_zone = at.film = at.lambda = kNone;
  StaticEquilibrium equilibrium(m);
  double heaviest = 0, inner = 0, outer = 0;
  long loaded = 0;
  for (int k = 0; k < kPositionsPerPitch; ++k) {
    const double turned = 2 * pi * k / kPositionsPerPitch / m.layout.rollers;
    const StaticState& rest =
        equilibrium.solve(roller_angles(m, turned).data(), at.cage_speed, heaviest_load(m.duty));
    if (!rest.converged) return;
    for (std::size_t j = 0; j < static_cast<std::size_t>(m.layout.rollers); ++j) {
      heaviest = std::max(heaviest, rest.inner_force[j]);
      inner = std::max(inner, rest.inner_slice[j]);
      outer = std::max(outer, rest.outer_slice[j]);
      if (rest.inner_force[j] > kLoadedShare * at.load) ++loaded;
    }
  }
  at.roller_load = heaviest;
  at.race_pressure = race_pressure(m, inner, outer);
  at.load_zone = 2 * pi * static_cast<double>(loaded) / (kPositionsPerPitch * m.layout.rollers);
  if (!m.lubricated || !(inner > 0)) return;
  at.film = film_thickness(m.inner_line.film, inner / slice_length(m), film_speed(at.entrainment));
  at.lambda = at.film / m.inner_line.traction.roughness;
}

std::string rounded(double value, const std::string& unit) {
  const double step = std::pow(10, std::floor(std::log10(value)) - 2);
  return number_text(value >= 100 ? std::round(value) : std::round(value / step) * step) + " " +
         unit;
}

}  // namespace

OperatingPoint operating_point(const Scene& scene) {
  OperatingPoint at = rated_point(scene);
  const BearingModel model = make_bearing_model(scene);
  add_clearances(scene, model, at);
  add_kinematics(model, at);
  add_load_distribution(model, at);
  return at;
}

// clang-format off
const std::vector<OperatingRow>& operating_rows() {
  using At = const OperatingPoint&;
  static const std::vector<OperatingRow> rows = {
      {"dynamic_rating_kN", "kN", "basic dynamic load rating C: bearing.dynamic_rating_kN, else by ISO 281", [](At p) { return 1e-3 * p.dynamic_rating; }},
      {"static_rating_kN", "kN", "basic static load rating C0: bearing.static_rating_kN, else by ISO 76", [](At p) { return 1e-3 * p.static_rating; }},
      {"equivalent_load_N", "N", "equivalent load P: radial load, rotating load and unbalance where they add up", [](At p) { return p.load; }},
      {"rating_ratio", "-", "C/P", [](At p) { return p.dynamic_rating / p.load; }},
      {"static_safety", "-", "C0/P0", [](At p) { return p.static_rating / p.load; }},
      {"life_L10_Mrev", "1e6 rev", "basic rating life L10 of ISO 281, in millions of revolutions: reached by 90 % of bearings", [](At p) { return 1e-6 * p.life; }},
      {"life_L10_h", "h", "the same life at the speed of one ring against the other", [](At p) { return p.life_time / 3600; }},
      {"least_load_skf_N", "N", "least load by SKF's rule; where bearing.least_load_factor and bearing.reference_speed_rpm are given", [](At p) { return p.least_load_skf; }},
      {"least_load_schaeffler_N", "N", "least load by Schaeffler's rule, C0/60", [](At p) { return p.least_load_schaeffler; }},
      {"roller_load_max_N", "N", "largest force of a roller on the inner race in static equilibrium, over positions of the rollers", [](At p) { return p.roller_load; }},
      {"race_pressure_max_MPa", "MPa", "largest Hertzian pressure of a slice at either race, likewise", [](At p) { return 1e-6 * p.race_pressure; }},
      {"load_zone_deg", "deg", "angle within which rollers carry more than 1 % of the load, likewise", [](At p) { return p.load_zone / (pi / 180); }},
      {"film_um", "um", "oil film at the heaviest slice of the inner race, rolling without slip", [](At p) { return 1e6 * p.film; }},
      {"lambda_ratio", "-", "the same film over the composite roughness of the races", [](At p) { return p.lambda; }},
      {"speed_factor_mm_min", "mm/min", "n d_m, n the speed of one ring against the other, d_m the diameter of the rollers' pitch circle", [](At p) { return 1e3 * p.pitch_diameter * p.speed / kRpm; }},
      {"cage_speed_rpm", "rpm", "kinematic speed of the cage", [](At p) { return p.cage_speed / kRpm; }},
      {"roller_speed_rpm", "rpm", "kinematic speed of a roller about its axis, relative to the cage, positive against the inner ring's sense", [](At p) { return p.roller_speed / kRpm; }},
      {"roller_spin_rpm", "rpm", "the same seen from outside, positive in the inner ring's sense", [](At p) { return p.roller_spin / kRpm; }},
      {"entrainment_speed_m_s", "m/s", "speed at which the inner race and a roller carry oil into their contact", [](At p) { return p.entrainment; }},
      {"internal_clearance_um", "um", "diametral clearance that raceways and rollers leave, of the thickest roller", [](At p) { return 1e6 * p.internal_clearance; }},
      {"pocket_width_clearance_um", "um", "pocket width less roller diameter, least over pockets", [](At p) { return 1e6 * p.pocket_width_clearance; }},
      {"pocket_length_clearance_um", "um", "pocket length less roller length, least over pockets", [](At p) { return 1e6 * p.pocket_length_clearance; }},
      {"guide_clearance_um", "um", "radial clearance of the cage in what guides it", [](At p) { return 1e6 * p.guide_clearance; }},
      {"flange_clearance_um", "um", "axial clearance of a roller between its flanges", [](At p) { return 1e6 * p.flange_clearance; }},
      {"cage_mass_g", "g", "mass of the cage", [](At p) { return 1e3 * p.cage_mass; }},
      {"roller_mass_g", "g", "mass of a roller", [](At p) { return 1e3 * p.roller_mass; }},
  };
  return rows;
}
// clang-format on

std::vector<std::string> operating_warnings(const Scene& scene) {
  const OperatingPoint at = rated_point(scene);
  std::vector<std::string> warnings;
  const auto force = [](double newtons) {
    return newtons >= 1e4 ? rounded(1e-3 * newtons, "kN") : rounded(newtons, "N");
  };
  const bool turns = make_duty(scene.operation).load_turns();
  const std::string load =
      (turns ? "the radial load in all, " : "load.radial_N = ") + force(at.load);
  if (at.load > at.static_rating)
    warnings.push_back(load + " is above the static load rating C0 = " + force(at.static_rating) +
                       ": races and rollers yield (ISO 76)");
  if (at.load > at.dynamic_rating)
    warnings.push_back(load + " is above the dynamic load rating C = " + force(at.dynamic_rating) +
                       ": less than a million revolutions of rating life (ISO 281)");
  else if (at.load > kLifeShare * at.dynamic_rating)
    warnings.push_back(load + " is above half the dynamic load rating C = " +
                       force(at.dynamic_rating) + ": rating life does not hold there (ISO 281)");
  const std::string speed =
      (scene.operation.outer_speed != 0 ? "the speed of one ring against the other, "
                                        : "speed.inner_rpm = ") +
      std::to_string(std::lround(at.speed / kRpm));
  if (at.speed > at.limiting_speed)
    warnings.push_back(speed + " is above bearing.limiting_speed_rpm = " +
                       std::to_string(std::lround(at.limiting_speed / kRpm)));
  else if (std::isnan(at.limiting_speed) && at.speed * at.pitch_diameter > kFastest)
    warnings.push_back(
        speed + " makes n d_m = " + rounded(1e3 * at.speed * at.pitch_diameter / kRpm, "mm/min") +
        ": bearings of aircraft engines, the fastest in service, reach some 3 "
        "million");
  if (at.speed == 0) return warnings;
  if (at.load < at.least_load_skf)
    warnings.push_back(load + " is below the least load by SKF's rule, " +
                       force(at.least_load_skf) +
                       " = k_r (6 + 4 n/n_ref) (d_m/100)^2: rollers and cage may skid");
  else if (std::isnan(at.least_load_skf) && at.load < at.least_load_schaeffler)
    warnings.push_back(load + " is below the least load by Schaeffler's rule, " +
                       force(at.least_load_schaeffler) + " = C0/60: rollers and cage may skid");
  return warnings;
}

}  // namespace cagetol
