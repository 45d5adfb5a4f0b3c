// A study that chooses its model by itself, as users start it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Fidelity : public testing::Test {
 protected:
  struct Ended {
    int code;
    std::string output;
  };
  Ended run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), std::string(CAGETOL_BINARY_DIR) + "/cagetol");
    Process process(arguments, [&] { ::setenv("CAGETOL_CACHE", (scratch_ / "cache").c_str(), 1); });
    const int code = process.wait();
    return {code, process.output()};
  }
  /// A study, made short.
  Ended sweep(const std::string& directory, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"sweep", shipped("studies/nu205-slip.toml"), "-o",
                                          scratch_ / directory};
    for (const char* setting :
         {"samples=12", "fidelity_samples=8", "scene.window.settle_revolutions=0.3",
          "scene.window.measure_revolutions=0.3", "scene.cage.mesh_density=2",
          "scene.cage.corner_radius_mm=0", "scene.watch.energy_residual_max=1000",
          "scene.watch.static_consistency_max=1000"})
      arguments.insert(arguments.end(), {"--set", setting});
    for (const std::string& setting : more) arguments.insert(arguments.end(), {"--set", setting});
    return run(arguments);
  }
  bool climbed(const std::string& directory, const std::string& rung) const {
    return std::filesystem::exists(scratch_ / (directory + "/fidelity/" + rung + "/study.h5"));
  }

  /// So far that a handful of short runs settles it, whatever their bits.
  const std::vector<std::string> far_limit_ = {
      "limit=[{quantity='cage_slip_ratio', max=0.5, source='test'}]"};
  ScratchDirectory scratch_;
};

TEST_F(Fidelity, ASettledLimitTakesTheCheapestRungAndThePilotsRuns) {
  const Ended automatic = sweep("auto", far_limit_);
  ASSERT_EQ(automatic.code, 0) << automatic.output;
  EXPECT_THAT(automatic.output,
              HasSubstr("fidelity: coarse-3, the cheapest rung that is good enough"));
  EXPECT_THAT(automatic.output, HasSubstr("8 runs of the pilot are the study's own"));
  EXPECT_THAT(automatic.output, HasSubstr("8 of 13 samples are already done"));
  EXPECT_TRUE(climbed("auto", "full"));
  EXPECT_FALSE(climbed("auto", "coarse-5"));
  EXPECT_THAT(automatic.output, HasSubstr("3 of 8 samples are already done"));  // a first look's
  std::ifstream file(scratch_ / "auto/fidelity/ladder.json");
  const auto ladder = nlohmann::json::parse(file);
  EXPECT_EQ(ladder["rungs_not_run"].size(), 5u);
  EXPECT_EQ(ladder["rungs_not_run"][0], "coarse-5");
  EXPECT_THAT(ladder["settled_assumes"].get<std::string>(), HasSubstr("scatter normally"));
  for (const auto& quantity : ladder["quantities"])
    if (quantity["quantity"] == "cage_slip_ratio") {
      EXPECT_EQ(quantity["rungs"][1]["verdict"], "settled");
      EXPECT_LT(quantity["rungs"][1]["wrong_share"], quantity["allowed_wrong_share"]);
      EXPECT_EQ(quantity["limits"][0]["maximum"], 0.5);
    }
  // The same study, decided, without the pilot's help: the same bits.
  const Ended pinned = run({"sweep", scratch_ / "auto/study.toml", "-o", scratch_ / "pinned"});
  ASSERT_EQ(pinned.code, 0) << pinned.output;
  EXPECT_THAT(pinned.output, Not(HasSubstr("pilot")));
  EXPECT_THAT(study_file_differences(scratch_ / "auto/study.h5", scratch_ / "pinned/study.h5"),
              IsEmpty());
  EXPECT_EQ(sweep("auto", far_limit_).code, 0);  // nothing is left to do
  const Ended report = run({"report", scratch_ / "auto"});
  ASSERT_EQ(report.code, 0) << report.output;
  std::ifstream page(scratch_ / "auto/report.html");
  const std::string html(std::istreambuf_iterator<char>(page), {});
  EXPECT_THAT(html, HasSubstr("<b>Settled</b>"));
}

TEST_F(Fidelity, ALimitThatTheReferenceLeavesOpenTakesTheHighestRung) {
  const Ended ended =
      sweep("auto", {"limit=[{quantity='cage_slip_ratio', max=0.0078, source='test'}]"});
  ASSERT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(ended.output,
              HasSubstr("fidelity: full, the highest rung: a first look at 3 samples finds no "
                        "other within reach; the pilot cost about"));
  EXPECT_TRUE(climbed("auto", "first-look/coarse-3"));
  EXPECT_FALSE(climbed("auto", "coarse-3"));
  EXPECT_FALSE(climbed("auto", "coarse-5"));  // hopeless
  EXPECT_THAT(ended.output, HasSubstr("8 runs of the pilot are the study's own"));
}

TEST_F(Fidelity, RunsOfAnotherDesignAreNotAdopted) {
  const Ended ended = sweep("auto", {far_limit_[0], "design='lhs'"});
  ASSERT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(ended.output, HasSubstr("fidelity: coarse-3"));
  EXPECT_THAT(ended.output, Not(HasSubstr("runs of the pilot")));
}

}  // namespace
}  // namespace cagetol
