// What a System says of its rates.
#include "src/integration/system.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "tests/support/random_bearing.hpp"

namespace cagetol {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool finite(const RandomBearing& b, const std::vector<double>& y) {
  System system(b.model);
  std::vector<double> rate(y.size());
  return system.rates(b.t, y.data(), rate.data());
}

// Positions' rates by speeds that are none, accelerations one by one by masses that are none: from
// the first pack of the rates to the last.
TEST(System, TellsOfARateThatIsNotFiniteWhereverItStands) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Freedom freedom = seed % 2 == 0 ? Freedom::tilting : Freedom::spatial;  // 26 or 24 packs
    RandomBearing b = random_bearing(seed, {.freedom = freedom});
    const StateLayout& l = b.model.layout;
    ASSERT_TRUE(finite(b, b.y)) << seed;
    const auto without_speed = [&](int component) {
      for (const double value : {kNone, std::numeric_limits<double>::infinity()}) {
        std::vector<double> y = b.y;
        y[static_cast<std::size_t>(component)] = value;
        EXPECT_FALSE(finite(b, y)) << seed << ", " << component;
      }
    };
    const auto without_mass = [&](double& mass) {
      const double known = mass;
      mass = kNone;
      EXPECT_FALSE(finite(b, b.y)) << seed;
      mass = known;
    };
    for (int j = 0; j < l.rollers; ++j) {
      for (int slot = 0; slot < kRollerPositions; ++slot)
        without_speed(l.velocity(static_cast<RollerVelocity>(slot), j));
      RollerGroup& group = b.model.groups[static_cast<std::size_t>(j / kLanes)];
      for (Pack* inverse : {&group.inverse_mass, &group.inverse_transverse, &group.inverse_polar})
        without_mass(reinterpret_cast<double*>(inverse)[j % kLanes]);
    }
    for (int slot = 0; slot < l.border(); ++slot) without_speed(l.border_velocity(slot));
    for (double* mass :
         {&b.model.ring_mass, &b.model.cage_mass, &b.model.cage_polar, &b.model.cage_transverse})
      without_mass(*mass);
    if (l.ring_tilt > 0) without_mass(b.model.ring_transverse);
  }
}

}  // namespace
}  // namespace cagetol
