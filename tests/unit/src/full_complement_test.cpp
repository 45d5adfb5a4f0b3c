// Bearings without a cage: contacts between neighbours, their derivatives, the solver of the chain
// that they make, and whole runs.
#include <gtest/gtest.h>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "src/integration/integrator.hpp"
#include "src/newton/newton_matrix.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/scene/roller_gap.hpp"
#include "src/scene/scene_keys.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/dense_jacobian.hpp"
#include "tests/support/random_bearing.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr const char* kScene = "ncf3008-full-complement";

RandomBearing complement(unsigned seed, Freedom freedom, bool lubricated = false) {
  return random_bearing(seed,
                        {.freedom = freedom, .lubricated = lubricated, .full_complement = true});
}

class FullComplement : public testing::TestWithParam<Freedom> {};
INSTANTIATE_TEST_SUITE_P(Rollers, FullComplement,
                         testing::Values(Freedom::spatial, Freedom::planar, Freedom::tilting),
                         [](const auto& test) { return freedom_name(test.param); });

/// Largest difference of assembled and differenced derivatives over the largest entry, in scales.
double missed(const RandomBearing& b, double step) {
  System system(b.model);
  system.linearise_at(b.t, b.y.data());
  const Eigen::MatrixXd assembled = assembled_jacobian(b.model, b.y, system.linear),
                        due = differenced_jacobian(b.model, b.t, b.y, system.scale, step);
  double apart = 0, size = 0;
  for (int i = 0; i < due.rows(); ++i)
    for (int j = 0; j < due.cols(); ++j) {
      const double row = system.scale[static_cast<std::size_t>(i)],
                   column = system.scale[static_cast<std::size_t>(j)];
      if (row > 1e20 || column > 1e20) continue;
      apart = std::max(apart, std::abs(assembled(i, j) - due(i, j)) * column / row);
      size = std::max(size, std::abs(due(i, j)) * column / row);
    }
  EXPECT_TRUE(std::isfinite(apart));
  return apart / size;
}

TEST_P(FullComplement, DerivativesAgreeWithDifferences) {
  for (const bool lubricated : {false, true}) {
    double worst = 0;
    for (unsigned seed = 0; seed < 24; ++seed)
      worst = std::max(worst, missed(complement(seed, GetParam(), lubricated), 1e-4));
    RecordProperty(lubricated ? "worst_oiled" : "worst_dry", std::to_string(worst));
    EXPECT_LT(worst, 0.02) << (lubricated ? "oiled" : "dry");
  }
}

/// Rollers beside each other, off the races, whose only contacts are those with each other.
RandomBearing only_neighbours(unsigned seed, Freedom freedom, bool lubricated) {
  RandomBearing b = complement(seed, freedom, lubricated);
  b.model.inner_radius -= 1e-3;
  b.model.outer_radius += 1e-3;
  for (Flange& flange : b.model.flanges) flange.clearance = 1;
  b.model.churning.on = false;
  b.model.outer_line.starved = true;  // oil does not reach so far
  b.model.outer_line.layer = b.model.inner_line.layer;
  return b;
}

TEST_P(FullComplement, DerivativesOfNeighboursAloneAreNearlyExact) {
  for (const bool lubricated : {false, true}) {
    double worst = 0;
    for (unsigned seed = 0; seed < 24; ++seed)
      worst = std::max(worst, missed(only_neighbours(seed, GetParam(), lubricated), 1e-5));
    RecordProperty(lubricated ? "worst_oiled" : "worst_dry", std::to_string(worst));
    EXPECT_LT(worst, 2e-3) << (lubricated ? "oiled" : "dry");
  }
}

