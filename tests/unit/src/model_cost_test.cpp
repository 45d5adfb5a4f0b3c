// What a scene switches off costs nothing: a simpler model is never dearer than the fuller one.
// Processor time, least of many repetitions taken by turns, so that a busy machine tells the same.
#include <gtest/gtest.h>
#include <algorithm>
#include <ctime>
#include <vector>

#include "src/dynamics/newton_matrix.hpp"
#include "src/dynamics/start_state.hpp"
#include "src/integration/system.hpp"
#include "tests/support/random_bearing.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// A bearing at a state with contacts.
struct Bearing {
  BearingModel model;
  std::vector<double> y;
};

Bearing loaded(const Scene& scene) {
  Bearing bearing{make_bearing_model(scene), {}};
  bearing.y = start_state(bearing.model, scene.start);
  return bearing;
}

Scene speed_scene() {
  Scene scene = shipped_scene("speed-z16");
  scene.start.state = "equilibrium";
  scene.operation.load_ramp = 0;
  return scene;
}

class Kernels {
 public:
  explicit Kernels(const Bearing& bearing)
      : y_(bearing.y), system_(bearing.model), newton_(bearing.model), rates_(y_.size()) {}

  void right_hand_side() { system_.rates(0, y_.data(), rates_.data()); }
  /// The work of a step of the default method: derivatives, factors, six stages.
  void step() {
    system_.linearise_at(0, y_.data());
    newton_.factor(system_.linear, 2e-6);
    for (int stage = 0; stage < 6; ++stage) {
      right_hand_side();
      newton_.solve(rates_.data(), rates_.data());
    }
  }

 private:
  std::vector<double> y_;
  System system_;
  NewtonMatrix newton_;
  std::vector<double> rates_;
};

double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Time of `simpler` over that of `fuller`.
template <class Work>
double cost_ratio(Kernels& simpler, Kernels& fuller, int calls, Work work) {
  double least[2] = {1e30, 1e30};
  for (int repetition = 0; repetition < 200; ++repetition)
    for (int which = 0; which < 2; ++which) {
      Kernels& kernels = which == 0 ? simpler : fuller;
      const double began = cpu_seconds();
      for (int k = 0; k < calls; ++k) work(kernels);
      least[which] = std::min(least[which], cpu_seconds() - began);
    }
  return least[0] / least[1];
}

void expect_not_dearer(const Bearing& simpler, const Bearing& fuller) {
  Kernels a(simpler), b(fuller);
  const double rates = cost_ratio(a, b, 100, [](Kernels& k) { k.right_hand_side(); });
  const double step = cost_ratio(a, b, 10, [](Kernels& k) { k.step(); });
  testing::Test::RecordProperty("rates", std::to_string(rates));
  testing::Test::RecordProperty("step", std::to_string(step));
  EXPECT_LT(rates, 1.1);
  EXPECT_LT(step, 1.1);
}

TEST(ModelCost, PlanarRollersAreNotDearerThanSpatialOnes) {
  for (const long slices : {1L, 5L}) {
    Scene scene = speed_scene();
    scene.discretisation.race_slices = slices;
    const Bearing spatial = loaded(scene);
    scene.model.rollers = "planar";
    expect_not_dearer(loaded(scene), spatial);
  }
}

TEST(ModelCost, NoFilmIsNotDearerThanAFilm) {
  Scene scene = speed_scene();
  const Bearing dry = loaded(scene);
  scene.film.model = "series";
  expect_not_dearer(dry, loaded(scene));
}

TEST(ModelCost, DryLandsAreNotDearerThanOiledOnes) {
  Scene scene = speed_scene();
  const Bearing dry = loaded(scene);
  scene.cage.guide_film.model = "short-bearing";
  expect_not_dearer(dry, loaded(scene));
}

TEST(ModelCost, APrescribedTiltOfTheRingIsNotDearerThanAFreeOne) {
  Scene scene = speed_scene();
  const Bearing prescribed = loaded(scene);
  scene.model.ring_tilt = "free";
  expect_not_dearer(prescribed, loaded(scene));
}

TEST(ModelCost, ARigidCageIsNotDearerThanAFlexibleOne) {
  const RandomBearing rigid = random_bearing(3), flexible = random_bearing(3, {.modes = 20});
  expect_not_dearer({rigid.model, rigid.y}, {flexible.model, flexible.y});
}

}  // namespace
}  // namespace cagetol
