// Thirteen rollers fill two packs but for three lanes. What stands in those lanes must not matter.
#include <gtest/gtest.h>
#include <vector>

#include "src/integration/system.hpp"
#include "tests/support/random_bearing.hpp"

namespace cagetol {
namespace {

TEST(Padding, ItsStateDoesNotMatter) {
  for (unsigned seed = 0; seed < 60; seed += 2) {  // even: Z = 13
    const RandomBearing b = random_bearing(seed);
    const StateLayout& l = b.model.layout;
    ASSERT_EQ(l.rollers, 13);
    System clean(b.model), dirty(b.model);
    clean.linearise_at(b.t, b.y.data());
    for (double garbage : {-7.5, 0.031, 4e3}) {
      std::vector<double> y = b.y;
      for (int j = l.rollers; j < l.padded(); ++j) {
        for (int slot = 0; slot < kRollerPositions; ++slot)
          y[static_cast<std::size_t>(l.position(static_cast<RollerPosition>(slot), j))] =
              garbage + slot;
        for (int slot = 0; slot < kRollerVelocities; ++slot)
          y[static_cast<std::size_t>(l.velocity(static_cast<RollerVelocity>(slot), j))] =
              3 * garbage - slot;
      }
      dirty.linearise_at(b.t, y.data());
      EXPECT_EQ(clean.rate, dirty.rate) << "seed " << seed << ", garbage " << garbage;
      EXPECT_EQ(clean.seen.friction_power, dirty.seen.friction_power);
      EXPECT_EQ(clean.seen.damping_power, dirty.seen.damping_power);
      EXPECT_EQ(clean.seen.drive_power, dirty.seen.drive_power);
      EXPECT_EQ(clean.seen.elastic_energy, dirty.seen.elastic_energy);
      EXPECT_EQ(clean.seen.ring_elastic_z, dirty.seen.ring_elastic_z);
      EXPECT_EQ(clean.seen.net_power_rate, dirty.seen.net_power_rate);
      EXPECT_EQ(clean.seen.longest_step, dirty.seen.longest_step);
      EXPECT_EQ(body_energy(b.model, b.y.data()), body_energy(b.model, y.data()));
    }
  }
}

}  // namespace
}  // namespace cagetol