// The contacts act between rollers alone: in all they move and turn nothing, about any axis, but
// for the lean that forces keep to first order.
TEST_P(FullComplement, NeighboursKeepMomentum) {
  for (const bool lubricated : {false, true})
    for (unsigned seed = 0; seed < 24; ++seed) {
      RandomBearing b = only_neighbours(seed, GetParam(), lubricated);
      b.model.gravity = b.model.gravity_axial = 0;
      const StateLayout& l = b.model.layout;
      std::vector<double> rates(b.y.size());
      evaluate_rates(b.model, b.t, b.y.data(), rates.data());
      const auto y = [&](int slot) { return b.y[static_cast<std::size_t>(slot)]; };
      const auto d = [&](int slot) { return rates[static_cast<std::size_t>(slot)]; };
      double force[3] = {0, 0, 0}, turn = 0, size = 0;
      for (int j = 0; j < l.rollers; ++j) {
        const RollerGroup& g = b.model.groups[static_cast<std::size_t>(j / kLanes)];
        const double m = g.mass[j % kLanes], r = y(l.position(kRadius, j)),
                     a = y(l.position(kAngle, j)), w = y(l.velocity(kOrbitRate, j));
        const double f_r = m * (d(l.velocity(kRadialSpeed, j)) - r * w * w),
                     f_t = m * (r * d(l.velocity(kOrbitRate, j)) +
                                2 * y(l.velocity(kRadialSpeed, j)) * w);
        force[0] += m * d(l.velocity(kAxialSpeed, j));
        force[1] += f_r * std::cos(a) - f_t * std::sin(a);
        force[2] += f_r * std::sin(a) + f_t * std::cos(a);
        turn += r * f_t + g.polar[j % kLanes] * d(l.velocity(kSpin, j));
        size += std::hypot(f_r, f_t);
      }
      EXPECT_GT(size, 1);
      for (const double sum : force) EXPECT_NEAR(sum, 0, 1e-11 * size) << seed;
      // Friction acts at the rollers' radii, which overlap by p; lean axes take part of a torque.
      const double within = GetParam() == Freedom::planar ? 1e-4 : 1e-3;
      EXPECT_NEAR(turn, 0, within * size * b.model.pitch_radius) << seed;
    }
}

TEST_P(FullComplement, TheChainIsSolvedLikeDenseFactors) {
  std::mt19937_64 engine(3);
  double worst = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const RandomBearing b = complement(seed, GetParam(), seed % 2 == 1);
    System system(b.model);
    system.linearise_at(b.t, b.y.data());
    ASSERT_TRUE(system.linear.neighbours_touch);
    const Eigen::MatrixXd assembled = assembled_jacobian(b.model, b.y, system.linear);
    const int n = system.size;
    for (const double beta : {1e-8, 1e-6, 2e-5}) {
      NewtonMatrix newton(b.model);
      ASSERT_TRUE(newton.factor(system.linear, beta));
      Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n), solution(n), scale(n);
      for (int i = 0; i < n; ++i) {
        scale[i] = system.scale[static_cast<std::size_t>(i)];
        if (scale[i] > 1e20)
          scale[i] = 1;
        else
          rhs[i] = scale[i] * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1);
      }
      newton.solve(rhs.data(), solution.data());
      const Eigen::MatrixXd J = scale.cwiseInverse().asDiagonal() * assembled * scale.asDiagonal();
      const Eigen::VectorXd dense =
          Eigen::PartialPivLU<Eigen::MatrixXd>(Eigen::MatrixXd::Identity(n, n) / beta - J)
              .solve(scale.cwiseInverse().cwiseProduct(rhs));
      const Eigen::VectorXd ours = scale.cwiseInverse().cwiseProduct(solution);
      const double apart = (ours - dense).cwiseAbs().maxCoeff() / dense.cwiseAbs().maxCoeff();
      worst = std::max(worst, apart);
      EXPECT_LT(apart, 1e-9) << "seed " << seed << ", beta " << beta;
      newton.solve(rhs.data(), rhs.data());
      EXPECT_EQ(rhs, solution);
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

