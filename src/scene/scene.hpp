// A scene: everything that determines one bearing run, in SI units. Immutable input of the physics;
// plain data with defaults. Defaults are the reference bearing NU 205 ECP with a machined steel
// window cage (inputs/README.md lists every key).
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace cagetol {

/// "auto": computed from the rest of the scene.
inline constexpr double kAuto = std::numeric_limits<double>::quiet_NaN();

struct Material {
  double young = 208e9;   ///< E [Pa]
  double poisson = 0.30;  ///< nu
  double density = 7810;  ///< rho [kg/m^3]
};

/// How much of the motion is modelled.
struct Simplification {
  std::string rollers = "spatial";  ///< "spatial" or "planar": no tilt, skew or axial motion
  std::string motion = "dynamic";   ///< "dynamic" or "quasi-static": equilibria, no integration
  std::string ring_tilt = "prescribed";  ///< of the inner ring: "prescribed" or "free"
};

struct BearingGeometry {
  long roller_count = 13;                   ///< Z
  double bore_diameter = 25e-3;             ///< [m]
  double outside_diameter = 52e-3;          ///< [m]
  double width = 15e-3;                     ///< [m]
  double inner_raceway_diameter = 31.5e-3;  ///< F, catalogue [m]
  double outer_raceway_diameter = 46.5e-3;  ///< E, catalogue [m]
  double shoulder_diameter =
      43.8e-3;  ///< outer-ring shoulders: flange face and guiding surface [m]
  double internal_clearance =
      30e-6;  ///< diametral, beyond what the catalogue diameters leave; half on each raceway [m]
  double flange_clearance = 0.08e-3;  ///< roller to both flanges, axial, total [m]
  Material ring_material;
  double inner_ring_mass = kAuto;                                                  ///< [kg]
  double inner_ring_polar_inertia = kAuto, inner_ring_transverse_inertia = kAuto;  ///< [kg m^2]
  double misalignment_y = 0;  ///< centre line of the inner ring: y_i + misalignment_y x [rad]
  double misalignment_z = 0;  ///< likewise in z [rad]
  double tilt_stiffness = 0;  ///< of the shaft, against a free tilt of the ring [N m/rad]
};

struct RollerGeometry {
  std::vector<double> diameter = {7.5e-3};  ///< D, one for all or one each [m]
  double length = 9e-3;                     ///< L_w [m]
  std::vector<double> taper = {0};  ///< diameter at the +x end minus diameter at the -x end [m]
  std::string profile = "none";     ///< "none" or "logarithmic" (ISO/TS 16281)
  Material material;
};

/// Oil film between the cage's lands and their guiding ring (src/contact/short_bearing.hpp).
struct GuideFilm {
  std::string model = "none";  ///< "none" or "short-bearing"
  double viscosity = 0.02;     ///< eta [Pa s]
  double width = kAuto;        ///< of a land, axial [m]
  double least = 1e-6;         ///< gap at which roughness ends the film and the lands touch [m]
};

struct CageGeometry {
  std::string model = "rigid";                    ///< "rigid" or "flexible"
  double inner_diameter = 37.0e-3;                ///< [m]
  double outer_diameter = 43.4e-3;                ///< [m]
  double width = 14e-3;                           ///< axial [m]
  std::vector<double> pocket_width = {7.65e-3};   ///< S_j, circumferential opening [m]
  std::vector<double> pocket_length = {9.25e-3};  ///< L_j, axial opening [m]
  std::vector<double> pocket_pitch = {
      0};  ///< dpsi_j, angular deviation of the pocket's centre [rad]
  std::vector<double> pocket_squareness = {
      0};  ///< dgamma_j, angle of the bar faces to the bearing axis [rad]
  Material material{206e9, 0.30, 7850};
  double yield_stress = 235e6;        ///< [Pa]
  double mass = kAuto;                ///< [kg]
  double polar_inertia = kAuto;       ///< about the bearing axis [kg m^2]
  double transverse_inertia = kAuto;  ///< about a diameter [kg m^2]
  std::string guidance = "outer";     ///< "outer", "inner" or "roller"
  double guide_clearance = kAuto;     ///< radial [m]
  double land_offset = kAuto;         ///< lands at x = +-land_offset [m]
  GuideFilm guide_film;
  long mesh_density = 4;       ///< of a flexible cage: elements through the thickness
  long modes = 20;             ///< elastic modes kept of a flexible cage
  double mode_damping = 0.01;  ///< damping ratio of elastic modes
  bool centrifugal = true;     ///< centrifugal loading of the elastic modes
  bool coriolis = true;        ///< Coriolis coupling of the elastic modes
};

/// Parameters of one contact kind.
struct ContactParameters {
  std::string law =
      "impact";  ///< "impact" (Adams IMPACT) or "hertz" (line contact, Hunt-Crossley damping)
  double stiffness =
      1.5e5;  ///< K of `impact`, N/mm^e as [P] Table 1 prints it; converted where the law is made
  double exponent = 10.0 / 9.0;    ///< e
  double damping = 750e3;          ///< c_max [N s/m]
  double damping_depth = 0.1e-3;   ///< d, depth at which the damping is full [m]
  double restitution = 0.9;        ///< of `hertz`, at the reference speed
  double restitution_speed = 0.1;  ///< [m/s]
  /// Friction (src/contact/friction.hpp); kAuto: those of all contacts.
  double friction_static = kAuto, friction_dynamic = kAuto, static_speed = kAuto,
         dynamic_speed = kAuto;
  double roughness = kAuto;  ///< composite, rms; kAuto: that of Lubrication [m]
};

struct Contacts {
  ContactParameters race{.law = "hertz"};  ///< roller-inner race and roller-outer race
  ContactParameters bar{.law = "hertz"};   ///< roller-pocket bar
  ContactParameters end;                   ///< roller end-pocket end wall
  ContactParameters flange;                ///< roller end-ring flange
  ContactParameters land;                  ///< cage land-ring shoulder
  double friction_static = 0.07;           ///< mu_s
  double friction_dynamic = 0.06;          ///< mu_d
  double static_speed = 0.1;               ///< v_s [m/s]
  double dynamic_speed = 1.0;              ///< v_d [m/s]
};

/// Oil film of the roller-race contacts (src/contact/oil_film.hpp).
struct OilFilm {
  std::string model = "none";         ///< "none", "series" or "series-bounded"
  double viscosity = 0.02;            ///< eta0 [Pa s]
  double pressure_viscosity = 18e-9;  ///< alpha [1/Pa]
  double least_force =
      1;  ///< of a whole contact; below it the film grows no thicker than along the tangent [N]
};

/// Oil in the bearing: films, rolling resistance, traction and drag (src/lubrication). `kAuto`
/// stands for what the named lubricant gives.
struct Lubrication {
  std::string model = "none";           ///< "none" (dry, or the films of OilFilm) or "film"
  std::string lubricant = "iso-vg-68";  ///< a name of lubricant_presets()
  double temperature = 70;              ///< of the oil in the bearing [degC]
  double viscosity_40 = kAuto;          ///< kinematic, at 40 degC [mm2/s]
  double viscosity_100 = kAuto;         ///< at 100 degC [mm2/s]
  double density = kAuto;               ///< at 15 degC [kg/m3]
  double viscosity = kAuto;             ///< eta at the operating temperature; overrides [Pa s]
  double pressure_viscosity = kAuto;    ///< alpha [1/Pa]
  double conductivity = 0.14;           ///< k [W/(m K)]
  double eyring_stress = 5e6;           ///< tau_E [Pa]
  double limiting_shear = 0.06;         ///< Lambda
  double race_roughness = 0.2e-6;       ///< composite, rms [m]
  double race_layer = 20e-6;            ///< oil at the inner race [m]
  double pocket_roughness = 0.5e-6;     ///< composite, rms [m]
  double pocket_layer = 20e-6;          ///< oil at bars and ends of pockets [m]
  bool squeeze = true, rolling_resistance = true, inlet_heating = true;
  bool film_traction = true;  ///< false: what slides in a contact rubs as without oil
  bool pocket_film = true;    ///< at the pockets' bars
  bool end_film = true;       ///< at roller ends, against pockets and flanges
  bool churning = true;
  double oil_share = 0.02;         ///< of the free space that is oil
  double roller_drag = 1;          ///< C_d of a roller in its orbit
  double carried_along = 0.5;      ///< share of the cage's speed at which oil and air turn
  bool land_film = true;           ///< short-bearing film at the lands of a guided cage
  double land_film_width = kAuto;  ///< of a land, axial [m]
  double land_film_least = 1e-6;   ///< gap at which roughness ends the film and the lands touch [m]
};

struct Operation {
  double radial_load = 1000;    ///< on the inner ring, along -z [N]
  double tilting_moment_y = 0;  ///< on an inner ring whose tilt is free, towards +y [N m]
  double tilting_moment_z = 0;  ///< likewise towards +z [N m]
  double load_ramp = 0;         ///< time over which load and moment rise from zero by STEP [s]
  double inner_speed = 6000 * 0.10471975511965977;  ///< about +x [rad/s]
  double speed_ramp_from = kAuto;                   ///< speed at t = 0; auto: no ramp [rad/s]
  double speed_ramp = 0;                            ///< time of the ramp by STEP [s]
  double gravity = 9.81;                            ///< along -z [m/s^2]
};

struct Start {
  std::string state = "auto";  ///< "steady", "equilibrium" or "centred"; auto: steady where
                               ///< lubricated, else equilibrium
  double cage_offset_y = 0;    ///< [m]
  double cage_offset_z = 0;    ///< [m]
  double cage_offset_x = 0;    ///< [m]
  double cage_phase = 0;       ///< rollers and cage turned together about the bearing axis [rad]
};

struct Window {
  double settle_revolutions = 2;           ///< cage revolutions before measuring
  std::string measure = "fixed";           ///< "auto": until the means have converged
  double measure_revolutions = 6;          ///< cage revolutions measured; auto: at most
  double measure_share = 0.1;              ///< auto: what the means may be off by, of themselves
  double peak_revolutions = kAuto;         ///< over which peaks are taken; auto: the whole window
  double longest_settle_revolutions = 60;  ///< of a lubricated bearing whose motion drifts
  double settle_time = kAuto;              ///< overrides settle_revolutions [s]
  double measure_time = kAuto;             ///< overrides measure_revolutions [s]
};

struct Discretisation {
  long race_slices = 5;
  long bar_stations = 3;
};

struct Integration {
  std::string method = "rodas4s";
  double tolerance = 0.001;  ///< multiple of the error scales (1 um, 1 cm/s and kin)
  double max_step = 50e-6;   ///< [s]
  double fixed_step = 1e-6;  ///< of fixed-step methods [s]
  long max_order = 2;        ///< cap of cvode-bdf
  bool touch_aware = true;   ///< end steps before predicted touches, lay them around those of races
  long step_budget = 20000000;  ///< attempted steps before the run is censored
  double wall_budget =
      0;  ///< wall-clock limit [s], 0: none; ends a run as not_run, never as a result
};

struct Watch {
  double static_consistency_max = 0.02;
  double energy_residual_max = 0.05;
  double cage_drift_max = 0.001;    ///< of lubricated bearings (quantities/stationarity.hpp)
  double power_surplus_max = 0.02;  ///< likewise
};

/// A value of the scene that nobody measured, and why it is what it is. Reports print them.
struct Assumption {
  std::string key, note;
};

struct Scene {
  std::string name = "nu205";
  std::vector<Assumption> assumptions;
  Simplification model;
  BearingGeometry bearing;
  RollerGeometry roller;
  CageGeometry cage;
  Contacts contact;
  OilFilm film;
  Lubrication lubrication;
  Operation operation;
  Start start;
  Window window;
  Discretisation discretisation;
  Integration integration;
  Watch watch;
  bool allow_interference =
      false;  ///< simulate a jammed pocket's elastic pinch instead of reporting the jam
  double history_interval = 20e-6;  ///< [s]
};

/// Whether a run ends its measuring window by itself.
inline bool measures_until_converged(const Scene& scene) {
  return scene.window.measure == "auto";
}

inline bool has_planar_rollers(const Scene& scene) {
  return scene.model.rollers == "planar";
}
/// Planar rollers see every section of the bearing alike: none is tilted.
inline bool has_free_ring_tilt(const Scene& scene) {
  return scene.model.ring_tilt == "free" && !has_planar_rollers(scene);
}
inline bool is_lubricated(const Scene& scene) {
  return scene.lubrication.model == "film";
}
/// The film at the cage's lands, by whichever model of lubrication there is; that of `lubrication`
/// has the viscosity of its oil, kAuto included.
inline GuideFilm land_film(const Scene& scene) {
  if (!is_lubricated(scene)) return scene.cage.guide_film;
  const Lubrication& l = scene.lubrication;
  const bool on = l.land_film && scene.cage.guidance != "roller";
  return {on ? "short-bearing" : "none", l.viscosity, l.land_film_width, l.land_film_least};
}
inline bool is_quasi_static(const Scene& scene) {
  return scene.model.motion == "quasi-static";
}

/// Element j of a per-pocket list that may hold one value for all.
inline double each(const std::vector<double>& values, long j) {
  return values.size() == 1 ? values[0] : values[static_cast<std::size_t>(j)];
}

}  // namespace cagetol
