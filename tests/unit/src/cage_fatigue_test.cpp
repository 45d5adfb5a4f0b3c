// Fatigue utilisation of the cage: closed forms, and what a run reads of its stress.
#include "src/quantities/cage_fatigue.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>

#include "src/cage/table/scene_cage.hpp"
#include "src/integration/system.hpp"
#include "src/quantities/bar_peaks.hpp"
#include "src/quantities/cage_stress.hpp"
#include "src/quantities/window_times.hpp"
#include "src/scene/materials.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr Strength kStrength{.yield = 200e6, .tensile = 400e6, .fatigue = 100e6};

using Components = Eigen::Matrix<double, 6, 1>;  // xx, yy, zz, xy, yz, zx

Components turned(const Components& s, const Eigen::Matrix3d& by) {
  Eigen::Matrix3d tensor;
  tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  const Eigen::Matrix3d t = by * tensor * by.transpose();
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
}

/// Stress of sectors of one station that swings: constant + amplitude sin.
struct Swing {
  Components constant = Components::Zero(), amplitude = Components::Zero();
};

CageFatigue::Place worst_of(const std::vector<std::vector<Swing>>& revolutions) {
  const auto sectors = static_cast<long>(revolutions.front().size());
  CageFatigue fatigue(1, sectors);
  for (const auto& revolution : revolutions) {
    for (int n = 0; n < 80; ++n) {
      Eigen::VectorXf stress(6 * sectors);
      for (long k = 0; k < sectors; ++k) {
        const Swing& swing = revolution[static_cast<std::size_t>(k)];
        const double sine = std::sin(2 * std::numbers::pi * n / 80);
        stress.segment(6 * k, 6) = (swing.constant + sine * swing.amplitude).cast<float>();
      }
      fatigue.add(stress);
    }
    fatigue.end_revolution();
  }
  return fatigue.worst(kStrength);
}

TEST(CageFatigue, IsGoodmansOfAConstantAndASineStress) {
  Swing tension, pressure, shear;
  tension.constant[0] = 80e6;
  tension.amplitude[0] = 30e6;
  pressure.constant[0] = -80e6;
  pressure.amplitude[0] = 30e6;
  shear.constant[3] = 40e6;  // its largest principal stress
  shear.amplitude[3] = 30e6;
  const auto alone = [](const Swing& swing) { return worst_of({{swing}}).utilisation; };
  EXPECT_NEAR(alone(tension), 0.3 + 0.2, 1e-6);
  EXPECT_NEAR(alone(pressure), 0.3, 1e-6);
  EXPECT_NEAR(alone(shear), 0.3 * std::sqrt(3) + 0.1, 1e-6);
  const CageFatigue::Place worst = worst_of({{pressure, shear, tension}});
  EXPECT_EQ(worst.sector, 1);
  EXPECT_NEAR(worst.amplitude, 30e6 * std::sqrt(3), 10);
  EXPECT_NEAR(worst.mean, 40e6, 10);
}

// Hydrostatic stress has no von Mises amplitude.
TEST(CageFatigue, OfHydrostaticStressIsNone) {
  Swing hydrostatic;
  hydrostatic.amplitude.head(3).setConstant(50e6);
  EXPECT_NEAR(worst_of({{hydrostatic}}).utilisation, 0, 1e-6);
}

// Tension one way and pressure the other, in turn, are shear.
TEST(CageFatigue, ComponentsThatSwingAgainstEachOtherAddUp) {
  Swing opposed;
  opposed.amplitude[0] = 50e6;
  opposed.amplitude[1] = -50e6;
  EXPECT_NEAR(worst_of({{opposed}}).utilisation, 0.5 * std::sqrt(3), 1e-6);
}

TEST(CageFatigue, DoesNotDependOnTheAxes) {
  Swing swing;
  swing.amplitude << 30e6, -10e6, 5e6, 12e6, -7e6, 3e6;
  swing.constant = 1.5 * swing.amplitude;
  const double one = worst_of({{swing}}).utilisation;
  const Eigen::Matrix3d by =
      Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Swing other{turned(swing.constant, by), turned(swing.amplitude, by)};
  EXPECT_NEAR(worst_of({{other}}).utilisation, one, 1e-5 * one);
}

