// A scene: everything that determines the run of one bearing, in SI units. Plain data, not changed
// by the physics. The defaults are the reference bearing NU 205 ECP with a machined steel window
// cage. inputs/KEYS.md lists every key. Above 400 lines: all that a scene holds, in one place.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "src/contact_laws/contact_parameters.hpp"
#include "src/contact_laws/material.hpp"
#include "src/input/number_list.hpp"
#include "src/scene/choices.hpp"

namespace cagetol {

/// Strengths of a material [Pa].
struct Strength {
  double yield = 235e6;    ///< of metals the 0.2 % proof stress, of polymers the stress at break
  double tensile = 370e6;  ///< R_m
  double fatigue = 165e6;  ///< sigma_w, amplitude that is endured fully reversed
};

/// A material by its name; kAuto: as the named one has it (materials.hpp).
struct MaterialChoice {
  std::string name;  ///< a name of material_presets()
  double young = kAuto, poisson = kAuto, density = kAuto;
  double expansion = kAuto;  ///< linear thermal expansion [1/K]
};

/// Which motions are modelled.
struct Simplification {
  MotionModel motion = MotionModel::dynamic;
  TiltModel ring_tilt = TiltModel::prescribed;  ///< of the inner ring
};

/// Waves around a raceway, one harmonic of its radial form (src/model/raceway_form.hpp).
struct Waviness {
  double amplitude = 0;  ///< a_k [m]
  long count = 2;        ///< k
  double phase = 0;      ///< phi_k [rad]
};
inline constexpr int kHarmonics = 2;  ///< harmonics of a raceway

struct BearingGeometry {
  long roller_count = 13;                   ///< Z
  double bore_diameter = 25e-3;             ///< [m]
  double outside_diameter = 52e-3;          ///< [m]
  double width = 15e-3;                     ///< [m]
  double inner_raceway_diameter = 31.5e-3;  ///< F, catalogue [m]
  double outer_raceway_diameter = 46.5e-3;  ///< E, catalogue [m]
  FlangeSides outer_flanges = FlangeSides::both, inner_flanges = FlangeSides::none;
  double shoulder_diameter = 43.8e-3;     ///< of the outer ring's flanges; kAuto: it has none [m]
  double inner_flange_diameter = kAuto;   ///< of the inner ring's flanges [m]
  double inner_flange_clearance = kAuto;  ///< as flange_clearance, which it is if kAuto [m]
  /// Of the flanges' faces to the radial plane, open towards their rim; for spherical roller ends
  /// [rad].
  double outer_flange_angle = 0, inner_flange_angle = 0;
  /// Surfaces that meet the cage; kAuto: flanges on both sides, or else the raceway [m].
  double outer_land_diameter = kAuto, inner_land_diameter = kAuto;
  /// Diametral clearance added to that of the catalogue diameters, half on each raceway [m].
  double internal_clearance = 30e-6;
  double flange_clearance = 0.08e-3;  ///< axial clearance of a roller between its flanges [m]
  MaterialChoice ring_material{"bearing-steel"};
  double inner_ring_mass = kAuto;                                                  ///< [kg]
  double inner_ring_polar_inertia = kAuto, inner_ring_transverse_inertia = kAuto;  ///< [kg m^2]
  std::array<Waviness, kHarmonics> inner_waviness = {Waviness{0, 2, 0}, Waviness{0, 3, 0}},
                                   outer_waviness = inner_waviness;
  double misalignment_y = 0;  ///< slope of the inner ring's centre line in y [rad]
  double misalignment_z = 0;  ///< slope in z [rad]
  double tilt_stiffness = 0;  ///< of the shaft against the tilt of a free ring [N m/rad]
  // No run depends on the rest (src/quantities/operating_point.hpp).
  double dynamic_rating = kAuto;                           ///< C; kAuto: by ISO 281 [N]
  double static_rating = kAuto;                            ///< C_0; kAuto: by ISO 76 [N]
  double reference_speed = kAuto, limiting_speed = kAuto;  ///< kAuto: not known [rad/s]
  double minimum_load_factor = kAuto;                      ///< k_r; kAuto: not known
};

struct RollerGeometry {
  std::vector<double> diameter = {7.5e-3};  ///< D, one value for all rollers or one for each [m]
  double length = 9e-3;                     ///< L_w [m]
  double corner_radius = kAuto;             ///< from the end to the cylinder; kAuto: 0.06 D [m]
  double end_radius = 0;                    ///< R_e of ends that are spheres; 0: flat [m]
  std::vector<double> taper = {0};  ///< diameter at the +x end minus diameter at the -x end [m]
  RollerProfile profile = RollerProfile::none;
  MaterialChoice material{"bearing-steel"};
};

/// Seats of the rings (src/operation/operating_clearance.hpp).
struct Fits {
  /// Of the inner ring on its shaft, diametral; < 0: loose, kAuto: a ring without seat [m].
  double inner_interference = kAuto;
  double shaft_bore = 0;  ///< diameter, 0: solid [m]
  MaterialChoice shaft_material{"bearing-steel"};
  double outer_interference = kAuto;  ///< of the outer ring in its housing, likewise [m]
  double housing_diameter = kAuto;    ///< outside; kAuto: much larger than the bearing [m]
  MaterialChoice housing_material{"cast-iron"};
};

/// Temperatures of parts, by which they grow from the dimensions that the scene gives [degC].
/// That of the cage is CageGeometry::temperature. kAuto: of the inner and the outer ring that of
/// the oil, of the rollers the mean of both rings, of shaft and housing that of their ring.
struct Temperatures {
  bool growth = false;    ///< false: parts have the dimensions that the scene gives
  double reference = 20;  ///< at which they have these
  double inner_ring = kAuto, outer_ring = kAuto, rollers = kAuto, shaft = kAuto, housing = kAuto;
  /// Those of oil and rings are found from the heat that the bearing makes and sheds.
  bool balance = false;
  double ambient = 20;         ///< of what the bearing sheds heat to [degC]
  double conductance = kAuto;  ///< kAuto: of ISO 15312 [W/K]
  double oil_flow = 0;         ///< through the bearing [m^3/s]
  double oil_inlet = kAuto;    ///< of that oil; kAuto: ambient [degC]
  double inner_above = 5;      ///< inner ring above outer ring and oil [K]
  /// What was found of the nominal bearing: of outer ring and oil [degC], the power lost there [W],
  /// and how much more is shed than lost a kelvin above [W/K]. kAuto: not yet.
  double found = kAuto, found_power = kAuto, found_slope = kAuto;
};

/// Whether its temperature is still to be found.
inline bool needs_temperature(const Temperatures& t) {
  return t.balance && std::isnan(t.found);
}

/// Modes a flexible cage can have, elastic ones and those of its bars: bounds scratch on the stack.
inline constexpr int kMostModes = 62;
/// Elastic ones: as many as a cage table holds.
inline constexpr int kMostElasticModes = 36;

struct CageGeometry {
  CageKind model = CageKind::rigid;               ///< none: the rest does nothing
  double inner_diameter = 37.0e-3;                ///< [m]
  double outer_diameter = 43.4e-3;                ///< [m]
  double width = 14e-3;                           ///< axial [m]
  std::vector<double> pocket_width = {7.65e-3};   ///< S_j, circumferential opening [m]
  std::vector<double> pocket_length = {9.25e-3};  ///< L_j, axial opening [m]
  /// dpsi_j, angular deviation of the pocket's centre [rad].
  std::vector<double> pocket_pitch = {0};
  /// dgamma_j, angle between bar faces and bearing axis [rad].
  std::vector<double> pocket_squareness = {0};
  MaterialChoice material{"steel-q235"};
  double temperature = kAuto;   ///< kAuto: that of the oil [degC]
  double swelling = 0;          ///< by moisture, of every length since it was measured
  double yield_stress = kAuto;  ///< kAuto: of the named material at its temperature [Pa]
  double tensile_strength = kAuto, fatigue_strength = kAuto;  ///< likewise [Pa]
  double mass = kAuto;                                        ///< [kg]
  double polar_inertia = kAuto;                               ///< about the bearing axis [kg m^2]
  double transverse_inertia = kAuto;                          ///< about a diameter [kg m^2]
  /// Mass times eccentricity of its mass centre, beside that of the pockets' deviations [kg m].
  double unbalance = 0;
  double unbalance_phase = 0;  ///< direction, from the middle of pocket 0 about +x [rad]
  Guidance guidance = Guidance::outer;
  double guide_clearance = kAuto;  ///< radial [m]
  double land_offset = kAuto;      ///< lands at x = +-land_offset [m]
  double land_width = kAuto;       ///< axial, of one land [m]
  double face_radius = kAuto;      ///< of the bars' faces in the radial plane; kAuto: flat [m]
  /// Opening of pocket j between lips at the bore, at the outside; kAuto: no lips [m].
  std::vector<double> retention_inner = {kAuto}, retention_outer = {kAuto};
  double edge_radius = 0.2e-3;    ///< of the bars' edges and lips [m]
  long mesh_density = 4;          ///< finite elements through the thickness of a flexible cage
  double corner_radius = 0.5e-3;  ///< of the pockets' corners [m]
  long modes = 10;                ///< number of elastic modes of a flexible cage
  bool bar_modes = true;          ///< and a static mode of every bar (src/cage/table/bar_modes.hpp)
  double mode_damping = kAuto;    ///< damping ratio of elastic modes; kAuto: half the loss factor
  bool centrifugal = true;        ///< centrifugal loading of the elastic modes
  bool coriolis = true;           ///< Coriolis coupling of the elastic modes
};

struct Contacts {
  ContactParameters race{.law = ForceLaw::hertz};  ///< roller-inner race and roller-outer race
  ContactParameters bar{.law = ForceLaw::hertz};   ///< roller-pocket bar
  ContactParameters end;                           ///< roller end-pocket side ring face
  ContactParameters flange;                        ///< roller end-ring flange
  ContactParameters land;                          ///< cage land-ring shoulder
  double friction_static = 0.07;                   ///< mu_s
  double friction_dynamic = 0.06;                  ///< mu_d
  double static_speed = 0.1;                       ///< v_s [m/s]
  double dynamic_speed = 1.0;                      ///< v_d [m/s]
  RaceApproach race_approach = RaceApproach::palmgren;
};

/// Oil in the bearing: films, rolling resistance, traction and drag (src/lubrication). kAuto: the
/// value of the named lubricant.
struct Lubrication {
  LubricationModel model = LubricationModel::none;
  std::string lubricant = "iso-vg-68";  ///< a name of lubricant_presets()
  double temperature = 70;              ///< of the oil in the bearing [degC]
  double viscosity_40 = kAuto;          ///< kinematic, at 40 degC [mm2/s]
  double viscosity_100 = kAuto;         ///< at 100 degC [mm2/s]
  double density = kAuto;               ///< at 15 degC [kg/m3]
  double viscosity = kAuto;             ///< eta at the operating temperature; overrides [Pa s]
  double pressure_viscosity = kAuto;    ///< alpha [1/Pa]
  double conductivity = 0.14;           ///< k [W/(m K)]
  double eyring_stress = 5e6;           ///< tau_E [Pa]
  double limiting_shear = kAuto;        ///< Lambda
  double race_roughness = 0.2e-6;       ///< composite, rms [m]
  /// For kAuto of the layers and oil_share below.
  OilSupply supply = OilSupply::automatic;
  double race_layer = kAuto;         ///< oil layer at the inner race; infinite: flooded [m]
  double outer_layer = kAuto;        ///< likewise at the outer race [m]
  double land_layer = kAuto;         ///< likewise between guide lands and their ring [m]
  double pocket_roughness = 0.5e-6;  ///< composite, rms [m]
  double pocket_layer = kAuto;       ///< likewise at bars and ends of pockets [m]
  bool squeeze = true, rolling_resistance = true, inlet_heating = true;
  bool film_traction = true;  ///< false: sliding contacts have the friction of a dry bearing
  bool pocket_film = true;    ///< film between rollers and pocket bars
  bool end_film = true;       ///< film at roller ends, against pockets and flanges
  bool churning = true;
  double oil_share = kAuto;         ///< volume fraction of oil in the free space
  double roller_drag = 1;           ///< C_d of a roller in its orbit
  double carried_along = 0.5;       ///< speed of oil and air over the cage's speed
  bool land_film = true;            ///< short-bearing film at the lands of a guided cage
  double land_film_width = kAuto;   ///< of a land, axial [m]
  double land_film_minimum = 1e-6;  ///< smallest film: below it the lands touch [m]
};

/// What a duty imposes, at instants in time and on straight lines between them; after the last one
/// it stays. A column without values keeps the constant of Operation.
struct DutyTable {
  std::string file;  ///< CSV that holds the columns; read_scene() fills them and empties this
  NumberList time;   ///< [s]
  NumberList inner_speed, outer_speed;        ///< [rad/s]
  NumberList radial_load, direction;          ///< [N], [rad]
  NumberList axial_load, moment_y, moment_z;  ///< [N], [N m]
  double repeat = kAuto;                      ///< period of a duty that repeats itself [s]

