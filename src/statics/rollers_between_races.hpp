// A pack of rollers between the races, at rest or orbiting, and their balance there: what static
// equilibrium iterates on.
#pragma once

#include <Eigen/Dense>

#include "src/statics/race_normals.hpp"

namespace cagetol {
namespace {  // static_equilibrium.cpp alone uses these, and inlines what pays

// Where nothing touches, a soft spring keeps Newton's matrix regular; it is in the matrix only, not
// in the balance of forces.
constexpr double kSoftSpring = 1e4;     // [N/m]
constexpr double kLongestMove = 20e-6;  // of ring or roller in one iteration [m]

/// Of a pack of rollers between the races.
struct RollerBalance {
  RaceNormals inner, outer;
  Pack k_rr, k_ra, k_aa, inverse;  ///< minus the slopes of force and moment by place and tilt
  Pack dr, da;                     ///< move of place and tilt that balances both
  double size;                     ///< of the longest move, at a roller's end [m]

  struct Move {
    Pack r, a;
  };
  /// How place and tilt follow the ring: its displacement (of = 0) or tilt (1), along r or t.
  Move follow(int of, int along) const {
    const Pack b_r = -inner.slope[of][0][along], b_a = -inner.slope[of + 1][0][along];
    return {(k_aa * b_r - k_ra * b_a) * inverse, (k_rr * b_a - k_ra * b_r) * inverse};
  }

  /// Newton's move of place and tilt while the ring moves by `d` (y, z, tilts about them).
  void advance(const RollerPack& q, const Eigen::Vector4d& d, double* radius, double* tilt) const {
    Pack r = load(radius) + dr, a = load(tilt) + da;
    for (int of = 0; of < 2; ++of) {
      const Pack y = splat(d[2 * of]), z = splat(d[2 * of + 1]);
      const Pack ring[2] = {along_r(q, y, z), along_t(q, y, z)};
      for (int along = 0; along < 2; ++along) {
        const Move with = follow(of, along);
        r += with.r * ring[along];
        a += with.a * ring[along];
      }
    }
    store(radius, r);
    store(tilt, a);
  }
};

/// A pack of rollers, and the races as it sees them.
struct RollersBetweenRaces {
  const BearingModel& model;
  const RollerGroup& roller;
  int first;  ///< roller of the pack
  double orbit_rate;
  bool spinning = false;  ///< as given, not as they roll
  RollerPack q{};
  RaceSide inner, outer;

  /// `spin` of all rollers between rings of these `speeds`, or nullptr: they roll on the outer
  /// ring, and the inner one turns with them.
  RollersBetweenRaces(const BearingModel& bearing, int group, const double* angle, double rate,
                      const StaticState& ring, const double* spin, const RingSpeeds& speeds,
                      const RingAngles& turned)
      : model(bearing),
        roller(bearing.groups[static_cast<std::size_t>(group)]),
        first(group * kLanes),
        orbit_rate(rate),
        inner{1,
              bearing.inner_radius,
              spin ? speeds.inner
                   : (2 * bearing.pitch_radius * rate - bearing.outer_radius * speeds.outer) /
                         bearing.inner_radius,
              {},
              {},
              {},
              {},
              {},
              {}},
        outer{-1, bearing.outer_radius, speeds.outer, {}, {}, {}, {}, {}, {}} {
    sine_cosine(load(angle + first), q.sine, q.cosine);
    inner.u_r = along_r(q, splat(ring.ring_y), splat(ring.ring_z));
    inner.u_t = along_t(q, splat(ring.ring_y), splat(ring.ring_z));
    inner.B_r = along_r(q, splat(ring.tilt_y), splat(ring.tilt_z));
    inner.B_t = along_t(q, splat(ring.tilt_y), splat(ring.tilt_z));
    if (!model.forms.round) {
      inner.form = &model.forms.inner;
      outer.form = &model.forms.outer;
      inner.turned = turned.inner;
      outer.turned = turned.outer;
    }
    spinning = spin != nullptr;
    if (spinning) q.spin = load(spin + first);
    travel(splat(model.pitch_radius * rate));
  }

  /// To places and tilts of all rollers, of which it takes its own.
  RollersBetweenRaces& put(const std::vector<double>& radius, const std::vector<double>& tilt) {
    q.r = load(radius.data() + first);
    q.a_r = load(tilt.data() + first);
    return *this;
  }

  /// They orbit from their places at rest: follow the races, r' = orbit_rate dr/dtheta + dr/dt.
  RollersBetweenRaces& orbit(const RollerBalance& rest) {
    travel(q.r * orbit_rate);
    q.vr = q.vt * (rest.inner.slope[0][0][1] + rest.outer.slope[0][0][1]) / rest.k_rr;
    if (inner.form) q.vr += (rest.inner.by_time[0] + rest.outer.by_time[0]) / rest.k_rr;
    return *this;
  }

  /// `dry` with its damping; of a film and the metal under it, `share` of the speed of approach.
  RollerBalance balance(const NormalLaw& dry, double share) const {
    RollerBalance b;
    if (model.lubricated) {
      b.inner = lubricated_normals(model, model.inner_line, roller, q, inner, share);
      b.outer = lubricated_normals(model, model.outer_line, roller, q, outer, share);
    } else {
      b.inner = race_normals(model, dry, roller, q, inner);
      b.outer = race_normals(model, dry, roller, q, outer);
    }
    const double half = model.roller_half_length;
    const Pack F = b.inner.force[0][0] + b.outer.force[0][0] +
                   roller.mass * (q.r * (orbit_rate * orbit_rate) - model.gravity * q.sine);
    const Pack T = b.inner.force[1][0] + b.outer.force[1][0];
    b.k_rr = kSoftSpring - b.inner.slope[0][0][0] - b.outer.slope[0][0][0];
    b.k_ra = -b.inner.slope[1][0][0] - b.outer.slope[1][0][0];
    b.k_aa = kSoftSpring * half * half - b.inner.slope[2][0][0] - b.outer.slope[2][0][0];
    b.inverse = 1.0 / (b.k_rr * b.k_aa - b.k_ra * b.k_ra);
    const auto within = [](Pack move, double most) {
      return min(max(move, splat(-most)), splat(most));
    };
    b.dr = within((b.k_aa * F - b.k_ra * T) * b.inverse, kLongestMove);
    b.da = within((b.k_rr * T - b.k_ra * F) * b.inverse, kLongestMove / half);
    b.size = largest(roller.exists * (abs(b.dr) + half * abs(b.da)));
    return b;
  }

 private:
  /// Rolling, without slip, drags the film in.
  void travel(Pack speed) {
    q.vt = speed;
    if (!spinning) q.spin = (outer.radius * outer.speed - q.vt) / roller.radius;
  }
};

}  // namespace
}  // namespace cagetol
