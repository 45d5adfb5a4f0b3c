// The guide film: Reynolds' equation by quadrature, Ocvirk's and Petroff's closed forms, limits,
// derivatives, and a run.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "src/contact_laws/short_bearing.hpp"
#include "src/integration/system.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/dense_jacobian.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kViscosity = 0.02, kGuideRadius = 21.8e-3, kWidth = 2.4e-3, kClearance = 0.2e-3;
const ShortBearing kBearing{true,
                            kViscosity* kGuideRadius* kWidth* kWidth* kWidth,
                            2 * pi* kViscosity* kGuideRadius* kGuideRadius* kGuideRadius* kWidth,
                            2 * pi* kViscosity* kGuideRadius* kWidth,
                            kClearance,
                            1e-6};

/// Gaps up to which oil fills the bearing: all of it, more than it, most and little of it [m].
constexpr double kLayers[] = {std::numeric_limits<double>::infinity(), 0.5e-3, 0.25e-3, 50e-6};
ShortBearing filled_up_to(double layer) {
  ShortBearing bearing = kBearing;
  bearing.layer = layer;
  return bearing;
}

/// Force on the journal from the pressure itself: parabola over the width, no suction, a meniscus.
/// The last one: torque over the difference of spins.
void integrated(const double D[2], const double V[2], double layer, double force[3]) {
  force[0] = force[1] = force[2] = 0;
  const int points = 200000;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * pi * (i + 0.5) / points, y = std::cos(angle), z = std::sin(angle);
    const double h = kClearance - D[0] * y - D[1] * z, closing = V[0] * y + V[1] * z;
    if (h >= layer) continue;
    force[2] += kViscosity * kGuideRadius * kGuideRadius * kGuideRadius * kWidth *
                (1 / h - 1 / layer) * 2 * pi / points;
    if (closing <= 0) continue;
    const double oil = (1 - h / layer) * (1 - h / layer);
    const double at_middle = 12 * kViscosity * closing * oil / (h * h * h) * kWidth * kWidth / 8;
    const double strip = 2.0 / 3 * at_middle * kWidth * kGuideRadius * 2 * pi / points;
    force[0] -= strip * y;
    force[1] -= strip * z;
  }
}

TEST(GuideFilm, ForceIsTheIntegralOfThePressure) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 40; ++k) {
    const double size = k == 0 ? 0 : 0.95 * kClearance * std::abs(unit(engine)),
                 angle = pi * unit(engine);
    const double D[2] = {size * std::cos(angle), size * std::sin(angle)},
                 V[2] = {0.1 * unit(engine), 0.1 * unit(engine)};
    const double layer = kLayers[k % 4];
    double expected[3];
    integrated(D, V, layer, expected);
    const auto film = short_bearing_film(filled_up_to(layer), D, V);
    const double scale = std::hypot(expected[0], expected[1]);
    EXPECT_NEAR(film.torque, expected[2], 1e-6 * expected[2]) << k;
    EXPECT_NEAR(film.force[0], expected[0], 1e-8 * scale) << k;
    EXPECT_NEAR(film.force[1], expected[1], 1e-8 * scale) << k;
  }
}

TEST(GuideFilm, LoadAndAttitudeAreOcvirks) {
  const double spin = 600;
  for (const double eps : {0.01, 0.1, 0.5, 0.9, 0.98}) {
    const double D[2] = {eps * kClearance, 0}, V[2] = {0, -spin / 2 * D[0]};
    const auto film = short_bearing_film(kBearing, D, V);
    const double rest = 1 - eps * eps;
    const double load = kViscosity * spin * kGuideRadius * std::pow(kWidth, 3) /
                        (4 * kClearance * kClearance) * eps / (rest * rest) *
                        std::sqrt(pi * pi * rest + 16 * eps * eps);
    EXPECT_NEAR(std::hypot(film.force[0], film.force[1]) / load, 1, 1e-12) << eps;
    EXPECT_LT(film.force[0], 0);  // back to the middle, and on in the sense of rotation
    EXPECT_NEAR(film.force[1] / -film.force[0], pi * std::sqrt(rest) / (4 * eps), 1e-9) << eps;
  }
}