TEST(CageFatigue, TakesTheQuantileOfRevolutions) {
  const auto revolutions = [](int count, int high) {
    std::vector<std::vector<Swing>> all(static_cast<std::size_t>(count), {Swing{}});
    for (int n = 0; n < count; ++n)
      all[static_cast<std::size_t>(n)][0].amplitude[0] = n < high ? 50e6 : 10e6;
    return all;
  };
  EXPECT_NEAR(worst_of(revolutions(99, 1)).utilisation, 0.5, 1e-6);  // the largest
  EXPECT_NEAR(worst_of(revolutions(100, 1)).utilisation, 0.1, 1e-6);
  EXPECT_NEAR(worst_of(revolutions(200, 3)).utilisation, 0.5, 1e-6);
}

TEST(CageFatigue, OfLessThanARevolutionIsThatOfWhatThereIs) {
  CageFatigue fatigue(1, 1);
  EXPECT_EQ(fatigue.worst(kStrength).utilisation, 0);
  Eigen::VectorXf stress = Eigen::VectorXf::Zero(6);
  fatigue.add(stress);
  stress[0] = 40e6F;
  fatigue.add(stress);
  EXPECT_NEAR(fatigue.worst(kStrength).utilisation, 0.2 + 0.05, 1e-6);
}

TEST(BarPeaks, AreSeenOnceAfterTheyPassed) {
  BarPeaks peaks(2, 1);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(4);  // two faces
  std::vector<double> seen;
  double mode = 0;
  for (const double at : {0.0, 1.0, 3.0, 2.0, 2.5, 1.0, 4.0, 4.0, 0.0}) {
    force[0] = force[1] = -at / 2;
    mode += 1;
    if (peaks.pass(&mode, force, 0)) seen.push_back(-2 * peaks.peak().bar_force[0]);
  }
  EXPECT_EQ(seen, (std::vector<double>{3, 4}));  // 2.5 is less than 3
  EXPECT_EQ(peaks.peak().modes[0], 8);
}

/// Against the stress at every accepted step.
TEST(CageFatigue, OfARunMissesNoPeakOfTheStress) {
  Scene scene = shipped_scene("nu205");
  scene.cage.model = CageKind::flexible;
  scene.cage.mesh_density = 2;
  scene.window.settle_revolutions = 0.5;
  scene.window.measure_revolutions = 2;
  scene.watch.cage_drift_max = scene.watch.power_surplus_max = 1e9;
  std::optional<CageStress> stress;
  std::optional<CageFatigue> fatigue;
  WindowTimes times{};
  long ended = 0;
  const auto see = [&](double t, const double* y, const System& system) {
    const BearingModel& m = system.model;
    if (!stress) {
      stress.emplace(*m.flexible.model);
      fatigue.emplace(m.flexible.model->stress_stations, m.layout.rollers);
      times = window_times(scene, m);
    }
    if (t < times.settle) return;
    fatigue->add(stress->components(y + m.layout.border_position(kModes), system.seen.bar_force,
                                    system.seen.centrifugal_spin));
    if (t < times.settle + (static_cast<double>(ended) + 1 - 1e-9) * times.revolution) return;
    fatigue->end_revolution();
    ++ended;
  };
  const Outcome outcome = simulate(scene, {.on_state = see});
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  EXPECT_EQ(ended, 2);
  const Strength strength = cage_strength(scene);
  EXPECT_EQ(strength.fatigue, 165e6);
  const CageFatigue::Place worst = fatigue->worst(strength);
  EXPECT_NEAR(quantity(outcome, "cage_fatigue_utilisation"), worst.utilisation,
              0.02 * worst.utilisation);
  // Fewer states may give a smaller swing about a larger mean: 0.012 % more at most so far.
  EXPECT_LE(quantity(outcome, "cage_fatigue_utilisation"), 1.0003 * worst.utilisation);
  EXPECT_NEAR(quantity(outcome, "cage_strength_utilisation"),
              quantity(outcome, "cage_stress_peak_MPa") / 235, 1e-9);
}

TEST(CageStrength, FallsWithTemperatureUnlessGiven) {
  Scene scene;
  scene.cage.material = {"pa66-gf25"};
  scene.cage.temperature = 90;
  EXPECT_NEAR(cage_strength(scene).tensile, 0.68 * 120e6, 1);
  EXPECT_NEAR(cage_strength(scene).fatigue, 0.68 * 40e6, 1);
  scene.cage.fatigue_strength = 25e6;
  EXPECT_EQ(cage_strength(scene).fatigue, 25e6);
  scene.cage.material = {"steel-q235"};
  EXPECT_EQ(cage_strength(scene).tensile, 370e6);
}

}  // namespace
}  // namespace cagetol
