// The stability suite in small: the default method and the explicit baseline where methods fail.
#include <gtest/gtest.h>
#include <string>

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
  const StabilityMap map = run_stability(
      fast_suite(), {IntegrationMethod::rodasp, IntegrationMethod::semi_implicit_euler}, 2);
  ASSERT_GE(map.rows.size(), 8u);
  for (const SuiteRow& row : map.rows) {
    EXPECT_EQ(row.cells.at(map.default_method).soundness, Soundness::right)
        << row.scene << ": " << row.cells.at(map.default_method).outcome.reason;
    for (const auto& [method, cell] : row.cells)
      EXPECT_NE(cell.soundness, Soundness::wrong)
          << spelled(method) << " on " << row.scene << ", off by " << cell.trajectory_error;
  }
  // The suite can tell: explicit steps of one microsecond do not carry 3 kN.
  for (const SuiteRow& row : map.rows)
    if (row.scene == "3 kN") {
      EXPECT_EQ(row.cells.at(IntegrationMethod::semi_implicit_euler).soundness, Soundness::failed);
    }
}

}  // namespace
}  // namespace cagetol
