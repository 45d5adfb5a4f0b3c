#include "src/quantities/quantity_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/quantities/quantity_rows.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

using Run = const JudgedRun&;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kLoadMargin = 4;    // a suddenly applied load presses twice as hard as at rest
constexpr double kStrainMax = 0.05;  // beyond it no cage is elastic
constexpr double kClearanceMargin = 1.05;  // beyond it a cage has left what holds it
constexpr double kInclined = 3;            // lips stand 70 degrees from the motion at most
constexpr double kLargestGapAngle = 1.4;   // between rollers that hold the ring, from below [rad]
constexpr double kForceMargin = 10;  // between states an acceleration is a cubic, forces are not

// Means are integrals over, and values between states lie on, parabolas through three states, which
// pass the largest state a little where steps grow quickly.
constexpr double kOrderMargin = 2;

/// How far the inner ring moves from the middle at most [m], and the energy of the parts that move
/// and of the load over that way [J].
struct Hold {
  double way = 0, energy = 0;
};

/// Clearance, more where the ring sinks between two rollers, and elastic approach.
Hold hold_of(Run run) {
  const BearingModel& m = run.model;
  double mass = 0, smallest = kInfinite, widest = 0, waves = 0;
  for (int j = 0; j < m.layout.rollers; ++j) {
    const RollerGroup& g = m.groups[static_cast<std::size_t>(j / kLanes)];
    const double radius = g.radius[j % kLanes], gap = g.half_width[j % kLanes] - radius;
    mass += g.mass[j % kLanes];
    smallest = std::min(smallest, radius);
    widest = std::max(widest, std::abs(each(run.scene.cage.pocket_pitch, j)) +
                                  std::max(gap, 0.0) / m.pitch_radius);
  }
  for (const auto* form : {&m.forms.inner, &m.forms.outer})
    for (const Waviness& wave : *form) waves += std::abs(wave.amplitude);
  const RingSpeeds rings = fastest_speeds(m.duty);
  const RingLoad load = heaviest_load(m.duty);
  const double cage_speed = kinematic_cage_speed(m, rings),
               surface = rings.inner * m.inner_radius + rings.outer * m.outer_radius,
               gap = m.outer_radius - m.inner_radius - 2 * smallest,
               preload = std::max(0.0, waves - gap) + 2e-6,
               lean = m.roller_half_length * std::hypot(m.misalignment_y, m.misalignment_z),
               pressed = largest_load(m.duty) + (m.ring_mass + mass) * std::abs(m.gravity) +
                         mass * m.pitch_radius * cage_speed * cage_speed +
                         std::hypot(load.moment_y, load.moment_z) / m.roller_half_length,
               slices = static_cast<double>(m.race_slices.size()),
               approach = elastic_penetration(m.race, kLoadMargin * pressed / slices),
               between =
                   std::min(std::numbers::pi / m.layout.rollers + 2 * widest, kLargestGapAngle);
  const double drop = 0.00035 * m.nominal_diameter * std::log(1e4);  // of a roller's profile
  const double way =
      (std::max(gap, 0.0) + waves + 2 * approach + preload + lean + drop) / std::cos(between);
  return {way, (mass + m.cage_mass) * surface * surface + 2 * kLoadMargin * pressed * way};
}

/// Of the cage's centre, over the guide clearance: that, what the guide deflects under the largest
/// forces of the run, all of it on one contact whose normal is inclined to the centre's motion, and
/// what an elastic cage deforms.
double whirl_held(Run run) {
  const BearingModel& m = run.model;
  const auto& cage = run.scene.cage;
  const bool rollers = m.guidance == Guidance::roller;
  const double force = run.quantities[rollers ? quantity_row("pocket_force_peak_N")
                                              : quantity_row("guide_force_peak_N")],
               bent = m.flexible.model ? (cage.outer_diameter - cage.inner_diameter) / 2 : 0,
               way = bent + (m.guidance == Guidance::outer ? 0 : hold_of(run).way) +
                     kInclined * elastic_penetration(rollers ? m.bar : m.land, force);
  return kClearanceMargin + way / m.guide_clearance;
}

/// Under the largest forces of the run [m/s^2].
double ring_acceleration(Run run) {
  const BearingModel& m = run.model;
  const double rollers = m.layout.rollers * run.quantities[quantity_row("roller_load_peak_N")],
               guide = std::fmax(0, run.quantities[quantity_row("guide_force_peak_N")]),
               load = largest_load(m.duty);
  return kForceMargin * ((rollers + guide + load) / m.ring_mass + std::abs(m.gravity));
}

/// Whether rolling turns the cage throughout the window, one way.
bool turns(Run run) {
  const Duty& duty = run.model.duty;
  const double first = kinematic_cage_speed(run.model, ring_speeds_at(duty, run.begin));
  return !duty.over_time() && first * kinematic_cage_speed(run.model, duty.speed) > 0;
}

std::string digits(double value) {
  return fmt::format("{:.4g}", value);
}

/// A quantity and its value.
std::string said(const Quantity& quantity, double value) {
  const std::string unit = quantity.unit;
  return std::string(quantity.key) + " = " + digits(value) + (unit == "-" ? "" : " " + unit);
}

