#include "tests/support/dense_jacobian.hpp"

#include <cmath>

namespace cagetol {

Eigen::MatrixXd assembled_jacobian(const BearingModel& m, const std::vector<double>& y,
                                   const Linearisation& linear) {
  const StateLayout& l = m.layout;
  const int n = l.size(), border = l.border();
  // Columns: local directions of every roller, then the border, as combinations of state
  // components; rows likewise.
  const int locals = l.rollers * kLocalVelocities;
  const int rows = locals + border;
  Eigen::MatrixXd by_position = Eigen::MatrixXd::Zero(rows, rows), by_velocity = by_position;
  Eigen::MatrixXd position_of = Eigen::MatrixXd::Zero(rows, n), velocity_of = position_of;
  Eigen::MatrixXd acceleration_of = Eigen::MatrixXd::Zero(n, rows);
  for (int j = 0; j < l.rollers; ++j) {
    const int g = j / kLanes, lane = j % kLanes, at = j * kLocalVelocities;
    const GroupLinear& local = linear.groups[static_cast<std::size_t>(g)];
    const RollerGroup& roller = m.groups[static_cast<std::size_t>(g)];
    const double theta = y[static_cast<std::size_t>(l.position(kAngle, j))];
    const double r = y[static_cast<std::size_t>(l.position(kRadius, j))], c = std::cos(theta),
                 s = std::sin(theta);
    position_of(at + kLr, l.position(kRadius, j)) =
        velocity_of(at + kLr, l.velocity(kRadialSpeed, j)) = 1;
    position_of(at + kLt, l.position(kAngle, j)) =
        velocity_of(at + kLt, l.velocity(kOrbitRate, j)) = r;
    position_of(at + kLx, l.position(kAxial, j)) =
        velocity_of(at + kLx, l.velocity(kAxialSpeed, j)) = 1;
    position_of(at + kLar, l.position(kAxisY, j)) =
        velocity_of(at + kLar, l.velocity(kAxisRateY, j)) = c;
    position_of(at + kLar, l.position(kAxisZ, j)) =
        velocity_of(at + kLar, l.velocity(kAxisRateZ, j)) = s;
    position_of(at + kLat, l.position(kAxisY, j)) =
        velocity_of(at + kLat, l.velocity(kAxisRateY, j)) = -s;
    position_of(at + kLat, l.position(kAxisZ, j)) =
        velocity_of(at + kLat, l.velocity(kAxisRateZ, j)) = c;
    velocity_of(at + kLs, l.velocity(kSpin, j)) = 1;
    acceleration_of(l.velocity(kRadialSpeed, j), at + kLr) = 1 / roller.mass[lane];
    acceleration_of(l.velocity(kOrbitRate, j), at + kLt) = 1 / roller.mass[lane] / r;
    acceleration_of(l.velocity(kAxialSpeed, j), at + kLx) = 1 / roller.mass[lane];
    const double lean = 1 / roller.transverse[lane];
    acceleration_of(l.velocity(kAxisRateY, j), at + kLar) = c * lean;
    acceleration_of(l.velocity(kAxisRateY, j), at + kLat) = -s * lean;
    acceleration_of(l.velocity(kAxisRateZ, j), at + kLar) = s * lean;
    acceleration_of(l.velocity(kAxisRateZ, j), at + kLat) = c * lean;
    acceleration_of(l.velocity(kSpin, j), at + kLs) = 1 / roller.polar[lane];
    const double turn[2][2] = {{c, s}, {-s, c}};  // (r, t) from (y, z)
    const auto add_ring = [&](const RingCoupling& ring, int slot, int i, int k, double turned) {
      by_position(at + i, locals + slot) += ring.position[i][k][lane] * turned;
      by_velocity(at + i, locals + slot) += ring.velocity[i][k][lane] * turned;
      if (i < kLocalPositions)
        by_position(locals + slot, at + i) += turned * ring.to_position[k][i][lane];
      by_velocity(locals + slot, at + i) += turned * ring.to_velocity[k][i][lane];
    };
    for (int i = 0; i < kLocalVelocities; ++i) {
      for (int k = 0; k < kLocalVelocities; ++k) {
        if (k < kLocalPositions) by_position(at + i, at + k) = local.position[i][k][lane];
        by_velocity(at + i, at + k) = local.velocity[i][k][lane];
      }
      for (int k = 0; k < 2; ++k)
        for (int a = 0; a < 2; ++a) {
          add_ring(local.ring, kRingY + a, i, k, turn[k][a]);
          if (l.ring_tilt > 0)
            add_ring(linear.tilts[static_cast<std::size_t>(g)].coupling, l.ring_tilt_slot() + a, i,
                     k, turn[k][a]);
        }
    }
    const int slot = linear.slot[static_cast<std::size_t>(j)];
    if (slot < 0) continue;
    const CageCoupling& cage = linear.couplings[static_cast<std::size_t>(slot)];
    const int packs = packs_for(l.coupled());
    for (int k = 0; k < l.coupled(); ++k) {
      const int row = locals + kCageY + k;
      const auto column = static_cast<std::size_t>(k);
      for (int i = 0; i < kLocalVelocities; ++i) {
        const auto pack = static_cast<std::size_t>(i * packs + k / kLanes);
        by_position(at + i, row) += cage.position[column][i];
        by_velocity(at + i, row) += cage.velocity[column][i];
        if (i < kLocalPositions) by_position(row, at + i) += cage.to_position[pack][k % kLanes];
        by_velocity(row, at + i) += cage.to_velocity[pack][k % kLanes];
      }
    }
  }
  by_position.bottomRightCorner(border, border) += linear.border_position;
  by_velocity.bottomRightCorner(border, border) += linear.border_velocity;
  const double masses[kRigidBorder] = {m.ring_mass,       m.ring_mass,      m.cage_mass,
                                       m.cage_mass,       m.cage_mass,      m.cage_polar,
                                       m.cage_transverse, m.cage_transverse};
  for (int i = 0; i < border; ++i) {
    position_of(locals + i, l.border_position(i)) = velocity_of(locals + i, l.border_velocity(i)) =
        1;
    const double mass = i < kRigidBorder          ? masses[i]
                        : i < l.ring_axial_slot() ? 1
                        : i < l.ring_tilt_slot()  ? m.ring_mass
                                                  : m.ring_transverse;
    acceleration_of(l.border_velocity(i), locals + i) = mass > 0 ? 1 / mass : 0;
  }
  Eigen::MatrixXd J = acceleration_of * (by_position * position_of + by_velocity * velocity_of);
  for (int slot = 0; slot < kRollerPositions; ++slot)
    for (int j = 0; j < l.rollers; ++j) {
      const auto position = static_cast<RollerPosition>(slot);
      J(l.position(position, j), l.velocity(static_cast<RollerVelocity>(slot), j)) = 1;
    }
  for (int i = 0; i < border; ++i) J(l.border_position(i), l.border_velocity(i)) = 1;
  return J;
}

Eigen::MatrixXd differenced_jacobian(const BearingModel& m, double t, const std::vector<double>& y,
                                     const PackVector& scale, double step) {
  const int n = m.layout.size();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
  std::vector<double> moved = y;
  Eigen::VectorXd up(n), down(n);
  for (int k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (scale[at] > 1e20) continue;  // padding
    const double h = step * scale[at];
    moved[at] = y[at] + h;
    const double high = moved[at];
    evaluate_rates(m, t, moved.data(), up.data());
    moved[at] = y[at] - h;
    evaluate_rates(m, t, moved.data(), down.data());
    J.col(k) = (up - down) / (high - moved[at]);
    moved[at] = y[at];
  }
  return J;
}

}  // namespace cagetol
