#include "src/quantities/operating_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/input/unit.hpp"
#include "src/lubrication/lubricant.hpp"
#include "src/model/bearing_model.hpp"
#include "src/quantities/load_rating.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/pocket_clearances.hpp"
#include "src/statics/start_state.hpp"
#include "src/statics/static_equilibrium.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
constexpr int kPositionsPerPitch = 32;          // the load zone is resolved to this part of a pitch
constexpr double kInLoadZone = 0.01;            // of the load: a roller in the load zone
constexpr double kFastest = 3e6 * 1e-3 * kRpm;  // n d_m of the fastest bearings in service [m/s]
constexpr double kLifeShare = 0.5;              // of C: the largest load of ISO 281

/// Of the nominal rollers.
RatedRollers rated_rollers(const Scene& scene) {
  double diameter = 0;
  for (long j = 0; j < scene.bearing.roller_count; ++j) diameter += each(scene.roller.diameter, j);
  return {scene.bearing.roller_count, diameter / static_cast<double>(scene.bearing.roller_count),
          scene.roller.length, 2 * pitch_radius(scene.bearing)};
}

/// Load of equal damage, and mean speed of one ring against the other.
struct MeanDuty {
  double load, speed;  ///< [N], [rad/s]
};
MeanDuty mean_duty(const Duty& duty) {
  MeanDuty mean{largest_load(duty), std::abs(duty.speed.inner - duty.speed.outer)};
  if (!duty.over_time()) return mean;
  constexpr int instants = 4096;
  constexpr double exponent = 10.0 / 3;
  const double begin = duty.course.rows().front().time, end = duty.course.rows().back().time;
  double turned = 0, damage = 0;
  for (int k = 0; k < instants; ++k) {
    const double t = begin + (end - begin) * (k + 0.5) / instants;
    const RingSpeeds rings = ring_speeds_at(duty, t);
    const RingLoad load = load_at(duty, t);
    const double speed = std::abs(rings.inner - rings.outer);
    turned += speed;
    damage += speed * std::pow(std::hypot(load.y, load.z), exponent);
  }
  if (turned > 0) mean = {std::pow(damage / turned, 1 / exponent), turned / instants};
  return mean;
}

/// All that needs neither model nor equilibrium.
OperatingPoint rated_point(const Scene& scene) {
  const BearingGeometry& b = scene.bearing;
  const RatedRollers rollers = rated_rollers(scene);
  OperatingPoint at{};
  at.dynamic_rating = given_or(b.dynamic_rating, dynamic_rating(rollers));
  at.static_rating = given_or(b.static_rating, static_rating(rollers));
  const Duty duty = make_duty(scene.operation);
  const MeanDuty mean = mean_duty(duty);
  at.load = mean.load;
  at.largest_load = largest_load(duty);
  at.speed = std::abs(duty.speed.inner - duty.speed.outer);
  at.temperature = scene.temperature.balance ? scene.temperature.found : kUnset;
  at.heat = scene.temperature.balance ? scene.temperature.found_power : kUnset;
  at.life = rating_life(at.dynamic_rating, at.load);
  at.life_time = 2 * pi * at.life / mean.speed;
  at.minimum_load_schaeffler = minimum_load_schaeffler(at.static_rating);
  at.minimum_load_skf = minimum_load_of(scene);
  at.pitch_diameter = rollers.pitch_diameter;
  at.limiting_speed = b.limiting_speed;
  return at;
}

double thickest_roller(const Scene& scene) {
  return *std::max_element(scene.roller.diameter.begin(), scene.roller.diameter.end());
}

/// Of a scene and the model of the same dimensions.
Clearances clearances_of(const Scene& scene, const BearingModel& m) {
  Clearances left;
  left.internal = 2 * (m.outer_radius - m.inner_radius - thickest_roller(scene));
  left.flange = scene.bearing.flange_clearance;
  left.pocket_width = left.pocket_length = std::numeric_limits<double>::infinity();
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const PocketClearances pocket = pocket_clearances(scene, j);
    left.pocket_width = std::min(left.pocket_width, pocket.tangential);
    left.pocket_length = std::min(left.pocket_length, pocket.axial);
  }
  left.guide = m.guide_clearance;
  return left;
}