TEST(GuideFilm, TorqueIsPetroffsWhereCentred) {
  const double still[2] = {0, 0};
  const auto film = short_bearing_film(kBearing, still, still);
  const double shear = kViscosity / kClearance;  // [Pa s/m]
  EXPECT_NEAR(film.torque, shear * kGuideRadius * 2 * pi * kGuideRadius * kWidth * kGuideRadius,
              1e-12 * film.torque);
  EXPECT_NEAR(film.axial, shear * 2 * pi * kGuideRadius * kWidth, 1e-12 * film.axial);
  EXPECT_EQ(film.force[0], 0);
  EXPECT_EQ(film.force[1], 0);
}

TEST(GuideFilm, DerivativesAreThoseOfDifferences) {
  std::mt19937_64 engine(6);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 60; ++k) {
    // Up to and past the end of the film at 198 um.
    const double size = kClearance * (k % 3 == 0 ? 0.995 + 0.02 * std::abs(unit(engine))
                                                 : std::abs(unit(engine))),
                 angle = pi * unit(engine);
    const double D[2] = {size * std::cos(angle), size * std::sin(angle)},
                 V[2] = {0.1 * unit(engine), 0.1 * unit(engine)};
    const ShortBearing bearing = filled_up_to(kLayers[k % 4]);
    const auto film = short_bearing_film(bearing, D, V);
    double damping = 0, stiffness = 0;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        damping = std::max(damping, std::abs(film.damping[i][j]));
        stiffness = std::max(stiffness, std::abs(film.stiffness[i][j]));
      }
    for (int j = 0; j < 2; ++j) {
      const auto moved = [&](double place, double speed) {
        double D2[2] = {D[0], D[1]}, V2[2] = {V[0], V[1]};
        D2[j] += place;
        V2[j] += speed;
        return short_bearing_film(bearing, D2, V2);
      };
      const double step = 1e-4 * std::max(kClearance - size, kBearing.minimum), faster = 1e-6;
      const auto up = moved(step, 0), down = moved(-step, 0), fast = moved(0, faster),
                 slow = moved(0, -faster);
      for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR((down.force[i] - up.force[i]) / (2 * step), film.stiffness[i][j],
                    1e-5 * stiffness)
            << k;
        EXPECT_NEAR((slow.force[i] - fast.force[i]) / (2 * faster), film.damping[i][j],
                    1e-6 * damping)
            << k;
      }
      EXPECT_NEAR((up.torque - down.torque) / (2 * step), film.torque_slope * film.direction[j],
                  1e-5 * film.torque_slope)
          << k;
    }
  }
}

TEST(GuideFilm, EndsAtItsLeastHeight) {
  const double V[2] = {0.05, -0.03};
  double before = 0;
  for (const double e : {0.0, 0.5, 0.9, 0.98, 0.99, 0.995, 1.0, 1.05, 1.5, 100.0}) {
    const double D[2] = {e * kClearance, 0};
    const double outward[2] = {0.05, 0};
    const auto film = short_bearing_film(kBearing, D, outward);
    EXPECT_TRUE(std::isfinite(film.force[0]) && std::isfinite(film.torque)) << e;
    EXPECT_GT(-film.force[0], before) << e;  // ever harder to squeeze
    before = -film.force[0];
  }
  // At the minimum height everywhere beyond: the film cannot be squeezed harder than there.
  const double last[2] = {1e6, 0}, outward[2] = {0.05, 0},
               edge[2] = {kClearance - kBearing.minimum, 0};
  ShortBearing thin = kBearing;
  thin.minimum = 1e-9;
  EXPECT_NEAR(short_bearing_film(kBearing, last, outward).force[0] /
                  short_bearing_film(thin, edge, outward).force[0],
              1, 1e-6);
  const double free = kClearance - 2 * kBearing.minimum;
  for (const double side : {-1e-13, 1e-13}) {
    const double D[2] = {free + side, 0}, at[2] = {free, 0};
    EXPECT_NEAR(
        short_bearing_film(kBearing, D, V).force[1] / short_bearing_film(kBearing, at, V).force[1],
        1, 1e-6);
  }
}

