#include "src/newton/roller_chain.hpp"

namespace cagetol {

RollerChain::RollerChain(const BearingModel& model)
    : model_(model),
      count_(model.layout.rollers),
      links_(static_cast<std::size_t>(count_)),
      positions_(links_.size()),
      forces_(links_.size()),
      solution_(links_.size()) {
  slots_ = {kRingY, kRingZ};
  if (model.layout.ring_axial > 0) slots_.push_back(model.layout.ring_axial_slot());
  for (int k = 0; k < model.layout.ring_tilt; ++k)
    slots_.push_back(model.layout.ring_tilt_slot() + k);
}

RollerChain::Pair RollerChain::block(const RollerOnRoller& of, int lane) const {
  Pair pair;
  pair.position.setZero();
  for (int i = 0; i < kLocalVelocities; ++i)
    for (int j = 0; j < kLocalVelocities; ++j) {
      pair.velocity(i, j) = of.velocity[i][j][lane];
      if (j < kLocalPositions) pair.position(i, j) = of.position[i][j][lane];
    }
  return pair;
}

RollerChain::Pair RollerChain::own(int roller) const {
  const GroupLinear& g = group(roller);
  const int lane = roller % kLanes;
  Pair pair;
  pair.position.setZero();
  for (int i = 0; i < kLocalVelocities; ++i)
    for (int j = 0; j < kLocalVelocities; ++j) {
      pair.velocity(i, j) = g.velocity[i][j][lane];
      if (j < kLocalPositions) pair.position(i, j) = g.position[i][j][lane];
    }
  return pair;
}

RollerChain::RingPair RollerChain::with_ring(int roller) const {
  RingPair pair;
  pair.position.setZero();
  pair.velocity.setZero();
  pair.to_position.setZero();
  pair.to_velocity.setZero();
  const GroupLinear& g = group(roller);
  const int lane = roller % kLanes;
  const double c = g.cosine[lane], s = g.sine[lane], turn[2][2] = {{c, s}, {-s, c}};
  const auto add = [&](const RingCoupling& ring, int first) {
    for (int i = 0; i < kLocalVelocities; ++i)
      for (int k = 0; k < 2; ++k)
        for (int a = 0; a < 2; ++a) {
          pair.position(i, first + a) += ring.position[i][k][lane] * turn[k][a];
          pair.velocity(i, first + a) += ring.velocity[i][k][lane] * turn[k][a];
          pair.to_velocity(first + a, i) += turn[k][a] * ring.to_velocity[k][i][lane];
          if (i < kLocalPositions)
            pair.to_position(first + a, i) += turn[k][a] * ring.to_position[k][i][lane];
        }
  };
  add(g.ring, 0);
  if (model_.layout.ring_tilt > 0)
    add(linear_->tilts[static_cast<std::size_t>(roller / kLanes)].coupling, 2);
  const int slot = linear_->slot[static_cast<std::size_t>(roller)];
  if (model_.layout.ring_axial == 0 || slot < 0) return pair;
  const CageCoupling& axial = linear_->couplings[static_cast<std::size_t>(slot)];
  const int column = model_.layout.ring_axial_slot() - kCageY,
            packs = packs_for(model_.layout.coupled());
  for (int i = 0; i < kLocalVelocities; ++i) {
    const auto pack = static_cast<std::size_t>(i * packs + column / kLanes);
    pair.position(i, 2) = axial.position[static_cast<std::size_t>(column)][i];
    pair.velocity(i, 2) = axial.velocity[static_cast<std::size_t>(column)][i];
    pair.to_velocity(2, i) = axial.to_velocity[pack][column % kLanes];
    if (i < kLocalPositions) pair.to_position(2, i) = axial.to_position[pack][column % kLanes];
  }
  return pair;
}

RollerChain::Vector RollerChain::local_mass(int roller) const {
  const RollerGroup& g = model_.groups[static_cast<std::size_t>(roller / kLanes)];
  const int lane = roller % kLanes;
  Vector mass;
  mass << g.mass[lane], g.mass[lane], g.mass[lane], g.transverse[lane], g.transverse[lane],
      g.polar[lane];
  return mass;
}

bool RollerChain::factor(const Linearisation& linear, const Eigen::VectorXd& border_mass,
                         double beta) {
  linear_ = &linear;
  mass_ = &border_mass;
  beta_ = beta;
  const int last = count_ - 1;
  const auto neighbours = [&](int j) -> const NeighbourLinear& {
    return linear.neighbours[static_cast<std::size_t>(j / kLanes)];
  };
  const auto matrix = [&](const Pair& of) -> Block { return -of.velocity - beta * of.position; };
  /// By the next roller's motion, and of the next roller by that of roller j.
  const auto ahead = [&](int j) { return matrix(block(neighbours(j).ahead, j % kLanes)); };
  const auto behind = [&](int j) { return matrix(block(neighbours(j).behind, j % kLanes)); };
  const auto diagonal = [&](int j) {
    Block D = matrix(own(j));
    D.diagonal() += local_mass(j) / beta;
    return D;
  };
  Corner S = Corner::Identity();
  S.topLeftCorner<kLocalVelocities, kLocalVelocities>() = diagonal(last);
  const int rings = static_cast<int>(slots_.size());
  for (int a = 0; a < rings; ++a)
    for (int c = 0; c < rings; ++c) {
      const int row = slots_[static_cast<std::size_t>(a)],
                column = slots_[static_cast<std::size_t>(c)];
      S(kLocalVelocities + a, kLocalVelocities + c) = -linear.border_velocity(row, column) -
                                                      beta * linear.border_position(row, column) +
                                                      (a == c ? border_mass[row] / beta : 0);
    }
  const RingPair closing = with_ring(last);
  S.topRightCorner<kLocalVelocities, kMostRing>() = -closing.velocity - beta * closing.position;
  S.bottomLeftCorner<kMostRing, kLocalVelocities>() =
      -closing.to_velocity - beta * closing.to_position;
  for (int j = 0; j < last; ++j) {
    Link& link = links_[static_cast<std::size_t>(j)];
    const RingPair ring = with_ring(j);
    ToCorner C;
    C.setZero();
    C.rightCols<kMostRing>() = -ring.velocity - beta * ring.position;
    FromCorner R;
    R.setZero();
    R.bottomRows<kMostRing>() = -ring.to_velocity - beta * ring.to_position;
    Block D = diagonal(j), U = Block::Zero();
    link.behind.setZero();
    if (j == 0) {  // the roller behind the first one is the last one
      C.leftCols<kLocalVelocities>() += behind(last);
      R.topRows<kLocalVelocities>() += ahead(last);
    } else {
      link.behind = behind(j - 1);
      const Link& before = links_[static_cast<std::size_t>(j - 1)];
      D.noalias() -= link.behind * before.ahead_solved;
      C.noalias() -= link.behind * before.solved;
      R.noalias() -= before.to_corner * before.ahead_solved;
    }
    if (j + 1 < last) {
      U = ahead(j);
    } else {
      C.leftCols<kLocalVelocities>() += ahead(j);
      R.topRows<kLocalVelocities>() += behind(j);
    }
    link.inverse = D.inverse();
    link.ahead_solved.noalias() = link.inverse * U;
    link.solved.noalias() = link.inverse * C;
    link.to_corner = R;
    S.noalias() -= R * link.solved;
  }
  corner_.compute(S);
  return S.allFinite() && corner_.matrixLU().allFinite();
}

void RollerChain::start(const double* rhs) {
  const StateLayout& l = model_.layout;
  const int rings = static_cast<int>(slots_.size());
  ring_positions_.setZero();
  ring_forces_.setZero();
  for (int a = 0; a < rings; ++a) {
    const int slot = slots_[static_cast<std::size_t>(a)];
    ring_positions_[a] = beta_ * rhs[l.border_position(slot)];
    ring_forces_[a] = (*mass_)[slot] * rhs[l.border_velocity(slot)];
  }
  for (int a = 0; a < rings; ++a)
    for (int c = 0; c < rings; ++c)
      ring_forces_[a] += linear_->border_position(slots_[static_cast<std::size_t>(a)],
                                                  slots_[static_cast<std::size_t>(c)]) *
                         ring_positions_[c];
  for (int j = 0; j < count_; ++j) {
    const GroupLinear& g = group(j);
    const int lane = j % kLanes;
    const double c = g.cosine[lane], s = g.sine[lane], r = g.radius[lane];
    const auto q = [&](RollerPosition slot) { return beta_ * rhs[l.position(slot, j)]; };
    const auto v = [&](RollerVelocity slot) { return rhs[l.velocity(slot, j)]; };
    Vector& P = positions_[static_cast<std::size_t>(j)];
    P << q(kRadius), r * q(kAngle), q(kAxial), c * q(kAxisY) + s * q(kAxisZ),
        c * q(kAxisZ) - s * q(kAxisY), 0;
    Vector speeds;
    speeds << v(kRadialSpeed), r * v(kOrbitRate), v(kAxialSpeed),
        c * v(kAxisRateY) + s * v(kAxisRateZ), c * v(kAxisRateZ) - s * v(kAxisRateY), v(kSpin);
    forces_[static_cast<std::size_t>(j)] = local_mass(j).cwiseProduct(speeds);
  }
  for (int j = 0; j < count_; ++j) {
    const int next = j + 1 < count_ ? j + 1 : 0;
    const auto at = static_cast<std::size_t>(j), after = static_cast<std::size_t>(next);
    const NeighbourLinear& with = linear_->neighbours[static_cast<std::size_t>(j / kLanes)];
    const RingPair ring = with_ring(j);
    forces_[at] += own(j).position * positions_[at] + ring.position * ring_positions_ +
                   block(with.ahead, j % kLanes).position * positions_[after];
    forces_[after] += block(with.behind, j % kLanes).position * positions_[at];
    ring_forces_ += ring.to_position * positions_[at];
  }
}

void RollerChain::solve(const double* rhs, double* x) {
  start(rhs);
  const int last = count_ - 1;
  CornerVector w;
  w << forces_.back(), ring_forces_;
  for (int j = 0; j < last; ++j) {
    Link& link = links_[static_cast<std::size_t>(j)];
    Vector f = forces_[static_cast<std::size_t>(j)];
    if (j > 0) f -= link.behind * links_[static_cast<std::size_t>(j - 1)].y;
    link.y = link.inverse * f;
    w -= link.to_corner * link.y;
  }
  w = corner_.solve(w).eval();
  solution_.back() = w.head<kLocalVelocities>();
  ring_solution_ = w.tail<kMostRing>();
  for (int j = last - 1; j >= 0; --j) {
    const Link& link = links_[static_cast<std::size_t>(j)];
    Vector& u = solution_[static_cast<std::size_t>(j)];
    u = link.y - link.solved * w;
    if (j + 1 < last) u -= link.ahead_solved * solution_[static_cast<std::size_t>(j + 1)];
  }
  finish(rhs, x);
}

void RollerChain::finish(const double* rhs, double* x) {
  const StateLayout& l = model_.layout;
  const auto put = [&](int position, int velocity, double speed) {
    x[position] = beta_ * (rhs[position] + speed);
    x[velocity] = speed;
  };
  for (int j = 0; j < l.padded(); ++j) {
    const bool exists = j < count_;
    Vector speeds = Vector::Zero();
    if (exists) {
      const GroupLinear& g = group(j);
      const double c = g.cosine[j % kLanes], s = g.sine[j % kLanes];
      const Vector& u = solution_[static_cast<std::size_t>(j)];
      speeds << u[kLr], u[kLt] * g.inverse_radius[j % kLanes], u[kLx], c * u[kLar] - s * u[kLat],
          s * u[kLar] + c * u[kLat], u[kLs];
    }
    for (int slot = 0; slot < kRollerPositions; ++slot) {
      const int at = l.position(static_cast<RollerPosition>(slot), j);
      x[at] = exists ? beta_ * (rhs[at] + speeds[slot]) : 0;
    }
    for (int slot = 0; slot < kRollerVelocities; ++slot)
      x[l.velocity(static_cast<RollerVelocity>(slot), j)] = speeds[slot];
  }
  // Nothing acts on what stands for a cage.
  for (int slot = kCageY; slot < kModes; ++slot)
    put(l.border_position(slot), l.border_velocity(slot), beta_ * rhs[l.border_velocity(slot)]);
  for (std::size_t a = 0; a < slots_.size(); ++a)
    put(l.border_position(slots_[a]), l.border_velocity(slots_[a]),
        ring_solution_[static_cast<Eigen::Index>(a)]);
  for (int i = l.border(); i < l.padded_border(); ++i)
    x[l.border_position(i)] = x[l.border_velocity(i)] = 0;
}

}  // namespace cagetol
