// What an engineer asks of a bearing under its load and speed before any run: ratings and life,
// load distribution, film, speeds, clearances, masses. All of it follows from the scene alone.
//
// The load distribution is that of static equilibria (src/statics/static_equilibrium.hpp) with the
// rollers at rest against the races, pressed outwards as they orbit at the kinematic cage speed,
// at positions over one pitch. Kinematics: rollers that roll without slip,
//   w_c = w_i R_i/(R_i + R_o),   w_r = (w_i - w_c) R_i/R_roller,   u = |w_i - w_c| R_i
// w_i, w_c speeds of inner ring and cage, w_r of a roller about its axis relative to the cage, u
// entrainment speed at the inner race. Film: loaded_film() of lubrication/lubricated_line.hpp at
// the heaviest slice of the inner race.
#pragma once

#include <string>
#include <vector>

#include "src/operation/operating_clearance.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// Clearances: least over rollers and pockets [m].
struct Clearances {
  double internal;                     ///< diametral
  double pocket_width, pocket_length;  ///< pocket less roller
  double guide, flange;                ///< radial of the cage, axial of a roller
};

/// NaN: not known, or not defined for the scene.
struct OperatingPoint {
  double dynamic_rating, static_rating;  ///< C, C_0: given or by the standards [N]
  /// P; under a duty over time the one of equal damage, by ISO 281 with exponent 10/3 [N].
  double load;
  double largest_load;                               ///< P_0 [N]
  double life;                                       ///< L_10 [revolutions]
  double life_time;                                  ///< at the speed of the inner ring [s]
  double minimum_load_skf, minimum_load_schaeffler;  ///< [N]

  double roller_load;    ///< largest on the inner race [N]
  double race_pressure;  ///< largest [Pa]
  double load_zone;      ///< angle within which rollers carry more than 1 % of the load [rad]
  double film;           ///< at the heaviest slice of the inner race [m]
  double lambda;         ///< film over composite roughness of the races

  double temperature, heat;  ///< of outer ring and oil, power shed there: of a balance [degC], [W]
  double pitch_diameter;     ///< d_m [m]
  double speed;              ///< of one ring against the other, under a duty the largest [rad/s]
  double limiting_speed;     ///< [rad/s]
  double inner_speed, outer_speed;  ///< w_i, w_o of the rings [rad/s]
  double cage_speed;                ///< w_c [rad/s]
  double roller_speed;              ///< w_r, relative to the cage [rad/s]
  double roller_spin;               ///< w_c - w_r, seen from outside [rad/s]
  double entrainment;               ///< u [m/s]
  Clearances clearance;             ///< in operation (src/operation/operating_clearance.hpp)
  Clearances made_clearance;        ///< as the scene gives the parts, cold and not mounted
  Growth inner_change, outer_change,
      roller_change;  ///< of the internal clearance, by each part [m]
  FitState inner_fit, outer_fit;
  double cage_mass, roller_mass;  ///< [kg]
  double rollers;                 ///< Z
};

/// Speed of the cage in multiples of the speed of one ring against the other; of the shaft's where
/// the outer ring stands still, and without slip (1 - D/d_m)/2 there, D and d_m diameters of a
/// roller and of the pitch circle:
///   (w_c - w_o)/(w_i - w_o)
/// In these multiples Z (1 - cage_order) rollers pass a point of the inner ring, Z cage_order one
/// of the outer ring. Not finite where no ring turns against the other.
double cage_order(const OperatingPoint& at);

/// The same point with a cage that slips: w_c (1 - slip).
OperatingPoint with_slip(OperatingPoint at, double slip);

/// Load distribution and film are NaN where no equilibrium is found.
OperatingPoint operating_point(const Scene& scene);

/// Minimum load by SKF's rule at the scene's largest speed; NaN where the scene gives no
/// bearing.minimum_load_factor or no bearing.reference_speed_rpm [N].
double minimum_load_of(const Scene& scene);

/// One line of its table.
struct OperatingRow {
  const char* key;                            ///< with its unit as suffix
  const char* unit;                           ///< "-" for a ratio
  const char* definition;                     ///< one sentence
  double (*value)(const OperatingPoint& of);  ///< in that unit
  /// Of what changes in operation: says nothing where nothing does (changes_in_operation()).
  bool of_change = false;
};
/// All lines, in the order of tables and files.
const std::vector<OperatingRow>& operating_rows();

/// What a bearing in service would not bear: too high a load or speed, or too light a load. One
/// sentence each, with the rule and its source.
std::vector<std::string> operating_warnings(const Scene& scene);

}  // namespace cagetol
