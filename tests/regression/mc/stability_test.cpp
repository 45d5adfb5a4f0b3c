// The stability suite in small: the default method and another one where methods fail.
#include <gtest/gtest.h>

#include "mc/benchmark/stability.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

std::vector<SuiteScene> fast_suite() {
  auto suite = read_suite(shipped("stability.toml"));
  std::erase_if(suite, [](const SuiteScene& scene) { return !scene.fast; });
  return suite;
}

TEST(StabilitySuite, TheDefaultIsRightAndNothingSilentlyWrong) {
  const StabilityMap map =
      run_stability(fast_suite(), {IntegrationMethod::rodasp, IntegrationMethod::cvode_bdf}, 2);
  ASSERT_GE(map.rows.size(), 8u);
  for (const SuiteRow& row : map.rows) {
    EXPECT_EQ(row.cells.at(map.default_method).soundness, Soundness::right)
        << row.scene << ": " << row.cells.at(map.default_method).outcome.reason;
    for (const auto& [method, cell] : row.cells)
      EXPECT_NE(cell.soundness, Soundness::wrong)
          << spelled(method) << " on " << row.scene << ", off by " << cell.trajectory_error;
  }
}

// Steps that are too long do not carry 3 kN.
TEST(StabilitySuite, TellsWhereAMethodFails) {
  std::vector<SuiteScene> suite = fast_suite();
  std::erase_if(suite, [](const SuiteScene& scene) { return scene.name != "3 kN"; });
  ASSERT_EQ(suite.size(), 1u);
  suite[0].scene.integration.tolerance = 10;
  const StabilityMap map = run_stability(suite, {IntegrationMethod::rodasp}, 2);
  EXPECT_EQ(map.rows[0].cells.at(IntegrationMethod::rodasp).soundness, Soundness::failed);
}

}  // namespace
}  // namespace cagetol
