// Slip of the rollers' orbits over whole turns of the cage.
#include "src/quantities/orbit_slip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/quantities/observer.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

/// Of imposed angles; the window begins with the cage at 1 rad and lasts `turns` of it.
template <class Rollers, class Speed>
double rate_ratio(double cage_speed, double turns, const Rollers& rollers, const Speed& speed) {
  OrbitSlip slip;
  const double end = 2 * pi * turns / std::abs(cage_speed);
  constexpr int kSteps = 5000;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = end * i / kSteps;
    slip.record(5 + t, 1 + cage_speed * t, rollers(t), speed(t));
  }
  return slip.rate_ratio();
}

TEST(OrbitSlip, IsThatOfImposedRates) {
  for (const double inner : {600.0, -600.0})
    EXPECT_NEAR(rate_ratio(
                    0.4 * inner, 3, [=](double t) { return 7 + 0.37 * inner * t; },
                    [=](double) { return inner; }),
                0.37, 1e-12);
}

// Rollers run ahead and fall behind once a turn: the mean over 2.3 turns would be 0.386.
TEST(OrbitSlip, LeavesOutWhatAPartOfATurnAdds) {
  EXPECT_NEAR(rate_ratio(
                  240, 2.3, [](double t) { return 222 * t + 0.6 * std::sin(240 * t); },
                  [](double) { return 600.0; }),
              0.37, 1e-6);
}

TEST(OrbitSlip, FollowsARampOfTheInnerRing) {
  EXPECT_NEAR(rate_ratio(
                  240, 2, [](double t) { return 0.38 * (500 * t + 1000 * t * t); },
                  [](double t) { return 500 + 2000 * t; }),
              0.38, 1e-9);
}

TEST(OrbitSlip, TakesAllOfAWindowWithoutAWholeTurn) {
  EXPECT_NEAR(rate_ratio(
                  240, 0.3, [](double t) { return 222 * t; }, [](double) { return 600.0; }),
              0.37, 1e-12);
}

// Every second roller at 0.8, the others at 0.9 of the kinematic speed, the cage at 0.95 of it:
// slip of orbits 0.15 but for an odd roller, slip of the cage 0.05, and no roller bears a load.
TEST(OrbitSlip, OfARunIsThatOfItsRollersNotOfItsCage) {
  Scene scene = shipped_scene("nu205");
  scene.start.state = StartState::centred;
  const BearingModel model = make_bearing_model(scene);
  const StateLayout& l = model.layout;
  const double kinematic = kinematic_cage_speed(model, model.duty.speed);
  std::vector<double> start = start_state(model, scene.start);
  const auto rate = [&](int j) { return (j % 2 == 0 ? 0.8 : 0.9) * kinematic; };
  const double turn = 2 * pi / (0.95 * kinematic);
  const auto state = [&](double t) {
    PackVector y(start.begin(), start.end());
    double& phi = y[static_cast<std::size_t>(l.border_position(kCagePhi))];
    phi += 0.95 * kinematic * t;
    y[static_cast<std::size_t>(l.border_velocity(kCagePhi))] = 0.95 * kinematic;
    for (int j = 0; j < l.rollers; ++j) {
      y[static_cast<std::size_t>(l.position(kAngle, j))] += rate(j) * t;
      y[static_cast<std::size_t>(l.velocity(kOrbitRate, j))] = rate(j);
    }
    return y;
  };
  System system(model);
  Observer observer(model, 0, 1.5 * turn);
  constexpr int kSteps = 300;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = 1.5 * turn * i / kSteps;
    const PackVector y = state(t);
    ASSERT_TRUE(system.linearise_at(t, y.data()));
    observer.record(t, y.data(), system);
  }
  const std::vector<double> q = observer.quantities();
  const auto value = [&](const char* key) {
    return q[static_cast<std::size_t>(quantity_index(key))];
  };
  EXPECT_NEAR(value("orbit_slip_ratio"), 1 - (7 * 0.8 + 6 * 0.9) / 13, 1e-9);
  EXPECT_NEAR(value("cage_slip_ratio"), 0.05, 1e-9);
}

}  // namespace
}  // namespace cagetol