// Rollers that roll alike rub on each other at twice their surface speed, and their friction brakes
// both.
TEST(NeighbourContact, SurfacesSlideAtTwiceTheSurfaceSpeed) {
  Scene scene = shipped_scene(kScene);
  scene.lubrication.model = LubricationModel::none;
  scene.model.rollers = RollerModel::planar;
  scene.operation.gravity = 0;
  scene.start.state = StartState::centred;
  BearingModel m = make_bearing_model(scene);
  m.inner_radius -= 1e-3;
  m.outer_radius += 1e-3;
  const StateLayout& l = m.layout;
  std::vector<double> y = start_state(m, scene.start);
  const auto at = [&](int slot) -> double& { return y[static_cast<std::size_t>(slot)]; };
  const double spin = -700, R = 4e-3, depth = 1e-6;
  // Two of them touch, all others stand apart.
  const double chord = 2 * R - depth;
  for (int j = 0; j < l.rollers; ++j) {
    at(l.position(kRadius, j)) = m.pitch_radius + (j < 2 ? 0 : j % 2 == 0 ? 1e-3 : -1e-3);
    at(l.velocity(kSpin, j)) = spin;
    at(l.velocity(kOrbitRate, j)) = 0;
  }
  at(l.position(kAngle, 0)) = 0;
  at(l.position(kAngle, 1)) = 2 * std::asin(chord / (2 * m.pitch_radius));
  System system(m);
  system.linearise_at(0, y.data());
  const auto& force = system.seen.neighbour_force;
  const double Q =
      77652 * std::pow(1e3 * scene.roller.length, 8.0 / 9) * std::pow(1e3 * depth, 10.0 / 9);
  EXPECT_NEAR(force[0], Q, 1e-4 * Q);
  for (std::size_t j = 1; j < 21; ++j) EXPECT_EQ(force[j], 0) << j;
  const double sliding = 2 * std::abs(spin) * R;  // above v_d: mu is that of full sliding
  EXPECT_NEAR(system.seen.friction_power, scene.contact.friction_dynamic * Q * sliding,
              1e-4 * system.seen.friction_power);
  const RollerGroup& g = m.groups[0];
  const double brake = scene.contact.friction_dynamic * Q * R / g.polar[0];
  for (const int j : {0, 1})
    EXPECT_NEAR(system.rate[static_cast<std::size_t>(l.velocity(kSpin, j))], brake, 1e-4 * brake)
        << j;
}

TEST(RollerGap, IsWhatRollersLeaveOnTheirCircle) {
  Scene scene = shipped_scene(kScene);
  const double D = 8e-3, pitch = 53.74e-3;
  EXPECT_NEAR(total_roller_gap(scene), (pi - 21 * std::asin(D / pitch)) * pitch, 1e-9);
  EXPECT_EQ(most_rollers(pitch / 2, D), 21);
  EXPECT_EQ(most_rollers(10e-3, 10e-3), 6);  // six around a seventh
}

void set(toml::table& root, const char* section, const char* key, auto value) {
  root[section].as_table()->insert_or_assign(key, value);
}

