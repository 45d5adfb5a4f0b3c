#include "src/statics/static_equilibrium.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "src/statics/rollers_between_races.hpp"

namespace cagetol {
namespace {

constexpr int kMostIterations = 60;
constexpr int kMostUnsettled = 200;  // tries at which rollers found no place: then there is none
constexpr double kNoPlace =
    1e-11;  // a roller that still moves farther at the last try has none [m]
// From a solution nearby ring and rollers need some 4 to 8 iterations; moves of rollers then left
// are below this length for each share of the load left over.
constexpr int kMostFollowing = 12;
constexpr double kFollowedWithin = 1e-4;  // [m]
// A search from anywhere: downhill with rollers at rest, then with a growing share of the damping.
constexpr int kMostDescending = 400;
constexpr int kMostHalvings = 30;
constexpr int kMostCorrections = 40;
constexpr double kMinimumShare = 1.0 / 16;  // by which the damping grows
constexpr double kProbe = 1e-9;             // move that tells a derivative [m]
constexpr double kStandstill = 1e-16;       // a move below this is none [m]
// Of a roller's place [m], for a balance of the ring to a share `accuracy` of the load: were it
// more, the ring's iteration would see noise (1e-14 m are a millionth of a newton of a loaded
// contact). Never below what the place itself can be told to.
double settled_within(double radius, double accuracy) {
  return std::max({1e-16, 2e-15 * radius, 1e-6 * accuracy});
}

void store_forces(const RollerBalance& b, int first, StaticState& state) {
  store(state.inner_force.data() + first, b.inner.total);
  store(state.inner_slice.data() + first, b.inner.heaviest);
  store(state.outer_slice.data() + first, b.outer.heaviest);
}

}  // namespace

/// On the ring from the rollers: force in y, z and moments about them; derivatives with respect to
/// displacement and tilt.
struct StaticEquilibrium::RingForce {
  Eigen::Vector4d force = Eigen::Vector4d::Zero();
  Eigen::Matrix4d slope = Eigen::Matrix4d::Zero();
  double elastic[2] = {0, 0};  ///< elastic part of the force
  bool settled = true;         ///< every roller found its place

  /// A pack of rollers, where they balance: force, and moment where the ring `tilts`. A move of the
  /// ring changes them directly, and through the roller that follows it.
  void add(const RollersBetweenRaces& at, const RollerBalance& b, bool tilts) {
    const Pack cosine = at.q.cosine, sine = at.q.sine;
    const Pack co = cosine * at.roller.exists, si = sine * at.roller.exists;
    const RaceNormals& on = b.inner;
    elastic[0] -= sum(co * on.elastic[0] - si * on.elastic[1]);
    elastic[1] -= sum(si * on.elastic[0] + co * on.elastic[1]);
    const int blocks = tilts ? 2 : 1;
    for (int m = 0; m < blocks; ++m) {
      Pack f[2];
      for (int i = 0; i < 2; ++i)
        f[i] = on.force[m][i] + on.slope[m][i][0] * b.dr + on.slope[m + 1][i][0] * b.da;
      force[2 * m] -= sum(co * f[0] - si * f[1]);
      force[2 * m + 1] -= sum(si * f[0] + co * f[1]);
      for (int n = 0; n < blocks; ++n) {
        Pack K[2][2];  // rows and columns in r, t
        for (int c = 0; c < 2; ++c) {
          const auto [r, a] = b.follow(n, c);
          for (int i = 0; i < 2; ++i)
            K[i][c] = on.slope[m + n][i][c] - on.slope[m][i][0] * r - on.slope[m + 1][i][0] * a;
        }
        const auto [rr, rt, tr, tt] = std::tie(K[0][0], K[0][1], K[1][0], K[1][1]);
        auto to = slope.block<2, 2>(2 * m, 2 * n);
        to(0, 0) += sum(co * (rr * cosine - rt * sine) - si * (tr * cosine - tt * sine));
        to(0, 1) += sum(co * (rr * sine + rt * cosine) - si * (tr * sine + tt * cosine));
        to(1, 0) += sum(si * (rr * cosine - rt * sine) + co * (tr * cosine - tt * sine));
        to(1, 1) += sum(si * (rr * sine + rt * cosine) + co * (tr * sine + tt * cosine));
      }
    }
  }
};

StaticEquilibrium::StaticEquilibrium(const BearingModel& model, double accuracy)
    : model_(model),
      undamped_(model.race),
      damped_(model.race),
      accuracy_(accuracy),
      lever_(model.roller_half_length),
      tilts_(model.layout.ring_tilt > 0),
      speeds_(model.duty.speed) {
  undamped_.damping = undamped_.chi = 0;
  const auto n = static_cast<std::size_t>(model.layout.padded());
  state_.radius.assign(n, model.outer_radius - model.nominal_diameter / 2);
  state_.tilt.assign(n, 0.0);
  resting_radius_ = state_.radius;
  resting_tilt_ = state_.tilt;
  state_.inner_force.assign(n, 0.0);
  state_.inner_slice = state_.outer_slice = state_.inner_force;
  state_.tilt_y = model.misalignment_y;
  state_.tilt_z = model.misalignment_z;
}

StaticEquilibrium::RingForce StaticEquilibrium::settle_rollers(const double* angle,
                                                               double orbit_rate,
                                                               const RingLoad& load,
                                                               RollerMotion motion) {
  RingForce ring;
  for (int group = 0; group < model_.layout.groups; ++group) {
    const int j = group * kLanes;
    RollersBetweenRaces at(model_, group, angle, orbit_rate, state_, spins_, speeds_, angles_);
    Pack &r = at.q.r, &a = at.q.a_r;
    at.put(state_.radius, state_.tilt);
    // At rest first, where no speed damps; then orbiting, and the law's damping has its say.
    bool moves = false;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
      const RollerBalance b = moves ? at.balance(damped_, share_) : at.balance(undamped_, 0);
      const bool settled = b.size < settled_within(model_.pitch_radius, accuracy_);
      if (settled && !moves && motion == RollerMotion::orbiting) {
        moves = true;
        store(resting_radius_.data() + j, r);
        store(resting_tilt_.data() + j, a);
        at.orbit(b);
        continue;
      }
      if (settled || iteration + 1 == kMostIterations) {
        ring.settled = ring.settled && b.size < kNoPlace;
        store_forces(b, j, state_);
        ring.add(at, b, tilts_);
        break;
      }
      r += b.dr;
      a += b.da;
    }
    store(state_.radius.data() + j, r);
    store(state_.tilt.data() + j, a);
  }
  add_outside(load, ring);
  return ring;
}

