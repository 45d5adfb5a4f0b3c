// Ladder, error budget and chart on bearings of other kinds that ship, in short.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::json;

/// A command on a shipped scene, over `revolutions` of the cage; what it writes to NAME.json.
Json written(const std::string& command, const std::string& scene, const std::string& directory,
             const std::string& revolutions, std::vector<std::string> more) {
  std::vector<std::string> arguments = {std::string(CAGETOL_BINARY_DIR) + "/cagetol", command,
                                        shipped("scenes/" + scene + ".toml"), "-o", directory};
  arguments.insert(arguments.end(), more.begin(), more.end());
  for (const std::string& setting :
       {"window.settle_revolutions=" + revolutions, "window.measure_revolutions=" + revolutions,
        std::string("cage.mesh_density=1"), std::string("cage.corner_radius_mm=0")})
    arguments.insert(arguments.end(), {"--set", setting});
  Process process(arguments);
  EXPECT_EQ(process.wait(), 0) << process.output();
  std::ifstream file(directory + "/" + command + ".json");
  return Json::parse(file, nullptr, false);
}

const Json& of(const Json& list, const char* key, const std::string& name) {
  for (const Json& entry : list)
    if (entry[key] == name) return entry;
  ADD_FAILURE() << "no " << name;
  return list;
}

void climb(const std::string& scene, const std::string& revolutions,
           const std::string& horizon_ms) {
  const ScratchDirectory scratch;
  const Json ladder = written("ladder", scene, scratch / "ladder", revolutions, {"--samples", "2"});
  ASSERT_TRUE(ladder.is_object());
  for (const Json& rung : ladder["rungs"]) EXPECT_EQ(rung["runs_ok"], 2) << rung["name"];
  EXPECT_EQ(ladder["rungs"].size(), 8u);
  const Json& place = of(ladder["quantities"], "quantity", "ring_displacement_mean_um");
  const double still = of(place["rungs"], "rung", "quasi-static")["shift"];
  EXPECT_LT(std::abs(still), 0.02 * place["mean"].get<double>());

  const Json refined =
      written("ladder", scene, scratch / "refine", revolutions, {"--samples", "2", "--refine"});
  ASSERT_TRUE(refined.is_object());
  for (const Json& rung : refined["rungs"]) EXPECT_EQ(rung["runs_ok"], 2) << rung["name"];
  const Json& kept = of(refined["quantities"], "quantity", "ring_displacement_mean_um");
  for (const char* setting : {"integrator", "slices", "window"}) {
    const double shift = of(kept["rungs"], "rung", setting)["shift"];
    EXPECT_LT(std::abs(shift), 0.02 * kept["mean"].get<double>()) << setting;
  }

  const Json chart = written("chart", scene, scratch / "chart", revolutions,
                             {"--methods", "rodas3,rodasp", "--starts", "1", "--replicas", "0",
                              "--horizon-ms", horizon_ms});
  ASSERT_TRUE(chart.is_object());
  EXPECT_GT(chart["points"].size(), 5u);
}

class Ladders : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, Ladders, testing::Values("bore10-small"));
TEST_P(Ladders, FitTheBearing) {
  climb(GetParam(), "0.1", "0.1");
}

class NightlyLadders : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, NightlyLadders,
                         testing::Values("n1014-spindle", "nu208-brass", "bore10-small",
                                         "nu2322-gearbox", "aero118-outer"));
TEST_P(NightlyLadders, FitTheBearing) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  climb(GetParam(), "0.5", "0.5");
}

}  // namespace
}  // namespace cagetol
