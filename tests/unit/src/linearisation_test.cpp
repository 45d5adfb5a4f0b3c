// Derivatives of the right-hand side, and the structured solver built on them, against dense
// references.
#include "src/newton/linearisation.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

#include "src/integration/integrator.hpp"
#include "src/newton/newton_matrix.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/dense_jacobian.hpp"
#include "tests/support/random_bearing.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

struct Linearised {
  RandomBearing bearing;
  System system;
  Eigen::MatrixXd assembled;
  explicit Linearised(const RandomBearing& b) : bearing(b), system(bearing.model) {
    system.linearise_at(bearing.t, bearing.y.data());
    assembled = assembled_jacobian(bearing.model, bearing.y, system.linear);
  }
};

/// Largest entry of a matrix in error scales, so that every component counts alike.
double size_in_scales(const Eigen::MatrixXd& J, const PackVector& scale, int first_row,
                      int last_row) {
  double size = 0;
  for (int i = first_row; i < last_row; ++i)
    for (int k = 0; k < J.cols(); ++k) {
      const double row = scale[static_cast<std::size_t>(i)],
                   column = scale[static_cast<std::size_t>(k)];
      if (row < 1e20 && column < 1e20) size = std::max(size, std::abs(J(i, k)) * column / row);
    }
  return size;
}

double relative_difference(const RandomBearing& bearing, double step) {
  const Linearised x(bearing);
  const auto& scale = x.system.scale;
  const Eigen::MatrixXd differenced =
      differenced_jacobian(x.bearing.model, x.bearing.t, x.bearing.y, scale, step);
  const int n = x.system.size;
  const double share = size_in_scales(x.assembled - differenced, scale, 0, n) /
                       size_in_scales(differenced, scale, 0, n);
  EXPECT_TRUE(std::isfinite(share));  // a maximum passes over what is not a number
  return share;
}

/// Rigid and flexible cages by turns.
RandomBearing bearing(unsigned seed, Freedom freedom) {
  return random_bearing(seed, {.modes = seed % 2 == 0 ? 0 : 5, .freedom = freedom});
}

/// The same with a cage that nothing touches.
RandomBearing free_cage(unsigned seed, Freedom freedom) {
  RandomBearing b = bearing(seed, freedom);
  for (CageGuide& guide : b.model.guides) guide.touching_at = 1;
  for (RollerGroup& group : b.model.groups) {
    group.half_width += 1e-2;
    group.half_length += 1e-2;
  }
  return b;
}

class Linearisation : public testing::TestWithParam<Freedom> {};
class NewtonMatrixOfRollers : public testing::TestWithParam<Freedom> {};
const auto kFreedoms = testing::Values(Freedom::spatial, Freedom::tilting);

INSTANTIATE_TEST_SUITE_P(Rollers, Linearisation, kFreedoms,
                         [](const auto& test) { return freedom_name(test.param); });
INSTANTIATE_TEST_SUITE_P(Rollers, NewtonMatrixOfRollers, kFreedoms,
                         [](const auto& test) { return freedom_name(test.param); });

TEST_P(Linearisation, RatesAreThoseOfTheRightHandSide) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Linearised x(seed % 4 == 3 ? free_cage(seed, GetParam()) : bearing(seed, GetParam()));
    const int n = x.system.size;
    std::vector<double> rates(x.bearing.y.size());
    evaluate_rates(x.bearing.model, x.bearing.t, x.bearing.y.data(), rates.data());
    // The same expressions; the compiler may fuse them differently.
    double size = 0, apart = 0;
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      apart = std::max(apart, std::abs(rates[k] - x.system.rate[k]) / x.system.scale[k]);
      size = std::max(size, std::abs(rates[k]) / x.system.scale[k]);
    }
    EXPECT_LT(apart, 1e-12 * size) << seed;
  }
}