void StaticEquilibrium::add_outside(const RingLoad& load, RingForce& ring) const {
  ring.force.head<2>() += force(load);
  if (!tilts_) return;
  ring.force[2] += load.moment_y - model_.tilt_stiffness * (state_.tilt_y - model_.misalignment_y);
  ring.force[3] += load.moment_z - model_.tilt_stiffness * (state_.tilt_z - model_.misalignment_z);
  ring.slope.diagonal().tail<2>().array() -= model_.tilt_stiffness;
}

Eigen::Vector2d StaticEquilibrium::force(const RingLoad& load) const {
  return {load.y, load.z - model_.ring_mass * model_.gravity};
}

double StaticEquilibrium::size(const RingLoad& load) const {
  const double radial = force(load).norm();
  return tilts_ ? std::max(radial, std::hypot(load.moment_y, load.moment_z) / lever_) : radial;
}

double StaticEquilibrium::tolerance(const RingLoad& load) const {
  return std::max(accuracy_ * size(load), 1e-8);
}

double StaticEquilibrium::imbalance(const RingForce& ring) const {
  return std::hypot(ring.force.head<2>().norm(), ring.force.tail<2>().norm() / lever_);
}

double StaticEquilibrium::length(const Eigen::Vector4d& move) const {
  return std::hypot(move.head<2>().norm(), lever_ * move.tail<2>().norm());
}

Eigen::Vector4d StaticEquilibrium::newton_move(const RingForce& ring, const RingLoad& load) const {
  // A light ring on one roller turns over it with a stiffness of weight over radius only: the
  // spring must not outweigh that many times, or the ring creeps to the next roller.
  const double soft =
      std::min(kSoftSpring, std::max(4 * force(load).norm(), 1e-3) / model_.inner_radius);
  Eigen::Matrix4d K = -ring.slope;
  K.diagonal() += Eigen::Vector4d(soft, soft, soft * lever_ * lever_, soft * lever_ * lever_);
  Eigen::Vector4d d = K.partialPivLu().solve(ring.force);
  if (const double far = length(d); far > kLongestMove) d *= kLongestMove / far;
  return d;
}

void StaticEquilibrium::move_ring(const Eigen::Vector4d& d) {
  state_.ring_y += d[0];
  state_.ring_z += d[1];
  state_.tilt_y += d[2];
  state_.tilt_z += d[3];
}

