// Press fits against finite elements: rings of two-node elements over the radius in plane stress,
// which minimise the elastic energy and know neither Lame's equations nor those of rotating discs.
#include "src/operation/press_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "src/model/bearing_model.hpp"
#include "src/operation/operating_clearance.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

constexpr int kRings = 150;  // elements over the thickness of a body

/// Radial displacements of the nodes of both bodies. Node kRings of the inner body and the first of
/// the outer one are at the seat, where the outer one is farther out by `interference` (of radii):
/// they share one unknown.
struct RadialElements {
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * kRings + 1, 2 * kRings + 1);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * kRings + 1);

  /// Elements of a body from unknown `first`, whose nodes stand `offset` farther out than these.
  void add(const FitBody& body, int first, double offset_at_first) {
    const double from = body.ring.inner_radius, step = (body.ring.outer_radius - from) / kRings;
    const auto& [young, nu, density] = body.ring.material;
    Eigen::Matrix2d law;  // of (strain along the radius, strain around)
    law << 1, nu, nu, 1;
    law *= young / (1 - nu * nu);
    for (int k = 0; k < kRings; ++k) {
      for (const double at : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {  // Gauss points
        const double low = (1 - at) / 2, high = (1 + at) / 2, radius = from + step * (k + high);
        Eigen::Matrix2d strain;
        strain << -1 / step, 1 / step, low / radius, high / radius;
        const Eigen::Vector2d value(low, high), known(k == 0 ? offset_at_first : 0, 0);
        const double volume = radius * step / 2;
        const Eigen::Vector2d free = body.heat * Eigen::Vector2d::Ones();
        stiffness.block<2, 2>(first + k, first + k) += volume * strain.transpose() * law * strain;
        load.segment<2>(first + k) += volume * (strain.transpose() * law * (free - strain * known) +
                                                density * body.speed * body.speed * radius * value);
      }
    }
  }
};

/// Growth of the diameters of bore and raceway of a ring on its shaft, or outside and raceway of a
/// ring in its housing.
struct Grown {
  double seat_inside, seat_outside, end_inside, end_outside;
};
Grown by_finite_elements(const PressFit& fit) {
  RadialElements both;
  both.add(fit.inside, 0, 0);
  both.add(fit.outside, kRings, fit.interference / 2);
  if (fit.inside.ring.inner_radius == 0) {  // the axis stays
    both.stiffness.row(0).setZero();
    both.stiffness.col(0).setZero();
    both.stiffness(0, 0) = 1;
    both.load[0] = 0;
  }
  const Eigen::VectorXd u = both.stiffness.ldlt().solve(both.load);
  return {2 * u[kRings], 2 * u[kRings] + fit.interference, 2 * u[0], 2 * u[2 * kRings]};
}

TEST(PressFitByFiniteElements, AgreesForAnyPairOfBodies) {
  std::mt19937_64 random(11);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const char* names[] = {"bearing-steel", "silicon-nitride", "cast-iron", "aluminium-cast",
                         "brass-cuzn40pb2"};
  int closed = 0;
  for (int k = 0; k < 60; ++k) {
    const double seat = draw(5e-3, 100e-3);
    const auto material = [&] { return material_named(names[random() % 5]).at_room; };
    const double speed = draw(0, 60) / seat;  // up to 60 m/s
    const PressFit fit = {
        {{k % 3 == 0 ? 0 : seat * draw(0.2, 0.8), seat, material()}, draw(-1e-3, 1e-3), speed},
        {{seat, seat * draw(1.1, 2.5), material()}, draw(-1e-3, 1e-3), speed},
        2 * seat * draw(1e-3, 3e-3),
        seat};
    if (fit_state(fit).pressure == 0) continue;
    ++closed;
    const Grown grown = by_finite_elements(fit);
    const double scale = fit.interference;
    EXPECT_NEAR(fit_growth(fit, false, seat).total(), grown.seat_inside, 1e-5 * scale);
    EXPECT_NEAR(fit_growth(fit, true, seat).total(), grown.seat_outside, 1e-5 * scale);
    EXPECT_NEAR(fit_growth(fit, true, fit.outside.ring.outer_radius).total(), grown.end_outside,
                1e-5 * scale);
    if (fit.inside.ring.inner_radius > 0) {
      EXPECT_NEAR(fit_growth(fit, false, fit.inside.ring.inner_radius).total(), grown.end_inside,
                  1e-5 * scale);
    }
  }
  EXPECT_GT(closed, 30);
}

/// The NU 205 on a hollow shaft in a housing of cast iron, warm and turning: its raceways.
TEST(PressFitByFiniteElements, AgreesForTheRacewaysOfABearing) {
  Scene scene;
  scene.fit.inner_interference = 14e-6;
  scene.fit.shaft_bore = 8e-3;
  scene.fit.outer_interference = 16e-6;
  scene.fit.housing_diameter = 90e-3;
  scene.temperature.growth = true;
  scene.temperature.inner_ring = 80;
  scene.temperature.shaft = 75;
  scene.temperature.outer_ring = 60;
  scene.temperature.housing = 50;
  scene.operation.inner_speed = 1600;
  scene.operation.centrifugal_growth = true;
  const Material steel = ring_material(scene), iron = material_named("cast-iron").at_room;
  const double cold = 20, alpha = 12e-6, iron_alpha = 10.5e-6;
  const PressFit inner = {{{4e-3, 12.5e-3, steel}, alpha * (75 - cold), 1600},
                          {{12.5e-3, 15.75e-3, steel}, alpha * (80 - cold), 1600},
                          14e-6,
                          12.5e-3};
  const PressFit outer = {{{23.25e-3, 26e-3, steel}, alpha * (60 - cold), 0},
                          {{26e-3, 45e-3, iron}, iron_alpha * (50 - cold), 0},
                          16e-6,
                          26e-3};
  const double inner_raceway = by_finite_elements(inner).end_outside,
               outer_raceway = by_finite_elements(outer).end_inside;
  const OperatingClearance by = operating_clearance(scene);
  EXPECT_GT(by.inner_fit.pressure, 1e6);
  EXPECT_GT(by.outer_fit.pressure, 1e6);
  EXPECT_NEAR(by.inner_raceway.total() / inner_raceway, 1, 1e-5);
  EXPECT_NEAR(by.outer_raceway.total() / outer_raceway, 1, 1e-5);
  const BearingModel model = make_bearing_model(scene);
  EXPECT_NEAR(2 * (model.outer_radius - model.inner_radius),
              15e-3 + 30e-6 + outer_raceway - inner_raceway, 0.05e-6);
}

/// What leaving the shoulders out is worth at most: an outer ring as thick all along as there.
TEST(PressFitByFiniteElements, BoundsTheStiffnessOfShoulders) {
  const Material steel = material_named("bearing-steel").at_room,
                 iron = material_named("cast-iron").at_room;
  const auto ring = [&](double bore) {
    return PressFit{{{bore, 26e-3, steel}}, {{26e-3, 45e-3, iron}}, 16e-6, 26e-3};
  };
  const double plain = by_finite_elements(ring(23.25e-3)).end_inside;  // at the raceway
  const double stout = fit_growth(ring(21.9e-3), false, 23.25e-3).total();
  EXPECT_NEAR(stout / plain, 0.84, 0.005);
}

}  // namespace
}  // namespace cagetol