TEST_P(Linearisation, RatesChangeWithTimeAsWavesPass) {
  for (const bool lubricated : {false, true}) {
    RandomBearing b =
        random_bearing(2, {.freedom = GetParam(), .lubricated = lubricated, .wavy = true});
    b.t = 5e-3;  // after the ramps
    System system(b.model);
    const double dt = 1e-6;
    ASSERT_TRUE(system.driven_by_time(b.t));
    system.linearise_at(b.t, b.y.data());
    std::vector<double> ahead(b.y.size()), behind(b.y.size()), found(b.y.size());
    evaluate_rates(b.model, b.t + dt, b.y.data(), ahead.data());
    evaluate_rates(b.model, b.t - dt, b.y.data(), behind.data());
    system.rates_by_time(b.t, b.y.data(), found.data());
    double size = 0, apart = 0;
    for (std::size_t i = 0; i < b.y.size(); ++i) {
      const double due = (ahead[i] - behind[i]) / (2 * dt);
      size = std::max(size, std::abs(due) / system.scale[i]);
      apart = std::max(apart, std::abs(due - found[i]) / system.scale[i]);
    }
    EXPECT_LT(apart, 1e-2 * size);
    const int roller = b.model.layout.velocity(kRadialSpeed, 0);
    EXPECT_NE(found[static_cast<std::size_t>(roller)], 0);
  }
}

TEST_P(Linearisation, RatesChangeWithTimeAsTheRampsDo) {
  for (const bool turning : {false, true})
    for (const bool speed_too : {false, true}) {
      RandomBearing b = bearing(1, GetParam());
      Duty& duty = b.model.duty;
      duty.fixed = {0, -1000, 3, -2};
      duty.load_ramp = 1e-3;
      duty.speed_ramp = speed_too ? 1e-3 : 0;
      duty.speed_from = {0.5 * duty.speed.inner, 100};
      if (turning) duty.rotating = 700, duty.rotating_speed = -900, duty.unbalance = 1e-3;
      System system(b.model);
      const double t = 4e-4, dt = 1e-6;
      system.linearise_at(t, b.y.data());
      std::vector<double> ahead(b.y.size()), behind(b.y.size()), found(b.y.size());
      evaluate_rates(b.model, t + dt, b.y.data(), ahead.data());
      evaluate_rates(b.model, t - dt, b.y.data(), behind.data());
      system.rates_by_time(t, b.y.data(), found.data());
      double size = 0, apart = 0;
      for (std::size_t i = 0; i < b.y.size(); ++i) {
        const double due = (ahead[i] - behind[i]) / (2 * dt);
        size = std::max(size, std::abs(due) / system.scale[i]);
        apart = std::max(apart, std::abs(due - found[i]) / system.scale[i]);
      }
      EXPECT_GT(size, 0);
      EXPECT_LT(apart, 1e-3 * size) << speed_too;
    }
}

TEST_P(Linearisation, ForgetsWhatTouchedTheCage) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    Linearised x(bearing(seed, GetParam()));
    const Eigen::MatrixXd touched = x.assembled;
    const BearingModel model = x.bearing.model;
    const auto linearised_anew = [&](const BearingModel& as) {
      x.bearing.model = as;
      x.system.linearise_at(x.bearing.t, x.bearing.y.data());
      return assembled_jacobian(x.bearing.model, x.bearing.y, x.system.linear);
    };
    const Linearised free(free_cage(seed, GetParam()));
    EXPECT_EQ(linearised_anew(free.bearing.model), free.assembled) << seed;
    EXPECT_EQ(linearised_anew(model), touched) << seed;
  }
}

// Left out of the derivatives: normal damping times the change of p' with position (the orbit's
// speed times a lean, at bars, walls and flanges), and lean angles times the sliding slope. These
// states, 30 um deep in every contact at once with leans of 2 mrad, are far beyond what a run
// meets.
TEST_P(Linearisation, AgreesWithDifferencesButForStatedTerms) {
  double worst = 0;
  for (unsigned seed = 0; seed < 48; ++seed)
    worst = std::max(worst, relative_difference(bearing(seed, GetParam()), 1e-4));
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 0.04);
}

// Left out as well: friction on an arc turns with its normal.
TEST(LinearisationOfPockets, AgreesWithDifferencesOnEdgesLipsAndCurvedFaces) {
  for (const Outline outline : {Outline::edges, Outline::lips, Outline::curved})
    for (const bool lubricated : {false, true}) {
      double worst = 0;
      for (unsigned seed = 0; seed < 24; ++seed)
        worst = std::max(worst,
                         relative_difference(random_bearing(seed, {.modes = seed % 2 == 0 ? 0 : 5,
                                                                   .lubricated = lubricated,
                                                                   .outline = outline}),
                                             1e-4));
      EXPECT_LT(worst, 0.04) << outline_name(outline) << (lubricated ? ", oiled" : ", dry");
    }
}