/// No oil but at races and lands.
Scene oiled(Guidance guidance = Guidance::outer) {
  Scene scene = shipped_scene("nu205");
  scene.cage.model = CageKind::rigid;
  Lubrication& oil = scene.lubrication;
  oil.viscosity = kViscosity;
  oil.squeeze = oil.rolling_resistance = oil.film_traction = false;
  oil.pocket_film = oil.end_film = oil.churning = false;
  scene.start.state = StartState::equilibrium;
  scene.cage.guidance = guidance;
  if (guidance == Guidance::inner) scene.cage.guide_clearance = 0.2e-3;
  return scene;
}

// Nothing else touches the cage: its rows of the Newton matrix are the film's alone.
TEST(GuideFilm, NewtonMatrixIsThatOfDifferences) {
  for (const Guidance guidance : {Guidance::outer, Guidance::inner}) {
    Scene scene = oiled(guidance);
    scene.start.cage_offset_y = 60e-6;
    scene.start.cage_offset_z = -30e-6;
    scene.bearing.misalignment_y = 1e-3;
    const BearingModel model = make_bearing_model(scene);
    const StateLayout& l = model.layout;
    auto y = start_state(model, scene.start);
    const double rates[] = {0.01, -0.02, 0.1, -0.05, 0.02, 260, 0.5, -0.8};
    for (int i = 0; i < kRigidBorder; ++i) {
      y[static_cast<std::size_t>(l.border_velocity(i))] = rates[i];
    }
    y[static_cast<std::size_t>(l.border_position(kCageAxisY))] = 1e-3;
    System system(model);
    system.linearise_at(0, y.data());
    ASSERT_EQ(system.linear.coupled, 0);
    const Eigen::MatrixXd ours = assembled_jacobian(model, y, system.linear),
                          theirs = differenced_jacobian(model, 0, y, system.scale, 1e-3);
    for (int i = kCageY; i < kRigidBorder; ++i) {
      const int row = l.border_velocity(i);
      double apart = 0, size = 0;
      for (int j = 0; j < l.border(); ++j)
        for (const int column : {l.border_position(j), l.border_velocity(j)}) {
          const double scale = system.scale[static_cast<std::size_t>(column)];
          apart = std::max(apart, std::abs(ours(row, column) - theirs(row, column)) * scale);
          size = std::max(size, std::abs(theirs(row, column)) * scale);
        }
      EXPECT_GT(size, 0) << i;
      // Left out: the mass centre turns about the middle, some nanometres.
      EXPECT_LT(apart, 1e-5 * size) << spelled(guidance) << ", row " << i;
    }
  }
}

TEST(GuideFilm, CarriesTheCageOfARun) {
  Scene scene = oiled(), dry = oiled();
  dry.lubrication.land_film = false;
  for (Scene* s : {&scene, &dry}) {
    s->window.settle_time = 0.01;
    s->window.measure_time = 0.02;
    s->integration.tolerance = 1e-5;  // the account is to close, whatever the default leaves open
  }
  const Outcome oil = simulate(scene), touching = simulate(dry);
  ASSERT_EQ(oil.status, Status::ok) << oil.reason;
  // Of a single run's residual a third is chance, of the mean of starts less.
  double residual = oil.run.energy_residual;
  constexpr int starts = 4;
  for (int k = 1; k < starts; ++k) {
    scene.start.cage_phase += std::numbers::pi / 180;
    residual += simulate(scene).run.energy_residual;
  }
  EXPECT_LT(residual / starts, 1e-4);
  EXPECT_LT(quantity(oil, "guide_impacts_per_revolution"), 1);
  EXPECT_GT(quantity(touching, "guide_impacts_per_revolution"), 10);
  EXPECT_GT(quantity(oil, "guide_force_rms_N"), 0.2);  // the cage's weight at least
  EXPECT_LT(quantity(oil, "whirl_radius_ratio_peak"), 1);
  // Two lands rub in oil: Petroff's loss at the cage's speed is the least.
  const BearingModel model = make_bearing_model(scene);
  const double speed = kinematic_cage_speed(model, model.duty.speed);
  const double petroff = 2 * model.guides[0].film.torque / model.guide_clearance * speed * speed;
  EXPECT_GT(quantity(oil, "power_loss_W"), petroff);
  EXPECT_LT(quantity(oil, "power_loss_W"), quantity(touching, "power_loss_W") + 3 * petroff);
}

}  // namespace
}  // namespace cagetol
