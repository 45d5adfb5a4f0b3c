// The real program with the real physics, on a window of a blink.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/mpi/standin.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> sweep_of(const std::string& study, const std::string& directory,
                                  const std::string& more = "seed=5") {
  return {CAGETOL_BINARY_DIR "/cagetol",
          "sweep",
          study,
          "-o",
          directory,
          "--set",
          "samples=6",
          "--set",
          "allowed_failure_share=1",
          "--set",
          "scene.cage.model=rigid",
          "--set",
          "scene.window.settle_revolutions=0.05",
          "--set",
          "scene.window.measure_revolutions=0.1",
          "--set",
          more};
}

const std::string kShippedStudy = CAGETOL_SOURCE_DIR "/inputs/studies/nu205-rated.toml";

TEST(ProgramTest, AnyNumberOfRanksGivesTheSameFileAndEverySampleReplaysToTheBit) {
  const ScratchDirectory scratch;
  const Ended serial = run(sweep_of(kShippedStudy, scratch / "0"));
  ASSERT_EQ(serial.code, 0) << serial.output;
  for (const int ranks : {1, 2, 3}) {
    const std::string directory = scratch / std::to_string(ranks);
    ASSERT_EQ(run(with_mpirun(ranks, sweep_of(kShippedStudy, directory))).code, 0);
    EXPECT_THAT(study_file_differences(study_file_of(scratch / "0"), study_file_of(directory)),
                IsEmpty());
  }
  for (const char* id : {"0", "3", "6"}) {
    const Ended replay =
        run({CAGETOL_BINARY_DIR "/cagetol", "replay", scratch / "2", "--sample", id});
    EXPECT_EQ(replay.code, 0) << replay.output;
    EXPECT_THAT(replay.output, HasSubstr("reproduced to the bit"));
  }
}

/// The run alone decides when its window ends: some samples converge, others measure the most.
TEST(ProgramTest, OperatingPointsGiveTheSameFileOnAnyNumberOfRanks) {
  const ScratchDirectory scratch;
  const auto sweep = [&](const std::string& directory) {
    return sweep_of(CAGETOL_SOURCE_DIR "/inputs/studies/nu205-duty.toml", directory);
  };
  const Ended serial = run(sweep(scratch / "0"));
  ASSERT_EQ(serial.code, 0) << serial.output;
  EXPECT_THAT(serial.output, HasSubstr("3 operating points, each sample runs at all of them"));
  ASSERT_EQ(run(with_mpirun(3, sweep(scratch / "3"))).code, 0);
  EXPECT_THAT(study_file_differences(study_file_of(scratch / "0"), study_file_of(scratch / "3")),
              IsEmpty());
  const Ended replay =
      run({CAGETOL_BINARY_DIR "/cagetol", "replay", scratch / "3", "--sample", "4"});
  EXPECT_EQ(replay.code, 0) << replay.output;
  EXPECT_THAT(replay.output, HasSubstr("reproduced to the bit"));
  EXPECT_THAT(replay.output, HasSubstr("friction_torque_Nmm@idle"));
}