/// Loaded races, the ring moving, rollers slipping a little.
RandomBearing loaded_races(ForceLaw law, Freedom freedom) {
  RandomBearing b;
  b.scene.contact.race.law = law;
  if (freedom == Freedom::tilting) b.scene.model.ring_tilt = TiltModel::free;
  b.model = make_bearing_model(b.scene);
  const StateLayout& l = b.model.layout;
  b.y = start_state(b.model, b.scene.start);
  b.y[static_cast<std::size_t>(l.border_velocity(kRingZ))] = 0.02;
  b.y[static_cast<std::size_t>(l.border_velocity(kRingY))] = 0.01;
  for (int j = 0; j < l.rollers; ++j) b.y[static_cast<std::size_t>(l.velocity(kSpin, j))] *= 1.003;
  return b;
}

TEST_P(Linearisation, LoadedRacesAreExact) {
  for (const ForceLaw law : {ForceLaw::hertz, ForceLaw::impact}) {
    const RandomBearing b = loaded_races(law, GetParam());
    // What differencing can tell: the error of its own falls with the step squared, down to 1e-7 at
    // this one.
    EXPECT_LT(relative_difference(b, 1e-4), 2e-7) << spelled(law);
  }
}

TEST_P(Linearisation, WavyRacesAreExact) {
  for (const bool lubricated : {false, true})
    for (const ForceLaw law : {ForceLaw::hertz, ForceLaw::impact}) {
      if (lubricated && law == ForceLaw::impact) continue;
      RandomBearing b = loaded_races(law, GetParam());
      b.scene.bearing.inner_waviness = {Waviness{4e-6, 2, 0.3}, Waviness{1e-6, 9, -1}};
      b.scene.bearing.outer_waviness = {Waviness{3e-6, 3, 2}, Waviness{}};
      b.scene.operation.outer_speed = -100;
      if (lubricated) b.scene.lubrication.model = LubricationModel::film;
      b.model = make_bearing_model(b.scene);
      b.t = 0.7e-3;
      EXPECT_LT(relative_difference(b, lubricated ? 1e-5 : 1e-4), 2e-6)
          << spelled(law) << (lubricated ? ", lubricated" : ", dry");
    }
}

/// A bearing full of oil, as loaded_races.
RandomBearing lubricated_races(Freedom freedom) {
  RandomBearing b = loaded_races(ForceLaw::hertz, freedom);
  b.scene.lubrication.model = LubricationModel::film;
  b.model = make_bearing_model(b.scene);
  return b;
}

TEST_P(Linearisation, LubricatedRacesAreExact) {
  for (const double speed : {1.0, 1e-3, 0.0}) {
    RandomBearing b = lubricated_races(GetParam());
    const StateLayout& l = b.model.layout;
    b.model.duty.speed.inner *= speed;
    b.model.duty.speed_from.inner = b.model.duty.speed.inner;
    for (int j = 0; j < l.rollers; ++j)
      for (const RollerVelocity slot : {kOrbitRate, kSpin})
        b.y[static_cast<std::size_t>(l.velocity(slot, j))] *= speed;
    // Close to standstill a film bends within shorter steps.
    EXPECT_LT(relative_difference(b, 1e-5), 1e-6) << speed;
  }
}

TEST_P(Linearisation, AgreesWithDifferencesWhereEverythingIsLubricated) {
  double worst = 0;
  for (unsigned seed = 0; seed < 48; ++seed)
    worst = std::max(worst,
                     relative_difference(
                         random_bearing(seed, {.freedom = GetParam(), .lubricated = true}), 1e-4));
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 0.04);
}

