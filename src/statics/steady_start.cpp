#include "src/statics/steady_start.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "src/contacts/land_contacts.hpp"

namespace cagetol {
namespace {

/// Cage speeds of the search over that without slip. An inner ring that guides the cage may drive
/// it beyond.
constexpr std::initializer_list<double> kShares = {1.01, 1,    0.99, 0.97, 0.93, 0.85, 0.72,
                                                   0.55, 0.38, 0.22, 0.1,  0.03, 0};
constexpr std::initializer_list<double> kFaster = {1.01, 1.03, 1.1, 1.3, 1.6, 2, 2.6};
constexpr double kSpeedWithin = 1e-6;  ///< share of the speed without slip
constexpr int kMostTrials = 40;

}  // namespace

CageRest cage_rest(const BearingModel& model, double cage_speed, const RingSpeeds& rings,
                   double force_y, double force_z) {
  CageRest rest;
  if (model.guidance == Guidance::roller) return rest;
  static const FlexibleCage rigid;
  const ModalState modal{&rigid, nullptr, nullptr, nullptr, 0};
  BearingModel straight = model;
  straight.misalignment_y = straight.misalignment_z = 0;
  const auto lands_at = [&](double y, double z) {
    BorderState b{};
    b.cage[0] = y;
    b.cage[1] = z;
    b.phi_rate = cage_speed;
    b.phi_cos = 1;
    b.speed = rings;
    BorderLoads loads;
    land_contacts<false>(straight, b, modal, loads, nullptr, nullptr, nullptr, nullptr);
    return loads;
  };
  // What lands answer grows with the distance and turns with the place.
  const double push = std::hypot(force_y, force_z);
  double near = 0, far = 2 * model.guide_clearance;
  while (far - near > 1e-15) {
    const double middle = (near + far) / 2;
    if (middle == near || middle == far) break;
    const BorderLoads on = lands_at(middle, 0);
    (std::hypot(on.cage[0], on.cage[1]) < push ? near : far) = middle;
  }
  const BorderLoads on = lands_at(far, 0);
  const double angle = std::atan2(-force_z, -force_y) - std::atan2(on.cage[1], on.cage[0]);
  rest.y = far * std::cos(angle);
  rest.z = far * std::sin(angle);
  rest.torque = on.cage[3];
  return rest;
}

SteadyStart find_steady_start(const BearingModel& model) {
  SteadyStart start;
  const RingSpeeds rings = ring_speeds_at(model.duty, 0);
  const double rolling = kinematic_cage_speed(model, rings);
  if (!model.lubricated || rolling == 0 || rings.inner == rings.outer) return start;
  RollerOrbit orbit(model);
  bool sound = true;
  // Torque on the cage along its turning, at a share of the speed without slip.
  const auto torque = [&](double share) {
    const double w = share * rolling;
    sound = orbit.solve(w);
    const OrbitTurn& turn = orbit.turn();
    start.rest =
        cage_rest(model, w, rings, turn.force_y, turn.force_z - model.cage_mass * model.gravity);
    const double churned =
        model.churning.on ? cage_churning(model.churning, w, rings.inner, rings.outer).cage : 0;
    return (turn.torque + start.rest.torque + churned) * (rolling < 0 ? -1 : 1);
  };
  struct Trial {
    double share, torque;
  };
  struct Bracket {
    Trial slow, fast;  ///< the cage is driven, and braked
  };
  const auto at = [&](double share) { return Trial{share, torque(share)}; };
  const auto bracket = [&](std::initializer_list<double> shares) -> std::optional<Bracket> {
    std::optional<Trial> from;
    for (const double share : shares) {
      const Trial to = at(share);
      if (!sound) return {};
      if (from && (to.torque < 0) != (from->torque < 0))
        return to.torque < 0 ? Bracket{*from, to} : Bracket{to, *from};
      from = to;
    }
    return {};
  };
  // Regula falsi, halving the torque of an end that stays (Illinois).
  const auto narrow = [&](Bracket b) {
    int stayed = 0;
    for (int k = 0; k < kMostTrials && sound; ++k) {
      const Trial to = at((b.fast.share * b.slow.torque - b.slow.share * b.fast.torque) /
                          (b.slow.torque - b.fast.torque));
      if (std::min(std::abs(to.share - b.fast.share), std::abs(to.share - b.slow.share)) <
          kSpeedWithin)
        return sound;
      if (to.torque < 0) {
        b.fast = to;
        if (stayed == 1) b.slow.torque /= 2;
        stayed = 1;
      } else {
        b.slow = to;
        if (stayed == -1) b.fast.torque /= 2;
        stayed = -1;
      }
    }
    return false;
  };
  const bool driven_beyond = at(*kFaster.begin()).torque >= 0;
  if (!sound) return start;
  const std::optional<Bracket> around = bracket(driven_beyond ? kFaster : kShares);
  if (!around || !narrow(*around)) return start;
  start.turn = orbit.turn();
  start.iterations = orbit.iterations();
  start.found = true;
  return start;
}

}  // namespace cagetol
