#include "src/dynamics/static_equilibrium.hpp"

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
// Of a roller's place [m]: 1e-14 m would be a millionth of a newton of a loaded contact, more than
// the balance of the ring is solved to, and its iteration would see noise. Never below what the
// place itself can be told to.
double settled_within(double radius) {
  return std::max(1e-16, 2e-15 * radius);
}

}  // namespace

StaticEquilibrium::StaticEquilibrium(const BearingModel& model)
    : model_(model), damped_(model.race) {
  model_.friction.static_coefficient = model_.friction.dynamic_coefficient = 0;
  const auto n = static_cast<std::size_t>(model.layout.padded());
  state_.radius.assign(n, model.outer_radius - model.nominal_diameter / 2);
  state_.tilt.assign(n, 0.0);
  state_.inner_force.assign(n, 0.0);
}

StaticEquilibrium::RingForce StaticEquilibrium::settle_rollers(const double* angle,
                                                               double orbit_rate,
                                                               RollerMotion motion) {
  RingForce ring{};
  Observation unused(model_);
  for (int group = 0; group < model_.layout.groups; ++group) {
    const RollerGroup& roller = model_.groups[static_cast<std::size_t>(group)];
    const int j = group * kLanes;
    RollerPack q{};
    sine_cosine(load(angle + j), q.sine, q.cosine);
    q.r = load(state_.radius.data() + j);
    q.a_r = load(state_.tilt.data() + j);
    const auto r = [&](double y, double z) { return along_r(q, splat(y), splat(z)); };
    const auto t = [&](double y, double z) { return along_t(q, splat(y), splat(z)); };
    const RaceSide inner{1,
                         model_.inner_radius,
                         2 * model_.pitch_radius * orbit_rate / model_.inner_radius,
                         r(state_.ring_y, state_.ring_z),
                         t(state_.ring_y, state_.ring_z),
                         {},
                         {},
                         r(model_.misalignment_y, model_.misalignment_z),
                         t(model_.misalignment_y, model_.misalignment_z),
                         model_.inner_film};
    const RaceSide outer{-1, model_.outer_radius, 0, {}, {}, {}, {}, {}, {}, model_.outer_film};
    // Rolling, without slip, drags the film in. At rest first, where no speed damps; then orbiting:
    // a roller follows the races, r' = orbit_rate dr/dtheta, and the law's damping has its say.
    q.vt = splat(model_.pitch_radius * orbit_rate);
    q.spin = -q.vt / roller.radius;
    model_.race.damping = model_.race.chi = 0;
    const int passes = motion == RollerMotion::at_rest ? 1 : 2;
    for (int pass = 0, iteration = 0; iteration < kMostIterations; ++iteration) {
      GroupLinear g{};
      RollerLoads loads;
      Pack total{}, a{}, er{}, et{}, drive{};
      race_contacts<true>(model_, roller, q, inner, loads, &g, &unused, total, a, er, et, drive);
      const RollerLoads on_inner = loads;
      const GroupLinear from_inner = g;
      const Pack elastic_r = er, elastic_t = et;
      store(state_.inner_force.data() + j, total);
      race_contacts<true>(model_, roller, q, outer, loads, &g, &unused, total, a, er, et, drive);
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
      const bool settled = largest(size) < settled_within(model_.pitch_radius);
      if (settled && pass + 1 < passes) {
        ++pass;
        model_.race = damped_;
        q.vt = q.r * orbit_rate;
        q.spin = -q.vt / roller.radius;
        q.vr = q.vt * g.position[kLr][kLt] / k_rr;
        continue;
      }
      if (settled || iteration + 1 == kMostIterations) {
        ring.settled = ring.settled && largest(size) < kNoPlace;
        // Condense: a ring move u changes the inner force directly, and through the roller that
        // follows it.
        const Pack co = q.cosine * roller.exists, si = q.sine * roller.exists;
        ring.y -= sum(co * on_inner.f[kLr] - si * on_inner.f[kLt]);
        ring.z -= sum(si * on_inner.f[kLr] + co * on_inner.f[kLt]);
        ring.elastic_z -= sum(si * elastic_r + co * elastic_t);
        Pack K[2][2];
        for (int c = 0; c < 2; ++c) {
          const int to_r = kLr, to_a = kLar, col = c == 0 ? kLr : kLt;
          const Pack b_r = -from_inner.position[to_r][col],
                     b_a = -from_inner.position[to_a][col];  // dF, dT per du
          const Pack dr_du = (k_aa * b_r - k_ra * b_a) * inverse,
                     da_du = (k_rr * b_a - k_ar * b_r) * inverse;
          for (int i = 0; i < 2; ++i) {
            const int row = i == 0 ? kLr : kLt;
            K[i][c] = from_inner.position[row][col] - from_inner.position[row][kLr] * dr_du -
                      from_inner.position[row][kLar] * da_du;
          }
        }
        ring.yy += sum(co * (K[0][0] * q.cosine - K[0][1] * q.sine) -
                       si * (K[1][0] * q.cosine - K[1][1] * q.sine));
        ring.yz += sum(co * (K[0][0] * q.sine + K[0][1] * q.cosine) -
                       si * (K[1][0] * q.sine + K[1][1] * q.cosine));
        ring.zy += sum(si * (K[0][0] * q.cosine - K[0][1] * q.sine) +
                       co * (K[1][0] * q.cosine - K[1][1] * q.sine));
        ring.zz += sum(si * (K[0][0] * q.sine + K[0][1] * q.cosine) +
                       co * (K[1][0] * q.sine + K[1][1] * q.cosine));
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

const StaticState& StaticEquilibrium::solve(const double* angle, double orbit_rate, double load,
                                            RollerMotion motion) {
  const double weight = load + model_.ring_mass * model_.gravity;
  state_.converged = false;
  int unsettled = 0;
  const auto settle = [&] {
    const RingForce force = settle_rollers(angle, orbit_rate, motion);
    if (!force.settled) ++unsettled;
    return force;
  };
  RingForce f = settle();
  const auto imbalance = [&] { return std::hypot(f.y, f.z - weight); };
  const double tolerance = std::max(1e-10 * weight, 1e-8);  // [N]
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
    const double yy = soft - f.yy, zz = soft - f.zz, yz = -f.yz, zy = -f.zy, b_z = f.z - weight;
    const double det = yy * zz - yz * zy;
    double dy = (zz * f.y - yz * b_z) / det, dz = (yy * b_z - zy * f.y) / det;
    const double length = std::hypot(dy, dz);
    if (length > kLongestMove) {
      dy *= kLongestMove / length;
      dz *= kLongestMove / length;
    }
    for (int halving = 0; halving < 30 && unsettled < kMostUnsettled; ++halving) {
      state_.ring_y += dy;
      state_.ring_z += dz;
      f = settle();
      // Energy is convex, so a step that still leads downhill at its end is sound even where the
      // imbalance did not fall: crossing a clearance it stays the load itself until the rollers
      // touch, and may be more just behind.
      const bool downhill = f.y * dy + (f.z - weight) * dz > 0;
      if (imbalance() < now || downhill || std::hypot(dy, dz) < 1e-16) break;
      state_.ring_y -= dy;
      state_.ring_z -= dz;
      dy /= 2;
      dz /= 2;
    }
    if (std::hypot(dy, dz) < 1e-16) {
      state_.converged = imbalance() < 1e-6 * std::max(weight, 1.0);
      break;
    }
  }
  state_.ring_elastic_z = f.elastic_z;
  return state_;
}

}  // namespace cagetol
