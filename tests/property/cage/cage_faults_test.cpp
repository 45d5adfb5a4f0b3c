// Whatever the deviations, a cage is a model or a fault that names a pocket, never a crash or a
// number that is none.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "src/cage/table/cage_model.hpp"
#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

using Deviations = std::vector<PocketDeviation>;

/// A number of any size and sign, now and then none.
double wild(std::mt19937& random) {
  constexpr double kSpecial[] = {
      std::numeric_limits<double>::quiet_NaN(),  std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity(),  std::numeric_limits<double>::max(),
      std::numeric_limits<double>::denorm_min(), -0.0};
  const auto kind = random() % 12;
  if (kind < std::size(kSpecial)) return kSpecial[kind];
  std::uniform_real_distribution<double> exponent(-8, 2);
  return (random() % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(random));
}

/// Some pockets of an undeviated cage made wild.
Deviations wild_pockets(std::mt19937& random) {
  Deviations deviations(13);
  const auto touched = 1 + random() % 4;
  for (unsigned i = 0; i < touched; ++i) {
    PocketDeviation& pocket = deviations[random() % 13];
    double* const values[] = {&pocket.width, &pocket.length, &pocket.pitch, &pocket.squareness};
    for (double* value : values)
      if (random() % 2 == 0) *value = wild(random);
  }
  return deviations;
}

bool deviates(const PocketDeviation& pocket) {
  return pocket.width != 0 || pocket.length != 0 || pocket.pitch != 0 || pocket.squareness != 0;
}

void expect_named(const CageFault& fault, const Deviations& deviations) {
  ASSERT_GE(fault.pocket, 0);
  ASSERT_LT(fault.pocket, 13);
  EXPECT_FALSE(fault.reason.empty());
  EXPECT_TRUE(deviates(deviations[static_cast<std::size_t>(fault.pocket)]))
      << fault.pocket << ": " << fault.reason;
}

TEST(CageFaults, AnyDeviationsGiveAModelOrAFaultThatNamesThePocket) {
  std::mt19937 random(20240914);
  int models = 0;
  int faults = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Deviations deviations = wild_pockets(random);
    const auto result = make_cage_model(test::coarse_table(), deviations, {.stress = false});
    if (const auto* fault = std::get_if<CageFault>(&result)) {
      ++faults;
      expect_named(*fault, deviations);
      continue;
    }
    ++models;
    const CageModel& model = std::get<CageModel>(result);
    EXPECT_TRUE(model.frequency.allFinite() && model.contact.allFinite() &&
                model.residual_compliance.allFinite());
    EXPECT_GT(model.frequency.minCoeff(), 1000);
  }
  EXPECT_GT(models, 50);
  EXPECT_GT(faults, 1000);
}

/// Beyond the table's range the mesh itself decides: no element is ever inverted.
TEST(CageFaults, AnyDeviationsGiveAMeshOfSoundElementsOrAFault) {
  std::mt19937 random(20240915);
  const CageTable& table = test::coarse_table();
  int meshes = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Deviations deviations = wild_pockets(random);
    const auto result = make_cage_mesh(table.cage, deviations, table.counts);
    if (const auto* fault = std::get_if<CageFault>(&result)) {
      expect_named(*fault, deviations);
      continue;
    }
    ++meshes;
    EXPECT_TRUE(std::get<CageMesh>(result).mesh.nodes.allFinite());
  }
  EXPECT_GT(meshes, 30);
}

}  // namespace
}  // namespace cagetol
