// Above 400 lines: factors and solutions read the same blocks, which nothing else does.
#include "src/newton/newton_matrix.hpp"

#include <algorithm>

#include "src/newton/roller_block.hpp"

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
  if (m.layout.ring_axial > 0) mass[m.layout.ring_axial_slot()] = m.ring_mass;
  mass.tail(m.layout.ring_tilt).setConstant(m.ring_transverse);
  return mass;
}

// A ring whose tilt is free has no flanges, so that its axial place is not.
static_assert(int{kRigidBorder} + kMostModes + 2 <= SmallInverse::kMost);

NewtonMatrix::NewtonMatrix(const BearingModel& model)
    : model_(model),
      groups_(static_cast<std::size_t>(model.layout.groups)),
      cages_(static_cast<std::size_t>(model.layout.rollers)),
      schur_(model.layout.border()),
      free_ring_(2 + model.layout.ring_tilt),
      free_cage_(model.layout),
      border_mass_(Eigen::VectorXd::Zero(model.layout.padded_border())),
      border_rhs_(border_mass_),
      border_positions_(border_mass_),
      border_solution_(border_mass_) {
  border_mass_.head(model.layout.border()) = border_mass(model);
  const int columns = model.layout.coupled();
  for (auto& c : cages_) {
    c.from.resize(static_cast<std::size_t>(columns));
    c.to.resize(static_cast<std::size_t>(kLocalVelocities * packs_for(columns)));
  }
}

template <class Then>
void NewtonMatrix::for_coupled(int group, const Then& then) const {
  if (linear_->coupled == 0) return;
  const int first = group * kLanes, count = std::min(kLanes, model_.layout.rollers - first);
  for (int lane = 0; lane < count; ++lane) {
    const int slot = linear_->slot[static_cast<std::size_t>(first + lane)];
    if (slot >= 0) then(lane, static_cast<std::size_t>(slot));
  }
}

const RingCoupling& NewtonMatrix::coupling(int group, int vector) const {
  const auto at = static_cast<std::size_t>(group);
  return vector == 0 ? linear_->groups[at].ring : linear_->tilts[at].coupling;
}

/// Blocks of the rollers, and what of them reaches the ring.
template <int vectors>
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
      for (int j = 0; j < kLocalVelocities; ++j)
        f.inverse[i][j] =
            -l.velocity[i][j] - (j < kLocalPositions ? beta * l.position[i][j] : Pack{});
      f.inverse[i][i] += mass[i] / beta;
    }
    if (!invert(f.inverse, mass, beta, roller.exists)) sound = false;
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
        multiply(f.inverse, from_ring[v][c], solved);
        for (int i = 0; i < kLocalVelocities; ++i) f.from_ring[v][i][c] = solved[i];
        multiply_left(to_ring, f.inverse, f.to_ring[v][c]);
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

/// Adds to each lane of `to` that touches the cage what `of_lane` gives over local directions.
template <class OfLane>
void NewtonMatrix::add_to_lanes(int group, Pack (&to)[kLocalVelocities],
                                const OfLane& of_lane) const {
  Eight added[kLanes] = {};
  bool some = false;
  for_coupled(group, [&](int lane, std::size_t slot) {
    added[lane] = of_lane(lane, slot);
    some = true;
  });
  if (!some) return;
  Pack columns[kEight];
  transpose(added, columns);
  for (int i = 0; i < kLocalVelocities; ++i) to[i] += columns[i];
}

