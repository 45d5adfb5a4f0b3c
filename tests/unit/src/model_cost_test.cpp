// What a scene switches off costs nothing: a simpler model is never dearer than the fuller one.
// Instructions, not time: a busy machine counts the same.
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "src/integration/system.hpp"
#include "src/newton/newton_matrix.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/instruction_count.hpp"
#include "tests/support/random_bearing.hpp"
#include "tests/support/sanitizers.hpp"
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
  scene.start.state = StartState::equilibrium;
  scene.operation.load_ramp = 0;
  return scene;
}

class Kernels {
 public:
  explicit Kernels(const Bearing& bearing)
      : y_(bearing.y), system_(bearing.model), newton_(bearing.model), rates_(y_.size()) {}

  void right_hand_side() { system_.rates(0, y_.data(), rates_.data()); }
  /// What a step of the default method does besides right-hand sides.
  void newton() {
    system_.linearise_at(0, y_.data());
    newton_.factor(system_.linear, 2e-6);
    newton_.solve(rates_.data(), rates_.data());
  }

 private:
  std::vector<double> y_;
  System system_;
  NewtonMatrix newton_;
  std::vector<double> rates_;
};

/// Instructions of `simpler` over those of `fuller`; nothing where they cannot be counted.
template <class Work>
std::optional<double> cost_ratio(const Bearing& simpler, const Bearing& fuller, Work work) {
  const auto count = [&](const Bearing& bearing) {
    Kernels kernels(bearing);
    work(kernels);  // what is only done once
    return instructions_of([&] { work(kernels); });
  };
  const auto less = count(simpler), more = count(fuller);
  if (!less || !more) return {};
  return static_cast<double>(*less) / static_cast<double>(*more);
}

void expect_not_dearer(const Bearing& simpler, const Bearing& fuller) {
  if (kSanitized) GTEST_SKIP() << kNotItsOwnCost;
  const auto rates = cost_ratio(simpler, fuller, [](Kernels& k) { k.right_hand_side(); });
  const auto newton = cost_ratio(simpler, fuller, [](Kernels& k) { k.newton(); });
  if (!rates || !newton) GTEST_SKIP() << "no process may be traced here";
  testing::Test::RecordProperty("rates", std::to_string(*rates));
  testing::Test::RecordProperty("newton", std::to_string(*newton));
  EXPECT_LE(*rates, 1.0);
  EXPECT_LE(*newton, 1.0);
}

TEST(ModelCost, DryLandsAreNotDearerThanOiledOnes) {
  const Scene scene = speed_scene();
  const Bearing dry = loaded(scene);
  Bearing oiled = dry;
  oil_the_lands(scene, oiled.model);
  expect_not_dearer(dry, oiled);
}

TEST(ModelCost, APrescribedTiltOfTheRingIsNotDearerThanAFreeOne) {
  Scene scene = speed_scene();
  const Bearing prescribed = loaded(scene);
  scene.model.ring_tilt = TiltModel::free;
  expect_not_dearer(prescribed, loaded(scene));
}

TEST(ModelCost, ARigidCageIsNotDearerThanAFlexibleOne) {
  const RandomBearing rigid = random_bearing(3), flexible = random_bearing(3, {.modes = 4});
  expect_not_dearer({rigid.model, rigid.y}, {flexible.model, flexible.y});
}

}  // namespace
}  // namespace cagetol
