#include "src/quantities/plausible_reach.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kSpeedMargin = 2;   // friction drives no part faster than the race's surface
constexpr double kLoadMargin = 4;    // a suddenly applied load presses twice as hard as at rest
constexpr double kStrainMax = 0.05;  // beyond it no cage is elastic
constexpr double kClearanceMargin = 1.05;  // beyond it a cage has left what holds it
constexpr double kInclined = 3;            // lips stand 70 degrees from the motion at most
constexpr double kFilmMargin = 20;  // integrals over half a film, 2 pi + 4 + pi at most, rounded up
constexpr double kFilmShare = 0.01;       // of a roller's radius: the films of the theory are thin
constexpr double kLargestGapAngle = 1.4;  // between rollers that hold the ring, from below [rad]

double largest_friction(const BearingModel& m) {
  double largest = m.lubricated ? m.inner_line.traction.limiting : 0;
  for (const FrictionLaw& law : m.friction)
    largest = std::max({largest, law.static_coefficient, law.dynamic_coefficient});
  return largest;
}

/// Of oil on the inner ring, rings and rollers pressed together by `races` and sliding at `surface`
/// speed: rolling resistance is less than between rigid bodies, the inlet's shear than in a gap of
/// the height of roughness [N m].
double oil_torque(const BearingModel& m, double races, double surface) {
  const Traction& t = m.outer_line.traction;
  const double length = 2 * m.roller_half_length, eta = t.viscosity;
  const double rolling = 2.0796 * std::sqrt(eta * surface * races / length) * length,
               shear = 2.849 * eta * surface * std::sqrt(t.radius / t.roughness) * length;
  const Churning& c = m.churning;
  const double bore = c.on && c.bore_gap > 0 ? gap_moment(c.fluid, surface / m.inner_radius,
                                                          c.inner_radius, c.width, c.bore_gap)
                                             : 0;
  return 4 * m.layout.rollers * (rolling + shear) * m.outer_radius + bore;
}

/// Several equal shares of one kind of contact.
struct Contact {
  const NormalLaw& law;
  double shares;

  /// At which they hold so much elastic energy [m].
  double depth(double energy) const {
    const double e = law.exponent;
    return 1e-6 * std::pow(1e6 * energy * (e + 1) / (shares * law.stiffness), 1 / (e + 1));
  }
  double energy(double depth) const { return shares * elastic_energy(law, std::max(depth, 0.0)); }
  /// At rest under a force [m].
  double depth_under(double force) const { return elastic_penetration(law, force / shares); }
  /// At a depth, closing at a speed [N].
  double force(double depth, double speed) const {
    const double elastic = shares * law.stiffness * std::pow(1e6 * depth, law.exponent);
    return law.hertz ? elastic * (1 + law.chi * speed) : elastic + shares * law.damping * speed;
  }
  double stiffness(double depth) const {
    return shares * law.stiffness * std::pow(1e6 * depth, law.exponent - 1) * 1e6 * law.exponent;
  }
};

/// Farthest that a flange lets a roller go from the middle [m].
double widest_flange_gap(const BearingModel& m) {
  double widest = 0, inner = 0;
  for (const Flange& flange : m.flanges) (flange.inner ? inner : widest) = flange.clearance;
  return widest + inner;
}

/// Slowest magnitude of a speed that ramps smoothly from one value to another.
double slowest_of(double first, double last) {
  return first * last <= 0 ? 0 : std::min(std::abs(first), std::abs(last));
}

}  // namespace

