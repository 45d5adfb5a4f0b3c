// What decides whether contacts of a pack of rollers with pockets and flanges are evaluated at all:
// a bound that is too small would lose touches without a word.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "src/contacts/flange_contacts.hpp"
#include "src/contacts/pocket_contacts.hpp"
#include "src/contacts/wall_contacts.hpp"
#include "tests/support/random_bearing.hpp"

namespace cagetol {
namespace {

/// One roller in every lane, and the cage; velocities are the rates of the places.
struct Motion {
  double r, theta, x, axis[2], vr, omega, vx, axis_rate[2], spin;
  double cage[3], cage_rate[3], phi, phi_rate, cage_axis[2], cage_axis_rate[2];

  RollerPack roller() const {
    RollerPack q;
    q.r = splat(r), q.x = splat(x);
    q.cosine = splat(std::cos(theta)), q.sine = splat(std::sin(theta));
    q.a_r = along_r(q, splat(axis[0]), splat(axis[1]));
    q.a_t = along_t(q, splat(axis[0]), splat(axis[1]));
    q.vr = splat(vr), q.omega = splat(omega), q.vt = q.r * q.omega, q.vx = splat(vx);
    q.b_r = along_r(q, splat(axis_rate[0]), splat(axis_rate[1]));
    q.b_t = along_t(q, splat(axis_rate[0]), splat(axis_rate[1]));
    q.spin = splat(spin);
    return q;
  }
  BorderState border() const {
    BorderState b{};
    std::copy(cage, cage + 3, b.cage);
    std::copy(cage_rate, cage_rate + 3, b.cage_rate);
    std::copy(cage_axis, cage_axis + 2, b.axis);
    std::copy(cage_axis_rate, cage_axis_rate + 2, b.axis_rate);
    b.phi = phi, b.phi_rate = phi_rate, b.phi_cos = std::cos(phi), b.phi_sin = std::sin(phi);
    return b;
  }
};

/// A bearing at a random motion of its first roller and cage.
struct Looked {
  explicit Looked(unsigned seed)
      : bearing(random_bearing(seed)), group(bearing.model.groups.front()) {
    std::mt19937_64 random(seed);
    const auto any = [&](double size) {
      return std::uniform_real_distribution<>(-size, size)(random);
    };
    motion.r = bearing.model.pitch_radius + any(1e-4);
    motion.phi = any(3);
    // The first pocket's angle: the model holds its direction in the cage.
    motion.theta = motion.phi + std::atan2(group.pocket_sin[0], group.pocket_cos[0]) + any(3e-3);
    motion.x = any(2e-4), motion.vr = any(0.1), motion.omega = 250 + any(5);
    motion.vx = any(0.1), motion.spin = any(2000), motion.phi_rate = 250 + any(5);
    for (int k = 0; k < 3; ++k) motion.cage[k] = any(2e-4), motion.cage_rate[k] = any(0.1);
    for (int k = 0; k < 2; ++k) {
      motion.axis[k] = any(0.02), motion.axis_rate[k] = any(20);
      motion.cage_axis[k] = any(0.02), motion.cage_axis_rate[k] = any(20);
    }
  }
  PocketFrame frame(const Motion& m) const {
    PocketFrame f = pocket_places(group, m.roller(), m.border());
    add_rates(m.roller(), m.border(), f);
    return f;
  }
  /// Penetrations of the first lane's stations into their bars, as the law has them.
  std::vector<double> into_bars(const Motion& m) const {
    const PocketFrame f = frame(m);
    const double kappa = f.A_T[0] + group.squareness[0];
    std::vector<double> p;
    for (const double xi : bearing.model.bar_stations)
      for (const double s : {-1.0, 1.0})
        p.push_back(s * (f.D_T[0] + xi * f.a_T[0] - kappa * (f.X[0] + xi)) + group.radius[0] -
                    group.half_width[0]);
    return p;
  }
  std::vector<double> into_walls(const Motion& m) const {
    const PocketFrame f = frame(m);
    std::vector<double> p;
    for (const double e : {-1.0, 1.0})
      for (const EndPoint& point : bearing.model.wall_points) {
        const double xi = e * bearing.model.roller_half_length, h = point.radial,
                     tau = point.tangential;
        const double X = f.X[0] + xi - h * f.a_R[0] - tau * f.a_T[0];
        const double D_R = f.D_R[0] + xi * f.a_R[0] + h, D_T = f.D_T[0] + xi * f.a_T[0] + tau;
        p.push_back(e * (X + f.A_R[0] * D_R + f.A_T[0] * D_T) - group.half_length[0]);
      }
    return p;
  }
  std::vector<double> into_flanges(const Motion& m) const {
    const RollerPack q = m.roller();
    std::vector<double> p;
    for (const Flange& flange : bearing.model.flanges)
      for (const EndPoint& point : flange.points)
        p.push_back(flange.side * (q.x[0] - point.radial * q.a_r[0] - point.tangential * q.a_t[0]) -
                    flange.clearance);
    return p;
  }
  RandomBearing bearing;
  RollerGroup group;
  Motion motion{};
};

double deepest(const std::vector<double>& p) {
  return *std::max_element(p.begin(), p.end());
}

constexpr unsigned kStates = 60;

TEST(Reach, OfBarsIsThatOfTheirStations) {
  for (unsigned seed = 0; seed < kStates; ++seed) {
    Looked at(seed);
    const double p = deepest(at.into_bars(at.motion));
    const PocketFrame f = at.frame(at.motion);
    at.group.exists = Pack{1};  // the lane that is looked at, no other
    EXPECT_TRUE(bars_in_reach(at.bearing.model, at.group, f, splat(-p + 1e-12))) << seed;
    EXPECT_FALSE(bars_in_reach(at.bearing.model, at.group, f, splat(-p - 1e-12))) << seed;
  }
}

TEST(Reach, OfWallsBoundsThatOfTheirPoints) {
  for (unsigned seed = 0; seed < kStates; ++seed) {
    const Looked at(seed);
    const double p = deepest(at.into_walls(at.motion));
    const PocketFrame f = at.frame(at.motion);
    EXPECT_TRUE(walls_in_reach(at.bearing.model, at.group, f, splat(-p))) << seed;
  }
}

TEST(Reach, OfFlangesBoundsThatOfTheirPoints) {
  for (unsigned seed = 0; seed < kStates; ++seed) {
    const Looked at(seed);
    const double p = deepest(at.into_flanges(at.motion));
    const RollerPack q = at.motion.roller();
    bool near = false;
    for (const Flange& flange : at.bearing.model.flanges)
      near = near || flange_in_reach(flange, at.group, q, at.motion.border(), splat(-p));
    EXPECT_TRUE(near) << seed;
  }
}

}  // namespace
}  // namespace cagetol