/// Clearances of the parts as they are made, and what changes them.
void add_clearances(const Scene& scene, const OperatingScene& hot, const BearingModel& m,
                    OperatingPoint& at) {
  at.clearance = clearances_of(hot, m);
  Scene cold = scene;
  cold.fit = {};
  cold.cage.swelling = 0;
  cold.temperature.growth = cold.operation.centrifugal_growth = false;
  at.made_clearance =
      changes_in_operation(scene) ? clearances_of(cold, make_bearing_model(cold)) : at.clearance;
  const OperatingClearance by = operating_clearance(scene);
  const double roller = thickest_roller(scene);
  const Growth& inner = by.inner_raceway;
  at.inner_change = {0 - inner.fit, 0 - inner.heat, 0 - inner.spin};  // no change is 0, not -0
  at.outer_change = by.outer_raceway;
  at.roller_change = {0, 0 - 2 * roller * by.roller_heat, 0 - 2 * by.roller_spin};
  at.inner_fit = by.inner_fit;
  at.outer_fit = by.outer_fit;
}

void add_masses(const BearingModel& m, OperatingPoint& at) {
  at.cage_mass = m.cage_mass;
  at.roller_mass = m.groups.front().mass[0];
}

void add_kinematics(const BearingModel& m, OperatingPoint& at) {
  at.rollers = static_cast<double>(m.layout.rollers);
  at.inner_speed = m.duty.speed.inner;
  at.outer_speed = m.duty.speed.outer;
  at.cage_speed = kinematic_cage_speed(m, m.duty.speed);
  const double rolling = (m.duty.speed.inner - at.cage_speed) * m.inner_radius;
  at.roller_speed = 2 * rolling / m.nominal_diameter;
  at.roller_spin = at.cage_speed - at.roller_speed;
  at.entrainment = std::abs(rolling);
}

/// Load zone, heaviest roller and contacts over one pitch of the rollers.
void add_load_distribution(const BearingModel& m, OperatingPoint& at) {
  at.roller_load = at.race_pressure = at.load_zone = at.film = at.lambda = kUnset;
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
      if (rest.inner_force[j] > kInLoadZone * at.largest_load) ++loaded;
    }
  }
  at.roller_load = heaviest;
  at.race_pressure = race_pressure(m, inner, outer);
  at.load_zone = 2 * pi * static_cast<double>(loaded) / (kPositionsPerPitch * m.layout.rollers);
  if (!m.lubricated || !(inner > 0)) return;
  at.film = loaded_film(m.inner_line, inner / slice_length(m), film_speed(at.entrainment));
  at.lambda = at.film / m.inner_line.traction.roughness;
}

std::string rounded(double value, const std::string& unit) {
  if (value == 0) return "0 " + unit;
  const double step = std::pow(10, std::floor(std::log10(value)) - 2);
  return number_text(value >= 100 ? std::round(value) : std::round(value / step) * step) + " " +
         unit;
}

std::string micrometres(double length) {
  return number_text(std::round(1e7 * length) / 10) + " um";
}

/// Preload and fits that open.
void add_clearance_warnings(const Scene& scene, std::vector<std::string>& warnings) {
  const BearingGeometry& b = scene.bearing;
  const double made = b.outer_raceway_diameter - b.inner_raceway_diameter + b.internal_clearance -
                      2 * thickest_roller(scene);
  const OperatingClearance by = operating_clearance(scene);
  const Growth change = by.internal(thickest_roller(scene));
  if (made + change.total() < 0)
    warnings.push_back("the internal clearance in operation is " +
                       micrometres(made + change.total()) + ", a preload: as made " +
                       micrometres(made) + ", fits " + micrometres(change.fit) + ", heat " +
                       micrometres(change.heat) + ", rotation " + micrometres(change.spin));
  const auto opens = [&](double given, const FitState& fit, const char* parts, const char* key) {
    if (!(given > 0) || fit.interference > 0) return;
    warnings.push_back(std::string(parts) + " come loose in operation: of " + key + " = " +
                       micrometres(given) + " heat and rotation leave a gap of " +
                       micrometres(-fit.interference));
  };
  opens(scene.fit.inner_interference, by.inner_fit, "inner ring and shaft",
        "fit.inner_interference_um");
  opens(scene.fit.outer_interference, by.outer_fit, "outer ring and housing",
        "fit.outer_interference_um");
}