/// Pocket widths of cages from -0.2 to 0.2 mm need several cage tables, which ranks make together.
TEST(ProgramTest, FlexibleCagesMeetTheSameTablesOnAnyRankAndInAReplay) {
  const ScratchDirectory scratch;
  const auto sweep = [&](const std::string& directory) {
    auto command = sweep_of(kShippedStudy, directory, "scene.cage.model='flexible'");
    for (const char* setting :
         {"scene.cage.mesh_density=1", "scene.cage.modes=6", "scene.cage.corner_radius_mm=0",
          "document.date='some day'",
          "scene.cage.pocket_width_mm.lot={law='uniform', lower=-0.2, upper=0.2}",
          "tolerance.dimension=[{key='cage.pocket_width_mm', tolerance_width_mm=0.1, "
          "candidates=[0.1]}]"})
      command.insert(command.end(), {"--set", setting});
    return command;
  };
  const auto cached = [](const std::string& folder, std::vector<std::string> command) {
    command.insert(command.begin(), {"env", "CAGETOL_CACHE=" + folder});
    return command;
  };
  const Ended serial = run(cached(scratch / "cache-1", sweep(scratch / "1")));
  ASSERT_EQ(serial.code, 0) << serial.output;
  EXPECT_THAT(serial.output, HasSubstr("making cage table 3 of "));
  const Ended shared = run(cached(scratch / "cache-2", with_mpirun(2, sweep(scratch / "2"))));
  ASSERT_EQ(shared.code, 0) << shared.output;
  EXPECT_THAT(study_file_differences(study_file_of(scratch / "1"), study_file_of(scratch / "2")),
              IsEmpty());
  for (const char* id : {"0", "3", "5"}) {
    const Ended replay =
        run(cached(scratch / ("alone-" + std::string(id)),
                   {CAGETOL_BINARY_DIR "/cagetol", "replay", scratch / "2", "--sample", id}));
    EXPECT_THAT(replay.output, HasSubstr("reproduced to the bit"));
    EXPECT_THAT(replay.output, HasSubstr("making a cage table"));
  }
  const std::string peak = scratch / "1/cage_peak.json";
  EXPECT_EQ(file_bytes(peak), file_bytes(scratch / "2/cage_peak.json"));
  const auto report =
      cached(scratch / "none", {CAGETOL_BINARY_DIR "/cagetol", "report", scratch / "1"});
  const Ended drawn = run(report);
  EXPECT_EQ(drawn.code, 0) << drawn.output;
  EXPECT_THAT(file_bytes(scratch / "1/report.html"),
              AllOf(HasSubstr("The largest stress of all samples"),
                    HasSubstr("NU, flanges on the outer ring"), HasSubstr("steel-q235")));
  EXPECT_THAT(file_bytes(scratch / "1/report.json"), HasSubstr("\"name\": \"load ratio C/P\""));
  EXPECT_EQ(
      run({"/usr/bin/python3", "-B", CAGETOL_SOURCE_DIR "/tests/unit/analysis/numbers_of_pages.py",
           scratch / "1/report.json", scratch / "1/report.html"})
          .code,
      0);
  std::filesystem::remove(peak);
  EXPECT_EQ(run(report).code, 0);
  EXPECT_FALSE(std::filesystem::exists(peak)) << "a report runs no sample";
  EXPECT_FALSE(std::filesystem::exists(scratch / "none"));
  EXPECT_EQ(run(cached(scratch / "cache-1", sweep(scratch / "1"))).code, 0);
  EXPECT_TRUE(std::filesystem::exists(peak)) << "a finished sweep makes up for what is missing";
}

TEST(ProgramTest, AnotherSeedIsRefusedWithKeyAndBothValues) {
  const ScratchDirectory scratch;
  ASSERT_EQ(run(sweep_of(kShippedStudy, scratch / "out")).code, 0);
  const Ended other = run(sweep_of(kShippedStudy, scratch / "out", "seed=6"));
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.output, HasSubstr("seed: 5 stored, 6 now"));
}

TEST(ProgramTest, ReplayNeedsTheStudyFileAloneNotTheMeasurements) {
  const ScratchDirectory scratch;
  std::filesystem::copy(CAGETOL_SOURCE_DIR "/inputs", scratch / "inputs",
                        std::filesystem::copy_options::recursive);
  const Ended sweep =
      run(sweep_of(scratch / "inputs/studies/nu205-measured.toml", scratch / "out"));
  ASSERT_EQ(sweep.code, 0) << sweep.output;
  std::filesystem::remove_all(scratch / "inputs");
  std::filesystem::create_directory(scratch / "copy");
  std::filesystem::copy(study_file_of(scratch / "out"), study_file_of(scratch / "copy"));
  const Ended replay =
      run({CAGETOL_BINARY_DIR "/cagetol", "replay", scratch / "copy", "--sample", "2", "--json"});
  EXPECT_EQ(replay.code, 0) << replay.output;
  EXPECT_THAT(replay.output, HasSubstr("\"reproduced\": true"));
}

TEST(ProgramTest, ReplayExplainsWhatIsMissingOrDamaged) {
  const ScratchDirectory scratch;
  const std::vector<std::string> replay = {CAGETOL_BINARY_DIR "/cagetol", "replay", scratch / "out",
                                           "--sample", "99"};
  const Ended missing = run(replay);
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.output,
              AllOf(HasSubstr("study.h5: there is no such file"), HasSubstr("remedy")));
  ASSERT_EQ(run(sweep_of(kShippedStudy, scratch / "out")).code, 0);
  const Ended beyond = run(replay);
  EXPECT_EQ(beyond.code, 2);
  EXPECT_THAT(beyond.output, HasSubstr("the study has the samples 0 to 6"));
  std::filesystem::resize_file(study_file_of(scratch / "out"), 5000);
  const Ended damaged = run(replay);
  EXPECT_EQ(damaged.code, 2);
  EXPECT_THAT(damaged.output, HasSubstr("start the same `cagetol sweep` again"));
}

TEST(ProgramTest, ABadStudyNamesFileLineKeyAndRemedyUnderMpirunToo) {
  const ScratchDirectory scratch;
  const Ended ended = run(
      with_mpirun(2, sweep_of(kShippedStudy, scratch / "out", "scene.cage.pocket_widht_mm=7.7")));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, AllOf(HasSubstr("pocket_width_mm"), HasSubstr("remedy")));
}

}  // namespace
}  // namespace cagetol