void StaticEquilibrium::spin(const double* spins, const RingSpeeds& speeds) {
  spins_ = spins;
  speeds_ = speeds;
}

const StaticState& StaticEquilibrium::solve(const double* angle, double orbit_rate,
                                            const RingLoad& load, RollerMotion motion) {
  if (motion == RollerMotion::orbiting && state_.converged) {
    const StaticState before = state_;
    if (follow(angle, orbit_rate, load)) return state_;
    state_ = before;
  }
  balance(angle, orbit_rate, load, motion);
  if (!state_.converged) search(angle, orbit_rate, load, motion);
  return state_;
}

bool StaticEquilibrium::follow(const double* angle, double orbit_rate, const RingLoad& load) {
  // A pack of rollers at rest, then orbiting from there.
  struct Step {
    RollersBetweenRaces at;
    RollerBalance resting, orbiting;
    Step(const StaticEquilibrium& of, int group, const double* angle, double orbit_rate)
        : at(of.model_, group, angle, orbit_rate, of.state_, of.spins_, of.speeds_, of.angles_),
          resting(at.put(of.resting_radius_, of.resting_tilt_).balance(of.undamped_, 0)),
          orbiting(
              at.orbit(resting).put(of.state_.radius, of.state_.tilt).balance(of.model_.race, 1)) {}
  };
  std::vector<Step> steps;
  steps.reserve(static_cast<std::size_t>(model_.layout.groups));
  for (state_.iterations = 0; state_.iterations < kMostFollowing; ++state_.iterations) {
    RingForce ring;
    double farthest = 0;
    steps.clear();
    for (int group = 0; group < model_.layout.groups; ++group) {
      const Step& step = steps.emplace_back(*this, group, angle, orbit_rate);
      ring.add(step.at, step.orbiting, tilts_);
      store_forces(step.orbiting, group * kLanes, state_);
      farthest = std::max({farthest, step.resting.size, step.orbiting.size});
    }
    add_outside(load, ring);
    std::copy(ring.elastic, ring.elastic + 2, state_.ring_elastic);
    if (imbalance(ring) < tolerance(load) && farthest < kFollowedWithin * accuracy_) return true;
    const Eigen::Vector4d d = newton_move(ring, load);
    move_ring(d);
    for (int group = 0; group < model_.layout.groups; ++group) {
      const int j = group * kLanes;
      const Step& step = steps[static_cast<std::size_t>(group)];
      step.resting.advance(step.at.q, d, resting_radius_.data() + j, resting_tilt_.data() + j);
      step.orbiting.advance(step.at.q, d, state_.radius.data() + j, state_.tilt.data() + j);
    }
  }
  return false;
}

void StaticEquilibrium::balance(const double* angle, double orbit_rate, const RingLoad& load,
                                RollerMotion motion) {
  state_.converged = false;
  int unsettled = 0;
  const auto settle = [&] {
    RingForce ring = settle_rollers(angle, orbit_rate, load, motion);
    if (!ring.settled) ++unsettled;
    return ring;
  };
  RingForce f = settle();
  for (state_.iterations = 0; state_.iterations < kMostIterations && unsettled < kMostUnsettled;
       ++state_.iterations) {
    const double now = imbalance(f);
    if (now < tolerance(load)) {
      state_.converged = true;
      break;
    }
    Eigen::Vector4d d = newton_move(f, load);
    for (int halving = 0; halving < 30 && unsettled < kMostUnsettled; ++halving) {
      move_ring(d);
      f = settle();
      // Energy is convex, so a step that still leads downhill at its end is sound even where the
      // imbalance did not fall: crossing a clearance it stays the load itself until the rollers
      // touch, and may be more just behind.
      const bool downhill = f.force.dot(d) > 0;
      if (imbalance(f) < now || downhill || length(d) < 1e-16) break;
      move_ring(-d);
      d /= 2;
    }
    if (length(d) < 1e-16) {
      state_.converged = imbalance(f) < 1e-6 * std::max(size(load), 1.0);
      break;
    }
  }
  std::copy(f.elastic, f.elastic + 2, state_.ring_elastic);
}

void StaticEquilibrium::reset() {
  state_.ring_y = state_.ring_z = 0;
  state_.tilt_y = model_.misalignment_y;
  state_.tilt_z = model_.misalignment_z;
  std::fill(state_.radius.begin(), state_.radius.end(),
            model_.outer_radius - model_.nominal_diameter / 2);
  std::fill(state_.tilt.begin(), state_.tilt.end(), 0.0);
  resting_radius_ = state_.radius;
  resting_tilt_ = state_.tilt;
  state_.converged = false;
}