std::string refusal(const toml::table& root) {
  try {
    read_scene(root, "test.toml");
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "";
}

TEST(FullComplementScene, RefusesRollersThatDoNotFitAndWhatIsNotModelled) {
  const auto as_shipped = [] {
    return read_toml(shipped(std::string("scenes/") + kScene + ".toml"));
  };
  toml::table more = as_shipped();
  EXPECT_EQ(refusal(more), "");
  set(more, "bearing", "roller_count", 22);
  EXPECT_NE(refusal(more).find("at most 21 rollers"), std::string::npos) << refusal(more);
  toml::table rows = as_shipped();
  set(rows, "bearing", "rows", 2);
  EXPECT_NE(refusal(rows).find("double-row"), std::string::npos) << refusal(rows);
  toml::table split = as_shipped();
  set(split, "cage", "split", true);
  EXPECT_NE(refusal(split).find("split"), std::string::npos) << refusal(split);
  toml::table fewer = as_shipped();
  set(fewer, "bearing", "roller_count", 19);
  EXPECT_FALSE(scene_doubts(read_scene(fewer, "test.toml")).empty());
  EXPECT_TRUE(scene_doubts(read_scene(as_shipped(), "test.toml")).empty());
}

Scene brief_scene(bool lubricated) {
  Scene scene = shipped_scene(kScene);
  if (!lubricated) scene.lubrication.model = LubricationModel::none;
  scene.window.settle_revolutions = 0.5;
  scene.window.measure_revolutions = lubricated ? 1.2 : 0.3;  // dry rollers rattle
  return scene;
}

TEST(FullComplementRun, HasQuantitiesOfNeighboursAndNoneOfACage) {
  for (const bool lubricated : {false, true}) {
    SCOPED_TRACE(lubricated ? "oiled" : "dry");
    const Outcome outcome = simulate(brief_scene(lubricated));
    ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
    EXPECT_LT(outcome.run.energy_residual, 5e-3);
    EXPECT_LT(outcome.run.static_consistency_error, 0.02);
    for (const char* key : {"cage_slip_ratio", "whirl_radius_ratio_mean", "pocket_force_rms_N",
                            "guide_force_peak_N", "end_force_p99_N", "power_land_W"})
      EXPECT_TRUE(std::isnan(quantity(outcome, key))) << key;
    EXPECT_GT(quantity(outcome, "neighbour_force_peak_N"), 0);
    EXPECT_GT(quantity(outcome, "power_neighbour_W"), 0);
    EXPECT_LT(std::abs(quantity(outcome, "orbit_slip_ratio")), 0.05);
  }
}

// All gaps are equal at the start. Rolling holds loaded rollers to the kinematic speed; they push
// those before them, which drag and gravity hold back, where they leave the load zone (theta grows;
// the load is at 270 degrees), and nothing pushes within the load.
TEST(FullComplementRun, RollersPushWhereTheyLeaveTheLoadZone) {
  const Scene scene = brief_scene(true);
  const BearingModel m = make_bearing_model(scene);
  constexpr int sectors = 12;
  double pushed[sectors] = {};
  SimulateOptions options;
  double last = 0;
  options.on_state = [&](double t, const double* y, const System& system) {
    for (int j = 0; j < m.layout.rollers; ++j) {
      const double angle = y[m.layout.position(kAngle, j)] * sectors / (2 * pi);
      const int sector = (static_cast<int>(std::floor(angle)) % sectors + sectors) % sectors;
      pushed[sector] += (t - last) * system.seen.neighbour_force[static_cast<std::size_t>(j)];
    }
    last = t;
  };
  ASSERT_EQ(simulate(scene, options).status, Status::ok);
  double all = 0;
  for (int k = 0; k < sectors; ++k) {
    RecordProperty("sector_" + std::to_string(k), std::to_string(pushed[k] / last));
    all += pushed[k];
  }
  const double entry = pushed[5] + pushed[6], middle = pushed[8] + pushed[9],
               exit = pushed[11] + pushed[0];
  EXPECT_GT(exit, 2 * entry);
  EXPECT_LT(middle, 0.1 * all);
}

TEST(FullComplementRun, SameSceneGivesTheSameBits) {
  const Scene scene = brief_scene(true);
  const Outcome one = simulate(scene), other = simulate(scene);
  for (std::size_t i = 0; i < one.quantities.size(); ++i)
    if (!std::isnan(one.quantities[i])) {
      EXPECT_EQ(one.quantities[i], other.quantities[i]) << i;
    }
}

TEST(FullComplementRun, RollersThatDoNotFitJam) {
  Scene scene = brief_scene(false);
  scene.roller.diameter.assign(21, 8e-3);
  scene.roller.diameter[3] += 0.3e-3;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::jammed);
  EXPECT_NEAR(outcome.interference_um, 98, 15);
}

}  // namespace
}  // namespace cagetol
