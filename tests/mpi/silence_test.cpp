// A rank that falls silent ends the run within the stated time; nothing finished is lost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "mc/sweep/journal.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "tests/mpi/standin.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> kSlow = {"--samples", "60", "--mean-ms", "1500"};
const std::vector<std::string> kFast = {"--samples", "60", "--mean-ms", "0.2"};

/// The rank of an MPI process.
int rank_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/environ");
  const std::string name = "OMPI_COMM_WORLD_RANK=";
  for (std::string setting; std::getline(file, setting, '\0');)
    if (setting.starts_with(name)) return std::stoi(setting.substr(name.size()));
  return -1;
}

class SilenceTest : public testing::TestWithParam<int> {};

/// A stopped process is silent, as one behind a cut link is; samples take longer than beats.
TEST_P(SilenceTest, EndsTheRunWithin75AndLosesNothing) {
  const ScratchDirectory scratch;
  const std::string out = scratch / "out";
  auto command = with_mpirun(3, standin(out, kSlow));
  command.insert(command.begin(), {"env", "CAGETOL_SILENCE_S=3"});
  Process sweep(command);
  std::vector<pid_t> ranks;
  while (sweep.running() && ranks.size() < 3) ranks = processes_below(sweep.id(), "standin_sweep");
  wait_for(sweep, out, 3);
  const std::size_t finished = finished_in(out);
  for (const pid_t rank : ranks)
    if (rank_of(rank) == GetParam()) ::kill(rank, SIGSTOP);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(sweep.wait(), 75) << sweep.output();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
  EXPECT_THAT(sweep.output(), AllOf(HasSubstr("rank " + std::to_string(GetParam()) + " on "),
                                    HasSubstr("has been silent for 3 s"), HasSubstr("remedy")));
  EXPECT_GE(finished_in(out), finished);
  ASSERT_EQ(run(with_mpirun(2, standin(out, kFast))).code, 0);
  ASSERT_EQ(run(standin(scratch / "whole", kFast)).code, 0);
  EXPECT_THAT(study_file_differences(study_file_of(scratch / "whole"), study_file_of(out)),
              IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(OfRank, SilenceTest, testing::Values(0, 2));

TEST(Silence, AnImpossibleLimitIsRefused) {
  const ScratchDirectory scratch;
  auto command = with_mpirun(2, standin(scratch / "out"));
  command.insert(command.begin(), {"env", "CAGETOL_SILENCE_S=soon"});
  const Ended ended = run(command);
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, HasSubstr("CAGETOL_SILENCE_S = soon"));
}

class DirectoryGone : public testing::TestWithParam<int> {};

TEST_P(DirectoryGone, IsSaidAtOnceAndEndsEveryRank) {
  const ScratchDirectory scratch;
  const std::string out = scratch / "out";
  const auto command = standin(out, {"--samples", "400", "--mean-ms", "3000"});
  Process sweep(GetParam() == 0 ? command : with_mpirun(GetParam(), command));
  wait_for(sweep, out, 2);
  std::error_code ignored;
  while (fs::exists(out)) fs::remove_all(out, ignored);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(sweep.wait(), 75) << sweep.output();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
  EXPECT_THAT(sweep.output(), AllOf(HasSubstr(journal_directory(out)),
                                    HasSubstr("removed or renamed"), HasSubstr("remedy")));
  EXPECT_FALSE(fs::exists(out));
}

INSTANTIATE_TEST_SUITE_P(Ranks, DirectoryGone, testing::Values(0, 2));

TEST(DirectoryRenamed, IsSaidToo) {
  const ScratchDirectory scratch;
  const std::string out = scratch / "out", moved = scratch / "moved";
  Process sweep(standin(out, {"--samples", "60", "--mean-ms", "300"}));
  wait_for(sweep, out, 2);
  fs::rename(out, moved);
  EXPECT_EQ(sweep.wait(), 75) << sweep.output();
  EXPECT_THAT(sweep.output(), HasSubstr("removed or renamed"));
  fs::rename(moved, out);
  EXPECT_GE(finished_in(out), 2u);
  EXPECT_EQ(run(standin(out, kFast)).code, 0);
}

}  // namespace
}  // namespace cagetol
