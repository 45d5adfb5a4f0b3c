// A map of screens: any number of ranks, ended anywhere, the same cells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "mc/sweep/stored_study.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "tests/mpi/standin.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

/// The stand-in slips by how far its widest pocket is too wide, in proportion to the speed; it has
/// no result above 20,000 r/min.
constexpr const char* kMapStudy = R"(name = "cells"
seed = 5
[scene]
file = ")" CAGETOL_SOURCE_DIR R"(/inputs/scenes/nu205.toml"
[scene.cage]
pocket_width_mm = { nominal = 7.65, pocket = { law = "normal", sigma = 0.009 } }
[scene.start]
cage_phase_deg = { noise = { law = "uniform", lower = 0, upper = 1 } }
[[limit]]
quantity = "cage_slip_ratio"
max = 0.04
source = "test"
[tolerance]
target_yield = 0.9
[[tolerance.dimension]]
key = "cage.pocket_width_mm"
tolerance_width_mm = 0.1
candidates = ["IT11", "IT12", "IT13", "IT14", 0.8]
[map]
budget_samples = 20
border_samples = 20
)";

class MapTest : public testing::Test {
 protected:
  MapTest() { std::ofstream(scratch_ / "study.toml") << kMapStudy; }

  std::vector<std::string> map(const std::string& directory,
                               const std::vector<std::string>& options = {},
                               const std::string& speeds = "600,6000,18000,24000") const {
    std::vector<std::string> command = {CAGETOL_BINARY_DIR "/standin_recommend",
                                        scratch_ / "study.toml",
                                        scratch_ / directory,
                                        "--over",
                                        "load.radial_N=500,2000",
                                        "--over",
                                        "speed.inner_rpm=" + speeds};
    command.insert(command.end(), options.begin(), options.end());
    return command;
  }
  std::string text(const std::string& directory) const {
    return file_bytes(scratch_ / (directory + "/map/map.json"));
  }
  /// Stages of all cells.
  std::vector<std::string> stages(const std::string& directory) const {
    std::vector<std::string> list;
    const fs::path map = scratch_ / (directory + "/map");
    for (const auto& entry : fs::recursive_directory_iterator(map))
      if (entry.path().filename() == "study.h5")
        list.push_back(fs::relative(entry.path().parent_path(), map));
    std::sort(list.begin(), list.end());
    return list;
  }
  void expect_same(const std::string& first, const std::string& second) const {
    EXPECT_EQ(text(first), text(second));
    ASSERT_EQ(stages(first), stages(second));
    for (const std::string& stage : stages(first)) {
      const auto file = [&](const std::string& directory) {
        return study_file_path(scratch_ / (directory + "/map/" + stage));
      };
      EXPECT_THAT(study_file_differences(file(first), file(second)), IsEmpty()) << stage;
    }
  }

  ScratchDirectory scratch_;
};