// clang-format off
constexpr const char* kRing = "the inner ring moves no farther than the clearance and the elastic approach of one roller under four times all that presses on it";
constexpr const char* kRingRemedy = "check bearing.internal_clearance_um, roller.diameter_mm, the load and contact.race, and tighten integration.tolerance";
constexpr const char* kStressRemedy = "make the cage table again (remove the cage cache), check cage.young_GPa and the bar forces, and tighten integration.tolerance";

}  // namespace

namespace bound {
const Bound finite{[](Run) { return ValueRange{-kInfinite, kInfinite}; }, ""};
const Bound not_negative{[](Run) { return ValueRange{0, kInfinite}; }, "a magnitude is not negative"};
const Bound share{[](Run) { return ValueRange{0, 1}; }, "a share lies between 0 and 1"};
const Bound slip{[](Run) { return ValueRange{-kInfinite, 1}; }, "a roller that does not spin at all slips by 1"};
const Bound circle{[](Run) { return ValueRange{0, 360 * (1 + 1e-9)}; }, "rollers are loaded at most all round"};
const Bound lean{[](Run) { return ValueRange{0, 1e3 * kLeanMax}; }, "the equations hold for small angles, up to 0.1 rad; beyond, parts tumble", "raise discretisation.race_slices to at least 3, check bearing.tilt_stiffness_N_m_rad and the end and flange clearances, and tighten integration.tolerance"};
const Bound whirl{[](Run r) { return ValueRange{0, whirl_held(r)}; }, "the cage would have left its guide: its centre moves no farther than 1.05 of the guide clearance and what the guide deflects under the forces of this run", "set cage.guidance = \"outer\" or \"inner\", or give the pockets of a cage that rollers guide lips that hold it (cage.retention_width_outer_mm); else tighten integration.tolerance and check cage.guide_clearance_mm, contact.land and start.cage_offset"};
const Bound axial{[](Run r) { return ValueRange{0, 2e6 * r.model.roller_half_length}; }, "the cage would have left the rollers, which are no longer", "check cage.pocket_length_mm, bearing.flange_clearance_mm and contact.end, and tighten integration.tolerance"};
const Bound ring_place{[](Run r) { return ValueRange{-1e6 * hold_of(r).way, 1e6 * hold_of(r).way}; }, kRing, kRingRemedy};
const Bound ring_orbit{[](Run r) { return ValueRange{0, 2e6 * hold_of(r).way}; }, kRing, kRingRemedy};
const Bound ring_acceleration{[](Run r) { return ValueRange{0, cagetol::ring_acceleration(r)}; }, "load and weight, and the largest force of this run on every roller, accelerate the ring by a tenth of that at most", kRingRemedy};
const Bound loss{[](Run r) { return ValueRange{-hold_of(r).energy / (r.end - r.begin), kInfinite}; }, "contacts dissipate; no more comes back than the bearing holds"};
const Bound stress{[](Run r) { return ValueRange{0, 1e-6 * kStrainMax * cage_material(r.scene).young}; }, "it would strain the cage by more than 5 %, where no cage is elastic", kStressRemedy};
const Bound pocket{[](Run r) { return ValueRange{0, r.model.layout.rollers - 1.0}; }, "the cage has no such pocket", kStressRemedy};
const Bound station{[](Run r) { return ValueRange{0, r.model.flexible.model->stress_stations - 1.0}; }, "the cage has no such stress station", kStressRemedy};
}  // namespace bound
// clang-format on

std::string find_impossible(const JudgedRun& run) {
  const bool turning = turns(run);
  for (std::size_t i = 0; i < kQuantityRows.size(); ++i) {
    const Quantity& row = kQuantityRows[i];
    const Given given = row.need.given;
    const double x = run.quantities[i];
    const auto problem = [&](const std::string& what, const std::string& why) {
      return what + ", which is impossible: " + why + "; remedy: " + row.bound.remedy;
    };
    if (!std::isfinite(x)) {
      if (given != Given::always && !turning) continue;
      if (std::isnan(x) && (given == Given::perhaps || !row.need.met(run.scene))) continue;
      return problem(std::string(row.key) + " is " + (std::isnan(x) ? "no number" : "infinite") +
                         " where the run must give one",
                     "a state or a contact is not finite");
    }
    const auto [low, high] = row.bound.range(run);
    if (x < low) return problem(said(row, x) + " is below " + digits(low), row.bound.reason);
    if (x > high) return problem(said(row, x) + " is beyond " + digits(high), row.bound.reason);
    // Where peaks are taken over a part of the window, a mean goes on.
    if (!*row.peak || row.kind == Kind::place || (run.peaks_in_part && !is_extreme(row.kind)))
      continue;
    const auto peak = static_cast<std::size_t>(quantity_index(row.peak));
    if (const double most = run.quantities[peak]; most >= 0 && x > kOrderMargin * most)
      return problem(said(row, x) + " is beyond " + said(kQuantityRows[peak], most),
                     "a mean or quantile does not exceed the largest value");
  }
  return {};
}

}  // namespace cagetol