/// What makers of bearings, cages and oils do not allow, or nobody has measured.
void add_makers_warnings(const Scene& scene, std::vector<std::string>& warnings) {
  constexpr double kMostMisaligned = 4 * pi / 10800;  // 4', SKF, cylindrical roller bearings
  constexpr double kMostAxial = 0.5;                  // of the radial load: SKF, flanged rings
  constexpr double kThickest = 7500;  // an oil bath that still wets its bearing [mm2/s]
  const double misaligned = std::hypot(scene.bearing.misalignment_y, scene.bearing.misalignment_z);
  if (misaligned > kMostMisaligned)
    warnings.push_back("the rings are misaligned by " + rounded(1e3 * misaligned, "mrad") +
                       ": makers allow 4 minutes of arc, 1.16 mrad, at most");
  const AxialLoads axial = axial_loads(scene.operation);
  const double pushed = std::max(-axial.minimum, axial.greatest);
  if (const double radial = largest_radial_load(scene.operation); pushed > kMostAxial * radial)
    warnings.push_back("an axial load of " + rounded(pushed, "N") + " on a radial one of " +
                       rounded(radial, "N") + ": flanges take half the radial load at most (SKF)");
  const auto& modulus = material_named(scene.cage.material.name).young;
  if (const double hot = cage_temperature(scene); !modulus.empty() && hot > modulus.back()[0])
    warnings.push_back("the cage is at " + rounded(hot, "degC") + "; of " +
                       scene.cage.material.name + " nothing is known above " +
                       rounded(modulus.back()[0], "degC") + ": the values there are taken");
  if (scene.discretisation.race_slices < 2)
    warnings.push_back(
        "discretisation.race_slices = 1: a slice takes no moment, nothing holds the "
        "rollers against tilting");
  if (!is_lubricated(scene)) return;
  const Lubrication& oil = scene.lubrication;
  const Oil& named = lubricant_named(oil.lubricant).oil;
  const double viscosity =
      kinematic_viscosity(viscosity_curve(given_or(oil.viscosity_40, named.viscosity_40),
                                          given_or(oil.viscosity_100, named.viscosity_100)),
                          oil.temperature);
  if (std::isnan(oil.viscosity) && viscosity > kThickest)
    warnings.push_back("at " + number_text(oil.temperature) + " degC the oil has " +
                       rounded(viscosity, "mm2/s") + " and hardly flows: such a run takes long");
}

}  // namespace

double minimum_load_of(const Scene& scene) {
  const BearingGeometry& b = scene.bearing;
  const RingSpeeds speed = make_duty(scene.operation).speed;
  return minimum_load_skf(b.minimum_load_factor,
                          std::abs(speed.inner - speed.outer) / b.reference_speed,
                          (b.bore_diameter + b.outside_diameter) / 2);
}

OperatingPoint operating_point(const Scene& scene) {
  OperatingPoint at = rated_point(scene);
  const OperatingScene hot = scene;
  const BearingModel model = make_bearing_model(hot);
  add_clearances(scene, hot, model, at);
  add_masses(model, at);
  add_kinematics(model, at);
  add_load_distribution(model, at);
  return at;
}

double cage_order(const OperatingPoint& at) {
  return (at.cage_speed - at.outer_speed) / (at.inner_speed - at.outer_speed);
}

