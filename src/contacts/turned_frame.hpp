// What derivatives taken in frozen directions of the rollers become: frames that turn, and what the
// inner ring feels of contacts that depend on its motion against the rollers alone.
#pragma once

#include "src/contacts/contact_frame.hpp"

namespace cagetol {
namespace {  // each source inlines what pays

/// Forces turn with the roller's directions, and its velocity does in directions held still:
/// completes a row of the races' derivatives, which were taken in frozen directions.
void turn_frame(const RollerPack& q, Pack* position, const Pack* velocity) {
  position[kLr] += q.omega * velocity[kLt];
  position[kLt] += q.vr / q.r * velocity[kLt] - q.omega * velocity[kLr];
}

/// Keeps what the inner race alone gives for the ring.
void finish_inner(const RollerPack& q, GroupLinear& g) {
  for (int i = 0; i < kLocalVelocities; ++i)
    for (int k = 0; k < 2; ++k) {
      g.ring.position[i][k] = -g.position[i][k];
      g.ring.velocity[i][k] = -g.velocity[i][k];
      g.ring.to_velocity[k][i] = -g.velocity[k][i];
      if (i < kLocalPositions) g.ring.to_position[k][i] = -g.position[k][i];
    }
  for (int k = 0; k < 2; ++k) turn_frame(q, g.ring.to_position[k], g.ring.to_velocity[k]);
}

/// What the axial motion of the inner ring does at its race, and to it: the opposite of what that
/// of the rollers does.
void finish_axial(const RollerPack& q, const GroupLinear& g, Pack exists, int group, int slot,
                  Linearisation& linear) {
  Pack to_position[kLocalPositions], to_velocity[kLocalVelocities];
  for (int j = 0; j < kLocalVelocities; ++j) {
    to_velocity[j] = -g.velocity[kLx][j];
    if (j < kLocalPositions) to_position[j] = -g.position[kLx][j];
  }
  turn_frame(q, to_position, to_velocity);
  linear.cage_touched = true;
  linear.border_velocity(slot, slot) += sum(exists * g.velocity[kLx][kLx]);
  linear.border_position(slot, slot) += sum(exists * g.position[kLx][kLx]);
  const auto cross = [&](Pack on_r, Pack on_t, int k) {
    return sum(exists *
               (k == kRingY ? g.cosine * on_r - g.sine * on_t : g.sine * on_r + g.cosine * on_t));
  };
  for (const int k : {kRingY, kRingZ}) {
    linear.border_velocity(k, slot) += cross(g.velocity[kLr][kLx], g.velocity[kLt][kLx], k);
    linear.border_position(k, slot) += cross(g.position[kLr][kLx], g.position[kLt][kLx], k);
    linear.border_velocity(slot, k) += cross(g.velocity[kLx][kLr], g.velocity[kLx][kLt], k);
    linear.border_position(slot, k) += cross(g.position[kLx][kLr], g.position[kLx][kLt], k);
  }
  linear.power_velocity[slot] -= sum(exists * g.power_velocity[kLx]);
  linear.power_position[slot] -= sum(exists * g.power_position[kLx]);
  const auto column = static_cast<std::size_t>(slot - kCageY), packs = column / kLanes + 1;
  const auto place = static_cast<int>(column) % kLanes;
  for (int i = 0; i < kLanes; ++i) {
    if (exists[i] == 0) continue;
    CageCoupling& c = linear.coupling(group * kLanes + i);
    for (int k = 0; k < kLocalVelocities; ++k) {
      const auto at = static_cast<std::size_t>(k) * packs + packs - 1;
      c.velocity[column][k] -= g.velocity[k][kLx][i];
      c.position[column][k] -= g.position[k][kLx][i];
      c.to_velocity[at][place] += to_velocity[k][i];
      if (k < kLocalPositions) c.to_position[at][place] += to_position[k][i];
    }
  }
}

/// The ring's own block from the inner race: d(force on ring)/d(ring) in y, z.
void add_ring_block(const GroupLinear& g, Linearisation& linear) {
  const auto add = [&](const Pack(&to)[kLocalVelocities][2], Eigen::MatrixXd& block) {
    // Force on the ring is the opposite of that on the roller: -d(f_r, f_t)/d(u_r, u_t).
    add_turned(g, -to[kLr][0], -to[kLr][1], -to[kLt][0], -to[kLt][1], block, kRingY, kRingY);
  };
  add(g.ring.position, linear.border_position);
  add(g.ring.velocity, linear.border_velocity);
}

}  // namespace
}  // namespace cagetol
