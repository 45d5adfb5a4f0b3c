// The state vector: named slots, never numbers. Rollers are stored component by component
// (structure of arrays), then the border: inner ring, cage, cage modes, and the inner ring's tilt
// where it is free. Positions first, then velocities. Each component of the rollers and the border
// are padded to whole packs, so that no pack lies across two cache lines.
#pragma once

#include "src/numerics/pack.hpp"

namespace cagetol {

/// Position slots of a roller: cylindrical position and the two small inertial components of its
/// axis a = (1, a_y, a_z).
enum RollerPosition { kRadius, kAngle, kAxial, kAxisY, kAxisZ, kRollerPositions };
/// Velocity slots of a roller: r', theta', x', a_y', a_z', and the absolute spin rate about its own
/// axis.
enum RollerVelocity {
  kRadialSpeed,
  kOrbitRate,
  kAxialSpeed,
  kAxisRateY,
  kAxisRateZ,
  kSpin,
  kRollerVelocities
};
/// Border slots: inner ring, then the cage's mass centre, spin angle and axis, then modal
/// coordinates, then of the inner ring, where they are free, its axial place and the two slopes
/// B_y, B_z of its centre line.
enum Border { kRingY, kRingZ, kCageY, kCageZ, kCageX, kCagePhi, kCageAxisY, kCageAxisZ, kModes };
inline constexpr int kRigidBorder = kModes;
inline constexpr int kCageRigid = kModes - kCageY;  ///< rigid degrees of freedom of the cage

/// Where each slot of the state vector is.
struct StateLayout {
  int rollers = 0;  ///< Z
  int groups = 0;   ///< packs of kLanes rollers
  int modes = 0;
  int ring_axial = 0;  ///< 1 where the inner ring's axial place is free, else 0
  int ring_tilt = 0;   ///< 2 where its tilt is free, else 0

  int padded() const { return groups * kLanes; }
  /// Directions of the border that single rollers couple to, from kCageY on: the cage's and the
  /// inner ring's axial one.
  int coupled() const { return kCageRigid + modes + ring_axial; }
  int ring_axial_slot() const { return kRigidBorder + modes; }              ///< of the border
  int ring_tilt_slot() const { return kRigidBorder + modes + ring_axial; }  ///< and the next one
  int border() const { return kRigidBorder + modes + ring_axial + ring_tilt; }
  int padded_border() const { return (border() + kLanes - 1) & -kLanes; }
  int positions() const { return kRollerPositions * padded() + padded_border(); }
  int velocities() const { return kRollerVelocities * padded() + padded_border(); }
  int size() const { return positions() + velocities(); }  ///< a multiple of kLanes

  int position(RollerPosition slot, int roller) const { return slot * padded() + roller; }
  int velocity(RollerVelocity slot, int roller) const {
    return positions() + slot * padded() + roller;
  }
  int border_position(int slot) const { return kRollerPositions * padded() + slot; }
  int border_velocity(int slot) const { return positions() + kRollerVelocities * padded() + slot; }
};

}  // namespace cagetol
