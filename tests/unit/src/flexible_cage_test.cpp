// The flexible cage within the bearing: what must hold whatever the modes, and a steel cage of the
// NU 205.
#include "src/model/flexible_cage.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <random>

#include "src/cage/table/scene_cage.hpp"
#include "src/integration/integrator.hpp"
#include "src/quantities/cage_stress.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"

namespace cagetol {
namespace {

Scene coarse_scene() {
  Scene s;
  s.cage.model = CageKind::flexible;
  s.cage.mesh_density = 2;
  s.cage.corner_radius = 0;  // its table takes a tenth of the time
  return s;
}

std::shared_ptr<const CageTable> coarse_table() {
  static const auto table = make_scene_cage_table(coarse_scene());
  return table;
}

Outcome run(const Scene& scene) {
  return simulate(scene, {.cage_table = coarse_table()});
}

double quantity(const Outcome& outcome, const char* key) {
  return outcome.quantities[static_cast<std::size_t>(quantity_index(key))];
}

/// A cage that nothing touches, spinning, leaning, bent.
struct LooseCage {
  Scene scene = coarse_scene();
  BearingModel model;
  std::vector<double> y;
  explicit LooseCage(double phase, bool spin_terms = true) {
    scene.cage.guidance = Guidance::roller;
    scene.cage.mode_damping = 0;
    scene.cage.centrifugal = scene.cage.coriolis = spin_terms;
    scene.operation.gravity = 0;
    scene.start.cage_phase = phase;
    scene.integration.method = IntegrationMethod::rodasp;
    scene.integration.tolerance = 1e-7;
    auto made = scene_cage_model(scene, *coarse_table());
    model = make_bearing_model(scene, std::get<std::shared_ptr<const CageModel>>(made));
    y = start_state(model, scene.start);
    const StateLayout& l = model.layout;
    const auto at = [&](int slot) -> double& { return y[static_cast<std::size_t>(slot)]; };
    at(l.border_velocity(kCageX)) = 1e-4;
    for (int k = 0; k < l.modes; ++k) {
      const double moved = model.flexible.scale[static_cast<std::size_t>(k)];
      at(l.border_position(kModes + k)) = (k % 3 - 1) * 2e-6 / moved;
      at(l.border_velocity(kModes + k)) = (k % 5 - 2) * 2e-2 / moved;
    }
  }
  void integrate(double end) {
    System system(model);
    double t = 0;
    system.linearise_at(t, y.data());
    const auto integrator = make_integrator(scene.integration, system, t, y.data());
    while (t < end) {
      ASSERT_EQ(integrator->step(system, t, y.data(), end), StepStatus::accepted);
      system.linearise_at(t, y.data());
    }
    EXPECT_EQ(system.seen.leading_force, PackVector(system.seen.leading_force.size(), 0.0));
  }
  const double* position() const { return y.data() + model.layout.border_position(0); }
  const double* velocity() const { return y.data() + model.layout.border_velocity(0); }
  double energy() const {
    const double *q = position(), *v = velocity();
    return model.cage_polar * v[kCagePhi] * v[kCagePhi] / 2 +
           modal_energy(model.flexible, v[kCagePhi], q + kModes, v + kModes);
  }
  double angular_momentum() const {
    const Eigen::Map<const Eigen::VectorXd> q(position() + kModes, model.layout.modes),
        v(velocity() + kModes, model.layout.modes);
    const CageModel& cage = *model.flexible.model;
    double momentum = model.cage_polar * velocity()[kCagePhi];
    if (model.flexible.centrifugal) momentum += 2 * velocity()[kCagePhi] * cage.centrifugal.dot(q);
    if (model.flexible.coriolis) momentum += v.dot(cage.gyroscopic * q);
    return momentum;
  }
};

TEST(FlexibleCage, SpinningFreeKeepsEnergyAndMomentum) {
  for (bool spin_terms : {true, false}) {
    LooseCage cage(0.3, spin_terms);
    const double energy = cage.energy(), momentum = cage.angular_momentum();
    const double spin_energy = cage.model.cage_polar * std::pow(cage.velocity()[kCagePhi], 2) / 2;
    cage.integrate(2e-3);
    EXPECT_NEAR(cage.energy(), energy, 1e-6 * energy);
    EXPECT_NEAR(cage.energy(), energy, 1e-3 * (energy - spin_energy));  // of what swings
    EXPECT_NEAR(cage.angular_momentum(), momentum, 1e-8 * momentum);
    EXPECT_NE(cage.angular_momentum(), 0);
  }
}

TEST(FlexibleCage, SpinningFreeDoesNotKnowTheOriginOfAngles) {
  LooseCage one(0), other(2.1);
  one.integrate(2e-3);
  other.integrate(2e-3);
  for (int k = 0; k < one.model.layout.modes; ++k) {
    const double scale = one.model.flexible.scale[static_cast<std::size_t>(k)];
    EXPECT_NEAR(one.position()[kModes + k] * scale, other.position()[kModes + k] * scale, 1e-11);
  }
  const double speed = one.velocity()[kCagePhi];
  EXPECT_NEAR(speed, other.velocity()[kCagePhi], 1e-8);
}

// Turned by one pocket, a bearing is the same bearing with its pockets renumbered. Steps of
// one length: stress is read at steps, and an error estimate lets rounding decide where they fall.
TEST(FlexibleCage, ABearingTurnedByOnePocketIsTheSame) {
  Scene scene = coarse_scene();
  scene.window.settle_time = 0.05e-3;
  scene.window.measure_time = 0.25e-3;
  scene.cage.pocket_width = {7.55e-3};
  scene.start.cage_offset_z = -0.15e-3;
  scene.integration.max_step = 0.02e-6;
  scene.integration.tolerance = 10;
  scene.watch.static_consistency_max = 1;
  const Outcome one = run(scene);
  scene.start.cage_phase = 2 * std::numbers::pi / 13;
  const Outcome other = run(scene);
  ASSERT_EQ(one.status, Status::ok) << one.reason;
  for (const char* key : {"cage_stress_peak_MPa", "cage_stress_rms_MPa", "pocket_force_peak_N"}) {
    EXPECT_GT(quantity(one, key), 0) << key;
    EXPECT_NEAR(quantity(one, key), quantity(other, key), 1e-5 * quantity(one, key)) << key;
  }
}

TEST(FlexibleCage, WithoutModesItMovesAsARigidCageDoes) {
  Scene scene = coarse_scene();
  scene.cage.modes = 0;
  scene.cage.bar_modes = false;
  scene.window.settle_time = 0;
  scene.window.measure_time = 2e-3;
  scene.cage.pocket_width = {7.51e-3};
  scene.watch.static_consistency_max = 1;
  const Outcome flexible = run(scene);
  scene.cage.model = CageKind::rigid;
  const Outcome rigid = run(scene);
  EXPECT_EQ(quantity(flexible, "pocket_force_rms_N"), quantity(rigid, "pocket_force_rms_N"));
  EXPECT_EQ(quantity(flexible, "cage_slip_ratio"), quantity(rigid, "cage_slip_ratio"));
  EXPECT_GT(quantity(flexible, "cage_stress_peak_MPa"), 0);
  EXPECT_TRUE(std::isnan(quantity(rigid, "cage_stress_peak_MPa")));
}

TEST(FlexibleCage, EnergyAccountCloses) {
  Scene scene = coarse_scene();
  scene.window.settle_time = 0.5e-3;
  scene.window.measure_time = 5e-3;
  scene.watch.static_consistency_max = 1;
  scene.integration.tolerance = 5e-5;
  constexpr int kStarts = 8;
  double sum = 0;
  for (int start = 0; start < kStarts; ++start) {
    scene.start.cage_phase = start * 0.05;
    const Outcome outcome = run(scene);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
    EXPECT_LT(outcome.run.energy_residual, 1e-2);
    sum += outcome.run.energy_residual;
  }
  EXPECT_LT(sum / kStarts, 2e-3);
}

// Shorter than from one instant of the record of stress to the next: the first one stands for it.
TEST(FlexibleCage, AWindowOfAHundredMicrosecondsHasItsStress) {
  Scene scene = coarse_scene();
  scene.window.settle_time = 0;
  scene.window.measure_time = 1e-4;
  const Outcome outcome = run(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  EXPECT_GT(quantity(outcome, "cage_stress_rms_MPa"), 0);
  EXPECT_LE(quantity(outcome, "cage_stress_rms_MPa"), quantity(outcome, "cage_stress_peak_MPa"));
}

TEST(FlexibleCage, ImpossiblePocketsAreAnOutcome) {
  Scene scene = coarse_scene();
  scene.cage.pocket_length.assign(13, 9.25e-3);
  scene.cage.pocket_length[4] = 15e-3;
  const Outcome outcome = run(scene);
  EXPECT_EQ(outcome.status, Status::jammed);
  EXPECT_EQ(outcome.pocket, 4);
  EXPECT_NE(outcome.reason.find("pocket 4"), std::string::npos) << outcome.reason;
  scene = coarse_scene();
  scene.cage.outer_diameter += 0.1e-3;
  EXPECT_EQ(run(scene).status, Status::failed);
}

// Clearance and mass follow the sample's diameters, elasticity is the table's.
TEST(FlexibleCage, DiametersMayDeviateByAShareOfTheThickness) {
  Scene scene = coarse_scene();
  scene.cage.outer_diameter += 0.06e-3;  // 0.94 % of 6.4 mm
  const auto made = scene_cage_model(scene, *coarse_table()),
             nominal = scene_cage_model(coarse_scene(), *coarse_table());
  ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const CageModel>>(made));
  const auto cage = std::get<std::shared_ptr<const CageModel>>(made),
             other = std::get<std::shared_ptr<const CageModel>>(nominal);
  EXPECT_EQ(cage->frequency, other->frequency);
  const BearingModel model = make_bearing_model(scene, cage),
                     before = make_bearing_model(coarse_scene(), other);
  EXPECT_NEAR(model.guide_clearance, before.guide_clearance - 0.03e-3, 1e-12);
  EXPECT_NEAR(model.cage_mass / before.cage_mass, 1.011, 0.001);
  scene.cage.inner_diameter -= 0.01e-3;
  const auto refused = scene_cage_model(scene, *coarse_table());
  ASSERT_TRUE(std::holds_alternative<CageFault>(refused));
  EXPECT_EQ(std::get<CageFault>(refused).kind, CageFaultKind::outside_table);
  EXPECT_NE(std::get<CageFault>(refused).reason.find("by 1.09 %"), std::string::npos)
      << std::get<CageFault>(refused).reason;
}

// Stiffness grows with the size, mass stays: frequencies by the root of 1 + g. Samples whose fit or
// speed differ have the same table, those of another temperature none.
TEST(FlexibleCage, HasTheDimensionsOfOperation) {
  Scene warm = coarse_scene();
  warm.cage.temperature = 220;
  warm.temperature.growth = true;
  const auto table = make_scene_cage_table(warm);
  EXPECT_EQ(table_point(warm, warm), GridPoint{});
  const auto made = scene_cage_model(warm, *table),
             cold = scene_cage_model(coarse_scene(), *coarse_table());
  const CageModel &grown = *std::get<std::shared_ptr<const CageModel>>(made),
                  &as_made = *std::get<std::shared_ptr<const CageModel>>(cold);
  EXPECT_NEAR(grown.body.mass / as_made.body.mass, 1, 1e-9);
  for (Eigen::Index k = 0; k < grown.elastic_modes(); ++k)
    EXPECT_NEAR(grown.frequency[k] / as_made.frequency[k], std::sqrt(1 + 12e-6 * 200), 1e-5);
  Scene sample = warm;
  sample.fit.inner_interference = 10e-6;
  sample.operation.centrifugal_growth = true;
  sample.cage.pocket_width[0] += 10e-6;
  ASSERT_TRUE(
      std::holds_alternative<std::shared_ptr<const CageModel>>(scene_cage_model(sample, *table)));
  sample.window.settle_time = 0;
  sample.window.measure_time = 0.2e-3;
  const Outcome outcome = simulate(sample, {.cage_table = table});
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
  sample.cage.temperature = 219;
  ASSERT_TRUE(std::holds_alternative<CageFault>(scene_cage_model(sample, *table)));
}

/// What becomes of a cage whose pockets are all wider, at the table that serves it.
std::variant<std::shared_ptr<const CageModel>, CageFault> wider_cage(double by) {
  Scene scene = coarse_scene();
  for (double& width : scene.cage.pocket_width) width += by;
  return scene_cage_model(
      scene, *make_scene_cage_table(coarse_scene(), table_point(coarse_scene(), scene)));
}

TEST(FlexibleCage, PocketsThatAreAllWiderThanTheNominalTableCoversHaveATableUpToAFault) {
  EXPECT_GT(0.4e-3, coarse_table()->range.width);
  EXPECT_TRUE(std::holds_alternative<std::shared_ptr<const CageModel>>(wider_cage(0.4e-3)));
  for (const auto& [by, kind] : {std::pair{0.6e-3, CageFaultKind::outside_table},
                                 std::pair{2e-3, CageFaultKind::geometry}}) {
    const auto made = wider_cage(by);
    ASSERT_TRUE(std::holds_alternative<CageFault>(made)) << by;
    EXPECT_EQ(std::get<CageFault>(made).kind, kind);
    EXPECT_EQ(std::get<CageFault>(made).pocket, 0);
  }
}

TEST(CageStress, IsTheLargestStationStressAndNeverAboveItsBound) {
  const Scene scene = coarse_scene();
  auto made = scene_cage_model(scene, *coarse_table());
  const CageModel& model = *std::get<std::shared_ptr<const CageModel>>(made);
  CageStress stress(model);
  std::mt19937_64 engine(7);
  const auto about = [&] { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1; };
  double tightest = 0;
  for (int n = 0; n < 50; ++n) {
    Eigen::VectorXd q(model.frequency.size()),
        force = Eigen::VectorXd::Zero(13 * 2 * model.bar_stations);
    for (double& x : q) x = 1e-7 * about() * (n % 3);
    for (int hits = 0; hits < 3; ++hits)
      force[static_cast<Eigen::Index>(engine() % static_cast<unsigned>(force.size()))] =
          20 * about();
    const double spin = 1500 * (n % 2);
    const Eigen::VectorXd all = station_stress(model, q, force, spin);
    Eigen::Index at = 0;
    const double most = all.maxCoeff(&at);
    // However far it is from the one before, the bound of the change holds.
    const double before = stress.last().stress, change = stress.change_bound(q.data(), force, spin);
    EXPECT_LE(std::abs(most - before), change * (1 + 1e-6) + 1e-5 * before);
    const auto largest = stress.largest(q.data(), force, spin);
    EXPECT_EQ(stress.change_bound(q.data(), force, spin), 0);
    EXPECT_NEAR(largest.stress, most, 1e-5 * most);
    EXPECT_EQ(largest.sector * model.stress_stations + largest.station, at);
    const double bound = stress.bound(q.data(), force, spin);
    EXPECT_GE(bound, most * (1 - 1e-6));
    tightest = std::max(tightest, most / bound);
  }
  EXPECT_GT(tightest, 0.3);  // a bound that says something
}

}  // namespace
}  // namespace cagetol
