// Thirteen rollers fill two packs but for three lanes. What stands in those lanes must not matter.
#include <gtest/gtest.h>
#include <algorithm>
#include <cstdint>
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
      EXPECT_EQ(body_energy(b.model, b.y.data()), body_energy(b.model, y.data()));
    }
  }
}

// A pack across two cache lines costs; every component of every state begins where a pack may.
TEST(Padding, NoPackLiesAcrossTwoCacheLines) {
  for (const int modes : {0, 5, 20})
    for (const int tilt : {0, 2}) {
      const StateLayout l{.rollers = 13, .groups = 2, .modes = modes, .ring_tilt = tilt};
      for (int slot = 0; slot < kRollerPositions; ++slot)
        EXPECT_EQ(l.position(static_cast<RollerPosition>(slot), 0) % kLanes, 0);
      for (int slot = 0; slot < kRollerVelocities; ++slot)
        EXPECT_EQ(l.velocity(static_cast<RollerVelocity>(slot), 0) % kLanes, 0) << modes;
      EXPECT_EQ(l.size() % kLanes, 0) << modes;
      EXPECT_GE(l.border_velocity(0) - l.border_position(0), l.border());
    }
  constexpr std::uintptr_t wanted = std::min<std::uintptr_t>(sizeof(Pack), EIGEN_MAX_ALIGN_BYTES);
  for (std::size_t n = 8; n < 3000; n += 8)
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(PackVector(n).data()) % wanted, 0u) << n;
}

}  // namespace
}  // namespace cagetol