// A linearly implicit step pays for a missing derivative by what the state's own motion makes of
// it, however small beside the largest: rollers travel at metres a second round a misaligned ring
// that stands still, and past flanges. Rates along the motion, in error scales, of a step of 10 us.
TEST(LinearisationAlongTheMotion, IsExactInARun) {
  const Scene scene = shipped_scene("speed-z16-skew");
  const BearingModel model = make_bearing_model(scene);
  System system(model);
  std::vector<double> y = start_state(model, scene.start), moved(y), ahead(y), behind(y);
  const auto integrator = make_integrator(scene.integration, system, 0, y.data());
  // Differences so short that the bend of a slice which has just touched does not tell.
  const double step = 1e-5, little = 2e-10;
  std::vector<double> missed;
  long on_flange = 0;
  double t = 0;
  for (long taken = 0; t < 20e-3; ++taken) {
    ASSERT_TRUE(system.linearise_at(t, y.data()));
    if (taken % 4 == 0) {
      const Eigen::VectorXd due =
          assembled_jacobian(model, y, system.linear) *
          Eigen::Map<const Eigen::VectorXd>(system.rate.data(), system.size);
      const auto rates_at = [&](double later, std::vector<double>& rates) {
        for (std::size_t i = 0; i < y.size(); ++i) moved[i] = y[i] + later * system.rate[i];
        evaluate_rates(model, t, moved.data(), rates.data());
      };
      rates_at(little, ahead);
      rates_at(-little, behind);
      double worst = 0;
      for (std::size_t i = 0; i < y.size(); ++i)
        worst = std::max(worst, std::abs((ahead[i] - behind[i]) / (2 * little) -
                                         due[static_cast<Eigen::Index>(i)]) *
                                    step * step / system.scale[i]);
      missed.push_back(worst);
      const auto& flange = system.seen.flange_force;
      if (*std::max_element(flange.begin(), flange.end()) > 0) ++on_flange;
    }
    ASSERT_EQ(integrator->step(system, t, y.data(), 20e-3), StepStatus::accepted);
  }
  std::sort(missed.begin(), missed.end());
  RecordProperty("worst", std::to_string(missed.back()));
  EXPECT_GT(on_flange, 10);
  EXPECT_LT(missed[missed.size() * 9 / 10], 1e-4);
  EXPECT_LT(missed.back(), 1e-3);
}

TEST_P(NewtonMatrixOfRollers, SolvesLikeDenseFactorsOfTheAssembledMatrix) {
  std::mt19937_64 engine(3);
  double worst = 0;
  for (unsigned seed = 0; seed < 96; ++seed) {
    const Linearised x(seed < 48 ? bearing(seed, GetParam()) : free_cage(seed, GetParam()));
    const int n = x.system.size;
    const bool floats = x.bearing.model.layout.ring_axial > 0;
    ASSERT_EQ(x.system.linear.cage_touched, seed < 48 || floats);
    for (double beta : {1e-8, 1e-6, 2e-5}) {
      NewtonMatrix newton(x.bearing.model);
      ASSERT_TRUE(newton.factor(x.system.linear, beta));
      Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n), solution(n), scale(n);
      for (int i = 0; i < n; ++i) {
        scale[i] = x.system.scale[static_cast<std::size_t>(i)];
        if (scale[i] > 1e20)
          scale[i] = 1;
        else
          rhs[i] = scale[i] * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1);
      }
      newton.solve(rhs.data(), solution.data());
      // Equilibrated with the scales, so that the dense factors lose nothing to units.
      const Eigen::MatrixXd J =
          scale.cwiseInverse().asDiagonal() * x.assembled * scale.asDiagonal();
      const Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n) / beta - J;
      const Eigen::VectorXd dense =
          Eigen::PartialPivLU<Eigen::MatrixXd>(A).solve(scale.cwiseInverse().cwiseProduct(rhs));
      const Eigen::VectorXd ours = scale.cwiseInverse().cwiseProduct(solution);
      const double apart = (ours - dense).cwiseAbs().maxCoeff() / dense.cwiseAbs().maxCoeff();
      worst = std::max(worst, apart);
      EXPECT_LT(apart, kSanitized ? 1e-10 : 1e-11) << "seed " << seed << ", beta " << beta;
      // The right-hand side may be the solution's own storage.
      newton.solve(rhs.data(), rhs.data());
      EXPECT_EQ(rhs, solution);
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

}  // namespace
}  // namespace cagetol
