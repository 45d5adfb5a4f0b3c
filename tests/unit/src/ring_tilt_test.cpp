// The free tilt of the inner ring against closed forms and independent sums, and what must not
// change its result.
#include <gtest/gtest.h>
#include <cmath>
#include <complex>
#include <numbers>

#include "src/integration/integrator.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "src/statics/static_equilibrium.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;
using Tilt = std::complex<double>;  // B_y + i B_z

Scene free_ring(Scene scene) {
  scene.model.ring_tilt = TiltModel::free;
  return scene;
}

/// A ring that nothing but its shaft touches: the races are 1 mm away.
Scene lonely_ring() {
  Scene scene = free_ring({});
  scene.bearing.internal_clearance = 4e-3;
  scene.cage.guidance = Guidance::roller;
  scene.operation = {.radial_load = 0, .inner_speed = 2000, .gravity = 0};
  scene.bearing.tilt_stiffness = 50;
  scene.bearing.misalignment_y = 0.4e-3;
  scene.integration.tolerance = 5e-7;
  return scene;
}

// I_t B'' = i I_p w B' - k (B - m): a forward nutation and a backward precession,
// Omega^2 - g Omega - k/I_t = 0 with g = I_p w/I_t.
TEST(RingTilt, OfALonelyRingNutatesAndPrecesses) {
  const Scene scene = lonely_ring();
  const BearingModel model = make_bearing_model(scene);
  const double half = model.ring_polar * scene.operation.inner_speed / model.ring_transverse / 2;
  const double root = std::sqrt(half * half + scene.bearing.tilt_stiffness / model.ring_transverse);
  const double nutation = half + root, precession = half - root;
  RecordProperty("nutation_Hz", std::to_string(nutation / (2 * pi)));
  RecordProperty("precession_Hz", std::to_string(precession / (2 * pi)));
  const StateLayout& l = model.layout;
  const int at = l.border_position(l.ring_tilt_slot()),
            rate = l.border_velocity(l.ring_tilt_slot());
  using enum IntegrationMethod;
  for (const IntegrationMethod method : {rodas3, rodasp, cvode_bdf, arkode_esdirk, arkode_erk}) {
    Integration keys = scene.integration;
    keys.method = method;
    keys.max_order = 5;
    System system(model);
    std::vector<double> y = start_state(model, {.state = StartState::centred});
    const auto slot = [&](int k) -> double& { return y[static_cast<std::size_t>(k)]; };
    EXPECT_EQ(Tilt(slot(at), slot(at + 1)), Tilt(0.4e-3, 0));  // as the shaft would have it
    const Tilt rest(0.4e-3, 0), first(1e-3, -0.5e-3), speed(2, 1);
    slot(at) = (rest + first).real(), slot(at + 1) = (rest + first).imag();
    slot(rate) = speed.real(), slot(rate + 1) = speed.imag();
    // first = a + b, speed = i (nutation a + precession b).
    const Tilt i(0, 1), a = (speed / i - precession * first) / (nutation - precession),
                        b = first - a;
    double t = 0;
    const auto integrator = make_integrator(keys, system, t, y.data());
    for (const double end : {1e-3, 5e-3, 10e-3}) {
      while (t < end) {
        ASSERT_TRUE(system.linearise_at(t, y.data()));
        ASSERT_EQ(integrator->step(system, t, y.data(), end), StepStatus::accepted);
      }
      const Tilt due = rest + a * std::exp(i * (nutation * t)) + b * std::exp(i * (precession * t));
      EXPECT_LT(std::abs(Tilt(slot(at), slot(at + 1)) - due), 1e-4 * std::abs(first))
          << spelled(method);
    }
  }
}

/// Elastic force and moments of the rollers on the ring, roller by roller and slice by slice. Equal
/// laws inside and outside share the approach of the races equally, whatever the roller has to do
/// for it.
struct OnRing {
  double y = 0, z = 0, moment_y = 0, moment_z = 0;
};
OnRing summed(const Scene& scene, const std::vector<double>& angle, const StaticState& ring) {
  OnRing on;
  const double length_mm = 1e3 * scene.roller.length;
  const long slices = scene.discretisation.race_slices;
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const double c = std::cos(angle[static_cast<std::size_t>(j)]),
                 s = std::sin(angle[static_cast<std::size_t>(j)]);
    for (long k = 0; k < slices; ++k) {
      const double x = ((static_cast<double>(k) + 0.5) / static_cast<double>(slices) - 0.5) *
                       scene.roller.length;
      const double approach = c * (ring.ring_y + x * ring.tilt_y) +
                              s * (ring.ring_z + x * ring.tilt_z) -
                              scene.bearing.internal_clearance / 2;
      if (approach <= 0) continue;
      const double force = 77652 * std::pow(length_mm, 8.0 / 9.0) *
                           std::pow(1e3 * approach / 2, 10.0 / 9.0) / static_cast<double>(slices);
      on.y -= c * force;
      on.z -= s * force;
      on.moment_y -= x * c * force;
      on.moment_z -= x * s * force;
    }
  }
  return on;
}

