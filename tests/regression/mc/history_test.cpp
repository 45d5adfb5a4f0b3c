// `cagetol history` over sweeps of short quasi-static studies.
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

constexpr const char* kQuantity = "ring_displacement_mean_um";

struct CommandEnd {
  int code;
  std::string output;
};

CommandEnd run_program(std::vector<std::string> words) {
  words.insert(words.begin(), std::string(CAGETOL_BINARY_DIR) + "/cagetol");
  Process process(words);
  const int code = process.wait();
  return {code, process.output()};
}

class History : public testing::Test {
 protected:
  std::string sweep(const std::string& night, const std::vector<std::string>& settings) const {
    std::vector<std::string> words = {"sweep",      shipped("studies/nu205-displacement.toml"),
                                      "-o",         scratch_ / night,
                                      "--progress", "off"};
    for (const std::string setting :
         {"samples=40", "scene.model.motion=quasi-static", "scene.window.measure_revolutions=1"})
      words.insert(words.end(), {"--set", setting});
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    const CommandEnd ended = run_program(words);
    EXPECT_EQ(ended.code, 0) << ended.output;
    return scratch_ / night;
  }
  const ScratchDirectory scratch_;
};

TEST_F(History, NamesWhatChangedFromNightToNight) {
  const std::string first = sweep("first", {}), same = sweep("same", {}),
                    looser = sweep("looser",
                                   {"scene.bearing.internal_clearance_um={nominal=40, lot={law="
                                    "'normal', sigma=2.5}}"}),
                    out = scratch_ / "out";
  const CommandEnd ended = run_program({"history", first, same, looser, "-o", out});
  ASSERT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(ended.output, HasSubstr(std::string("changed: mean of ") + kQuantity));
  EXPECT_THAT(ended.output, HasSubstr("inputs[bearing.internal_clearance_um].nominal"));
  const auto rows = nlohmann::json::parse(file_bytes(out + "/history.json"))["rows"];
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_TRUE(rows[0]["changed"].is_null());
  EXPECT_EQ(rows[1]["changed"], 0);
  EXPECT_EQ(rows[1]["yield"], rows[0]["yield"]);
  EXPECT_GT(rows[2]["changed"].get<int>(), 3);
  const auto &before = rows[1]["quantities"][kQuantity], &after = rows[2]["quantities"][kQuantity];
  EXPECT_GT(after["mean"].get<double>(), 1.1 * before["mean"].get<double>());
  EXPECT_LT(before["mean_lower"], before["mean"]);
  for (const auto& change : rows[2]["changes"])
    if (change["quantity"] == kQuantity && change["statistic"] == "mean") {
      EXPECT_NEAR(change["new"].get<double>(), after["mean"].get<double>(), 1e-9);
    }
  for (const char* file : {"/history.html", "/history.csv", "/figures/history.svg"})
    EXPECT_TRUE(std::filesystem::exists(out + file)) << file;
  EXPECT_THAT(file_bytes(out + "/history.html"), HasSubstr("scene.bearing.internal_clearance_um"));
}

TEST_F(History, SaysWhyTwoStudiesCannotBeCompared) {
  const std::string first = sweep("first", {}),
                    lone = sweep("lone", {"samples=1", "allowed_failure_share=1"});
  const CommandEnd ended = run_program({"history", first, lone, "-o", scratch_ / "out"});
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(ended.output,
              HasSubstr("not comparable with the study before: the new study has fewer"));
  EXPECT_EQ(run_program({"history", first, "-o", scratch_ / "out"}).code, 2);
  const CommandEnd missing =
      run_program({"history", first, scratch_ / "nowhere", "-o", scratch_ / "out"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.output, HasSubstr("nowhere"));
}

}  // namespace
}  // namespace cagetol
