// Derivatives of all generalised forces at one state, stored the way the bearing couples: a roller
// with itself, with the inner ring, and - only while it touches its pocket - with the cage. In
// local directions of each roller, frozen at the state:
//   velocities  V = (r', r theta', x', a_r', a_t', w_s)
//   positions   P = (dr, r dtheta, dx, da_r, da_t)
// Border directions are the inertial ones of enum Border, the cage about its mass centre.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>
#include <vector>

#include "src/model/state.hpp"
#include "src/numerics/kernel.hpp"
#include "src/numerics/pack_matrix.hpp"

namespace cagetol {

/// Local directions of a roller.
enum Local { kLr, kLt, kLx, kLar, kLat, kLs, kLocalVelocities, kLocalPositions = kLs };

static_assert(int{kLocalVelocities} <= kEight);

/// Coupling of a pack of rollers with a vector of the inner ring - its displacement, or its tilt -
/// in the rollers' directions r, t.
struct RingCoupling {
  Pack position[kLocalVelocities][2], velocity[kLocalVelocities][2];  ///< dF/d(vector), dF/d(rate)
  Pack to_position[2][kLocalPositions],
      to_velocity[2][kLocalVelocities];  ///< d(force conjugate to the vector)/dP, dV
};

struct GroupLinear {
  Pack position[kLocalVelocities][kLocalPositions];   ///< dF/dP
  Pack velocity[kLocalVelocities][kLocalVelocities];  ///< dF/dV
  Pack power_position[kLocalPositions],
      power_velocity[kLocalVelocities];  ///< gradient of the net power, see below
  RingCoupling ring;                     ///< with the inner ring's displacement
  Pack cosine, sine;                     ///< of the roller's angle
  Pack radius, inverse_radius;           ///< r [m]

  /// What contacts add to; the rest is written anew at each state.
  void clear() {
    for (auto& row : position) std::fill(std::begin(row), std::end(row), Pack{});
    for (auto& row : velocity) std::fill(std::begin(row), std::end(row), Pack{});
    std::fill(std::begin(power_position), std::end(power_position), Pack{});
    std::fill(std::begin(power_velocity), std::end(power_velocity), Pack{});
  }
};

/// Adds a matrix in the rollers' directions r, t to a block in y, z, from `row`, `column` on.
inline void add_turned(const GroupLinear& g, Pack rr, Pack rt, Pack tr, Pack tt,
                       Eigen::MatrixXd& block, int row, int column) {
  const Pack c = g.cosine, s = g.sine;
  block(row, column) += sum(c * (rr * c - rt * s) - s * (tr * c - tt * s));
  block(row, column + 1) += sum(c * (rr * s + rt * c) - s * (tr * s + tt * c));
  block(row + 1, column) += sum(s * (rr * c - rt * s) + c * (tr * c - tt * s));
  block(row + 1, column + 1) += sum(s * (rr * s + rt * c) + c * (tr * s + tt * c));
}

/// What a pack of rollers has to do with the free tilt of the inner ring.
struct TiltLinear {
  RingCoupling coupling;
  Pack position[2][2], velocity[2][2];        ///< d(moment in r, t)/d(tilt), d(its rate)
  Pack power_position[2], power_velocity[2];  ///< as in GroupLinear
};

/// Coupling of one roller with the cage's degrees of freedom (rigid, then modes), then the axial
/// place of the inner ring where it is free: over the roller's local directions, or in packs over
/// these.
struct CageCoupling {
  int roller = -1;
  /// dF/d(cage), dF/d(its rate) on the roller, for each of the cage's directions.
  std::vector<Eight> position, velocity;
  /// d(force on the cage)/dP, dV: packs_for(coupled) packs for each local direction.
  std::vector<Pack> to_position, to_velocity;
};

/// One contact of a roller with the cage, or of the cage with a ring, as three channels: normal,
/// and two tangential directions; with an oil film a fourth, of the roller's axis along the first
/// tangential one. Channel g is the row dv/d(generalised velocity) of its sliding speed (for the
/// normal channel: of the separation speed -p').
struct ContactRows {
  static constexpr int kMostChannels = 4;
  double roller[kMostChannels][kEight] = {};  ///< zeros behind the directions
  std::vector<double> border[kMostChannels];  ///< over ring, cage and modes
  double lean[kLocalPositions] =
      {};  ///< dependence of the second tangential speed on the roller's positions
};

struct Linearisation {
  CAGETOL_KERNEL explicit Linearisation(const StateLayout& layout);
  /// Makes ready for another state; the cage's own terms (set_cage_block) stay until they are set.
  CAGETOL_KERNEL void clear();
  /// The coupling record of a roller, made on first use.
  CAGETOL_KERNEL CageCoupling& coupling(int roller);
  /// Adds what add_film_contact gathered to the border's matrices.
  CAGETOL_KERNEL void add_films();

