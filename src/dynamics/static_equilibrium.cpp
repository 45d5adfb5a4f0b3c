#include "src/dynamics/static_equilibrium.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "src/dynamics/race_contacts.hpp"

namespace cagetol {
namespace {

// Where nothing touches, a soft spring keeps Newton's matrix regular; it is in the matrix only, not
// in the balance of forces.
constexpr double kSoftSpring = 1e4;     // [N/m]
constexpr double kLongestMove = 20e-6;  // [m]
constexpr int kMostIterations = 60;
constexpr int kMostUnsettled = 200;  // tries at which rollers found no place: then there is none
constexpr double kNoPlace =
    1e-11;  // a roller that still moves farther at the last try has none [m]
// Of a roller's place [m], for a balance of the ring to a share `accuracy` of the load: were it
// more, the ring's iteration would see noise (1e-14 m are a millionth of a newton of a loaded
// contact). Never below what the place itself can be told to.
double settled_within(double radius, double accuracy) {
  return std::max({1e-16, 2e-15 * radius, 1e-6 * accuracy});
}

}  // namespace

StaticEquilibrium::StaticEquilibrium(const BearingModel& model, double accuracy)
    : model_(model), damped_(model.race), accuracy_(accuracy), unused_(model) {
  model_.friction.static_coefficient = model_.friction.dynamic_coefficient = 0;
  const auto n = static_cast<std::size_t>(model.layout.padded());
  state_.radius.assign(n, model.outer_radius - model.nominal_diameter / 2);
  state_.tilt.assign(n, 0.0);
  resting_radius_ = state_.radius;
  resting_tilt_ = state_.tilt;
  state_.inner_force.assign(n, 0.0);
  state_.tilt_y = model.misalignment_y;
  state_.tilt_z = model.misalignment_z;
}

template <bool tilting>
StaticEquilibrium::RingForce StaticEquilibrium::settle_rollers(const double* angle,
                                                               double orbit_rate,
                                                               RollerMotion motion, bool near) {
  RingForce ring{};
  for (int group = 0; group < model_.layout.groups; ++group) {
    const RollerGroup& roller = model_.groups[static_cast<std::size_t>(group)];
    const int j = group * kLanes;
    RollerPack q{};
    sine_cosine(load(angle + j), q.sine, q.cosine);
    const auto start = [&](const std::vector<double>& radius, const std::vector<double>& tilt) {
      q.r = load(radius.data() + j);
      q.a_r = load(tilt.data() + j);
    };
    near ? start(resting_radius_, resting_tilt_) : start(state_.radius, state_.tilt);
    const auto r = [&](double y, double z) { return along_r(q, splat(y), splat(z)); };
    const auto t = [&](double y, double z) { return along_t(q, splat(y), splat(z)); };
    const RaceSide inner{1,
                         model_.inner_radius,
                         2 * model_.pitch_radius * orbit_rate / model_.inner_radius,
                         model_.inner_film,
                         r(state_.ring_y, state_.ring_z),
                         t(state_.ring_y, state_.ring_z),
                         {},
                         {},
                         r(state_.tilt_y, state_.tilt_z),
                         t(state_.tilt_y, state_.tilt_z)};
    const RaceSide outer{-1, model_.outer_radius, 0, model_.outer_film, {}, {}, {}, {}, {}, {}};
    // Rolling, without slip, drags the film in. At rest first, where no speed damps; then orbiting:
    // a roller follows the races, r' = orbit_rate dr/dtheta, and the law's damping has its say.
    // Each from where it was, nearby.
    q.vt = splat(model_.pitch_radius * orbit_rate);
    q.spin = -q.vt / roller.radius;
    model_.race.damping = model_.race.chi = 0;
    const int passes = motion == RollerMotion::at_rest ? 1 : 2;
    for (int pass = 0, iteration = 0; iteration < kMostIterations; ++iteration) {
      GroupLinear g{};
      RollerLoads loads;
      Pack total{}, a{}, er{}, et{}, drive{};
      TiltLinear by_tilt;
      if constexpr (tilting) by_tilt = {};
      RingTilt tilt{.rate_r = {}, .rate_t = {}, .linear = &by_tilt};
      race_contacts<true, tilting>(model_, roller, q, inner, loads, &g, &unused_, total, a, er, et,
                                   drive, &tilt);
      const RollerLoads on_inner = loads;
      Pack P[kLocalVelocities][kLocalPositions];  // of the inner race alone
      std::copy(&g.position[0][0], &g.position[0][0] + sizeof P / sizeof(Pack), &P[0][0]);
      const Pack elastic_r = er, elastic_t = et;
      store(state_.inner_force.data() + j, total);
      race_contacts<true>(model_, roller, q, outer, loads, &g, &unused_, total, a, er, et, drive);
      const Pack F =
          loads.f[kLr] + roller.mass * (q.r * (orbit_rate * orbit_rate) - model_.gravity * q.sine);
      const Pack T = loads.f[kLar];
      const double half = model_.roller_half_length;
      const Pack k_rr = kSoftSpring - g.position[kLr][kLr], k_ra = -g.position[kLr][kLar];
      const Pack k_ar = -g.position[kLar][kLr],
                 k_aa = kSoftSpring * half * half - g.position[kLar][kLar];
      const Pack inverse = 1.0 / (k_rr * k_aa - k_ra * k_ar);
      const Pack dr =
          min(max((k_aa * F - k_ra * T) * inverse, splat(-kLongestMove)), splat(kLongestMove));
      const Pack da = min(max((k_rr * T - k_ar * F) * inverse, splat(-kLongestMove / half)),
                          splat(kLongestMove / half));
      const Pack size = roller.exists * (max(dr, -dr) + half * max(da, -da));
      const bool settled = largest(size) < settled_within(model_.pitch_radius, accuracy_);
      if (settled && pass + 1 < passes) {
        ++pass;
        model_.race = damped_;
        q.vt = q.r * orbit_rate;
        q.spin = -q.vt / roller.radius;
        q.vr = q.vt * g.position[kLr][kLt] / k_rr;
        store(resting_radius_.data() + j, q.r);
        store(resting_tilt_.data() + j, q.a_r);
        if (near) start(state_.radius, state_.tilt);
        continue;
      }
      if (settled || iteration + 1 == kMostIterations) {
        ring.settled = ring.settled && largest(size) < kNoPlace;
        // Condense: a move of the ring changes the inner force directly, and through the roller
        // that follows it. Rows: forces on the ring in r, t, then moments; columns likewise.
        constexpr int n = tilting ? 4 : 2;
        const RingCoupling& with_tilt = by_tilt.coupling;
        Pack K[n][n];
        for (int c = 0; c < n; ++c) {
          const int of_tilt = c - 2, col = of_tilt < 0 ? kLr + c : kLr + of_tilt;
          Pack b_r = -P[kLr][col], b_a = -P[kLar][col];  // dF, dT per move of the ring
          if constexpr (tilting)
            if (of_tilt >= 0)
              b_r = with_tilt.position[kLr][of_tilt], b_a = with_tilt.position[kLar][of_tilt];
          const Pack dr_du = (k_aa * b_r - k_ra * b_a) * inverse,
                     da_du = (k_rr * b_a - k_ar * b_r) * inverse;
          for (int i = 0; i < 2; ++i) {
            Pack direct = P[kLr + i][col];
            if constexpr (tilting)
              if (of_tilt >= 0) direct = -with_tilt.position[kLr + i][of_tilt];
            K[i][c] = direct - P[kLr + i][kLr] * dr_du - P[kLr + i][kLar] * da_du;
            if constexpr (tilting) {
              const Pack(&moment)[kLocalPositions] = with_tilt.to_position[i];
              K[2 + i][c] = (of_tilt < 0 ? -moment[col] : by_tilt.position[i][of_tilt]) +
                            moment[kLr] * dr_du + moment[kLar] * da_du;
            }
          }
        }
        const Pack co = q.cosine * roller.exists, si = q.sine * roller.exists;
        const auto add = [&](int row, int column) {
          const Pack rr = K[row][column], rt = K[row][column + 1], tr = K[row + 1][column],
                     tt = K[row + 1][column + 1];
          auto to = ring.slope.block<2, 2>(row, column);
          to(0, 0) += sum(co * (rr * q.cosine - rt * q.sine) - si * (tr * q.cosine - tt * q.sine));
          to(0, 1) += sum(co * (rr * q.sine + rt * q.cosine) - si * (tr * q.sine + tt * q.cosine));
          to(1, 0) += sum(si * (rr * q.cosine - rt * q.sine) + co * (tr * q.cosine - tt * q.sine));
          to(1, 1) += sum(si * (rr * q.sine + rt * q.cosine) + co * (tr * q.sine + tt * q.cosine));
        };
        for (int row = 0; row < n; row += 2)
          for (int column = 0; column < n; column += 2) add(row, column);
        ring.force[0] -= sum(co * on_inner.f[kLr] - si * on_inner.f[kLt]);
        ring.force[1] -= sum(si * on_inner.f[kLr] + co * on_inner.f[kLt]);
        ring.elastic_z -= sum(si * elastic_r + co * elastic_t);
        if constexpr (tilting) {
          ring.force[2] += sum(co * tilt.moment[0] - si * tilt.moment[1]);
          ring.force[3] += sum(si * tilt.moment[0] + co * tilt.moment[1]);
        }
        break;
      }
      q.r += dr;
      q.a_r += da;
    }
    store(state_.radius.data() + j, q.r);
    store(state_.tilt.data() + j, q.a_r);
  }
  return ring;
}

const StaticState& StaticEquilibrium::solve(const double* angle, double orbit_rate,
                                            const RingLoad& load, RollerMotion motion) {
  if (motion == RollerMotion::orbiting && state_.converged) {
    const StaticState before = state_;
    if (balance(angle, orbit_rate, load, motion, true).converged) return state_;
    state_ = before;
  }
  return balance(angle, orbit_rate, load, motion, false);
}

const StaticState& StaticEquilibrium::balance(const double* angle, double orbit_rate,
                                              const RingLoad& load, RollerMotion motion,
                                              bool near) {
  const bool tilting = model_.layout.ring_tilt > 0;
  const double weight = load.radial + model_.ring_mass * model_.gravity;
  const double lever = model_.roller_half_length;  // makes forces of moments, and moves of tilts
  state_.converged = false;
  int unsettled = 0;
  // What is left over of the forces and moments on the ring, and their derivatives.
  const auto settle = [&] {
    RingForce ring = tilting ? settle_rollers<true>(angle, orbit_rate, motion, near)
                             : settle_rollers<false>(angle, orbit_rate, motion, near);
    if (!ring.settled) ++unsettled;
    ring.force[1] -= weight;
    if (tilting) {
      ring.force[2] +=
          load.moment_y - model_.tilt_stiffness * (state_.tilt_y - model_.misalignment_y);
      ring.force[3] +=
          load.moment_z - model_.tilt_stiffness * (state_.tilt_z - model_.misalignment_z);
      ring.slope.diagonal().tail<2>().array() -= model_.tilt_stiffness;
    }
    return ring;
  };
  const auto move = [&](const Eigen::Vector4d& d) {
    state_.ring_y += d[0];
    state_.ring_z += d[1];
    state_.tilt_y += d[2];
    state_.tilt_z += d[3];
  };
  const auto length = [&](const Eigen::Vector4d& d) {
    return std::hypot(std::hypot(d[0], d[1]), lever * std::hypot(d[2], d[3]));
  };
  RingForce f = settle();
  const auto imbalance = [&] {
    return std::hypot(std::hypot(f.force[0], f.force[1]),
                      std::hypot(f.force[2], f.force[3]) / lever);
  };
  const double size =
      tilting ? std::max(weight, std::hypot(load.moment_y, load.moment_z) / lever) : weight;
  const double tolerance = std::max(accuracy_ * size, 1e-8);  // [N]
  // A light ring on one roller turns over it with a stiffness of weight over radius only: the
  // spring must not outweigh that many times, or the ring creeps to the next roller.
  const double soft =
      std::min(kSoftSpring, std::max(4 * std::abs(weight), 1e-3) / model_.inner_radius);
  for (state_.iterations = 0; state_.iterations < kMostIterations && unsettled < kMostUnsettled;
       ++state_.iterations) {
    const double now = imbalance();
    if (now < tolerance) {
      state_.converged = true;
      break;
    }
    Eigen::Matrix4d K = -f.slope;
    K.diagonal() += Eigen::Vector4d(soft, soft, soft * lever * lever, soft * lever * lever);
    Eigen::Vector4d d = K.partialPivLu().solve(f.force);
    if (const double far = length(d); far > kLongestMove) d *= kLongestMove / far;
    for (int halving = 0; halving < 30 && unsettled < kMostUnsettled; ++halving) {
      move(d);
      f = settle();
      // Energy is convex, so a step that still leads downhill at its end is sound even where the
      // imbalance did not fall: crossing a clearance it stays the load itself until the rollers
      // touch, and may be more just behind.
      const bool downhill = f.force.dot(d) > 0;
      if (imbalance() < now || downhill || length(d) < 1e-16) break;
      move(-d);
      d /= 2;
    }
    if (length(d) < 1e-16) {
      state_.converged = imbalance() < 1e-6 * std::max(size, 1.0);
      break;
    }
  }
  state_.ring_elastic_z = f.elastic_z;
  return state_;
}

}  // namespace cagetol