// In a bearing so large that the contact's direction does not turn with the ring's displacement.
TEST(RingTilt, UnderAMomentBalancesTheSumOverRollersAndSlices) {
  Scene scene = free_ring({});
  scene.bearing.roller_count = 16;
  scene.bearing.inner_raceway_diameter = 1.991;
  scene.bearing.outer_raceway_diameter = 2.009;
  scene.bearing.shoulder_diameter = 2.006;
  scene.bearing.internal_clearance = 10e-6;
  scene.roller.diameter = {9e-3};
  scene.operation.gravity = 0;
  for (const double stiffness : {0.0, 2e4})
    for (const double radial : {0.0, 5000.0})
      for (const long slices : {3L, 8L}) {
        scene.bearing.tilt_stiffness = stiffness;
        scene.bearing.misalignment_z = stiffness > 0 ? 0.2e-3 : 0;
        scene.discretisation.race_slices = slices;
        const BearingModel model = make_bearing_model(scene);
        const RingLoad load{0, -radial, 6, 10};
        const std::vector<double> angle = roller_angles(model, 0.1);
        StaticEquilibrium equilibrium(model);
        const StaticState& rest = equilibrium.solve(angle.data(), 0, load);
        ASSERT_TRUE(rest.converged);
        const OnRing on = summed(scene, angle, rest);
        const double held_y = stiffness * rest.tilt_y,
                     held_z = stiffness * (rest.tilt_z - scene.bearing.misalignment_z);
        EXPECT_NEAR(on.y, 0, 1e-4 * (radial + 1000));
        EXPECT_NEAR(on.z, radial, 1e-4 * (radial + 1000));
        EXPECT_NEAR(on.moment_y + load.moment_y, held_y, 1e-3);
        EXPECT_NEAR(on.moment_z + load.moment_z, held_z, 1e-3);
        EXPECT_GT(rest.tilt_y, 0.1e-3);  // the way the moment pushes
        EXPECT_GT(rest.tilt_z, 0.1e-3);
      }
}

Scene brief(Scene scene) {
  scene.window.settle_time = 3e-3;
  scene.window.measure_time = 5e-3;
  return scene;
}

// Friction moves the ring a little; a shaft leaves it little to move.
TEST(RingTilt, OfARunIsThatOfStatics) {
  Scene scene = brief(free_ring(dry_scene("nu205")));
  scene.integration.tolerance = 5e-5;
  scene.bearing.tilt_stiffness = 1e4;
  scene.operation.tilting_moment_y = -4;
  scene.operation.tilting_moment_z = 10;
  const Outcome motion = simulate(scene);
  ASSERT_EQ(motion.status, Status::ok) << motion.reason;
  EXPECT_LT(quantity(motion, "static_consistency_error"), 2e-3);
  EXPECT_LT(motion.run.energy_residual, 2e-3);
  scene.model.motion = MotionModel::quasi_static;
  const Outcome statics = simulate(scene);
  ASSERT_EQ(statics.status, Status::ok) << statics.reason;
  const double tilt = quantity(statics, "ring_tilt_mean_mrad");
  RecordProperty("statics", std::to_string(tilt));
  RecordProperty("motion", std::to_string(quantity(motion, "ring_tilt_mean_mrad")));
  EXPECT_NEAR(quantity(motion, "ring_tilt_mean_mrad"), tilt, 0.02 * tilt);
  EXPECT_LT(quantity(motion, "ring_tilt_std_mrad"), 0.05 * tilt);
  EXPECT_TRUE(std::isnan(quantity(statics, "ring_tilt_std_mrad")));
}

TEST(RingTilt, OfAStiffShaftIsThePrescribedMisalignment) {
  Scene scene = brief(shipped_scene("nu205"));
  scene.start.state = StartState::centred;
  scene.operation.load_ramp = 1e-3;
  const Outcome prescribed = simulate(scene);
  scene.bearing.tilt_stiffness = 1e8;
  const Outcome held = simulate(free_ring(scene));
  ASSERT_EQ(held.status, Status::ok) << held.reason;
  EXPECT_DOUBLE_EQ(quantity(prescribed, "ring_tilt_mean_mrad"), 0.3);
  EXPECT_TRUE(std::isnan(quantity(prescribed, "ring_tilt_std_mrad")));
  EXPECT_NEAR(quantity(held, "ring_tilt_mean_mrad"), 0.3, 1e-4);
  EXPECT_NEAR(quantity(held, "ring_displacement_mean_um"),
              quantity(prescribed, "ring_displacement_mean_um"), 0.01);
}

// Without load and gravity no direction is marked but that of the moment.
TEST(RingTilt, TurnsWithTheMoment) {
  Scene scene = free_ring({});
  scene.operation.radial_load = scene.operation.gravity = 0;
  scene.integration.tolerance = 1e-5;
  const auto tilt_at_end = [&](double moment_y, double moment_z, double phase) {
    scene.operation.tilting_moment_y = moment_y;
    scene.operation.tilting_moment_z = moment_z;
    scene.start.cage_phase = phase;
    const BearingModel model = make_bearing_model(scene);
    System system(model);
    std::vector<double> y = start_state(model, scene.start);
    double t = 0;
    const auto integrator = make_integrator(scene.integration, system, t, y.data());
    while (t < 0.5e-3) {
      EXPECT_TRUE(system.linearise_at(t, y.data()));
      if (integrator->step(system, t, y.data(), 0.5e-3) != StepStatus::accepted) break;
    }
    const double* tilt = y.data() + model.layout.border_position(model.layout.ring_tilt_slot());
    return Tilt(tilt[0], tilt[1]);
  };
  const Tilt plain = tilt_at_end(2, 0, 0), turned = tilt_at_end(0, 2, pi / 2);
  EXPECT_GT(plain.real(), 1e-3);
  EXPECT_LT(std::abs(turned - Tilt(0, 1) * plain), 1e-6 * std::abs(plain));
}

TEST(RingTilt, MayNotGrowBeyondSmallAngles) {
  Scene scene = lonely_ring();
  scene.bearing.tilt_stiffness = 10;
  scene.operation.tilting_moment_y = 1.5;
  scene.start.state = StartState::centred;
  scene.window.settle_time = 0;
  scene.window.measure_time = 2e-3;
  scene.watch.static_consistency_max = 10;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_NE(outcome.reason.find("the inner ring tilted by"), std::string::npos) << outcome.reason;
}

}  // namespace
}  // namespace cagetol
