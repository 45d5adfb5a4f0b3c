// Raceways that are no circles: statics in closed form, and motions that must repeat or mirror.
#include "src/model/raceway_form.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "src/integration/integrator.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "src/statics/static_equilibrium.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

TEST(RacewayForm, IsTheSumOfItsHarmonicsWithDerivatives) {
  const std::array<Waviness, kHarmonics> form = {Waviness{3e-6, 2, 0.4}, Waviness{-1e-6, 7, 2}};
  for (const double angle : {-9.0, 0.0, 0.3, 70.0}) {
    const auto height = [&](double a) {
      return 3e-6 * std::cos(2 * a - 0.4) - 1e-6 * std::cos(7 * a - 2);
    };
    const FormAt at = form_at(form, splat(angle));
    const double step = 1e-4;
    EXPECT_NEAR(at.height[0], height(angle), 1e-18);
    EXPECT_NEAR(at.slope[0], (height(angle + step) - height(angle - step)) / (2 * step), 1e-12);
    EXPECT_NEAR(at.bend[0],
                (height(angle + step) - 2 * height(angle) + height(angle - step)) / (step * step),
                1e-11);
  }
}

/// Round rollers between rings at rest under a radial load, without weight.
Scene resting_scene() {
  Scene scene;
  scene.operation.gravity = 0;
  scene.operation.inner_speed = 0;
  scene.discretisation.race_slices = 1;
  return scene;
}

const StaticState& rest_of(const BearingModel& model, StaticEquilibrium& statics,
                           const RingAngles& turned, double phase = 0) {
  statics.turn_rings(turned);
  return statics.solve(roller_angles(model, phase).data(), 0, load_at(model.duty, 1));
}

// One wave is a circle whose centre stands a beside the ring's: the ring moves by that much and
// rollers are loaded as before.
TEST(WavyRaceway, OneWaveIsAnEccentricCircle) {
  Scene scene = resting_scene();
  const BearingModel round = make_bearing_model(scene);
  const double a = 5e-6;
  scene.bearing.inner_waviness[0] = {a, 1, 0};
  const BearingModel wavy = make_bearing_model(scene);
  StaticEquilibrium on_round(round), on_wavy(wavy);
  const StaticState& circle = rest_of(round, on_round, {});
  for (const double turned : {0.0, 0.7, pi / 2, 4.0}) {
    const StaticState& eccentric = rest_of(wavy, on_wavy, {turned, 0});
    ASSERT_TRUE(eccentric.converged);
    // To a^2/R, 1.6 nm.
    EXPECT_NEAR(eccentric.ring_y, circle.ring_y - a * std::cos(turned), 2e-9);
    EXPECT_NEAR(eccentric.ring_z, circle.ring_z - a * std::sin(turned), 2e-9);
    for (std::size_t j = 0; j < 13; ++j)
      EXPECT_NEAR(eccentric.inner_force[j], circle.inner_force[j], 0.2) << j;
  }
}

// Pinched between an oval ring and a round one without load, a roller at theta bears half of what
// both races approach: K (delta/2)^e each, with delta = interference + a cos 2 (theta - turned).
TEST(WavyRaceway, AnOvalRingPinchesRollersAsItsFormSays) {
  Scene scene = resting_scene();
  scene.operation.radial_load = 0;
  scene.bearing.roller_count = 12;
  scene.bearing.internal_clearance = -40e-6;
  const double a = 8e-6, turned = 0.4;
  for (const bool inner : {true, false}) {
    scene.bearing.inner_waviness[0].amplitude = inner ? a : 0;
    scene.bearing.outer_waviness[0].amplitude = inner ? 0 : -a;
    const BearingModel model = make_bearing_model(scene);
    StaticEquilibrium statics(model);
    const StaticState& rest = rest_of(model, statics, {turned, turned});
    ASSERT_TRUE(rest.converged);
    EXPECT_NEAR(std::hypot(rest.ring_y, rest.ring_z), 0, 1e-11);
    double most = 0, minimum = 1e9;
    for (int j = 0; j < 12; ++j) {
      const double theta = 2 * pi * j / 12,
                   depth = (20e-6 + a * std::cos(2 * (theta - turned))) / 2;
      const double due = 77652 * std::pow(9, 8.0 / 9) * std::pow(1e3 * depth, 10.0 / 9);
      const double force = rest.inner_force[static_cast<std::size_t>(j)];
      EXPECT_NEAR(force, due, 2e-3 * due) << (inner ? "inner " : "outer ") << j;
      most = std::max(most, force);
      minimum = std::min(minimum, force);
    }
    EXPECT_GT(most, 1.5 * minimum);
  }
}

