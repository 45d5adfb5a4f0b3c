// STEP, IMPACT, the Hertzian law with Hunt-Crossley damping, and friction, at points computed by
// hand.
#include <gtest/gtest.h>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "src/contact_laws/friction.hpp"
#include "src/contact_laws/normal_force.hpp"

namespace cagetol {
namespace {

TEST(Step, HandComputedPoints) {
  EXPECT_EQ(step(-1, 0, 2, 4, 10), 2);
  EXPECT_EQ(step(0, 0, 2, 4, 10), 2);
  EXPECT_EQ(step(1, 0, 2, 4, 10), 2 + 8 * 0.15625);  // z = 1/4: 1/16 * 2.5
  EXPECT_EQ(step(2, 0, 2, 4, 10), 6);
  EXPECT_EQ(step(4, 0, 2, 4, 10), 10);
  EXPECT_EQ(step(9, 0, 2, 4, 10), 10);
  EXPECT_EQ(step(2, 0, 10, 4, 2), 6);
}

TEST(Step, SlopeIsTheDerivativeAndVanishesAtBothEnds) {
  for (double z : {0.1, 0.3, 0.5, 0.9})
    EXPECT_NEAR(smooth_step_slope(z), (smooth_step(z + 1e-6) - smooth_step(z - 1e-6)) / 2e-6, 1e-9);
  EXPECT_EQ(smooth_step_slope(0.0), 0);
  EXPECT_EQ(smooth_step_slope(1.0), 0);
  EXPECT_EQ(smooth_step_slope(-0.5), 0);
  EXPECT_EQ(smooth_step_slope(1.5), 0);
}

ContactParameters impact() {
  return {};
}
ContactParameters hertz() {
  ContactParameters p;
  p.law = ForceLaw::hertz;
  return p;
}

TEST(NormalForce, ImpactAtHandComputedPoints) {
  const NormalLaw law = make_normal_law(impact(), 9e-3, 1);
  // 0.1 mm deep: K p^e = 1.5e5 * 0.1^(10/9) = 11,613.955 N, damper full: 750 N s/mm * 20 mm/s =
  // 15,000 N.
  EXPECT_NEAR(normal_force(law, 1e-4, 0.0).force, 11613.955, 1e-3);
  EXPECT_NEAR(normal_force(law, 1e-4, 0.02).force, 11613.955 + 15000, 1e-3);
  // Half way: S(1/2) = 1/2.
  EXPECT_NEAR(normal_force(law, 0.5e-4, 0.02).force, 1.5e5 * std::pow(0.05, 10.0 / 9.0) + 7500,
              1e-6);
  // Deeper than d the damping stays full.
  EXPECT_NEAR(normal_force(law, 2e-4, 0.01).force, 1.5e5 * std::pow(0.2, 10.0 / 9.0) + 7500, 1e-6);
  // physics.md: c = 3.0 N s/mm at 3.7 um, 375 at 50 um.
  EXPECT_NEAR(normal_force(law, 3.7e-6, 0.0).damping, 3.0e3, 20);
  EXPECT_NEAR(normal_force(law, 50e-6, 0.0).damping, 375e3, 1e-6);
}

TEST(NormalForce, NeverPulls) {
  for (const auto& parameters : {impact(), hertz()}) {
    const NormalLaw law = make_normal_law(parameters, 9e-3, 1);
    const auto q = normal_force(law, 30e-6, -1e3);
    EXPECT_EQ(q.force, 0);
    EXPECT_EQ(q.stiffness, 0);
    EXPECT_EQ(q.damping, 0);
    EXPECT_GT(q.elastic, 0);
    for (double p : {0.0, -1e-9, -1e-3}) {
      const auto open = normal_force(law, p, 1.0);
      EXPECT_EQ(open.force, 0);
      EXPECT_EQ(open.elastic, 0);
      EXPECT_EQ(open.stiffness, 0);
      EXPECT_EQ(open.damping, 0);
    }
  }
}

TEST(NormalForce, ClampBeginsWhereDamperAndSpringCancel) {
  const NormalLaw law = make_normal_law(impact(), 9e-3, 1);
  const double p = 40e-6;
  const double rate = -normal_force(law, p, 0.0).elastic / normal_force(law, p, 0.0).damping;
  EXPECT_GT(normal_force(law, p, rate * (1 - 1e-9)).force, 0);
  EXPECT_EQ(normal_force(law, p, rate * (1 + 1e-9)).force, 0);
}

TEST(NormalForce, HertzOfOneContactNotOfThePair) {
  const NormalLaw law = make_normal_law(hertz(), 10e-3, 1);
  const double delta = 2e-3, force = normal_force(law, delta * 1e-3, 0.0).force;  // [mm], [N]
  // ISO/TS 16281: c_L = 35,948 L^(8/9) is for inner and outer contact in series, half the approach
  // each.
  EXPECT_NEAR(35948 * std::pow(10, 8.0 / 9.0) * std::pow(2 * delta, 10.0 / 9.0) / force, 1, 1e-5);
  // Palmgren, one contact: delta = 3.84e-5 Q^0.9/L^0.8 (mm, N), rounded differently: 80,596
  // L^(8/9), 3.8 % stiffer.
  EXPECT_NEAR(std::pow(delta * std::pow(10, 0.8) / 3.84e-5, 10.0 / 9.0) / force, 1.0379, 1e-3);
}

TEST(NormalForce, SharesAddUpToTheWhole) {
  for (const auto& parameters : {impact(), hertz()}) {
    const double whole = normal_force(make_normal_law(parameters, 9e-3, 1), 7e-6, 0.05).force;
    EXPECT_NEAR(5 * normal_force(make_normal_law(parameters, 9e-3, 5), 7e-6, 0.05).force, whole,
                1e-12 * whole);
  }
}

TEST(NormalForce, DerivativesAreThoseOfTheForceOnEitherSideOfEveryEdge) {
  for (const auto& parameters : {impact(), hertz()}) {
    const NormalLaw law = make_normal_law(parameters, 9e-3, 1);
    for (double p : {1e-7, 5e-6, 60e-6, 0.9999e-4, 1.0001e-4, 3e-4})
      for (double rate : {-1e-3, 0.0, 0.3}) {
        const auto q = normal_force(law, p, rate);
        if (q.force == 0) continue;
        const double h = 1e-4 * p, k = 1e-6;
        const auto at = [&](double dp, double dr) { return normal_force(law, p + dp, rate + dr); };
        EXPECT_NEAR(q.stiffness, (at(h, 0).force - at(-h, 0).force) / (2 * h), 1e-6 * q.stiffness);
        EXPECT_NEAR(q.damping, (at(0, k).force - at(0, -k).force) / (2 * k),
                    1e-6 * (q.damping + 1));
        EXPECT_NEAR(q.elastic_stiffness, (at(h, 0).elastic - at(-h, 0).elastic) / (2 * h),
                    1e-6 * q.stiffness);
        EXPECT_NEAR(q.elastic, (elastic_energy(law, p + h) - elastic_energy(law, p - h)) / (2 * h),
                    1e-6 * q.elastic);
      }
  }
}

TEST(NormalForce, FirstDerivativeIsContinuousAtTouchAndAtFullDamping) {
  for (const auto& parameters : {impact(), hertz()}) {
    const NormalLaw law = make_normal_law(parameters, 9e-3, 1);
    // At touch force and stiffness grow from zero: stiffness like p^(1/9), slowly, but from zero.
    EXPECT_LT(normal_force(law, 1e-30, 0.1).force, 1e-20);
    EXPECT_LT(normal_force(law, 1e-60, 0.1).stiffness,
              1e-6 * normal_force(law, 1e-6, 0.1).stiffness);
    const auto before = normal_force(law, 1e-4 * (1 - 1e-12), 0.1),
               after = normal_force(law, 1e-4 * (1 + 1e-12), 0.1);
    EXPECT_NEAR(before.stiffness, after.stiffness, 1e-9 * after.stiffness);
    EXPECT_NEAR(before.damping, after.damping, 1e-9 * after.damping);
  }
}

/// Speed of separation of a mass that hits a wall at `approach`, by small Runge-Kutta steps:
/// nothing shared with the program's integrators.
double separation_speed(const NormalLaw& law, double mass, double approach) {
  double p = 1e-15, v = approach;
  const auto slope = [&](double x, double u) { return -normal_force(law, x, u).force / mass; };
  const double h = 2e-9;
  for (int n = 0; n < 2000000; ++n) {
    const double k1 = slope(p, v), k2 = slope(p + h / 2 * v, v + h / 2 * k1);
    const double v2 = v + h / 2 * k1, v3 = v + h / 2 * k2;
    const double k3 = slope(p + h / 2 * v2, v3), v4 = v + h * k3, k4 = slope(p + h * v3, v4);
    p += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (p <= 0) break;
  }
  return -v;
}

TEST(HuntCrossley, RestitutionAtTheReferenceSpeedIsExact) {
  for (double restitution : {0.5, 0.7, 0.9, 0.99}) {
    ContactParameters parameters = hertz();
    parameters.restitution = restitution;
    const NormalLaw law = make_normal_law(parameters, 9e-3, 1);
    // u - ln(1 + u) = -w - ln(1 - w), u = chi v_in, w = chi v_out.
    const double u = law.chi * 0.1, w = restitution * u;
    EXPECT_NEAR((u - std::log1p(u)) / (-w - std::log1p(-w)), 1, 1e-10);
    EXPECT_NEAR(separation_speed(law, 3e-3, 0.1) / 0.1, restitution, 1e-5);
  }
}

TEST(HuntCrossley, SlowerImpactsBounceBetter) {
  const NormalLaw law = make_normal_law(hertz(), 9e-3, 1);
  EXPECT_GT(separation_speed(law, 3e-3, 0.05) / 0.05, 0.94);
  EXPECT_EQ(hunt_crossley_chi(1, 0.1), 0);
}

TEST(HuntCrossley, RefusesImpossibleRestitution) {
  for (double e : {0.0, -0.1, 1.1, std::nan("")})
    EXPECT_THROW(hunt_crossley_chi(e, 0.1), std::domain_error);
}

TEST(NormalForce, ElasticPenetrationInvertsTheLaw) {
  for (const auto& parameters : {impact(), hertz()}) {
    const NormalLaw law = make_normal_law(parameters, 9e-3, 5);
    EXPECT_NEAR(normal_force(law, elastic_penetration(law, 42), 0.0).elastic, 42, 1e-10);
    EXPECT_EQ(elastic_penetration(law, 0), 0);
  }
}

double coefficient(double v) {
  return friction(FrictionLaw{}, v * v).ratio * v;
}

TEST(Friction, HandComputedPoints) {
  EXPECT_EQ(coefficient(0), 0);
  // Below v_s: mu_s (3 s - s^3)/2 = 0.07 * (1.5 - 0.125)/2 at s = 1/2.
  EXPECT_NEAR(coefficient(0.05), 0.048125, 1e-15);
  EXPECT_NEAR(coefficient(0.1), 0.07, 1e-15);
  EXPECT_NEAR(coefficient(0.55), 0.065, 1e-15);
  EXPECT_NEAR(coefficient(0.325), 0.07 - 0.01 * 0.15625, 1e-15);
  EXPECT_NEAR(coefficient(1), 0.06, 1e-15);
  EXPECT_NEAR(coefficient(7), 0.06, 1e-15);
}

TEST(Friction, SlopeIsContinuousAtBothTransitionsAndAtZero) {
  const auto slope = [](double v) {  // dmu/dv = bend v^2 + ratio
    const auto f = friction(FrictionLaw{}, v * v);
    return f.bend * v * v + f.ratio;
  };
  for (double v : {0.02, 0.08, 0.3, 0.8, 2.0})
    EXPECT_NEAR(slope(v), (coefficient(v + 1e-6) - coefficient(v - 1e-6)) / 2e-6, 1e-8);
  EXPECT_NEAR(slope(0), 1.5 * 0.07 / 0.1, 1e-12);
  for (double edge : {0.1, 1.0}) {
    EXPECT_NEAR(slope(edge * (1 - 1e-9)), 0, 1e-8);
    EXPECT_NEAR(slope(edge * (1 + 1e-9)), 0, 1e-8);
  }
}

TEST(ContactLaws, LanesFollowTheScalarLaw) {
  const std::vector<double> depths = {-1e-6, 0, 1e-9, 3e-7, 5e-6, 4e-5, 1e-4, 3e-4};
  const std::vector<double> speeds = {0, 1e-3, 0.05, 0.1, 0.2, 0.9, 1.0, 5};
  for (const auto& parameters : {impact(), hertz()}) {
    const NormalLaw law = make_normal_law(parameters, 9e-3, 5);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const std::size_t first = k / kLanes * kLanes;
      const int i = static_cast<int>(k - first);
      const auto lanes = normal_force(law, load(&depths[first]), splat(0.02));
      const Pack v = load(&speeds[first]);
      const auto rubbing = friction(FrictionLaw{}, v * v);
      const auto one = normal_force(law, depths[k], 0.02);
      EXPECT_NEAR(lanes.force[i], one.force, 2e-15 * one.force) << i;
      EXPECT_NEAR(lanes.stiffness[i], one.stiffness, 2e-15 * one.stiffness) << i;
      EXPECT_NEAR(lanes.damping[i], one.damping, 2e-15 * one.damping) << i;
      const auto f = friction(FrictionLaw{}, speeds[k] * speeds[k]);
      EXPECT_NEAR(rubbing.ratio[i], f.ratio, 1e-15) << i;
      EXPECT_NEAR(rubbing.bend[i], f.bend, 1e-13) << i;
    }
  }
}

}  // namespace
}  // namespace cagetol