void StaticEquilibrium::search(const double* angle, double orbit_rate, const RingLoad& load,
                               RollerMotion motion) {
  const int spent = state_.iterations;
  reset();
  state_.iterations = spent;
  RingForce f = descend(angle, orbit_rate, load);
  if (state_.converged && motion == RollerMotion::orbiting) {
    double share = 0;
    for (double step = 1; share < 1 && step >= kMinimumShare;) {
      const StaticState from = state_;
      const auto resting = std::pair{resting_radius_, resting_tilt_};
      const double next = std::min(1.0, share + step);
      share_ = next;
      damped_.damping = next * model_.race.damping;
      damped_.chi = next * model_.race.chi;
      if (correct(angle, orbit_rate, load, f)) {
        share = next;
        continue;
      }
      const int used = state_.iterations;
      state_ = from;
      state_.iterations = used;
      std::tie(resting_radius_, resting_tilt_) = resting;
      step /= 2;
    }
    damped_ = model_.race;
    share_ = 1;
    state_.converged = share == 1;
  }
  std::copy(f.elastic, f.elastic + 2, state_.ring_elastic);
}

StaticEquilibrium::RingForce StaticEquilibrium::descend(const double* angle, double orbit_rate,
                                                        const RingLoad& load) {
  // At rest forces have a potential. A ring on one roller is at the top of a hill: along directions
  // in which the potential bends down the move goes downhill all the same (the stiffness counts by
  // its magnitude), until the next roller holds the ring.
  const Eigen::Vector4d lever(1, 1, lever_, lever_);  // makes all four lengths and forces
  const double soft =
      std::min(kSoftSpring, std::max(4 * force(load).norm(), 1e-3) / model_.inner_radius);
  const auto settle = [&] {
    return settle_rollers(angle, orbit_rate, load, RollerMotion::at_rest);
  };
  RingForce f = settle();
  for (int k = 0; k < kMostDescending; ++k, ++state_.iterations) {
    const double now = imbalance(f);
    if (f.settled && now < tolerance(load)) {
      state_.converged = true;
      break;
    }
    Eigen::Matrix4d K = f.slope.array() / (lever * lever.transpose()).array();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes(-(K + K.transpose()) / 2);
    Eigen::Vector4d along = axes.eigenvectors().transpose() * f.force.cwiseQuotient(lever);
    along.array() /= axes.eigenvalues().array().abs().max(soft);
    Eigen::Vector4d d = (axes.eigenvectors() * along).cwiseQuotient(lever);
    if (const double far = length(d); far > kLongestMove) d *= kLongestMove / far;
    for (int halving = 0; halving < kMostHalvings; ++halving) {
      move_ring(d);
      f = settle();
      if (imbalance(f) < now || f.force.dot(d) > 0) break;
      move_ring(-d);
      d /= 2;
    }
    if (length(d) < kStandstill) break;
  }
  return f;
}

bool StaticEquilibrium::correct(const double* angle, double orbit_rate, const RingLoad& load,
                                RingForce& f) {
  const int unknowns = tilts_ ? 4 : 2;
  const auto settle = [&] {
    return settle_rollers(angle, orbit_rate, load, RollerMotion::orbiting);
  };
  f = settle();
  for (int k = 0; k < kMostCorrections; ++k, ++state_.iterations) {
    if (!f.settled) return false;
    const double now = imbalance(f);
    if (now < tolerance(load)) return true;
    // By differences: damping lets the force depend on the stiffness, which no slope knows.
    Eigen::Matrix4d slope = Eigen::Matrix4d::Identity();
    for (int i = 0; i < unknowns; ++i) {
      const double probe = i < 2 ? kProbe : kProbe / lever_;
      const Eigen::Vector4d move = probe * Eigen::Vector4d::Unit(i);
      move_ring(move);
      slope.col(i) = (settle().force - f.force) / probe;
      move_ring(-move);
    }
    Eigen::Vector4d d = -slope.partialPivLu().solve(f.force);
    if (!d.allFinite()) return false;
    if (const double far = length(d); far > kLongestMove) d *= kLongestMove / far;
    int halving = 0;
    for (; halving < kMostHalvings; ++halving) {
      move_ring(d);
      f = settle();
      if (f.settled && imbalance(f) < now) break;
      move_ring(-d);
      d /= 2;
    }
    if (halving == kMostHalvings) return false;
  }
  return false;
}

}  // namespace cagetol