  std::vector<GroupLinear> groups;
  std::vector<TiltLinear> tilts;  ///< one for each group where the inner ring's tilt is free
  Eigen::MatrixXd border_position, border_velocity;
  /// Something touches the cage: a roller, a ring, a guide film; or the inner ring moves axially.
  /// Where nothing does, the border's matrices hold but the blocks of the ring and the cage's own
  /// terms.
  bool cage_touched = false;
  /// Gradient over the border of the net power: drive + load - dissipation, the rate of the stored
  /// energy. Its time derivative makes the energy account's quadrature one order better than the
  /// powers alone would.
  Eigen::VectorXd power_position, power_velocity;
  std::vector<CageCoupling> couplings;  ///< the first `coupled` are in use, in order of first touch
  int coupled = 0;
  std::vector<int> slot;  ///< roller -> index into couplings, or -1
  /// What oiled contacts add over the cage's directions: each column in whole packs.
  std::vector<Pack> film_position, film_velocity;
  bool films = false;   ///< they hold something
  ContactRows scratch;  ///< for the contact being added; its border rows are zero outside the cage
                        ///< between contacts
};

/// What a contact's law says at a state: see NormalForce and Friction.
struct ContactSlopes {
  double force, stiffness, damping, ratio, bend, v1, v2;
  double elastic, elastic_stiffness, rate;  ///< elastic part of the force and its slope; p'
};

/// Gradient of the dissipated power D = Q ratio v^2 + (Q - K p^e) p' of a contact with respect to
/// p, p', v1, v2.
template <class T>
struct DissipationSlopes {
  T p, rate, v1, v2;
};
template <class T>
DissipationSlopes<T> dissipation_slopes(T force, T stiffness, T damping, T ratio, T bend, T v1,
                                        T v2, T elastic, T elastic_stiffness, T rate) {
  const T speed2 = v1 * v1 + v2 * v2, along = ratio * speed2 + rate;
  const T slide = force * (2.0 * ratio + bend * speed2);
  return {along * stiffness - elastic_stiffness * rate, along * damping + force - elastic,
          slide * v1, slide * v2};
}

/// Adds one contact. `roller` < 0: border only.
CAGETOL_KERNEL void add_contact(const ContactRows& rows, const ContactSlopes& slopes, int roller,
                                Linearisation& linear);

/// What an oiled contact's law says at a state: change of its forces along the channels normal, v1,
/// v2 and axis, and of the net power (what it takes, negative), with p, p', v1, v2 and the speed of
/// the axis.
struct FilmContactSlopes {
  enum Variable { kP, kRate, kV1, kV2, kAxis, kVariables };
  double force[kVariables][ContactRows::kMostChannels] = {};
  double power[kVariables] = {};
};

/// Adds one oiled contact of `roller` with the cage.
CAGETOL_KERNEL void add_film_contact(const ContactRows& rows, const FilmContactSlopes& slopes,
                                     int roller, Linearisation& linear);

}  // namespace cagetol