  bool empty() const { return time.empty(); }
};

/// Named parts of a run, with quantities of their own.
struct Phases {
  std::vector<std::string> name;
  NumberList from, to;  ///< [s]
};

struct Operation {
  double radial_load = 1000;      ///< on the inner ring [N]
  double axial_load = 0;          ///< on the inner ring, along +x [N]
  double load_direction = 0;      ///< of the radial load, about +x from -z [rad]
  double rotating_load = 0;       ///< on the inner ring, beside the radial load [N]
  double rotating_speed = kAuto;  ///< about +x; kAuto: turns with the inner ring [rad/s]
  double rotating_phase = 0;      ///< direction of rotating load and unbalance at t = 0 [rad]
  double unbalance = 0;           ///< of what turns with the inner ring [kg m]
  double tilting_moment_y = 0;    ///< on a free inner ring: tilts its centre line to +y [N m]
  double tilting_moment_z = 0;    ///< tilts it to +z [N m]
  double load_ramp = 0;           ///< rise time of load and moment from zero, by STEP [s]
  double inner_speed = 6000 * 0.10471975511965977;  ///< about +x [rad/s]
  double outer_speed = 0;                           ///< of the outer ring, likewise [rad/s]
  double speed_ramp_from = kAuto;  ///< inner_speed at t = 0; kAuto: no ramp [rad/s]
  double outer_ramp_from = kAuto;  ///< likewise of outer_speed [rad/s]
  double speed_ramp = 0;           ///< duration of the ramps, by STEP [s]
  DutyTable table = {};
  double gravity = 9.81;            ///< [m/s^2]
  double shaft_inclination = 0;     ///< of +x above the horizontal; gravity is along -z at 0 [rad]
  bool centrifugal_growth = false;  ///< of rings, shaft, housing, rollers and cage at their speeds
};

struct Start {
  /// automatic: steady where lubricated, else equilibrium.
  StartState state = StartState::automatic;
  double cage_offset_y = 0;  ///< [m]
  double cage_offset_z = 0;  ///< [m]
  double cage_offset_x = 0;  ///< [m]
  double cage_phase = 0;     ///< initial angle of cage and rollers about the bearing axis [rad]
};

struct Window {
  double settle_revolutions = 2;           ///< cage revolutions before the measurement
  double measure_revolutions = 6;          ///< cage revolutions measured
  double peak_revolutions = kAuto;         ///< over which peaks are taken; kAuto: whole window
  double longest_settle_revolutions = 60;  ///< limit of settling for lubricated bearings that drift
  double whirl_clearance = kAuto;          ///< over which whirl is taken; kAuto: of this scene [m]
  double settle_time = kAuto;              ///< overrides settle_revolutions [s]
  double measure_time = kAuto;             ///< overrides measure_revolutions [s]
};

struct Discretisation {
  long race_slices = 5;
  long bar_stations = 3;
};

struct Integration {
  IntegrationMethod method = IntegrationMethod::rodasp;
  double tolerance = 0.001;    ///< multiple of the error scales (error_units in system.hpp)
  double max_step = kAuto;     ///< [s]
  long max_order = 2;          ///< highest order of cvode_bdf
  double step_budget = kAuto;  ///< attempted steps before the run is censored
  double wall_budget = 0;      ///< wall-clock limit, 0: none; a run beyond it is not_run [s]
};

struct Watch {
  double static_consistency_max = 0.02;
  double energy_residual_max = 0.05;
  double cage_drift_max = 0.001;    ///< lubricated bearings only (quantities/stationarity.hpp)
  double power_surplus_max = 0.02;  ///< lubricated bearings only
};

/// An assumed value of the scene and the reason for it. Reports print them.
struct Assumption {
  std::string key, note;
  /// What the value may be as well, in the key's unit; NaN: no range is given.
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();

