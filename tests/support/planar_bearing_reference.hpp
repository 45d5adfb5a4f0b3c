// A lubricated bearing in the plane, written from the equations of its films, rolling resistance
// and traction alone (the tops of src/lubrication/*.hpp state them; no code of theirs is used): one
// contact at a time, vectors in y and z, std::pow, bisection, an integrator of its own. Slow and
// plain on purpose: a reference for tests.
//
// The outer ring is at rest, the inner one turns. Rollers have a place in the plane and a spin, the
// cage turns about the bearing's axis and is held there. Slices, profiles, tilt, flanges, pocket
// ends, bars that bend and heating in the inlet are left out.
#pragma once

namespace cagetol {

struct PlanarOil {
  double viscosity = 0.02, pressure_viscosity = 1.8e-8;              ///< eta [Pa s], alpha [1/Pa]
  double eyring = 5e6, limiting = 0.06;                              ///< tau_E [Pa], Lambda
  double race_roughness = 0.2e-6, pocket_roughness = 0.2e-6;         ///< composite, rms [m]
  double race_layer = 20e-6, outer_layer = 0, pocket_layer = 20e-6;  ///< gaps with oil; 0: all [m]
};

/// Adams' friction of asperities: mu_s at v_s, mu_d from v_d on.
struct PlanarFriction {
  double static_coefficient = 0.07, dynamic_coefficient = 0.06;
  double static_speed = 0.1, dynamic_speed = 1;  ///< [m/s]
};

/// The reference bearing NU 205 at 6000 rpm and 1 kN.
struct PlanarBearing {
  int rollers = 13;
  double roller_radius = 3.75e-3, roller_length = 9e-3;         ///< [m]
  double inner_radius = 15.7425e-3, outer_radius = 23.2575e-3;  ///< actual ones of the races [m]
  double roller_density = 7810;                                 ///< [kg/m3]
  double race_modulus = 208e9 / 0.91,
         bar_modulus = 2 / (0.91 / 208e9 + 0.91 / 206e9);  ///< E' [Pa]
  double half_clearance = 75e-6;                           ///< of a pocket [m]
  double cage_inertia = 1.81804e-5;                        ///< [kg m2]
  double chi = 0;                          ///< Hunt-Crossley damping of bodies [s/m]
  double inner_speed = 628.3185307179586;  ///< [rad/s]
  double load = 1000;                      ///< on the inner ring, along -z [N]
  PlanarOil oil;
  PlanarFriction friction;
  double drag_density = 0;    ///< of the fluid in the free space, 0: no drag [kg/m3]
  double drag_carried = 0.5;  ///< the fluid's speed over the cage's
  double land_moment = 0;     ///< of the guide lands' oil, per speed of the cage [N m s]
};

/// One line contact between given bodies.
struct PlanarContact {
  double viscosity, pressure_viscosity, eyring, limiting, roughness;
  double radius, length, modulus;  ///< R, L [m], E' [Pa]
  double approach;                 ///< a of delta = a q^0.9 [m (m/N)^0.9]
  double layer;                    ///< of oil [m]; 0: flooded
  double chi;
  PlanarFriction friction;
};
PlanarContact inner_race_contact(const PlanarBearing& bearing);
PlanarContact outer_race_contact(const PlanarBearing& bearing);
PlanarContact bar_contact(const PlanarBearing& bearing);

struct PlanarContactForces {
  double normal = 0;     ///< Q [N]
  double steady = 0;     ///< of it, that of the steady film [N]
  double film = 0;       ///< of it, that of the film with squeeze [N]
  double traction = 0;   ///< on the surface that slides with `sliding`, against it [N]
  double rolling = 0;    ///< F_r, signed as `entrainment` [N]
  double thickness = 0;  ///< h [m]
  /// About -dQ/d gap, -dQ/d rate and d traction/d sliding, for an implicit integrator.
  double stiffness = 0, damping = 0, slope = 0;
};
/// `gap` of the undeformed bodies, its `rate`; `entrainment` and `sliding` signed, along one
/// direction. `log_load`, where given, is the solution's start and becomes its result, ln q.
PlanarContactForces contact_forces(const PlanarContact& contact, double gap, double rate,
                                   double entrainment, double sliding, double* log_load = nullptr);

/// Motion of a body in the plane; `spin` counted from y to z.
struct PlanarBody {
  double y = 0, z = 0, vy = 0, vz = 0, spin = 0;
};
/// Losses of one instant or means of a run [W].
struct PlanarLosses {
  double rolling = 0, sliding = 0, pocket = 0, squeeze = 0, drag = 0, lands = 0;
  double total() const { return rolling + sliding + pocket + squeeze + drag + lands; }
};
/// What one roller feels and what it does to others.
struct PlanarRollerForces {
  double y = 0, z = 0, moment = 0;               ///< on the roller [N], [N m]
  double ring_y = 0, ring_z = 0;                 ///< on the inner ring [N]
  double ring_moment = 0, cage_moment = 0;       ///< about the ring's axis, the bearing's [N m]
  double inner = 0, outer = 0, bar[2] = {0, 0};  ///< normal forces; bars ahead, behind [N]
  double outer_y = 0, outer_z = 0, outer_moment = 0;  ///< on the outer ring
  double bar_y = 0, bar_z = 0;                        ///< on the cage
  double film = 0;  ///< power that steady films and bodies take: -Q_w dg/dt [W]
  PlanarLosses losses;
  PlanarContactForces inner_contact, outer_contact, bar_contacts[2];
  double inner_rate = 0, outer_rate = 0, bar_rate[2] = {0, 0};  ///< of their gaps [m/s]
};
/// `pocket`: angle of the middle of its pocket. `starts`: ln q of inner, outer, bar ahead, behind.
PlanarRollerForces roller_forces(const PlanarBearing& bearing, const PlanarBody& ring,
                                 const PlanarBody& roller, double pocket, double cage_speed,
                                 double* starts = nullptr);

struct PlanarRun {
  double start = 1;                                 ///< cage speed over the kinematic one
  double settle = 0.3, measure = 0.3, step = 2e-6;  ///< [s]
  /// The inner ring follows its load against this dashpot, without mass; 0: held at its static
  /// displacement. A bearing that skids has thinner films and lighter rollers: held, its ring bears
  /// less than the load [N s/m].
  double ring_dashpot = 2e4;
};
struct PlanarOutcome {
  double displacement = 0;           ///< of the ring along the load, mean [m]
  double cage_slip = 0;              ///< 1 - cage speed over the kinematic one
  double torque = 0;                 ///< losses over the inner ring's speed [N m]
  double drive = 0;                  ///< mean moment that keeps the inner ring turning [N m]
  double bar_rms = 0, bar_peak = 0;  ///< of a roller's force on its bars, both added [N]
  double cage_drift = 0;  ///< change of the cage's speed from the window's first half to its second
                          ///< over its mean
  PlanarLosses losses;
};
double kinematic_speed(const PlanarBearing& bearing);
/// At which the rollers bear the load, averaged over their places; they roll without slip.
double static_displacement(const PlanarBearing& bearing);
/// From the ring's static displacement and rollers that roll.
PlanarOutcome planar_bearing_run(const PlanarBearing& bearing, const PlanarRun& run);

}  // namespace cagetol
