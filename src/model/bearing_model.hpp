// The immutable bearing model of one sample: what the right-hand side reads, computed once from the
// scene.
#pragma once

#include <array>
#include <vector>

#include "src/contact_laws/friction.hpp"
#include "src/contact_laws/normal_force.hpp"
#include "src/contact_laws/short_bearing.hpp"
#include "src/lubrication/churning.hpp"
#include "src/lubrication/flat_film.hpp"
#include "src/lubrication/lubricated_line.hpp"
#include "src/lubrication/point_film.hpp"
#include "src/model/duty.hpp"
#include "src/model/flexible_cage.hpp"
#include "src/model/raceway_form.hpp"
#include "src/model/state.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// A piece of the bars' outline in the radial plane that is an arc (src/contacts/pocket_face.hpp),
/// of a pack of pockets.
struct OutlineArc {
  bool hollow = false;  ///< a curved face
  int edge = 0;         ///< where the face ends: -1 at the bore, 1 at the outside; 0: face or lip
  double radius = 0;    ///< [m]
  double travel = 0;    ///< speed of the contact along the bar over that of the roller's axis
  Pack height, offset;  ///< of its centre [m]
  Pack low_w, low_u, high_w, high_u;  ///< direction of the face's normal at its ends
};

/// Constants of a pack of rollers and their pockets.
struct RollerGroup {
  Pack exists;                   ///< 1 for a roller, 0 for padding
  Pack mass, polar, transverse;  ///< [kg], [kg m^2]
  Pack inverse_mass, inverse_polar, inverse_transverse;
  Pack radius;                     ///< [m]
  Pack taper_slope;                ///< change of radius with position along the axis [-]
  Pack pocket_cos, pocket_sin;     ///< of the pocket centre's angle in the cage, deviation included
  Pack half_width, half_length;    ///< of the pocket [m]
  Pack squareness;                 ///< angle of the bar faces to the bearing axis [rad]
  Pack face_low, face_high;        ///< heights between which a flat face answers [m]
  OutlineArc face;                 ///< where faces are curved
  std::array<OutlineArc, 2> ends;  ///< edges or lips, at the bore and at the outside
};

inline constexpr int kMostSlices = 100;  ///< of a race: bounds scratch that lives on the stack

/// A slice of a roller: position along its axis and the drop of its profile [m].
struct Slice {
  double position;
  double drop;
};

/// A point of a roller's end face, relative to the centre of that face [m].
struct EndPoint {
  double radial, tangential;
};

/// An inclined flange that meets spherical-ended rollers (src/contacts/sphere_flange.hpp).
struct SphereFlange {
  bool on = false;
  double radius = 0;            ///< R_e [m]
  double centre = 0;            ///< e (L/2 - R_e): place of the sphere's centre on the axis [m]
  double sine = 0, cosine = 1;  ///< of the flange's angle
  double rest = 0;              ///< distance of the axes for which `clearance` holds [m]
  double stiffness = 0;         ///< K of K p^1.5 [N/m^1.5]
  double damping = 0;           ///< c_max [N s/m]
  double inverse_depth = 0;     ///< of the full damping [1/m]
  PointFilm film;
};

/// A flange of a ring, which holds rollers on one side.
struct Flange {
  bool inner = false;
  double side = 1;                 ///< e: -1 or 1
  double clearance = 0;            ///< from a roller's end that stands in the middle [m]
  std::array<EndPoint, 2> points;  ///< where a roller's end meets its rim
  FlatFilm film;                   ///< of one point
  SphereFlange sphere;             ///< instead of points and their film
};

/// What rubs on what, each pair with its friction; kEndPair: roller end on pocket side ring face.
enum FrictionPair { kRacePair, kBarPair, kEndPair, kFlangePair, kLandPair, kFrictionPairs };

/// A surface of a ring that the cage's lands may meet.
struct CageGuide {
  bool inner = false;      ///< of the inner ring
  double clearance = 0;    ///< radial [m]
  double touching_at = 0;  ///< offset at which lands touch: less than `clearance` under a film [m]
  double land_radius = 0, ring_radius = 0;  ///< [m]
  ShortBearing film;                        ///< of one land
};

/// From the power of a run to its temperature (src/operation/heat_shed.hpp).
struct HeatAccount {
  bool on = false;
  double found = 0, power = 0, slope = 1;  ///< of the nominal bearing [degC], [W], [W/K]
  double shed_slope = 0;                   ///< heat shed for each kelvin more [W/K]
};

struct BearingModel {
  StateLayout layout;
  std::vector<RollerGroup> groups;
  std::vector<Slice> race_slices;
  std::vector<double> bar_stations;     ///< positions along the roller's axis [m]
  std::array<EndPoint, 2> wall_points;  ///< where a roller end meets the pocket's side ring face
  double roller_half_length = 0;
  std::vector<Flange> flanges;  ///< of the outer ring, then of the inner one