  bool has_range() const { return !std::isnan(low); }
};

struct Scene {
  std::string name = "nu205";
  std::vector<Assumption> assumptions;
  Simplification model;
  BearingGeometry bearing;
  RollerGeometry roller;
  CageGeometry cage;
  Fits fit;
  Temperatures temperature;
  Contacts contact;
  Lubrication lubrication;
  Operation operation;
  Phases phase;
  Start start;
  Window window;
  Discretisation discretisation;
  Integration integration;
  Watch watch;
  /// Simulate the elastic pinch of a jammed pocket instead of reporting the jam.
  bool allow_interference = false;
  double history_interval = 20e-6;  ///< [s]
};

inline bool has_free_ring_tilt(const Scene& scene) {
  return scene.model.ring_tilt == TiltModel::free;
}
/// Whether speed or load follow a table, so that no cage revolution stands for another.
inline bool changes_over_time(const Operation& operation) {
  return !operation.table.empty();
}
/// Ends of the values that an axial load takes, zero among them [N].
struct AxialLoads {
  double minimum = 0, greatest = 0;
};
AxialLoads axial_loads(const Operation& operation);
/// The axial load at the start, or else the first one that is not zero [N].
double first_axial_load(const Operation& operation);
/// Largest magnitudes of radial load and speeds over time [N], [rad/s].
double largest_radial_load(const Operation& operation);
double largest_inner_speed(const Operation& operation);
double largest_outer_speed(const Operation& operation);

/// An axial load moves the inner ring until flanges carry it; without one it keeps its place.
inline bool has_free_axial_place(const Scene& scene) {
  const AxialLoads loads = axial_loads(scene.operation);
  return loads.minimum != 0 || loads.greatest != 0;
}
inline bool is_flexible(const Scene& scene) {
  return scene.cage.model == CageKind::flexible;
}
inline bool is_lubricated(const Scene& scene) {
  return scene.lubrication.model == LubricationModel::film;
}
/// Whether there is a film at the cage's lands.
inline bool has_land_film(const Scene& scene) {
  return is_lubricated(scene) && scene.lubrication.land_film &&
         scene.cage.guidance != Guidance::roller;
}
/// Radius of the circle on which the rollers' axes run [m].
inline double pitch_radius(const BearingGeometry& bearing) {
  return (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 4;
}
/// Of the surface on the inner ring that meets the cage's bore [m].
inline double inner_land_diameter(const BearingGeometry& b) {
  if (!std::isnan(b.inner_land_diameter)) return b.inner_land_diameter;
  return b.inner_flanges == FlangeSides::both ? b.inner_flange_diameter
                                              : b.inner_raceway_diameter - b.internal_clearance / 2;
}
/// Of the surface on the outer ring that meets the cage's outside [m].
inline double outer_land_diameter(const BearingGeometry& b) {
  if (!std::isnan(b.outer_land_diameter)) return b.outer_land_diameter;
  return b.outer_flanges == FlangeSides::both ? b.shoulder_diameter
                                              : b.outer_raceway_diameter + b.internal_clearance / 2;
}
/// Whether roller ends have oil between them and what they face.
inline bool has_end_film(const Scene& scene) {
  return is_lubricated(scene) && scene.lubrication.end_film;
}
/// From a roller's end to its cylinder [m].
inline double corner_radius(const Scene& scene) {
  return given_or(scene.roller.corner_radius, 0.06 * scene.roller.diameter[0]);
}
/// Angle of a ring's flanges where spherical-ended rollers meet them, else 0 [rad].
inline double sphere_flange_angle(const Scene& scene, bool inner) {
  const double angle = inner ? scene.bearing.inner_flange_angle : scene.bearing.outer_flange_angle;
  return scene.roller.end_radius > 0 ? angle : 0;
}
/// Height of a ring's flange that meets the flat part of roller ends: from the rollers' corners to
/// its rim [m]. Not positive where they do not reach each other.
inline double flange_pad(const Scene& scene, bool inner) {
  const BearingGeometry& b = scene.bearing;
  const double height = inner ? b.inner_flange_diameter - b.inner_raceway_diameter
                              : b.outer_raceway_diameter - b.shoulder_diameter;
  return height / 2 - corner_radius(scene);
}
inline bool is_quasi_static(const Scene& scene) {
  return scene.model.motion == MotionModel::quasi_static;
}

/// Element j of a per-pocket list, which may hold a single value for all pockets.
inline double each(const std::vector<double>& values, long j) {
  return values.size() == 1 ? values[0] : values[static_cast<std::size_t>(j)];
}

}  // namespace cagetol