TEST_F(MapTest, SaysWhatDecidesInEachCellOnAnyNumberOfRanksAndAfterKills) {
  const Ended serial = run(map("serial"));
  ASSERT_EQ(serial.code, 0) << serial.output;
  const auto rows = nlohmann::json::parse(text("serial"))["rows"];
  ASSERT_EQ(rows.size(), 8U);
  const auto& slow = rows[0];
  EXPECT_EQ(slow["decides"], "jams");
  EXPECT_EQ(slow["lower_mm"], slow["upper_mm"]);
  // 1.00, 0.98 and 0.76 of the cages of IT11, IT12 and IT13 keep the limit at 6000 r/min.
  const auto& rated = rows[1];
  EXPECT_EQ(rated["decides"], "cage_slip_ratio");
  EXPECT_EQ(rated["grade"], "IT12");
  EXPECT_EQ(rated["runner_up"], "jams");
  EXPECT_LT(rated["lower_mm"], rated["width_mm"]);
  EXPECT_EQ(rows[2]["candidate"], -1);
  EXPECT_THAT(rows[3]["problem"].get<std::string>(), HasSubstr("too few"));
  // Loads do nothing in the stand-in: the rows of one are those of the other.
  EXPECT_EQ(rows[5]["width_mm"], rated["width_mm"]);
  // More where the interval holds two candidates and a neighbour differs, or too few had results.
  EXPECT_EQ(stages("serial").size(), 12U);
  EXPECT_EQ(rated["runs"], 40);
  EXPECT_EQ(slow["runs"], 20);
  for (const char* file : {"map.html", "map.csv", "figures/map.svg"})
    EXPECT_TRUE(fs::exists(scratch_ / (std::string("serial/map/") + file))) << file;

  ASSERT_EQ(run(with_mpirun(2, map("ranks"))).code, 0);
  expect_same("serial", "ranks");
  for (const char* stage : {"load.radial_N-500_speed.inner_rpm-600/screen",
                            "load.radial_N-2000_speed.inner_rpm-6000/screen",
                            "load.radial_N-2000_speed.inner_rpm-6000/more"}) {
    Process process(map("killed", {"--ms", "20"}));
    wait_for(process, scratch_ / (std::string("killed/map/") + stage), 5);
    process.signal(SIGKILL);
    process.wait();
    EXPECT_FALSE(fs::exists(scratch_ / "killed/map/map.json"));
  }
  ASSERT_EQ(run(with_mpirun(2, map("killed"))).code, 0);
  expect_same("serial", "killed");
}

TEST_F(MapTest, CellsOfOneAnswerTakeNoFurtherRunsAndAnotherGridTakesWhatIsThere) {
  const Ended one = run(map("out", {}, "600,700"));
  ASSERT_EQ(one.code, 0) << one.output;
  EXPECT_THAT(stages("out"), testing::Each(HasSubstr("screen")));
  EXPECT_EQ(stages("out").size(), 4U);
  const auto file =
      study_file_path(scratch_ / "out/map/load.radial_N-500_speed.inner_rpm-600/screen");
  const auto written = fs::last_write_time(file);
  ASSERT_EQ(run(map("out", {}, "600,800")).code, 0);
  EXPECT_EQ(fs::last_write_time(file), written);
  EXPECT_EQ(nlohmann::json::parse(text("out"))["axes"][1]["values"].dump(), "[600.0,800.0]");
}

TEST_F(MapTest, EndsWithoutAMapWhereNoCellHasAnAnswer) {
  const Ended none = run(with_mpirun(2, map("out", {}, "24000,25000")));
  EXPECT_EQ(none.code, 3) << none.output;
  EXPECT_THAT(none.output, HasSubstr("no cell has an answer; the first: "));
  EXPECT_FALSE(fs::exists(scratch_ / "out/map/map.json"));
}

TEST_F(MapTest, ZonesMayLieAboveTheNominalValueButAllAlike) {
  const auto with = [&](const std::string& candidates) {
    std::string changed = kMapStudy;
    const auto from = changed.find("candidates"), to = changed.find("[map]");
    changed.replace(from, to - from, "candidates = " + candidates + "\n");
    std::ofstream(scratch_ / "study.toml") << changed;
  };
  with("[\"js11\", \"H12\"]");
  const Ended mixed = run(map("mixed", {}, "600,700"));
  EXPECT_EQ(mixed.code, 2) << mixed.output;
  EXPECT_THAT(mixed.output, testing::AllOf(HasSubstr("tolerance.dimension.candidates = H12"),
                                           HasSubstr("all H or all js")));
  // Above the nominal value no pocket is too narrow for its roller.
  with("[\"H11\", \"H12\", \"H14\"]");
  ASSERT_EQ(run(map("above", {}, "600,700")).code, 0);
  const auto row = nlohmann::json::parse(text("above"))["rows"][0];
  EXPECT_EQ(row["grade"], "H14") << row.dump();
  EXPECT_EQ(row["decides"], "");
}

}  // namespace
}  // namespace cagetol
