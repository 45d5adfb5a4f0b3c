// The stability suite in small: the default method and the explicit baseline where methods fail.
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "mc/engine/stability.hpp"

namespace cagetol {
namespace {

std::vector<SuiteScene> fast_suite() {
  auto suite = read_suite(std::string(CAGETOL_SOURCE_DIR) + "/inputs/stability.toml");
  std::erase_if(suite, [](const SuiteScene& scene) { return !scene.fast; });
  return suite;
}

TEST(StabilitySuite, TheDefaultIsRightOrSaysThatItIsNot) {
  const StabilityMap map = run_stability(fast_suite(), {"rodas3", "semi-implicit-euler"}, 2);
  // Its watch on energy stops it there; a tighter tolerance is needed.
  const std::set<std::string> default_gives_up = {"contact stiffness x100"};
  ASSERT_GE(map.rows.size(), 8u);
  for (const SuiteRow& row : map.rows) {
    const bool gives_up = default_gives_up.contains(row.scene);
    EXPECT_EQ(row.cells.at(map.default_method).soundness,
              gives_up ? Soundness::failed : Soundness::right)
        << row.scene << ": " << row.cells.at(map.default_method).outcome.reason;
    for (const auto& [method, cell] : row.cells)
      EXPECT_NE(cell.soundness, Soundness::wrong)
          << method << " on " << row.scene << ", off by " << cell.trajectory_error;
  }
  // The suite can tell: explicit steps of one microsecond do not carry 3 kN.
  for (const SuiteRow& row : map.rows)
    if (row.scene == "3 kN") {
      EXPECT_EQ(row.cells.at("semi-implicit-euler").soundness, Soundness::failed);
    }
}

}  // namespace
}  // namespace cagetol
