// The short studies of shipped bearings run, two samples of half a revolution each.
#include <gtest/gtest.h>
#include <cstdlib>
#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

class ShortStudies : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, ShortStudies,
                         testing::Values("gearbox", "spindle", "axial", "main-shaft",
                                         "own-bearing-lips"));

TEST_P(ShortStudies, Run) {
  if (std::string(GetParam()) == "own-bearing-lips" && std::getenv("CAGETOL_NIGHTLY") == nullptr)
    GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  const ScratchDirectory scratch;
  const std::string directory = scratch / "out";
  Process process({std::string(CAGETOL_BINARY_DIR) + "/cagetol", "sweep",
                   shipped(std::string("studies/") + GetParam() + ".toml"), "-o", directory,
                   "--set", "samples=2", "--set", "scene.window.settle_revolutions=0.3", "--set",
                   "scene.window.measure_revolutions=0.3"});
  EXPECT_EQ(process.wait(), 0) << process.output();
  const StudyData data = read_study_data(directory + "/study.h5");
  EXPECT_EQ(data.status, std::vector<RunStatus>(2, RunStatus::ok));
}

}  // namespace
}  // namespace cagetol
