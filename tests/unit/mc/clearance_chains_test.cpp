#include "mc/run/clearance_chains.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Study study_of(const std::string& cage, const std::string& more = "",
               const std::string& scene = "scenes/nu205.toml") {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "study.toml")
      << "[scene]\nfile = \"" << shipped(scene) << "\"\n[scene.cage]\n"
      << cage << more;
  return read_study(scratch / "study.toml");
}

const ClearanceChain& named(const std::vector<ClearanceChain>& chains, const std::string& name) {
  for (const ClearanceChain& chain : chains)
    if (chain.name == name) return chain;
  ADD_FAILURE() << name;
  return chains.front();
}

void expect_um(const Interval& ends, double lower, double upper, double within = 1e-6) {
  EXPECT_NEAR(1e6 * ends.lower, lower, within);
  EXPECT_NEAR(1e6 * ends.upper, upper, within);
}

constexpr const char* kWidth =
    "pocket_width_mm = { nominal = 7.65, pocket = { law = \"normal\", sigma = 0.01 } }\n";
constexpr const char* kRollers =
    "[scene.roller]\ndiameter_mm = { nominal = 7.5, lot = { law = \"uniform\", lower = 0, upper = "
    "0.004 } }\n";
constexpr const char* kDrawing =
    "[[tolerance.dimension]]\nkey = \"cage.pocket_width_mm\"\ntolerance_width_mm = 0.1\ncandidates "
    "= [0.2]\n";

// Pockets of 7.65 +-0.05 with a sigma of 10 um, rollers of 7.5 +0.004/0.
TEST(ClearanceChains, AddDrawingsAndLaws) {
  const auto chains = clearance_chains(study_of(kWidth, std::string(kRollers) + kDrawing));
  const ClearanceChain& bars = named(chains, "roller to both bars");
  EXPECT_THAT(bars.keys,
              testing::UnorderedElementsAre("cage.pocket_width_mm", "roller.diameter_mm"));
  EXPECT_NEAR(1e6 * bars.nominal, 150, 1e-6);
  expect_um(bars.worst, 150 - 50 - 4, 150 + 50, 1e-4);
  const double rss = std::hypot(50, 2);
  expect_um(bars.rss, 148 - rss, 148 + rss, 1e-4);
  // Three standard deviations of the normal law, widened by the rollers' 4/sqrt(12) um.
  const double three = 3 * std::hypot(10, 4 / std::sqrt(12));
  expect_um(bars.sampled, 148 - three, 148 + three, 0.7);
  EXPECT_THAT(named(chains, "roller to both pocket ends").keys, IsEmpty());
  expect_um(named(chains, "roller to both pocket ends").sampled, 250, 250);
}

// Without a drawing a normal law ends at three standard deviations; half the clearance and the way
// of the pocket's centre are before one bar.
TEST(ClearanceChains, PitchCountsBeforeOneBar) {
  const Study study =
      study_of(std::string(kWidth) +
               "pocket_pitch_mrad = { nominal = 0, pocket = { law = \"normal\", sigma = 1 } }\n");
  const auto chains = clearance_chains(study);
  const double way = 3e3 * pitch_radius(study.scene.bearing);  // 3 mrad, in um
  const ClearanceChain& bar = named(chains, "evenly spaced roller to one bar");
  EXPECT_THAT(bar.keys, ElementsAre("cage.pocket_width_mm", "cage.pocket_pitch_mrad"));
  expect_um(bar.worst, 75 - 15 - way, 75 + 15 + way, 1e-4);
  expect_um(bar.rss, 75 - std::hypot(15, way), 75 + std::hypot(15, way), 1e-4);
  expect_um(bar.sampled, 75 - std::hypot(15, way), 75 + std::hypot(15, way), 1);
  EXPECT_THAT(named(chains, "roller to both bars").keys, ElementsAre("cage.pocket_width_mm"));
}

TEST(ClearanceChains, KnowRingsAndLipsAndNoRunNumbers) {
  Study study = study_of(
      "inner_diameter_mm = { nominal = 37, lot = { law = \"uniform\", lower = -0.02, upper = 0.02 "
      "} "
      "}\nretention_width_outer_mm = { nominal = 7.2, lot = { law = \"normal\", sigma = 0.01 } "
      "}\n");
  const auto chains = clearance_chains(study);
  const ClearanceChain& ring = named(chains, "cage to the inner ring, radial");
  EXPECT_THAT(ring.keys, ElementsAre("cage.inner_diameter_mm"));
  EXPECT_NEAR(1e6 * (ring.worst.upper - ring.worst.lower), 20, 1e-4);  // radial: half of 40 um
  EXPECT_NEAR(1e6 * (ring.sampled.upper - ring.sampled.lower), 20, 0.2);
  EXPECT_THAT(named(chains, "roller to the lips at the outside").keys,
              ElementsAre("cage.retention_width_outer_mm"));
  study.seed = 99;
  study.samples = 7;
  const auto again = clearance_chains(study);
  for (std::size_t k = 0; k < chains.size(); ++k) {
    EXPECT_EQ(chains[k].sampled.lower, again[k].sampled.lower);
    EXPECT_EQ(chains[k].sampled.upper, again[k].sampled.upper);
  }
}

TEST(ClearanceChains, PrintALineEach) {
  const auto text = chains_text(clearance_chains(study_of(kWidth, kDrawing)));
  EXPECT_THAT(text, testing::HasSubstr("0.135 % to 99.865 % of the pockets of 20000 cages"));
  EXPECT_THAT(text, testing::ContainsRegex("roller to both bars +150.0 +100.0 to 200.0 +100.0 to "
                                           "200.0 .* cage.pocket_width_mm"));
  EXPECT_THAT(text, testing::ContainsRegex("roller to both pocket ends +250.0 +250.0 to 250.0 "));
}

}  // namespace
}  // namespace cagetol
