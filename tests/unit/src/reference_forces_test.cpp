// The lane-parallel right-hand side against the plain reference of
// tests/support/reference_forces.hpp.
#include "tests/support/reference_forces.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <string>

#include "src/integration/system.hpp"
#include "tests/support/random_bearing.hpp"

namespace cagetol {
namespace {

/// Accelerations that share a unit and a size.
struct ContactKind {
  std::string name;
  std::vector<int> slots;
};

std::vector<ContactKind> acceleration_kinds(const StateLayout& l) {
  std::vector<ContactKind> kinds;
  const char* names[] = {"r''", "theta''", "x''", "a_y''", "a_z''", "w_s'"};
  for (int slot = 0; slot < kRollerVelocities; ++slot) {
    ContactKind kind{names[slot], {}};
    for (int j = 0; j < l.rollers; ++j)
      kind.slots.push_back(l.velocity(static_cast<RollerVelocity>(slot), j));
    kinds.push_back(kind);
  }
  const auto border = [&](int slot) { return l.border_velocity(slot); };
  kinds.push_back({"ring''", {border(kRingY), border(kRingZ)}});
  kinds.push_back({"cage''", {border(kCageY), border(kCageZ)}});
  kinds.push_back({"cage x''", {border(kCageX)}});
  kinds.push_back({"phi''", {border(kCagePhi)}});
  kinds.push_back({"A''", {border(kCageAxisY), border(kCageAxisZ)}});
  if (l.ring_tilt > 0)
    kinds.push_back({"B''", {border(l.ring_tilt_slot()), border(l.ring_tilt_slot() + 1)}});
  return kinds;
}

/// Largest difference of a kind over the largest sum of contact contributions of that kind:
/// opposite contacts may cancel.
double difference(const ContactKind& kind, const std::vector<double>& rates,
                  const Reference& reference) {
  double apart = 0, size = 0;
  for (int slot : kind.slots) {
    const auto k = static_cast<std::size_t>(slot);
    apart = std::max(apart, std::abs(rates[k] - reference.rates[k]));
    size = std::max({size, std::abs(reference.rates[k]), reference.gross[k]});
  }
  return apart / std::max(size, 1e-300);
}

void expect_same(const RandomBearing& b, const Reference& reference, unsigned seed) {
  std::vector<double> rates(b.y.size());
  evaluate_rates(b.model, b.t, b.y.data(), rates.data());
  for (int i = 0; i < b.model.layout.positions(); ++i)
    ASSERT_EQ(rates[static_cast<std::size_t>(i)], reference.rates[static_cast<std::size_t>(i)])
        << "seed " << seed;
  for (const ContactKind& kind : acceleration_kinds(b.model.layout))
    // An angle is known to 4e-16, a bar's gap of some 10 um on a radius of 20 to 33 mm therefore
    // to 1e-12 of itself.
    EXPECT_LT(difference(kind, rates, reference), 1e-11)
        << kind.name << ", seed " << seed << ", guidance " << spelled(b.scene.cage.guidance);
}

class ReferenceForces : public testing::TestWithParam<Freedom> {};
INSTANTIATE_TEST_SUITE_P(Bearings, ReferenceForces,
                         testing::Values(Freedom::spatial, Freedom::tilting),
                         [](const auto& test) { return freedom_name(test.param); });

TEST_P(ReferenceForces, AgreeInRandomStatesOfEveryKind) {
  std::array<long, kContactKinds> touching{}, pulling{};
  for (unsigned seed = 0; seed < 360; ++seed) {
    const RandomBearing b = random_bearing(seed, {.freedom = GetParam()});
    const Reference reference = reference_rates(b.scene, b.t, b.y);
    for (int k = 0; k < kContactKinds; ++k) {
      touching[static_cast<std::size_t>(k)] += reference.touching[static_cast<std::size_t>(k)];
      pulling[static_cast<std::size_t>(k)] += reference.pulling[static_cast<std::size_t>(k)];
    }
    expect_same(b, reference, seed);
  }
  for (int k = 0; k < kContactKinds; ++k) {
    EXPECT_GT(touching[static_cast<std::size_t>(k)], 100) << "contact kind " << k;
    RecordProperty("touching_" + std::to_string(k),
                   std::to_string(touching[static_cast<std::size_t>(k)]));
    RecordProperty("pulling_" + std::to_string(k),
                   std::to_string(pulling[static_cast<std::size_t>(k)]));
  }
}

TEST_P(ReferenceForces, AgreeOnWavyRaceways) {
  long touching = 0;
  for (unsigned seed = 0; seed < 96; ++seed) {
    const RandomBearing b = random_bearing(seed, {.freedom = GetParam(), .wavy = true});
    const Reference reference = reference_rates(b.scene, b.t, b.y);
    touching += reference.touching[kInnerRace] + reference.touching[kOuterRace];
    expect_same(b, reference, seed);
  }
  EXPECT_GT(touching, 1000);
}

TEST_P(ReferenceForces, AgreeOnSphereEnds) {
  long touching = 0;
  for (unsigned seed = 0; seed < 96; ++seed) {
    const RandomBearing b = random_bearing(seed, {.freedom = GetParam(), .sphere_ends = true});
    const Reference reference = reference_rates(b.scene, b.t, b.y);
    touching += reference.touching[kFlange];
    expect_same(b, reference, seed);
    System system(b.model);
    system.linearise_at(b.t, b.y.data());
    const auto same = [&](double ours, double theirs, const char* what) {
      EXPECT_NEAR(ours, theirs, 1e-10 * std::abs(theirs)) << what << ", seed " << seed;
    };
    same(system.seen.elastic_energy, reference.elastic_energy, "elastic energy");
    same(system.seen.friction_power, reference.friction_power, "friction power");
    same(system.seen.drive_power, reference.drive_power, "drive power");
    same(system.seen.damping_power, reference.damping_power, "damping power");
  }
  EXPECT_GT(touching, 300);
}

TEST(ReferenceForcesOfPockets, AgreeOnEdgesLipsAndCurvedFaces) {
  for (const Outline outline : {Outline::edges, Outline::lips, Outline::curved}) {
    SCOPED_TRACE(outline_name(outline));
    long touching = 0;
    for (unsigned seed = 0; seed < 96; ++seed) {
      const RandomBearing b = random_bearing(seed, {.outline = outline});
      const Reference reference = reference_rates(b.scene, b.t, b.y);
      touching += reference.touching[kBar];
      expect_same(b, reference, seed);
    }
    EXPECT_GT(touching, 1000);
  }
}

}  // namespace
}  // namespace cagetol
