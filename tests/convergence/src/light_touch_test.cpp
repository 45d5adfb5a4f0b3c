// Rollers of the lively scene touch flanges lightly, a dozen times a millisecond in all. What the
// step that begins such a touch does to the energy of axial motion and skew, against the same step
// in many small parts: skew remembers it for tens of milliseconds, so it may not lean to one side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/dynamics/start_state.hpp"
#include "src/integration/integrator.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// Energy of a roller's axial motion, its skew and its contacts with the flanges [J].
struct FlangeEnergy {
  double kinetic, elastic;
};

FlangeEnergy flange_energy(const BearingModel& model, const std::vector<double>& y, int roller) {
  const StateLayout& l = model.layout;
  const RollerGroup& group = model.groups[static_cast<std::size_t>(roller / kLanes)];
  const int lane = roller % kLanes;
  const auto at = [&](int slot) { return y[static_cast<std::size_t>(slot)]; };
  const double angle = at(l.position(kAngle, roller));
  const double c = std::cos(angle), s = std::sin(angle);
  const double ay = at(l.position(kAxisY, roller)), az = at(l.position(kAxisZ, roller));
  const double tilt = c * ay + s * az, skew = c * az - s * ay;
  const double rate =
      c * at(l.velocity(kAxisRateZ, roller)) - s * at(l.velocity(kAxisRateY, roller));
  const double speed = at(l.velocity(kAxialSpeed, roller));
  FlangeEnergy energy{
      group.mass[lane] * speed * speed / 2 + group.transverse[lane] * rate * rate / 2, 0};
  for (const double end : {-1.0, 1.0})
    for (const EndPoint& point : model.flange_points) {
      const double p =
          end * (at(l.position(kAxial, roller)) - point.radial * tilt - point.tangential * skew) -
          model.flange_half_clearance;
      energy.elastic += elastic_energy(model.flange, p);
    }
  return energy;
}

TEST(LightTouch, BeginsWithoutEnergyLostOrWon) {
  const Scene scene = shipped_scene("speed-z16-skew");
  const BearingModel model = make_bearing_model(scene);
  std::vector<double> y = start_state(model, scene.start), before;
  System system(model), parts(model);
  double t = 0;
  const double begin = 5e-3, end = 60e-3;
  const auto integrator = make_integrator(scene.integration, system, t, y.data());
  ASSERT_TRUE(system.linearise_at(t, y.data()));
  double error = 0, kinetic = 0;
  int touches = 0;
  while (t < end) {
    before = y;
    const double from = t;
    const PackVector force = system.seen.flange_force;
    ASSERT_EQ(integrator->step(system, t, y.data(), end), StepStatus::accepted);
    ASSERT_TRUE(system.linearise_at(t, y.data()));
    if (t < begin) continue;
    std::vector<int> touched;
    for (int j = 0; j < model.layout.rollers; ++j) {
      const auto k = static_cast<std::size_t>(j);
      if (force[k] == 0 && system.seen.flange_force[k] > 0 && system.seen.inner_force[k] == 0)
        touched.push_back(j);
    }
    if (touched.empty()) continue;
    Integration small = scene.integration;
    small.tolerance = 1e-6;
    small.max_step = std::min(0.1e-6, (t - from) / 8);
    double at = from;
    const auto exact = make_integrator(small, parts, at, before.data());
    ASSERT_TRUE(parts.linearise_at(at, before.data()));
    while (at < t) {
      ASSERT_EQ(exact->step(parts, at, before.data(), t), StepStatus::accepted);
      ASSERT_TRUE(parts.linearise_at(at, before.data()));
    }
    for (const int j : touched) {
      const FlangeEnergy is = flange_energy(model, y, j), was = flange_energy(model, before, j);
      error += is.kinetic + is.elastic - was.kinetic - was.elastic;
      kinetic += was.kinetic;
      ++touches;
    }
  }
  EXPECT_GT(touches, 100);
  EXPECT_LT(std::abs(error), 1e-4 * kinetic);
}

}  // namespace
}  // namespace cagetol
