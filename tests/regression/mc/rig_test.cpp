// `cagetol rig` as users start it, on a dry bearing and short runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

class Rig : public testing::Test {
 protected:
  std::vector<std::string> command(const std::string& csv, const std::string& directory,
                                   std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {std::string(CAGETOL_BINARY_DIR) + "/cagetol",
                                      "rig",
                                      shipped("scenes/nu205.toml"),
                                      scratch_ / csv,
                                      "-o",
                                      scratch_ / directory,
                                      "--starts",
                                      "3"};
    words.insert(words.end(), more.begin(), more.end());
    for (const char* setting : {"window.settle_revolutions=0.3", "window.measure_revolutions=0.3",
                                "lubrication.model=none", "watch.energy_residual_max=1000",
                                "watch.static_consistency_max=1000"})
      words.insert(words.end(), {"--set", setting});
    return words;
  }
  void write(const std::string& csv, const std::string& rows) const {
    std::ofstream(scratch_ / csv) << "radial_N,speed_rpm,cage_order\n" << rows;
  }
  nlohmann::json read(const std::string& directory) const {
    std::ifstream file(scratch_ / directory + "/rig.json");
    return nlohmann::json::parse(file);
  }
  const ScratchDirectory scratch_;
};

TEST_F(Rig, HoldsEachRowAgainstStartsAndAssumptionsWithAnyNumberOfRanks) {
  write("one.csv", "1000,6000,0.3\n");
  Process serial(command("one.csv", "serial"));
  ASSERT_EQ(serial.wait(), 0) << serial.output();
  EXPECT_THAT(serial.output(), HasSubstr("no assumption"));
  const auto rig = read("serial");
  ASSERT_EQ(rig["rows"].size(), 1U);
  const auto& row = rig["rows"][0];
  EXPECT_EQ(row["standing"], "outside");  // a dry cage does not slip by a quarter
  EXPECT_NEAR(row["measured_slip"].get<double>(), 1 - 0.3 / 0.40365, 1e-4);
  // Shifts by assumptions widen it, to the side that each goes: which ones depends on the motion.
  EXPECT_LE(row["lower"], row["starts_lower"]);
  EXPECT_GE(row["upper"], row["starts_upper"]);
  EXPECT_GT(row["upper"].get<double>() - row["lower"].get<double>(),
            row["starts_upper"].get<double>() - row["starts_lower"].get<double>());
  EXPECT_NEAR(row["outer_passing_order"].get<double>(), 13 * row["order"].get<double>(), 1e-9);
  EXPECT_EQ(rig["ends"], 2 * row["shifts"].size() - 1);  // gravity is at its upper end as it is
  for (const char* file : {"rig.csv", "rig.html", "figures/rig.svg"})
    EXPECT_TRUE(std::filesystem::exists(scratch_ / "serial/" + file)) << file;
  Process parallel(with_mpirun(2, command("one.csv", "mpi")));
  ASSERT_EQ(parallel.wait(), 0) << parallel.output();
  EXPECT_EQ(read("mpi"), rig);
}

TEST_F(Rig, RowsOfTheSameLoadAndSpeedShareTheirRuns) {
  write("first.csv", "500,3000,0.4\n");
  write("second.csv", "500,3000,0.2\n500,3000,0.402\n");
  Process first(command("first.csv", "out", {"--starts-only"}));
  ASSERT_EQ(first.wait(), 0) << first.output();
  const auto before =
      std::filesystem::last_write_time(scratch_ / "out/rows/500N-3000rpm/base/study.h5");
  Process second(command("second.csv", "out", {"--starts-only"}));
  ASSERT_EQ(second.wait(), 0) << second.output();
  EXPECT_EQ(std::filesystem::last_write_time(scratch_ / "out/rows/500N-3000rpm/base/study.h5"),
            before);
  EXPECT_EQ(read("out")["rows"][0]["slip"], read("out")["rows"][1]["slip"]);
}

TEST_F(Rig, RefusesWhatNoRigMeasures) {
  write("fast.csv", "500,3000,1.4\n");
  Process fast(command("fast.csv", "out"));
  EXPECT_EQ(fast.wait(), 2);
  EXPECT_THAT(fast.output(),
              HasSubstr("fast.csv:2: cage order = 1.4: the cage turns backwards, or"));
  write("one.csv", "500,3000,0.4\n");
  Process turning(command("one.csv", "out", {"--set", "speed.outer_rpm=10"}));
  EXPECT_EQ(turning.wait(), 2);
  EXPECT_THAT(turning.output(), HasSubstr("the outer ring turns"));
}

}  // namespace
}  // namespace cagetol