  NormalLaw race, bar, wall, flange,
      land;  ///< each already the share of one slice, station, point or land
  std::array<FrictionLaw, kFrictionPairs> friction;
  bool lubricated = false;                ///< races by the laws below instead of `race`
  LubricatedLine inner_line, outer_line;  ///< of one slice
  LubricatedLine bar_line;                ///< of one station
  double film_watch = 0;      ///< normal force of a slice from which its film counts as loaded [N]
  LubricatedLine edge_line;   ///< the same at edges and lips
  bool oiled_bars = false;    ///< bars by these lines, instead of `bar`
  bool curved_faces = false;  ///< of the bars
  bool shaped_pockets = false;  ///< with lips or curved faces: not bounded by flats alone
  FlatFilm wall_film;           ///< of one point
  Churning churning;

  double inner_radius = 0, outer_radius = 0;  ///< actual race radii R_i, R_o [m]
  double race_modulus = 0;                    ///< E' of rollers and rings [Pa]
  RacewayForms forms;                         ///< of the raceways
  double misalignment_y = 0,
         misalignment_z = 0;  ///< tilt of the ring, or what its shaft would give it
  double ring_mass = 0, ring_polar = 0, ring_transverse = 0;
  double tilt_stiffness = 0;  ///< of the shaft, against the free tilt of the ring [N m/rad]
  double cage_mass = 0, cage_polar = 0, cage_transverse = 0;
  double unbalance_y = 0,
         unbalance_z = 0;  ///< mass centre minus geometric centre in the cage frame [m]
  Strength cage_strength;
  FlexibleCage flexible;  ///< no modes: a rigid cage
  Guidance guidance = Guidance::outer;
  /// The ring that guides the cage, then the other one, by which the cage is held if all else gives
  /// way; both where rollers guide it, the outer ring first.
  std::array<CageGuide, 2> guides;
  double guide_clearance = 0;  ///< radial, of what guides the cage [m]
  double land_offset = 0;      ///< lands are at x = +- this, ...
  double land_edge = 0;        ///< ... and touch at +- this from there; 0: at one point [m]

  Duty duty;
  double first_axial_load = 0;            ///< by whose side rollers start [N]
  double gravity = 0, gravity_axial = 0;  ///< along -z, along -x [m/s^2]

  HeatAccount heat;
  double pitch_radius = 0;      ///< (F + E)/4 of the actual raceways [m]
  double nominal_diameter = 0;  ///< roller diameter, mean of all [m]
};

/// Builds the model of a scene in operation (src/operation/operating_clearance.hpp), with the
/// elastic modes of `cage` where given. Throws std::domain_error for what cannot be built (the
/// reader checks scenes before).
BearingModel make_bearing_model(const OperatingScene& scene,
                                std::shared_ptr<const CageModel> cage = {});

/// Mass centre minus geometric centre of the cage in inertial directions (y, z) [m], at the cosine
/// and sine of its angle.
inline void turned_unbalance(const BearingModel& m, double cosine, double sine, double (&to)[2]) {
  to[0] = cosine * m.unbalance_y - sine * m.unbalance_z;
  to[1] = sine * m.unbalance_y + cosine * m.unbalance_z;
}

/// Kinematic cage speed (w_i R_i + w_o R_o) / (R_i + R_o) at these speeds of the rings [rad/s].
double kinematic_cage_speed(const BearingModel& model, const RingSpeeds& speeds);

/// Time between two rollers that pass one place, at the largest speeds of the duty; infinite where
/// nothing turns [s].
double roller_interval(const BearingModel& model);

/// Load and weight on the inner ring at time t [N], [N m].
RingLoad ring_force_at(const BearingModel& model, double t);

/// Axial length of one slice of a race [m].
double slice_length(const BearingModel& model);

/// Largest Hertzian pressure where slices of the inner and of the outer race bear these normal
/// forces [N], on rollers of mean diameter (contact_laws/hertz_line.hpp) [Pa].
double race_pressure(const BearingModel& model, double inner_slice, double outer_slice);

/// The least of the contacts' static speeds [m/s].
double minimum_static_speed(const BearingModel& model);

/// A pocket whose roller does not fit: clearance <= 0.
struct Jam {
  int pocket = -1;              ///< -1: none
  const char* where = "width";  ///< "width", "length", "lips at the bore", "lips at the outside"
  double interference = 0;      ///< [m], >= 0
};
/// The worst jam of the scene in operation.
Jam find_jam(const OperatingScene& scene);

}  // namespace cagetol