OperatingPoint with_slip(OperatingPoint at, double slip) {
  at.cage_speed *= 1 - slip;
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
      {"static_safety", "-", "C0/P0", [](At p) { return p.static_rating / p.largest_load; }},
      {"life_L10_Mrev", "1e6 rev", "basic rating life L10 of ISO 281, in millions of revolutions: reached by 90 % of bearings", [](At p) { return 1e-6 * p.life; }},
      {"life_L10_h", "h", "basic rating life L10 in hours at the speed of one ring against the other", [](At p) { return p.life_time / 3600; }},
      {"minimum_load_skf_N", "N", "minimum load by SKF's rule; where bearing.minimum_load_factor and bearing.reference_speed_rpm are given", [](At p) { return p.minimum_load_skf; }},
      {"minimum_load_schaeffler_N", "N", "minimum load by Schaeffler's rule, C0/60", [](At p) { return p.minimum_load_schaeffler; }},
      {"roller_load_max_N", "N", "largest force of a roller on the inner race in static equilibrium, over positions of the rollers", [](At p) { return p.roller_load; }},
      {"race_pressure_max_MPa", "MPa", "largest Hertzian pressure of a slice at either race in static equilibrium, over positions of the rollers", [](At p) { return 1e-6 * p.race_pressure; }},
      {"load_zone_deg", "deg", "angle within which rollers carry more than 1 % of the load in static equilibrium", [](At p) { return p.load_zone / (pi / 180); }},
      {"film_um", "um", "oil film at the heaviest slice of the inner race, rolling without slip", [](At p) { return 1e6 * p.film; }},
      {"lambda_ratio", "-", "oil film at the heaviest slice of the inner race over the composite roughness of the races", [](At p) { return p.lambda; }},
      {"balanced_temperature_C", "degC", "temperature of oil and outer ring at which the nominal bearing sheds what it loses; under temperature.balance", [](At p) { return p.temperature; }},
      {"balanced_heat_W", "W", "power that the nominal bearing loses and sheds at its balanced temperature; under temperature.balance", [](At p) { return p.heat; }},
      {"speed_factor_mm_min", "mm/min", "n d_m, n the speed of one ring against the other, d_m the diameter of the rollers' pitch circle", [](At p) { return 1e3 * p.pitch_diameter * p.speed / kRpm; }},
      {"cage_speed_rpm", "rpm", "kinematic speed of the cage", [](At p) { return p.cage_speed / kRpm; }},
      {"cage_order", "-", "speed of the cage without slip, against the outer ring, over the speed of the inner ring against the outer one", [](At p) { return cage_order(p); }},
      {"inner_passing_order", "-", "rollers that pass a point of the inner ring in a turn of one ring against the other, without slip", [](At p) { return p.rollers * (1 - cage_order(p)); }},
      {"outer_passing_order", "-", "rollers that pass a point of the outer ring in a turn of one ring against the other, without slip", [](At p) { return p.rollers * cage_order(p); }},
      {"roller_speed_rpm", "rpm", "kinematic speed of a roller about its axis, relative to the cage, positive against the inner ring's sense", [](At p) { return p.roller_speed / kRpm; }},
      {"roller_spin_rpm", "rpm", "kinematic speed of a roller about its axis seen from outside, positive in the inner ring's sense", [](At p) { return p.roller_spin / kRpm; }},
      {"entrainment_speed_m_s", "m/s", "speed at which the inner race and a roller carry oil into their contact", [](At p) { return p.entrainment; }},
      {"internal_clearance_as_made_um", "um", "diametral clearance that raceways and rollers leave, of the thickest roller, before fits, heat and rotation", [](At p) { return 1e6 * p.made_clearance.internal; }, true},
      {"inner_fit_change_um", "um", "change of the internal clearance by the fit of the inner ring, cold and at rest", [](At p) { return 1e6 * p.inner_change.fit; }, true},
      {"outer_fit_change_um", "um", "change of the internal clearance by the fit of the outer ring, cold and at rest", [](At p) { return 1e6 * p.outer_change.fit; }, true},
      {"inner_heat_change_um", "um", "change of the internal clearance by heat of inner ring and shaft", [](At p) { return 1e6 * p.inner_change.heat; }, true},
      {"outer_heat_change_um", "um", "change of the internal clearance by heat of outer ring and housing", [](At p) { return 1e6 * p.outer_change.heat; }, true},
      {"roller_heat_change_um", "um", "change of the internal clearance by heat of the rollers", [](At p) { return 1e6 * p.roller_change.heat; }, true},
      {"inner_rotation_change_um", "um", "change of the internal clearance by rotation of inner ring and shaft", [](At p) { return 1e6 * p.inner_change.spin; }, true},
      {"outer_rotation_change_um", "um", "change of the internal clearance by rotation of outer ring and housing", [](At p) { return 1e6 * p.outer_change.spin; }, true},
      {"roller_rotation_change_um", "um", "change of the internal clearance by rotation of the rollers", [](At p) { return 1e6 * p.roller_change.spin; }, true},
      {"internal_clearance_um", "um", "internal clearance in operation: as made, with its changes by fits, heat and rotation", [](At p) { return 1e6 * p.clearance.internal; }},
      {"inner_fit_interference_um", "um", "interference of inner ring and shaft in operation, of diameters; below 0: the fit is open; none without fit.inner_interference_um", [](At p) { return 1e6 * p.inner_fit.interference; }, true},
      {"inner_fit_pressure_MPa", "MPa", "pressure between inner ring and shaft in operation", [](At p) { return 1e-6 * p.inner_fit.pressure; }, true},
      {"outer_fit_interference_um", "um", "interference of outer ring and housing in operation, of diameters; below 0: the fit is open; none without fit.outer_interference_um", [](At p) { return 1e6 * p.outer_fit.interference; }, true},
      {"outer_fit_pressure_MPa", "MPa", "pressure between outer ring and housing in operation", [](At p) { return 1e-6 * p.outer_fit.pressure; }, true},
      {"pocket_width_clearance_as_made_um", "um", "pocket width less roller diameter, least over pockets, before fits, heat and rotation", [](At p) { return 1e6 * p.made_clearance.pocket_width; }, true},
      {"pocket_width_clearance_um", "um", "pocket width less roller diameter in operation", [](At p) { return 1e6 * p.clearance.pocket_width; }},
      {"pocket_length_clearance_as_made_um", "um", "pocket length less roller length, before fits, heat and rotation", [](At p) { return 1e6 * p.made_clearance.pocket_length; }, true},
      {"pocket_length_clearance_um", "um", "pocket length less roller length in operation", [](At p) { return 1e6 * p.clearance.pocket_length; }},
      {"guide_clearance_as_made_um", "um", "radial clearance of the cage in what guides it, before fits, heat and rotation", [](At p) { return 1e6 * p.made_clearance.guide; }, true},
      {"guide_clearance_um", "um", "radial clearance of the cage in what guides it, in operation", [](At p) { return 1e6 * p.clearance.guide; }},
      {"flange_clearance_as_made_um", "um", "axial clearance of a roller between its flanges, before fits, heat and rotation", [](At p) { return 1e6 * p.made_clearance.flange; }, true},
      {"flange_clearance_um", "um", "axial clearance of a roller between its flanges in operation", [](At p) { return 1e6 * p.clearance.flange; }},
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
  const bool turns = make_duty(scene.operation).load_turns(),
             over_time = changes_over_time(scene.operation);
  const std::string load = (over_time ? "the equivalent load, "
                            : turns   ? "the radial load in all, "
                                      : "load.radial_N = ") +
                           force(at.load);
  if (at.largest_load > at.static_rating)
    warnings.push_back((over_time ? "the largest load, " + force(at.largest_load) : load) +
                       " is above the static load rating C0 = " + force(at.static_rating) +
                       ": races and rollers yield (ISO 76)");
  if (at.load > at.dynamic_rating)
    warnings.push_back(load + " is above the dynamic load rating C = " + force(at.dynamic_rating) +
                       ": less than a million revolutions of rating life (ISO 281)");
  else if (at.load > kLifeShare * at.dynamic_rating)
    warnings.push_back(load + " is above half the dynamic load rating C = " +
                       force(at.dynamic_rating) + ": rating life does not hold there (ISO 281)");
  const std::string speed =
      (over_time                          ? "the largest speed of one ring against the other, "
       : scene.operation.outer_speed != 0 ? "the speed of one ring against the other, "
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
  add_clearance_warnings(scene, warnings);
  add_makers_warnings(scene, warnings);
  if (at.speed == 0) return warnings;
  if (at.load < at.minimum_load_skf)
    warnings.push_back(load + " is below the minimum load by SKF's rule, " +
                       force(at.minimum_load_skf) +
                       " = k_r (6 + 4 n/n_ref) (d_m/100)^2: rollers and cage may skid");
  else if (std::isnan(at.minimum_load_skf) && at.load < at.minimum_load_schaeffler)
    warnings.push_back(load + " is below the minimum load by Schaeffler's rule, " +
                       force(at.minimum_load_schaeffler) + " = C0/60: rollers and cage may skid");
  return warnings;
}

}  // namespace cagetol