PlausibleReach::PlausibleReach(const Scene& scene, const BearingModel& m, const PlausibleRun& run)
    : flexible(m.layout.modes > 0 || m.flexible.model != nullptr),
      planar(m.planar),
      tilts(m.layout.ring_tilt > 0),
      quasi_static(run.quasi_static),
      peaks_in_part(run.peaks_in_part),
      rollers(m.layout.rollers),
      duration(run.end - run.begin),
      revolutions(run.revolutions),
      steps(run.steps),
      guide_clearance(m.guide_clearance) {
  double mass = 0, smallest = 1e30, lightest = 1e30, pinch = 0, length_pinch = 0, play = 0,
         pocket_play = 1e30, widest_gap = 0;
  for (int j = 0; j < rollers; ++j) {
    const RollerGroup& g = m.groups[static_cast<std::size_t>(j / kLanes)];
    const int lane = j % kLanes;
    mass += g.mass[lane];
    lightest = std::min(lightest, g.mass[lane]);
    smallest = std::min(smallest, g.radius[lane]);
    const double gap = g.half_width[lane] - g.radius[lane];
    const double slack = g.half_length[lane] - m.roller_half_length;
    pinch = std::max(pinch, -gap);
    pocket_play = std::min(pocket_play, gap);
    length_pinch = std::max(length_pinch, -slack);
    play = std::max(play, slack);
    widest_gap = std::max(widest_gap, std::abs(each(scene.cage.pocket_pitch, j)) +
                                          std::max(gap, 0.0) / m.pitch_radius);
  }
  const RingSpeeds rings = fastest_speeds(m.duty);
  fastest = rings.inner + rings.outer;
  const RingSpeeds first = ring_speeds_at(m.duty, run.begin), &last = m.duty.speed;
  slowest = slowest_of(kinematic_cage_speed(m, first), kinematic_cage_speed(m, last));
  apart = slowest_of(first.inner - first.outer, last.inner - last.outer);
  over_time = m.duty.over_time();
  if (over_time) slowest = apart = 0;
  turns = slowest > 0;
  const double gravity = std::abs(m.gravity),
               surface = rings.inner * m.inner_radius + rings.outer * m.outer_radius;

  // The inner ring: clearance, more where it sinks between two rollers, and elastic approach.
  const Contact race{m.race, static_cast<double>(m.race_slices.size())};
  const double speed_of_cage = kinematic_cage_speed(m, rings);
  const double centrifugal = mass * m.pitch_radius * speed_of_cage * speed_of_cage;
  const RingLoad load = heaviest_load(m.duty);
  const double at_rest = largest_load(m.duty) + (m.ring_mass + mass) * gravity + centrifugal +
                         std::hypot(load.moment_y, load.moment_z) / m.roller_half_length;
  const double gap = m.outer_radius - m.inner_radius - 2 * smallest;
  double lobes = 0;
  for (const auto* form : {&m.forms.inner, &m.forms.outer})
    for (const Lobes& wave : *form) lobes += std::abs(wave.amplitude);
  const double preload = std::max(0.0, lobes - gap) + 2e-6;
  const double between = std::min(pi / rollers + 2 * widest_gap, kLargestGapAngle);
  const double lean = m.roller_half_length * std::hypot(m.misalignment_y, m.misalignment_z);
  ring_move = (std::max(gap, 0.0) + lobes + 2 * race.depth_under(kLoadMargin * at_rest) + preload +
               lean + 0.00035 * m.nominal_diameter * std::log(1e4)) /
              std::cos(between);

  const ShortBearing& guide_film = m.guides[0].film;
  // Energy: everything at the largest speed, load and weight over the way of the ring, and what a
  // start away from the middle presses together.
  const Contact bars{m.bar, 2.0 * static_cast<double>(m.bar_stations.size())};
  const Contact walls{m.wall, 4}, lands{m.land, m.land_edge > 0 ? 4.0 : 2.0}, flanges{m.flange, 4};
  const double offset = std::hypot(scene.start.cage_offset_y, scene.start.cage_offset_z);
  const double offset_x = std::abs(scene.start.cage_offset_x);
  const double fall = std::sqrt(4 * gravity * m.outer_radius);
  speed = kSpeedMargin * (surface + fall);
  energy = speed * speed * (0.75 * mass + m.cage_mass) + 2 * kLoadMargin * at_rest * ring_move +
           rollers * (race.energy(preload) + bars.energy(offset - pocket_play + pinch) +
                      walls.energy(offset_x + length_pinch)) +
           lands.energy(offset - m.guides[0].touching_at);
  speed += std::sqrt(2 * energy / m.ring_mass);
  orbit_rate = speed / m.pitch_radius;

  pocket_force = bars.force(bars.depth(energy) + pinch, 2 * speed);
  end_force = walls.force(walls.depth(energy) + length_pinch, 2 * speed);
  const double pressed = lands.depth(energy);
  guide_force = lands.force(pressed, 2 * speed);
  if (guide_film.on) {
    const double h = guide_film.least;
    guide_force +=
        kFilmMargin * guide_film.pressure / (h * h * h) * (fastest * m.guide_clearance + 2 * speed);
  }
  race_force = race.force(race.depth(energy) + preload, 2 * speed);
  race_pressure = cagetol::race_pressure(m, race_force, race_force);
  const Contact all_races{m.race, race.shares * rollers};
  const double races = all_races.force(all_races.depth(energy) + preload, 2 * speed);
  ring_acceleration = (races + largest_load(m.duty) + guide_force) / m.ring_mass + gravity;
  touch_rate = std::sqrt(std::max({bars.stiffness(bars.depth(energy) + pinch),
                                   walls.stiffness(walls.depth(energy) + length_pinch),
                                   lands.stiffness(pressed)}) /
                         std::min(lightest, m.cage_mass)) /
               pi;

  // The cage: its guide and what that gives way; rollers that guide it move between the races.
  const double wall = (scene.cage.outer_diameter - scene.cage.inner_diameter) / 2;
  const double bent = flexible ? wall : 0;
  const double guide = m.guidance == Guidance::outer   ? pressed
                       : m.guidance == Guidance::inner ? pressed + ring_move
                                                       : bars.depth(energy) + std::max(gap, 0.0);
  whirl = bent + kClearanceMargin * m.guide_clearance + guide;
  rollers_guide_ = m.guidance == Guidance::roller;
  guide_ = rollers_guide_ ? m.bar : m.land;
  whirl_free_ = bent + kClearanceMargin * m.guide_clearance +
                (m.guidance == Guidance::outer   ? 0
                 : m.guidance == Guidance::inner ? ring_move
                                                 : std::max(gap, 0.0));
  axial = play + widest_flange_gap(m) + walls.depth(energy) + flanges.depth(energy) +
          kLeanMax * m.nominal_diameter + offset_x;

  stress = kStrainMax * cage_material(scene).young;
  const Strength strength = cage_strength(scene);
  yield = stress / strength.yield;
  // Components within +-stress have a von Mises stress up to sqrt(3 + 9) times it, a principal
  // stress up to three times it.
  fatigue = 4 * stress / strength.fatigue + 3 * stress / strength.tensile;
  power = energy / duration;
  stations = flexible ? static_cast<double>(m.flexible.model->stress_stations) : 0;
  film_thickest = kFilmShare * m.nominal_diameter / 2;
  lambda_thickest = m.lubricated ? film_thickest / m.inner_line.traction.roughness : 0;
  torque = largest_friction(m) * (races + guide_force) * m.inner_radius +
           (m.lubricated ? oil_torque(m, races, speed) : 0) +
           (guide_film.on ? 2 * guide_film.torque * speed / m.inner_radius / guide_film.least : 0);
}

// One contact may take the whole force, and the cage's centre goes farther than a contact gives way
// whose normal is inclined to its motion.
double PlausibleReach::whirl_under(double guide_peak, double pocket_peak) const {
  return whirl_free_ +
         kInclined * elastic_penetration(guide_, rollers_guide_ ? pocket_peak : guide_peak);
}

}  // namespace cagetol
