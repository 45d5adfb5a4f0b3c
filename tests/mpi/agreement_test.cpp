// Ranks that were given different things do not start; nor does one that MPI did not join.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "mc/sweep/sweep_directory.hpp"
#include "tests/mpi/standin.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// `mpirun -n 1 FIRST : -n 2 OTHERS`.
std::vector<std::string> mixed(const std::vector<std::string>& first,
                               const std::vector<std::string>& others) {
  auto words = with_mpirun(1, first);
  words.insert(words.end(), {":", "-np", "2"});
  words.insert(words.end(), others.begin(), others.end());
  return words;
}

std::vector<std::string> with_environment(std::vector<std::string> settings,
                                          const std::vector<std::string>& command) {
  settings.insert(settings.begin(), "env");
  settings.insert(settings.end(), command.begin(), command.end());
  return settings;
}

class AgreementTest : public testing::Test {
 protected:
  std::string directory_of(const std::string& name) { return scratch_ / name; }
  /// Bytes of journals: none where no sample was run.
  std::uintmax_t journalled(const std::string& directory) {
    const std::string journal = longest_journal(directory);
    return journal.empty() ? 0 : fs::file_size(journal);
  }
  ScratchDirectory scratch_;
  std::string out_ = scratch_ / "out";
};

TEST_F(AgreementTest, RanksWithDifferentStudiesAreRefusedWithKeyRanksAndValues) {
  const Ended ended = run(mixed(standin(out_, {"--load", "8"}), standin(out_, {"--load", "7"})));
  EXPECT_EQ(ended.code, 2) << ended.output;
  EXPECT_THAT(ended.output,
              AllOf(HasSubstr("rank 1 on "), HasSubstr(" has scene.load.radial_N = 7, rank 0 on "),
                    HasSubstr(" has scene.load.radial_N = 8"), HasSubstr("remedy")));
  EXPECT_EQ(finished_in(out_), 0u);
}

TEST_F(AgreementTest, RanksThatReadAnotherFileAreRefusedWithItsName) {
  const Ended ended = run(mixed(standin(out_), standin(out_, {"--file-hash", "feedbeef"})));
  EXPECT_EQ(ended.code, 2) << ended.output;
  EXPECT_THAT(ended.output, AllOf(HasSubstr("file measured.csv has hash feedbeef"),
                                  HasSubstr("file measured.csv has hash 0123456789abcdef")));
  EXPECT_EQ(finished_in(out_), 0u);
}

TEST_F(AgreementTest, RanksOfDifferentBuildsAreRefusedWithBothNamed) {
  const std::string other = scratch_ / "other_build";
  fs::copy_file(CAGETOL_BINARY_DIR "/standin_sweep", other);
  std::ofstream(other, std::ios::app) << "x";
  const Ended ended = run(mixed(standin(out_), {other, out_}));
  EXPECT_EQ(ended.code, 2) << ended.output;
  EXPECT_THAT(ended.output, AllOf(HasSubstr("the ranks run different programs"),
                                  HasSubstr("rank 1 on "), HasSubstr("remedy")));
  EXPECT_EQ(finished_in(out_), 0u);
}

TEST_F(AgreementTest, RanksWithDifferentDirectoriesAreRefusedWithHostAndFile) {
  fs::create_directories(journal_directory(directory_of("theirs")));
  const Ended ended = run(mixed(standin(out_), standin(directory_of("theirs"))));
  EXPECT_EQ(ended.code, 2) << ended.output;
  EXPECT_THAT(ended.output, AllOf(HasSubstr("is another directory to rank 1 on "),
                                  HasSubstr("file system that all hosts share")));
  EXPECT_EQ(journalled(directory_of("theirs")), 0u);
}

TEST_F(AgreementTest, OneSweepAndARecommendationDoNotMix) {
  const std::vector<std::string> recommend = {CAGETOL_BINARY_DIR "/standin_recommend",
                                              CAGETOL_SOURCE_DIR "/inputs/studies/nu205-rated.toml",
                                              out_};
  const Ended ended = run(mixed(standin(out_), recommend));
  EXPECT_EQ(ended.code, 2) << ended.output;
  EXPECT_THAT(ended.output, HasSubstr("runs one sweep with"));
  EXPECT_THAT(ended.output, HasSubstr("runs several sweeps with"));
}

/// A launcher that Open MPI cannot join leaves each process alone.
TEST_F(AgreementTest, ARankThatMpiDidNotJoinEndsWith2AndWritesNothing) {
  for (const char* rank : {"0", "1"}) {
    const Ended ended =
        run(with_environment({std::string("PMI_RANK=") + rank, "PMI_SIZE=2"}, standin(out_)));
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_THAT(ended.output,
                AllOf(HasSubstr(std::string("as rank ") + rank + " of 2"),
                      HasSubstr("MPI knows it as rank 0 of 1"), HasSubstr("srun --mpi=pmix")));
  }
  EXPECT_EQ(run(with_environment({"PMI_RANK=1"}, standin(out_))).code, 2);
  EXPECT_EQ(journalled(out_), 0u);
}

TEST_F(AgreementTest, ALauncherOfOneProcessIsNoMatter) {
  EXPECT_EQ(run(with_environment({"PMI_RANK=0", "PMI_SIZE=1"}, standin(out_))).code, 0);
  EXPECT_EQ(finished_in(out_), 40u);
}

TEST_F(AgreementTest, TasksOfSrunWithoutPmixAreRefused) {
  const Ended ended =
      run(with_environment({"SLURM_STEP_NUM_TASKS=4", "SLURM_PROCID=3"}, standin(out_)));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, AllOf(HasSubstr("srun started 4 tasks"), HasSubstr("--mpi=pmix")));
  EXPECT_THAT(longest_journal(out_), IsEmpty());
}

TEST_F(AgreementTest, AnEnvironmentThatLostMpirunsOwnVariablesIsRefused) {
  const Ended ended = run(with_environment(
      {"OMPI_COMM_WORLD_RANK=1", "OMPI_COMM_WORLD_SIZE=2", "OMPI_COMM_WORLD_LOCAL_RANK=1"},
      standin(out_)));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, AllOf(HasSubstr("PMIX_NAMESPACE"), HasSubstr("remedy")));
}

}  // namespace
}  // namespace cagetol
