#include "src/dynamics/linearisation.hpp"

#include "src/dynamics/flexible_cage.hpp"

namespace cagetol {

Linearisation::Linearisation(const StateLayout& layout)
    : groups(static_cast<std::size_t>(layout.groups)),
      tilts(layout.ring_tilt > 0 ? groups.size() : 0),
      border_position(Eigen::MatrixXd::Zero(layout.border(), layout.border())),
      border_velocity(Eigen::MatrixXd::Zero(layout.border(), layout.border())),
      power_position(Eigen::VectorXd::Zero(layout.border())),
      power_velocity(Eigen::VectorXd::Zero(layout.border())),
      couplings(static_cast<std::size_t>(layout.rollers)),
      slot(static_cast<std::size_t>(layout.rollers), -1) {
  for (auto& row : scratch.border)
    row.assign(static_cast<std::size_t>(kCageY + layout.cage()), 0.0);
  const int columns = layout.cage();
  for (auto& c : couplings) {
    c.position.setZero(kLocalVelocities, columns);
    c.velocity.setZero(kLocalVelocities, columns);
    c.to_position.setZero(columns, kLocalPositions);
    c.to_velocity.setZero(columns, kLocalVelocities);
  }
}

void Linearisation::clear() {
  for (auto& g : groups) g.clear();
  for (auto& t : tilts) t = TiltLinear{};
  if (cage_touched) {
    border_position.setZero();
    border_velocity.setZero();
  } else {
    const int ring[2] = {kRingY, static_cast<int>(border_position.rows()) - 2};
    const int vectors = tilts.empty() ? 1 : 2;
    for (int v = 0; v < vectors; ++v)
      for (int w = 0; w < vectors; ++w) {
        border_position.block<2, 2>(ring[v], ring[w]).setZero();
        border_velocity.block<2, 2>(ring[v], ring[w]).setZero();
      }
  }
  cage_touched = false;
  power_position.setZero();
  power_velocity.setZero();
  for (int i = 0; i < coupled; ++i)
    slot[static_cast<std::size_t>(couplings[static_cast<std::size_t>(i)].roller)] = -1;
  coupled = 0;
}

CageCoupling& Linearisation::coupling(int roller) {
  int& index = slot[static_cast<std::size_t>(roller)];
  if (index < 0) {
    index = coupled++;
    auto& c = couplings[static_cast<std::size_t>(index)];
    c.roller = roller;
    c.position.setZero();
    c.velocity.setZero();
    c.to_position.setZero();
    c.to_velocity.setZero();
  }
  return couplings[static_cast<std::size_t>(index)];
}

void Linearisation::hold(int group) {
  GroupLinear& g = groups[static_cast<std::size_t>(group)];
  for (int i = 0; i < kLocalVelocities; ++i)
    for (int j = 0; j < kLocalVelocities; ++j) {
      if (!held<true>(i) && !held<true>(j)) continue;
      g.velocity[i][j] = Pack{};
      if (j < kLocalPositions) g.position[i][j] = Pack{};
    }
  for (int i = kLx; i <= kLat; ++i) {
    for (int k = 0; k < 2; ++k)
      g.ring.position[i][k] = g.ring.velocity[i][k] = g.ring.to_position[k][i] =
          g.ring.to_velocity[k][i] = Pack{};
    g.power_position[i] = g.power_velocity[i] = Pack{};
  }
  for (int n = 0; n < coupled; ++n) {
    CageCoupling& c = couplings[static_cast<std::size_t>(n)];
    if (c.roller / kLanes != group) continue;
    constexpr int count = kLat - kLx + 1;
    c.position.middleRows<count>(kLx).setZero();
    c.velocity.middleRows<count>(kLx).setZero();
    c.to_position.middleCols<count>(kLx).setZero();
    c.to_velocity.middleCols<count>(kLx).setZero();
  }
}

void add_contact(const ContactRows& rows, const ContactSlopes& s, int roller,
                 Linearisation& linear) {
  linear.cage_touched = true;
  // F1 = -ratio Q v1, F2 likewise; dQ = k dp + c dp', dp = -g_n P, dp' = -g_n V.
  const double d11 = s.force * (s.ratio + s.bend * s.v1 * s.v1),
               d12 = s.force * s.bend * s.v1 * s.v2;
  const double d22 = s.force * (s.ratio + s.bend * s.v2 * s.v2);
  const double along1 = s.ratio * s.v1, along2 = s.ratio * s.v2;
  const auto mixed = [&](double gn, double g1, double g2, double& e, double& w1, double& w2) {
    e = gn - along1 * g1 - along2 * g2;
    w1 = d11 * g1 + d12 * g2;
    w2 = d12 * g1 + d22 * g2;
  };
  const int border = static_cast<int>(rows.border[0].size());
  const double *bn = rows.border[0].data(), *b1 = rows.border[1].data(),
               *b2 = rows.border[2].data();
  const int first = roller < 0 ? 0 : kCageY;  // rollers never couple to the ring through the cage
  const int lane = roller % kLanes;
  GroupLinear* group =
      roller < 0 ? nullptr : &linear.groups[static_cast<std::size_t>(roller / kLanes)];
  CageCoupling* coupling = roller < 0 ? nullptr : &linear.coupling(roller);
  const auto lost = dissipation_slopes(s.force, s.stiffness, s.damping, s.ratio, s.bend, s.v1, s.v2,
                                       s.elastic, s.elastic_stiffness, s.rate);
  double e, w1, w2;
  if (roller >= 0) {
    for (int i = 0; i < kLocalVelocities; ++i) {
      mixed(rows.roller[0][i], rows.roller[1][i], rows.roller[2][i], e, w1, w2);
      for (int j = 0; j < kLocalVelocities; ++j)
        group->velocity[i][j][lane] -=
            e * s.damping * rows.roller[0][j] + w1 * rows.roller[1][j] + w2 * rows.roller[2][j];
      for (int j = 0; j < kLocalPositions; ++j)
        group->position[i][j][lane] -= e * s.stiffness * rows.roller[0][j] + w2 * rows.lean[j];
      group->power_velocity[i][lane] +=
          lost.rate * rows.roller[0][i] - lost.v1 * rows.roller[1][i] - lost.v2 * rows.roller[2][i];
      if (i < kLocalPositions)
        group->power_position[i][lane] += lost.p * rows.roller[0][i] - lost.v2 * rows.lean[i];
      for (int j = first; j < border; ++j) {
        coupling->velocity(i, j - first) -= e * s.damping * bn[j] + w1 * b1[j] + w2 * b2[j];
        coupling->position(i, j - first) -= e * s.stiffness * bn[j];
      }
    }
  }
  constexpr int kMostBorder = kRigidBorder + kMostModes;
  double damped[kMostBorder], stiff[kMostBorder], by1[kMostBorder], by2[kMostBorder];
  for (int i = first; i < border; ++i) {
    mixed(bn[i], b1[i], b2[i], e, by1[i], by2[i]);
    damped[i] = e * s.damping;
    stiff[i] = e * s.stiffness;
    linear.power_velocity[i] += lost.rate * bn[i] - lost.v1 * b1[i] - lost.v2 * b2[i];
    linear.power_position[i] += lost.p * bn[i];
  }
  for (int i = first; roller >= 0 && i < border; ++i) {
    for (int j = 0; j < kLocalVelocities; ++j)
      coupling->to_velocity(i - first, j) -=
          damped[i] * rows.roller[0][j] + by1[i] * rows.roller[1][j] + by2[i] * rows.roller[2][j];
    for (int j = 0; j < kLocalPositions; ++j)
      coupling->to_position(i - first, j) -= stiff[i] * rows.roller[0][j] + by2[i] * rows.lean[j];
  }
  // Column by column, as these matrices lie in memory.
  for (int j = first; j < border; ++j) {
    double *velocity = linear.border_velocity.col(j).data(),
           *position = linear.border_position.col(j).data();
    const double n = bn[j], t1 = b1[j], t2 = b2[j];
    for (int i = first; i < border; ++i) {
      velocity[i] -= damped[i] * n + by1[i] * t1 + by2[i] * t2;
      position[i] -= stiff[i] * n;
    }
  }
}

}  // namespace cagetol
