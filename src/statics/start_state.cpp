#include "src/statics/start_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/statics/static_equilibrium.hpp"
#include "src/statics/steady_start.hpp"

namespace cagetol {
namespace {

/// Between the values of a turn at equal angles from zero.
double at_angle(const std::vector<double>& turn, double angle) {
  const double count = static_cast<double>(turn.size());
  const double place = angle / (2 * std::numbers::pi) * count, below = std::floor(place);
  const auto value = [&](double n) {
    return turn[static_cast<std::size_t>(n - count * std::floor(n / count))];
  };
  return value(below) + (place - below) * (value(below + 1) - value(below));
}

/// Where roller `j` has the gap to its bar that a mean one has `ahead` of the middle [m].
double place_in_pocket(const BearingModel& m, int j, double ahead) {
  if (j >= m.layout.rollers) return 0;
  const auto play = [&](int k) {
    const RollerGroup& g = m.groups[static_cast<std::size_t>(k / kLanes)];
    return g.half_width[k % kLanes] - g.radius[k % kLanes];
  };
  double mean = 0;
  for (int k = 0; k < m.layout.rollers; ++k) mean += play(k) / m.layout.rollers;
  const double own = play(j) - mean;
  return ahead > 0 ? std::max(ahead + own, 0.0) : std::min(ahead - own, 0.0);
}

/// Gives rollers the spins of a turn, and the places in their pockets.
void put_rollers(const BearingModel& m, const Start& start, const OrbitTurn& turn,
                 const std::vector<double>& angle, std::vector<double>& y) {
  const auto at = [&](int slot) -> double& { return y[static_cast<std::size_t>(slot)]; };
  for (int j = 0; j < m.layout.padded(); ++j) {
    const double a = angle[static_cast<std::size_t>(j)];
    const double ahead = place_in_pocket(m, j, at_angle(turn.offset, a)) -
                         start.cage_offset_y * std::sin(a) + start.cage_offset_z * std::cos(a);
    at(m.layout.position(kAngle, j)) += ahead / at(m.layout.position(kRadius, j));
    at(m.layout.velocity(kSpin, j)) = at_angle(turn.spin, a);
  }
}

}  // namespace

std::vector<double> roller_angles(const BearingModel& m, double cage_phase) {
  const StateLayout& l = m.layout;
  std::vector<double> angle(static_cast<std::size_t>(l.padded()));
  for (int j = 0; j < l.padded(); ++j) {
    const RollerGroup& g = m.groups[static_cast<std::size_t>(j / kLanes)];
    angle[static_cast<std::size_t>(j)] =
        cage_phase + (j < l.rollers ? std::atan2(g.pocket_sin[j % kLanes], g.pocket_cos[j % kLanes])
                                    : 2 * std::numbers::pi * j / l.padded());
  }
  return angle;
}

std::vector<double> start_state(const BearingModel& m, const Start& start) {
  const StateLayout& l = m.layout;
  std::vector<double> y(static_cast<std::size_t>(l.size()), 0.0);
  const auto at = [&](int slot) -> double& { return y[static_cast<std::size_t>(slot)]; };
  const bool settled = start.state != StartState::centred;
  const bool seeks =
      start.state == StartState::steady || (start.state == StartState::automatic && m.lubricated);
  const SteadyStart steady = seeks ? find_steady_start(m) : SteadyStart{};
  const RingSpeeds rings = ring_speeds_at(m.duty, 0);
  const double cage_speed = steady.found ? steady.turn.cage_speed : kinematic_cage_speed(m, rings);

  const std::vector<double> angle = roller_angles(m, start.cage_phase);
  StaticEquilibrium equilibrium(m);
  equilibrium.turn_outer(rings.outer);
  const StaticState* rest =
      settled ? &equilibrium.solve(angle.data(), cage_speed, load_at(m.duty, 0)) : nullptr;
  for (int j = 0; j < l.padded(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    const double a = angle[k], radius = rest ? rest->radius[k] : m.pitch_radius;
    const double roller_radius = m.groups[static_cast<std::size_t>(j / kLanes)].radius[j % kLanes];
    at(l.position(kRadius, j)) = radius;
    at(l.position(kAngle, j)) = a;
    const double tilt = rest ? rest->tilt[k] : 0;
    at(l.position(kAxisY, j)) = tilt * std::cos(a);
    at(l.position(kAxisZ, j)) = tilt * std::sin(a);
    at(l.velocity(kOrbitRate, j)) = cage_speed;
    // Pure rolling at both races: R_pitch w_c - R_w w_s = R_i w_i.
    at(l.velocity(kSpin, j)) =
        (m.pitch_radius * cage_speed - m.inner_radius * rings.inner) / roller_radius;
    // The tilt goes round with the roller.
    at(l.velocity(kAxisRateY, j)) = -tilt * cage_speed * std::sin(a);
    at(l.velocity(kAxisRateZ, j)) = tilt * cage_speed * std::cos(a);
  }
  if (steady.found) put_rollers(m, start, steady.turn, angle, y);
  if (rest) {
    at(l.border_position(kRingY)) = rest->ring_y;
    at(l.border_position(kRingZ)) = rest->ring_z;
  }
  if (l.ring_axial > 0) {
    // An axial load closes the gaps: rollers at the outer flange, the inner one at the rollers.
    const double way = m.first_axial_load > 0 ? 1 : -1;
    double outer = 0, inner = 0;
    for (const Flange& flange : m.flanges) (flange.inner ? inner : outer) = flange.clearance;
    for (int j = 0; j < l.rollers; ++j) at(l.position(kAxial, j)) = way * outer;
    at(l.border_position(l.ring_axial_slot())) = way * (outer + inner);
  }
  if (l.ring_tilt > 0) {
    at(l.border_position(l.ring_tilt_slot())) = rest ? rest->tilt_y : m.misalignment_y;
    at(l.border_position(l.ring_tilt_slot() + 1)) = rest ? rest->tilt_z : m.misalignment_z;
  }
  at(l.border_position(kCagePhi)) = start.cage_phase;
  at(l.border_velocity(kCagePhi)) = cage_speed;
  // The scene speaks of the geometric centre, the state of the mass centre.
  const double c = std::cos(start.cage_phase), s = std::sin(start.cage_phase);
  double e[2];
  turned_unbalance(m, c, s, e);
  at(l.border_position(kCageY)) = start.cage_offset_y + e[0];
  at(l.border_position(kCageZ)) = start.cage_offset_z + e[1];
  at(l.border_position(kCageX)) = start.cage_offset_x + at(l.position(kAxial, 0));
  at(l.border_velocity(kCageY)) = -cage_speed * e[1];
  at(l.border_velocity(kCageZ)) = cage_speed * e[0];
  if (m.flexible.centrifugal)  // spun out already
    for (int k = 0; k < l.modes; ++k)
      at(l.border_position(kModes + k)) = cage_speed * cage_speed *
                                          m.flexible.model->centrifugal[k] /
                                          m.flexible.stiffness[static_cast<std::size_t>(k)];
  return y;
}

}  // namespace cagetol
