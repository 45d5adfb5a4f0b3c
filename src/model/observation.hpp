// What a run sees of its contacts at one state, beside forces and derivatives (forces.hpp).
#pragma once

#include <array>

#include "src/model/bearing_model.hpp"
#include "src/numerics/pack_vector.hpp"

namespace cagetol {

/// Where power goes. kFilm is what the steady films take: of either sign, because their force
/// follows the entrainment, and small over a turn.
enum Mechanism {
  kRaceSliding,
  kRollingResistance,
  kPocketFriction,
  kEndFriction,
  kFlangeFriction,
  kLandFriction,
  kChurning,
  kSqueeze,
  kDamping,
  kFilm,
  kMechanisms
};

inline constexpr double kNoFilm = 1e30;  ///< stands for a film where nothing touches [m]

/// What is seen of the contacts at one state. Arrays have one element per roller (padded).
struct Observation {
  explicit Observation(const BearingModel& model);
  void clear();
  /// Adds to friction_power or damping_power, and to `lost`.
  void rub(Mechanism where, double power) {
    friction_power += power;
    lost[where] += power;
  }
  void damp(Mechanism where, double power) {
    damping_power += power;
    lost[where] += power;
  }

  PackVector inner_force;    ///< normal force on the inner race, all slices [N]
  PackVector outer_force;    ///< on the outer race [N]
  PackVector inner_sliding;  ///< force-weighted mean sliding speed at the inner race [m/s]
  PackVector inner_rubbing;  ///< power of sliding at the inner race [W]
  PackVector leading_force,
      trailing_force;       ///< on the pocket's bars ahead of and behind the roller [N]
  PackVector wall_force;    ///< on both side ring faces of the pocket [N]
  PackVector flange_force;  ///< on the ring's flanges [N]
  /// Force on the cage at its bar stations towards larger theta, flexible cages only [N]: per
  /// pocket the stations of the trailing face, then of the leading face (station_stress,
  /// src/cage/table/cage_model.hpp).
  Eigen::VectorXd bar_force;
  double centrifugal_spin = 0;  ///< of the cage where its centrifugal load is on, else 0 [rad/s]
  /// Of contact and guide film at x = -land_offset, +land_offset [N].
  double land_force[2] = {0, 0};
  bool land_touching[2] = {false, false};
  double ring_elastic_y = 0,
         ring_elastic_z = 0;  ///< elastic part of the forces on the inner ring [N]
  double drive_power = 0;     ///< of the inner ring's prescribed rotation [W]
  double load_power = 0;      ///< of the applied load [W]
  double friction_power = 0;  ///< dissipated by friction, in films and in oil and air [W]
  double damping_power = 0;   ///< dissipated by normal damping and squeeze; with what the steady
                              ///< films take, of either sign [W]
  std::array<double, kMechanisms> lost{};  ///< the same two, split by mechanism [W]
  double net_power_rate = 0;  ///< d/dt of drive + load - friction - damping power [W/s]
  double elastic_energy = 0;  ///< stored in contacts [J]
  double inner_slice = 0, outer_slice = 0;  ///< largest normal force of a race slice [N]
  double thinnest_film = 0;  ///< of loaded race contacts; very large without a film or load [m]
};

}  // namespace cagetol
