// `cagetol map` as users start it: what it refuses, a cell that cannot be made, a map beside runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/file_bytes.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::Not;

class MapCommand : public testing::Test {
 protected:
  struct Said {
    int code;
    std::string text;
  };
  static Said run(std::vector<std::string> words) {
    words.insert(words.begin(), std::string(CAGETOL_BINARY_DIR) + "/cagetol");
    Process process(words);
    const int code = process.wait();
    return {code, process.output()};
  }
  /// On a bearing that hardly sheds its heat, in runs of a moment.
  Said study(const std::string& command, const std::vector<std::string>& more) const {
    std::vector<std::string> words = {command, shipped("studies/nu205-map.toml"), "-o",
                                      scratch_ / "out"};
    for (const char* setting : {"scene.cage.model=rigid", "scene.window.settle_revolutions=0.3",
                                "scene.window.measure_revolutions=0.3", "map.budget_samples=20",
                                "samples=20", "map.border_samples=20", "allowed_failure_share=1",
                                "scene.temperature.conductance_W_K=0.15", "operating_point=[]",
                                "limit=[{quantity='driving_slip_ratio', max=0.3, source='test'}]"})
      words.insert(words.end(), {"--set", setting});
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  Said map(const std::string& up, const std::string& across) const {
    return study("map", {"--over", up, "--over", across});
  }
  const ScratchDirectory scratch_;
};

TEST_F(MapCommand, RefusesWhatMakesNoMap) {
  const std::string load = "load.radial_N=500,2000";
  const auto refused = [&](const std::vector<std::string>& over, const std::string& message) {
    std::vector<std::string> words;
    for (const std::string& axis : over) words.insert(words.end(), {"--over", axis});
    const Said said = study("map", words);
    EXPECT_EQ(said.code, 2) << said.text;
    EXPECT_THAT(said.text, HasSubstr(message));
  };
  refused({load}, "--over = load.radial_N=500,2000: a map is over two keys");
  refused({load, load}, "a map is over two keys");
  refused({load, "speed.inner_rpm=9..1:4"}, "--over = speed.inner_rpm=9..1:4: the values do not");
  refused({load, "speed.inner=1,2"}, "speed.inner_rpm");
  refused({load, "cage.width_mm=13,14"}, "nothing that the bearing is");
  const Said scene = run({"map", shipped("scenes/nu205.toml"), "-o", scratch_ / "out", "--over",
                          load, "--over", "speed.inner_rpm=3000,4000"});
  EXPECT_EQ(scene.code, 2) << scene.text;
  EXPECT_THAT(scene.text, HasSubstr("the study has no limits"));
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "out"));
}

TEST_F(MapCommand, ShowsACellThatCannotBeMadeAndAReportShowsTheMap) {
  const Said made = map("load.radial_N=1000,2000", "speed.inner_rpm=3000,16000");
  ASSERT_EQ(made.code, 0) << made.text;
  EXPECT_THAT(made.text, HasSubstr("speed.inner_rpm 16000: no answer: "));
  const auto stored = nlohmann::json::parse(file_bytes(scratch_ / "out/map/map.json"));
  EXPECT_EQ(stored["rows"][0]["problem"], "");
  EXPECT_EQ(stored["rows"][0]["decides"], "jams");
  EXPECT_THAT(stored["rows"][1]["problem"].get<std::string>(), HasSubstr("degC"));
  EXPECT_EQ(stored["points"][0]["at"].dump(), "[1000.0,6000.0]");
  EXPECT_EQ(stored["lines"][0]["name"], "minimum load");
  const std::string csv = file_bytes(scratch_ / "out/map/map.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  const std::string page = file_bytes(scratch_ / "out/map/map.html");
  EXPECT_THAT(page, HasSubstr("no answer: "));
  EXPECT_THAT(page, HasSubstr("data:image/svg+xml"));
  // Alone its pages are written again, beside runs the report has it.
  std::filesystem::remove(scratch_ / "out/map/map.html");
  const Said alone = run({"report", scratch_ / "out"});
  EXPECT_EQ(alone.code, 0) << alone.text;
  EXPECT_EQ(file_bytes(scratch_ / "out/map/map.html"), page);
  ASSERT_EQ(study("sweep", {}).code, 0);
  ASSERT_EQ(run({"report", scratch_ / "out"}).code, 0);
  EXPECT_EQ(nlohmann::json::parse(file_bytes(scratch_ / "out/report.json"))["map"], stored);
  EXPECT_THAT(file_bytes(scratch_ / "out/report.html"), HasSubstr("Where it matters"));
  EXPECT_TRUE(std::filesystem::exists(scratch_ / "out/figures/map.svg"));
}

}  // namespace
}  // namespace cagetol