bool NewtonMatrix::factor(const Linearisation& linear, double beta) {
  return model_.layout.ring_tilt > 0 ? factor_as<2>(linear, beta) : factor_as<1>(linear, beta);
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

template <int vectors>
bool NewtonMatrix::factor_as(const Linearisation& linear, double beta) {
  linear_ = &linear;
  beta_ = beta;
  if (!linear.cage_touched) {
    start_free_ring<vectors>();
    bool sound = factor_rollers<vectors>(beta);
    if (!finish_free_ring<vectors>()) sound = false;
    return free_cage_.factor(linear, border_mass_, beta) && sound;
  }
  auto schur = schur_.matrix();
  schur = -linear.border_velocity - beta * linear.border_position;
  schur.diagonal() += border_mass_.head(model_.layout.border()) / beta;
  bool sound = factor_rollers<vectors>(beta);
  with_packs(packs_for(model_.layout.coupled()),
             [&]<int packs>() { factor_cage<vectors, packs>(); });
  if (!schur_.invert()) sound = false;
  return sound;
}

// One function: what it keeps in registers between its loops would go through memory otherwise.
template <int vectors, int packs>
void NewtonMatrix::factor_cage() {
  const int columns = model_.layout.coupled();
  auto schur = schur_.matrix();
  // What reaches the cage from the ring by way of rollers, and the ring from the cage.
  Pack ring_columns[vectors][2][packs] = {}, ring_rows[vectors][2][packs] = {};
  for (int group = 0; group < model_.layout.groups; ++group) {
    const Group& f = groups_[static_cast<std::size_t>(group)];
    const GroupLinear& l = linear_->groups[static_cast<std::size_t>(group)];
    for_coupled(group, [&](int lane, std::size_t slot) {
      const CageCoupling& c = linear_->couplings[slot];
      Cage& cage = cages_[slot];
      for (int i = 0; i < kLocalVelocities; ++i)
        for (int p = 0; p < packs; ++p) {
          const auto at = static_cast<std::size_t>(i * packs + p);
          cage.to[at] = -c.to_velocity[at];
          if (i < kLocalPositions) cage.to[at] -= beta_ * c.to_position[at];
        }
      Eight inverse[kLocalVelocities] = {};  // column by column
      for (int j = 0; j < kLocalVelocities; ++j)
        for (int i = 0; i < kLocalVelocities; ++i) inverse[j][i] = f.inverse[i][j][lane];
      const double co = l.cosine[lane], si = l.sine[lane];
      const auto turned = [&](Pack r, Pack t, int axis) {
        return axis == 0 ? r[lane] * co - t[lane] * si : r[lane] * si + t[lane] * co;
      };
      for (int first = 0; first < packs * kLanes; first += kLanes) {
        Eight into[kLanes] = {};  // N, column by column
        for (int k = 0; k < kLanes && first + k < columns; ++k) {
          const auto column = static_cast<std::size_t>(first + k);
          into[k] = -c.velocity[column] - beta_ * c.position[column];
          Eight from{};
          for (int j = 0; j < kLocalVelocities; ++j) from += inverse[j] * into[k][j];
          cage.from[column] = from;
          for (int p = 0; p < packs; ++p) {
            const int row = p * kLanes;
            Pack reached{};
            for (int i = 0; i < kLocalVelocities; ++i)
              reached += cage.to[static_cast<std::size_t>(i * packs + p)] * from[i];
            double* to = &schur(kCageY + row, kCageY + first + k);
            store_first(to, load_first(to, columns - row) - reached, columns - row);
          }
        }
        Pack by_direction[kEight];
        transpose(into, by_direction);
        for (int v = 0; v < vectors; ++v)
          for (int axis = 0; axis < 2; ++axis)
            for (int i = 0; i < kLocalVelocities; ++i)
              ring_rows[v][axis][first / kLanes] +=
                  turned(f.to_ring[v][0][i], f.to_ring[v][1][i], axis) * by_direction[i];
      }
      for (int v = 0; v < vectors; ++v)
        for (int axis = 0; axis < 2; ++axis)
          for (int i = 0; i < kLocalVelocities; ++i) {
            const double by = turned(f.from_ring[v][i][0], f.from_ring[v][i][1], axis);
            for (int p = 0; p < packs; ++p)
              ring_columns[v][axis][p] += by * cage.to[static_cast<std::size_t>(i * packs + p)];
          }
    });
  }
  for (int v = 0; v < vectors; ++v)
    for (int axis = 0; axis < 2; ++axis)
      for (int c = 0; c < columns; ++c) {
        const int ring = ring_slot(v) + axis, lane = c % kLanes;
        schur(ring, kCageY + c) -= ring_rows[v][axis][c / kLanes][lane];
        schur(kCageY + c, ring) -= ring_columns[v][axis][c / kLanes][lane];
      }
}

void NewtonMatrix::solve(const double* rhs, double* x) {
  model_.layout.ring_tilt > 0 ? solve_as<2>(rhs, x) : solve_as<1>(rhs, x);
}

template <int vectors>
void NewtonMatrix::solve_as(const double* rhs, double* x) {
  if (linear_->coupled == 0) return solve_with<vectors, 0>(rhs, x);
  with_packs(packs_for(model_.layout.coupled()),
             [&]<int packs>() { solve_with<vectors, packs>(rhs, x); });
}

/// The border's right-hand side, as it is without rollers, and its positions.
template <int vectors>
void NewtonMatrix::start_border(const double* rhs) {
  const StateLayout& layout = model_.layout;
  const double *bq = rhs + layout.border_position(0), *bv = rhs + layout.border_velocity(0);
  for (int i = 0; i < layout.padded_border(); i += kLanes) {
    store(&border_positions_[i], beta_ * load(bq + i));
    store(&border_rhs_[i], load(&border_mass_[i]) * load(bv + i));
  }
  if (linear_->cage_touched) {
    with_packs(packs_for(layout.border()), [&]<int rows>() {
      add_product<rows>(linear_->border_position, border_positions_.data(), border_rhs_.data());
    });
    return;
  }
  const Eigen::MatrixXd& stiff = linear_->border_position;
  for (int v = 0; v < vectors; ++v)
    for (int w = 0; w < vectors; ++w)
      border_rhs_.segment<2>(ring_slot(v)) += stiff.block<2, 2>(ring_slot(v), ring_slot(w)) *
                                              border_positions_.segment<2>(ring_slot(w));
  for (int k = kModes; k < kModes + layout.modes; ++k)
    border_rhs_[k] += stiff(k, k) * border_positions_[k];
}

/// Right-hand side of a pack of rollers in their directions: positions, and forces with what these
/// positions and the border's make.
template <int vectors>
NewtonMatrix::RollerSide NewtonMatrix::roller_side(int n, const double* rhs) const {
  const StateLayout& layout = model_.layout;
  const GroupLinear& l = linear_->groups[static_cast<std::size_t>(n)];
  const RollerGroup& roller = model_.groups[static_cast<std::size_t>(n)];
  const int j = n * kLanes;
  const auto q = [&](RollerPosition slot) { return beta_ * load(rhs + layout.position(slot, j)); };
  const auto velocity = [&](RollerVelocity slot) { return load(rhs + layout.velocity(slot, j)); };
  const Pack ay = q(kAxisY), az = q(kAxisZ), by = velocity(kAxisRateY), bz = velocity(kAxisRateZ);
  RollerSide side{{q(kRadius), l.radius * q(kAngle), q(kAxial), l.cosine * ay + l.sine * az,
                   l.cosine * az - l.sine * ay},
                  {}};
  Pack(&force)[kLocalVelocities] = side.force;
  force[kLr] = roller.mass * velocity(kRadialSpeed);
  force[kLt] = roller.mass * l.radius * velocity(kOrbitRate);
  force[kLx] = roller.mass * velocity(kAxialSpeed);
  force[kLar] = roller.transverse * (l.cosine * by + l.sine * bz);
  force[kLat] = roller.transverse * (l.cosine * bz - l.sine * by);
  force[kLs] = roller.polar * velocity(kSpin);
  const RingVectors<vectors> ring(l, border_positions_, layout);
  for (int i = 0; i < kLocalVelocities; ++i) {
    for (int k = 0; k < kLocalPositions; ++k) force[i] += l.position[i][k] * side.position[k];
    for (int v = 0; v < vectors; ++v) {
      const RingCoupling& with = coupling(n, v);
      force[i] += with.position[i][0] * ring.r[v] + with.position[i][1] * ring.t[v];
    }
  }
  return side;
}

/// Eliminates the rollers: what they leave on ring and cage goes to the border's right-hand side.
/// `packs` of a vector over the cage's directions; 0 where no roller touches the cage.
template <int vectors, int packs>
void NewtonMatrix::eliminate_rollers(const double* rhs) {
  const StateLayout& layout = model_.layout;
  Pack on_ring[vectors][2] = {};  // in y, z
  [[maybe_unused]] Pack on_cage[std::max(packs, 1)] = {};
  const double* const cage_positions = border_positions_.data() + kCageY;
  for (int n = 0; n < layout.groups; ++n) {
    const GroupLinear& l = linear_->groups[static_cast<std::size_t>(n)];
    const RollerGroup& roller = model_.groups[static_cast<std::size_t>(n)];
    Group& f = groups_[static_cast<std::size_t>(n)];
    auto [P, force] = roller_side<vectors>(n, rhs);
    Pack to_ring[vectors][2] = {};
    for (int v = 0; v < vectors; ++v)
      for (int a = 0; a < 2; ++a)
        for (int k = 0; k < kLocalPositions; ++k)
          to_ring[v][a] += coupling(n, v).to_position[a][k] * P[k];
    if constexpr (packs > 0) {
      const Pack* const at = P;
      add_to_lanes(n, force, [&](int lane, std::size_t slot) {
        const CageCoupling& c = linear_->couplings[slot];
        for (int k = 0; k < kLocalPositions; ++k)
          for (int p = 0; p < packs; ++p)
            on_cage[p] += c.to_position[static_cast<std::size_t>(k * packs + p)] * at[k][lane];
        return weighted_sum(c.position, cage_positions);
      });
    }
    for (int v = 0; v < vectors; ++v) {
      Pack(&to)[2] = to_ring[v];
      for (int a = 0; a < 2; ++a) to[a] -= product(f.to_ring[v][a], force);
      on_ring[v][0] += roller.exists * (l.cosine * to[0] - l.sine * to[1]);
      on_ring[v][1] += roller.exists * (l.sine * to[0] + l.cosine * to[1]);
    }
    multiply(f.inverse, force, f.rhs);
    if constexpr (packs > 0)
      for_coupled(n, [&](int lane, std::size_t slot) {
        for (int i = 0; i < kLocalVelocities; ++i)
          for (int p = 0; p < packs; ++p)
            on_cage[p] -= cages_[slot].to[static_cast<std::size_t>(i * packs + p)] * f.rhs[i][lane];
      });
  }
  for (int p = 0; p < packs; ++p) {
    const int left = layout.coupled() - p * kLanes;
    double* to = border_rhs_.data() + kCageY + p * kLanes;
    store_first(to, load_first(to, left) + on_cage[p], left);
  }
  for (int v = 0; v < vectors; ++v)
    for (int a = 0; a < 2; ++a) border_rhs_[ring_slot(v) + a] += sum(on_ring[v][a]);
}

/// Rollers from the border's solution, into x.
template <int vectors, int packs>
void NewtonMatrix::substitute_rollers(const double* rhs, double* x) {
  const StateLayout& layout = model_.layout;
  for (int n = 0; n < layout.groups; ++n) {
    const GroupLinear& l = linear_->groups[static_cast<std::size_t>(n)];
    const RollerGroup& roller = model_.groups[static_cast<std::size_t>(n)];
    Group& f = groups_[static_cast<std::size_t>(n)];
    const int j = n * kLanes;
    const RingVectors<vectors> ring(l, border_solution_, layout);
    Pack u[kLocalVelocities];
    for (int i = 0; i < kLocalVelocities; ++i) {
      u[i] = f.rhs[i];
      for (int v = 0; v < vectors; ++v)
        u[i] = u[i] - f.from_ring[v][i][0] * ring.r[v] - f.from_ring[v][i][1] * ring.t[v];
    }
    if constexpr (packs > 0)
      add_to_lanes(n, u, [&](int, std::size_t slot) {
        return -weighted_sum(cages_[slot].from, border_solution_.data() + kCageY);
      });
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
}

template <int vectors, int packs>
void NewtonMatrix::solve_with(const double* rhs, double* x) {
  const StateLayout& layout = model_.layout;
  start_border<vectors>(rhs);
  eliminate_rollers<vectors, packs>(rhs);
  if (linear_->cage_touched)
    schur_.solve(border_rhs_.data(), border_solution_.data());
  else
    solve_free_border<vectors>();
  substitute_rollers<vectors, packs>(rhs, x);
  double *xq = x + layout.border_position(0), *xv = x + layout.border_velocity(0);
  for (int i = 0; i < layout.padded_border(); i += kLanes) {
    const Pack velocity = load(&border_solution_[i]);
    store(xq + i, load(&border_positions_[i]) + beta_ * velocity);
    store(xv + i, velocity);
  }
}

}  // namespace cagetol
