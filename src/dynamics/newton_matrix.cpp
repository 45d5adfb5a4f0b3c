#include "src/dynamics/newton_matrix.hpp"

#include <cmath>

#include "src/dynamics/roller_block.hpp"

namespace cagetol {
namespace {

/// What couples of the inner ring to rollers, in the rollers' directions r, t: its displacement,
/// and its tilt where that is free.
template <int vectors>
struct RingVectors {
  Pack r[vectors], t[vectors];
  RingVectors(const GroupLinear& l, const Eigen::VectorXd& border, const StateLayout& layout) {
    for (int v = 0; v < vectors; ++v) {
      const int slot = v == 0 ? kRingY : layout.ring_tilt_slot();
      r[v] = l.cosine * border[slot] + l.sine * border[slot + 1];
      t[v] = l.cosine * border[slot + 1] - l.sine * border[slot];
    }
  }
};

}  // namespace

Eigen::VectorXd border_mass(const BearingModel& m) {
  Eigen::VectorXd mass = Eigen::VectorXd::Ones(m.layout.border());
  mass[kRingY] = mass[kRingZ] = m.ring_mass;
  mass[kCageY] = mass[kCageZ] = mass[kCageX] = m.cage_mass;
  mass[kCagePhi] = m.cage_polar;
  mass[kCageAxisY] = mass[kCageAxisZ] = m.cage_transverse;
  mass.tail(m.layout.ring_tilt).setConstant(m.ring_transverse);
  return mass;
}

static_assert(int{kRigidBorder} + kMostModes + 2 <= SmallInverse::kMost);

NewtonMatrix::NewtonMatrix(const BearingModel& model)
    : model_(model),
      groups_(static_cast<std::size_t>(model.layout.groups)),
      cages_(static_cast<std::size_t>(model.layout.rollers)),
      schur_(model.layout.border()),
      free_ring_(2 + model.layout.ring_tilt),
      free_cage_(model.layout),
      border_mass_(border_mass(model)),
      border_rhs_(model.layout.border()),
      border_positions_(model.layout.border()),
      border_solution_(model.layout.border()) {
  const int columns = model.layout.cage();
  for (auto& c : cages_) {
    c.into.setZero(kLocalVelocities, columns);
    c.from.setZero(kLocalVelocities, columns);
    c.to.setZero(columns, kLocalVelocities);
  }
}

const RingCoupling& NewtonMatrix::coupling(int group, int vector) const {
  const auto at = static_cast<std::size_t>(group);
  return vector == 0 ? linear_->groups[at].ring : linear_->tilts[at].coupling;
}

/// Blocks of the rollers, and what of them reaches the ring.
template <bool planar, int vectors>
bool NewtonMatrix::factor_rollers(double beta) {
  bool sound = true;
  double ring[vectors][vectors][2][2] = {};
  for (int g = 0; g < model_.layout.groups; ++g) {
    const GroupLinear& l = linear_->groups[static_cast<std::size_t>(g)];
    const RollerGroup& roller = model_.groups[static_cast<std::size_t>(g)];
    Group& f = groups_[static_cast<std::size_t>(g)];
    Pack mass[kLocalVelocities];
    local_mass(roller, mass);
    for (int i = 0; i < kLocalVelocities; ++i) {
      if (held<planar>(i)) continue;
      for (int j = 0; j < kLocalVelocities; ++j)
        if (!held<planar>(j))
          f.inverse[i][j] =
              -l.velocity[i][j] - (j < kLocalPositions ? beta * l.position[i][j] : Pack{});
      f.inverse[i][i] += mass[i] / beta;
    }
    if (!invert<planar>(f.inverse, mass, beta, roller.exists)) sound = false;
    Pack from_ring[vectors][2][kLocalVelocities];  // N, ring part
    for (int v = 0; v < vectors; ++v) {
      const RingCoupling& with = coupling(g, v);
      for (int c = 0; c < 2; ++c) {
        Pack to_ring[kLocalVelocities], solved[kLocalVelocities];
        for (int i = 0; i < kLocalVelocities; ++i) {
          from_ring[v][c][i] = -(with.velocity[i][c] + beta * with.position[i][c]);
          to_ring[i] = -with.to_velocity[c][i] -
                       (i < kLocalPositions ? beta * with.to_position[c][i] : Pack{});
        }
        multiply<planar>(f.inverse, from_ring[v][c], solved);
        for (int i = 0; i < kLocalVelocities; ++i) f.from_ring[v][i][c] = solved[i];
        multiply_left<planar>(to_ring, f.inverse, f.to_ring[v][c]);
      }
    }
    const Pack co = roller.exists * l.cosine, si = roller.exists * l.sine;
    for (int v = 0; v < vectors; ++v)
      for (int w = 0; w < vectors; ++w) {
        Pack local[2][2] = {};
        for (int a = 0; a < 2; ++a)
          for (int c = 0; c < 2; ++c)
            for (int i = 0; i < kLocalVelocities; ++i)
              local[a][c] += f.to_ring[v][a][i] * from_ring[w][c][i];
        const Pack rr = local[0][0], rt = local[0][1], tr = local[1][0], tt = local[1][1];
        auto& to = ring[v][w];
        to[0][0] += sum(co * (rr * l.cosine - rt * l.sine) - si * (tr * l.cosine - tt * l.sine));
        to[0][1] += sum(co * (rr * l.sine + rt * l.cosine) - si * (tr * l.sine + tt * l.cosine));
        to[1][0] += sum(si * (rr * l.cosine - rt * l.sine) + co * (tr * l.cosine - tt * l.sine));
        to[1][1] += sum(si * (rr * l.sine + rt * l.cosine) + co * (tr * l.sine + tt * l.cosine));
      }
  }
  auto schur = schur_.matrix();
  for (int v = 0; v < vectors; ++v)
    for (int w = 0; w < vectors; ++w)
      for (int a = 0; a < 2; ++a)
        for (int c = 0; c < 2; ++c) schur(ring_slot(v) + a, ring_slot(w) + c) -= ring[v][w][a][c];
  return sound;
}

bool NewtonMatrix::factor(const Linearisation& linear, double beta) {
  return model_.planar                 ? factor_as<true, 1>(linear, beta)
         : model_.layout.ring_tilt > 0 ? factor_as<false, 2>(linear, beta)
                                       : factor_as<false, 1>(linear, beta);
}

/// The ring's own block into schur_, for the rollers to add what reaches it.
template <int vectors>
void NewtonMatrix::start_free_ring() {
  auto schur = schur_.matrix();
  for (int v = 0; v < vectors; ++v)
    for (int w = 0; w < vectors; ++w) {
      const int row = ring_slot(v), column = ring_slot(w);
      auto block = schur.block<2, 2>(row, column);
      block = -linear_->border_velocity.block<2, 2>(row, column) -
              beta_ * linear_->border_position.block<2, 2>(row, column);
      if (v == w) block.diagonal() += border_mass_.segment<2>(row) / beta_;
    }
}

template <int vectors>
bool NewtonMatrix::finish_free_ring() {
  for (int v = 0; v < vectors; ++v)
    for (int w = 0; w < vectors; ++w)
      free_ring_.matrix().block<2, 2>(2 * v, 2 * w) =
          schur_.matrix().block<2, 2>(ring_slot(v), ring_slot(w));
  return free_ring_.invert();
}

/// border_solution_ of border_rhs_.
template <int vectors>
void NewtonMatrix::solve_free_border() {
  double ring[2 * vectors];
  for (int i = 0; i < 2 * vectors; ++i) ring[i] = border_rhs_[ring_slot(i / 2) + i % 2];
  free_ring_.solve(ring, ring);
  for (int i = 0; i < 2 * vectors; ++i) border_solution_[ring_slot(i / 2) + i % 2] = ring[i];
  free_cage_.solve(border_rhs_, border_solution_);
}

template <bool planar, int vectors>
bool NewtonMatrix::factor_as(const Linearisation& linear, double beta) {
  linear_ = &linear;
  beta_ = beta;
  if (!linear.cage_touched) {
    start_free_ring<vectors>();
    bool sound = factor_rollers<planar, vectors>(beta);
    if (!finish_free_ring<vectors>()) sound = false;
    return free_cage_.factor(linear, border_mass_, beta) && sound;
  }
  const int cage_columns = model_.layout.cage();
  auto schur = schur_.matrix();
  schur = -linear.border_velocity - beta * linear.border_position;
  schur.diagonal() += border_mass_ / beta;
  bool sound = factor_rollers<planar, vectors>(beta);
  for (int n = 0; n < linear.coupled; ++n) {
    const CageCoupling& c = linear.couplings[static_cast<std::size_t>(n)];
    Cage& cage = cages_[static_cast<std::size_t>(n)];
    Group& f = groups_[static_cast<std::size_t>(c.roller / kLanes)];
    const GroupLinear& l = linear.groups[static_cast<std::size_t>(c.roller / kLanes)];
    const int lane = c.roller % kLanes;
    cage.into = -c.velocity - beta * c.position;
    cage.to = -c.to_velocity;
    cage.to.leftCols<kLocalPositions>() -= beta * c.to_position;
    Eigen::Matrix<double, kLocalVelocities, kLocalVelocities> inverse;
    double ring_from[vectors][kLocalVelocities][2], ring_to[vectors][2][kLocalVelocities];
    const double co = l.cosine[lane], si = l.sine[lane];
    for (int i = 0; i < kLocalVelocities; ++i) {
      for (int j = 0; j < kLocalVelocities; ++j) inverse(i, j) = f.inverse[i][j][lane];
      for (int v = 0; v < vectors; ++v) {
        const double fr = f.from_ring[v][i][0][lane], ft = f.from_ring[v][i][1][lane];
        ring_from[v][i][0] = fr * co - ft * si;
        ring_from[v][i][1] = fr * si + ft * co;
        const double tr = f.to_ring[v][0][i][lane], tt = f.to_ring[v][1][i][lane];
        ring_to[v][0][i] = tr * co - tt * si;
        ring_to[v][1][i] = tr * si + tt * co;
      }
    }
    cage.from.noalias() = inverse * cage.into;
    schur.block(kCageY, kCageY, cage_columns, cage_columns).noalias() -= cage.to * cage.from;
    for (int i = 0; i < kLocalVelocities; ++i)
      for (int v = 0; v < vectors; ++v)
        for (int a = 0; a < 2; ++a) {
          const int ring = ring_slot(v) + a;
          schur.row(ring).segment(kCageY, cage_columns) -= ring_to[v][a][i] * cage.into.row(i);
          schur.col(ring).segment(kCageY, cage_columns) -= ring_from[v][i][a] * cage.to.col(i);
        }
  }
  if (!schur_.invert()) sound = false;
  return sound;
}

void NewtonMatrix::solve(const double* rhs, double* x) {
  model_.planar                 ? solve_as<true, 1>(rhs, x)
  : model_.layout.ring_tilt > 0 ? solve_as<false, 2>(rhs, x)
                                : solve_as<false, 1>(rhs, x);
}

template <bool planar, int vectors>
void NewtonMatrix::solve_as(const double* rhs, double* x) {
  const StateLayout& layout = model_.layout;
  const int border = layout.border(), cage_columns = layout.cage();
  const double *bq = rhs + layout.border_position(0), *bv = rhs + layout.border_velocity(0);
  for (int i = 0; i < border; ++i) {
    border_positions_[i] = beta_ * bq[i];
    border_rhs_[i] = border_mass_[i] * bv[i];
  }
  if (linear_->cage_touched) {
    border_rhs_.noalias() += linear_->border_position * border_positions_;
  } else {
    const Eigen::MatrixXd& stiff = linear_->border_position;
    for (int v = 0; v < vectors; ++v)
      for (int w = 0; w < vectors; ++w)
        border_rhs_.segment<2>(ring_slot(v)) += stiff.block<2, 2>(ring_slot(v), ring_slot(w)) *
                                                border_positions_.segment<2>(ring_slot(w));
    for (int k = kModes; k < kModes + layout.modes; ++k)
      border_rhs_[k] += stiff(k, k) * border_positions_[k];
  }

  Pack on_ring[vectors][2] = {};  // in y, z
  for (int n = 0; n < layout.groups; ++n) {
    const GroupLinear& l = linear_->groups[static_cast<std::size_t>(n)];
    const RollerGroup& roller = model_.groups[static_cast<std::size_t>(n)];
    Group& f = groups_[static_cast<std::size_t>(n)];
    const int j = n * kLanes;
    const auto q = [&](RollerPosition slot) {
      return beta_ * load(rhs + layout.position(slot, j));
    };
    const auto velocity = [&](RollerVelocity slot) { return load(rhs + layout.velocity(slot, j)); };
    const Pack ay = q(kAxisY), az = q(kAxisZ), by = velocity(kAxisRateY), bz = velocity(kAxisRateZ);
    const Pack P[kLocalPositions] = {q(kRadius), l.radius * q(kAngle), q(kAxial),
                                     l.cosine * ay + l.sine * az, l.cosine * az - l.sine * ay};
    Pack force[kLocalVelocities];
    force[kLr] = roller.mass * velocity(kRadialSpeed);
    force[kLt] = roller.mass * l.radius * velocity(kOrbitRate);
    force[kLx] = roller.mass * velocity(kAxialSpeed);
    force[kLar] = roller.transverse * (l.cosine * by + l.sine * bz);
    force[kLat] = roller.transverse * (l.cosine * bz - l.sine * by);
    force[kLs] = roller.polar * velocity(kSpin);
    RingVectors<vectors> ring(l, border_positions_, model_.layout);
    for (int i = 0; i < kLocalVelocities; ++i) {
      if (held<planar>(i)) continue;
      for (int k = 0; k < kLocalPositions; ++k)
        if (!held<planar>(k)) force[i] += l.position[i][k] * P[k];
      for (int v = 0; v < vectors; ++v) {
        const RingCoupling& with = coupling(n, v);
        force[i] += with.position[i][0] * ring.r[v] + with.position[i][1] * ring.t[v];
      }
    }
    Pack to_ring[vectors][2] = {};
    for (int v = 0; v < vectors; ++v)
      for (int a = 0; a < 2; ++a)
        for (int k = 0; k < kLocalPositions; ++k)
          to_ring[v][a] += coupling(n, v).to_position[a][k] * P[k];
    for (int lane = 0; lane < kLanes && linear_->coupled > 0 && j + lane < layout.rollers; ++lane) {
      const int slot = linear_->slot[static_cast<std::size_t>(j + lane)];
      if (slot < 0) continue;
      const CageCoupling& c = linear_->couplings[static_cast<std::size_t>(slot)];
      for (int i = 0; i < kLocalVelocities; ++i)
        force[i][lane] += c.position.row(i).dot(border_positions_.segment(kCageY, cage_columns));
      for (int k = 0; k < kLocalPositions; ++k)
        border_rhs_.segment(kCageY, cage_columns) += c.to_position.col(k) * P[k][lane];
    }
    for (int v = 0; v < vectors; ++v) {
      Pack(&to)[2] = to_ring[v];
      for (int a = 0; a < 2; ++a) to[a] -= product(f.to_ring[v][a], force);
      on_ring[v][0] += roller.exists * (l.cosine * to[0] - l.sine * to[1]);
      on_ring[v][1] += roller.exists * (l.sine * to[0] + l.cosine * to[1]);
    }
    multiply<planar>(f.inverse, force, f.rhs);
    for (int lane = 0; lane < kLanes && linear_->coupled > 0 && j + lane < layout.rollers; ++lane) {
      const int slot = linear_->slot[static_cast<std::size_t>(j + lane)];
      if (slot < 0) continue;
      const Cage& cage = cages_[static_cast<std::size_t>(slot)];
      for (int i = 0; i < kLocalVelocities; ++i)
        border_rhs_.segment(kCageY, cage_columns) -= cage.to.col(i) * f.rhs[i][lane];
    }
  }
  for (int v = 0; v < vectors; ++v)
    for (int a = 0; a < 2; ++a) border_rhs_[ring_slot(v) + a] += sum(on_ring[v][a]);
  if (linear_->cage_touched)
    schur_.solve(border_rhs_.data(), border_solution_.data());
  else
    solve_free_border<vectors>();

  for (int n = 0; n < layout.groups; ++n) {
    const GroupLinear& l = linear_->groups[static_cast<std::size_t>(n)];
    const RollerGroup& roller = model_.groups[static_cast<std::size_t>(n)];
    Group& f = groups_[static_cast<std::size_t>(n)];
    const int j = n * kLanes;
    RingVectors<vectors> ring(l, border_solution_, model_.layout);
    Pack u[kLocalVelocities];
    for (int i = 0; i < kLocalVelocities; ++i) {
      u[i] = f.rhs[i];
      for (int v = 0; v < vectors; ++v)
        u[i] = u[i] - f.from_ring[v][i][0] * ring.r[v] - f.from_ring[v][i][1] * ring.t[v];
    }
    for (int lane = 0; lane < kLanes && linear_->coupled > 0 && j + lane < layout.rollers; ++lane) {
      const int slot = linear_->slot[static_cast<std::size_t>(j + lane)];
      if (slot < 0) continue;
      const Cage& cage = cages_[static_cast<std::size_t>(slot)];
      for (int i = 0; i < kLocalVelocities; ++i)
        u[i][lane] -= cage.from.row(i).dot(border_solution_.segment(kCageY, cage_columns));
    }
    const Pack speed[kRollerVelocities] = {u[kLr],
                                           u[kLt] * l.inverse_radius,
                                           u[kLx],
                                           l.cosine * u[kLar] - l.sine * u[kLat],
                                           l.sine * u[kLar] + l.cosine * u[kLat],
                                           u[kLs]};
    for (int slot = 0; slot < kRollerPositions; ++slot) {
      const int at = slot * layout.padded() + j;
      store(x + at, beta_ * (load(rhs + at) + speed[slot]) * roller.exists);
    }
    for (int slot = 0; slot < kRollerVelocities; ++slot)
      store(x + layout.positions() + slot * layout.padded() + j, speed[slot] * roller.exists);
  }
  for (int i = 0; i < border; ++i) {
    x[layout.border_position(i)] = border_positions_[i] + beta_ * border_solution_[i];
    x[layout.border_velocity(i)] = border_solution_[i];
  }
}

}  // namespace cagetol