// A ring with k waves under a fixed load looks the same after a k-th of a turn: its displacement
// has that period, and hardly anything at lower frequencies.
TEST(WavyRaceway, DisplacementVariesAsOftenAsWavesPass) {
  for (const long k : {2L, 3L, 5L}) {
    Scene scene = resting_scene();
    const double a = 4e-6;
    scene.bearing.inner_waviness[0] = {a, k, 0};
    const BearingModel model = make_bearing_model(scene);
    StaticEquilibrium statics(model);
    constexpr int n = 60;        // a multiple of all k
    double harmonic[2][8] = {};  // cosine and sine parts over a turn of the ring
    for (int i = 0; i < n; ++i) {
      const double turned = 2 * pi * i / n;
      const StaticState& rest = rest_of(model, statics, {turned, 0});
      ASSERT_TRUE(rest.converged);
      for (int h = 0; h < 8; ++h) {
        harmonic[0][h] += 2 * rest.ring_z * std::cos(h * turned) / n;
        harmonic[1][h] += 2 * rest.ring_z * std::sin(h * turned) / n;
      }
    }
    for (int h = 1; h < 8; ++h) {
      const double size = std::hypot(harmonic[0][h], harmonic[1][h]);
      if (h == k) {
        EXPECT_GT(size, 0.1 * a) << k;
      } else if (h % k != 0) {
        EXPECT_LT(size, 1e-10) << k << ", " << h;
      }
    }
  }
}

/// Runs a motion for some 2 ms; state at its end.
std::vector<double> end_of(const BearingModel& model, const Scene& scene) {
  System system(model);
  std::vector<double> y = start_state(model, scene.start);
  double t = 0;
  const auto integrator = make_integrator(scene.integration, system, t, y.data());
  const double end = 2e-3;
  while (t < end) {
    EXPECT_TRUE(system.linearise_at(t, y.data()));
    EXPECT_EQ(integrator->step(system, t, y.data(), end), StepStatus::accepted);
  }
  return y;
}

// Mirrored in the plane x-z: theta becomes pi - theta, so cos(k theta - phi) keeps its value with
// k pi - phi for phi.
TEST(WavyRaceway, MirroredSpeedsMirrorTheMotion) {
  Scene scene;
  scene.operation.gravity = 0;
  scene.operation.outer_speed = -300;
  scene.bearing.roller_count = 12;  // of which each has a mirror image
  scene.integration.tolerance = 1e-5;
  scene.bearing.inner_waviness = {Waviness{5e-6, 2, 0.3}, Waviness{2e-6, 3, 1}};
  scene.bearing.outer_waviness = {Waviness{3e-6, 4, -2}, Waviness{1e-6, 5, 0.2}};
  Scene mirrored = scene;
  mirrored.operation.inner_speed *= -1;
  mirrored.operation.outer_speed *= -1;
  for (auto* form : {&mirrored.bearing.inner_waviness, &mirrored.bearing.outer_waviness})
    for (Waviness& of : *form) of.phase = static_cast<double>(of.count) * pi - of.phase;
  const BearingModel one = make_bearing_model(scene), other = make_bearing_model(mirrored);
  const std::vector<double> a = end_of(one, scene), b = end_of(other, mirrored);
  const auto at = [](const std::vector<double>& y, int slot) {
    return y[static_cast<std::size_t>(slot)];
  };
  const StateLayout& l = one.layout;
  const double y = at(a, l.border_position(kRingY)), z = at(a, l.border_position(kRingZ));
  EXPECT_GT(std::abs(y), 1e-7);
  EXPECT_NEAR(at(b, l.border_position(kRingY)), -y, 1e-9);
  EXPECT_NEAR(at(b, l.border_position(kRingZ)), z, 1e-9);
  for (int j = 0; j < 12; ++j) {
    const int image = (18 - j) % 12;
    EXPECT_NEAR(at(b, l.position(kRadius, image)), at(a, l.position(kRadius, j)), 2e-8) << j;
    EXPECT_NEAR(at(b, l.velocity(kSpin, image)), -at(a, l.velocity(kSpin, j)),
                1e-4 * std::abs(at(a, l.velocity(kSpin, j))))
        << j;
  }
}

// A whole run: its watches hold, statics among them, and the ring's path is wider than with round
// raceways.
TEST(WavyRaceway, RunsWithinItsWatches) {
  for (const bool lubricated : {false, true}) {
    Scene scene;
    if (lubricated) scene.lubrication.model = LubricationModel::film;
    scene.window.settle_revolutions = 0.5;
    scene.window.measure_revolutions = 1.5;
    const Outcome round = simulate(scene);
    scene.bearing.inner_waviness[0].amplitude = 5e-6;
    scene.bearing.outer_waviness[1].amplitude = 2e-6;
    const Outcome wavy = simulate(scene);
    ASSERT_EQ(wavy.status, Status::ok) << wavy.reason;
    EXPECT_LT(wavy.run.static_consistency_error, 0.01);
    EXPECT_LT(wavy.run.energy_residual, 1e-3);
    const auto orbit = static_cast<std::size_t>(quantity_index("ring_orbit_p95_um"));
    EXPECT_GT(wavy.quantities[orbit], round.quantities[orbit] + 1);
  }
}

}  // namespace
}  // namespace cagetol
