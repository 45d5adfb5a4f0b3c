// Ranks are killed at random moments; starting the same command again ends with the same study
// file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <random>

#include "tests/mpi/standin.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

using testing::IsEmpty;

constexpr std::size_t kSamples = 60;
constexpr std::size_t kRanks = 3;

unsigned number_or(const char* variable, unsigned usual) {
  const char* asked = std::getenv(variable);
  return asked == nullptr ? usual : static_cast<unsigned>(std::atoi(asked));
}

unsigned rounds(unsigned usual) {
  return number_or("CAGETOL_KILLS", usual);
}

/// Every part of a long night, and every test, has kills of its own.
std::mt19937 random_of(unsigned test, unsigned round) {
  std::seed_seq seed{number_or("CAGETOL_KILL_SEED", 0), test, round};
  return std::mt19937(seed);
}

const std::vector<std::string> kOptions = {
    "--samples", std::to_string(kSamples), "--mean-ms", "8", "--rebuild", "0.05"};

class KillTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(run(standin(scratch_ / "whole", kOptions)).code, 0); }

  /// Starts a sweep of DIR, which has samples left to do, and calls `kill` with its ranks when a
  /// random number of them is done. A slow machine may kill too late; then all are done.
  template <class Kill>
  void kill_at_random(const std::string& directory, std::mt19937& random, Kill kill) {
    const std::size_t done = finished_in(directory);
    ASSERT_LT(done, kSamples);
    Process sweep(with_mpirun(kRanks, standin(directory, kOptions)));
    const std::vector<pid_t> ranks = ranks_of(sweep, kRanks);
    wait_for(sweep, directory, done + random() % (kSamples - done));
    const std::size_t seen = finished_in(directory);
    if (!ranks.empty()) kill(sweep, ranks);
    sweep.wait();
    EXPECT_GE(finished_in(directory), seen) << "finished samples are lost";
  }

  void expect_goes_on_to_the_same_end(const std::string& directory) {
    const Ended ended = run(with_mpirun(kRanks, standin(directory, kOptions)));
    ASSERT_EQ(ended.code, 0) << ended.output;
    EXPECT_THAT(study_file_differences(study_file_of(scratch_ / "whole"), study_file_of(directory)),
                IsEmpty());
  }

  ScratchDirectory scratch_;
};

TEST_F(KillTest, OneRankKilledAndResumed) {
  for (unsigned round = 0; round < rounds(2); ++round) {
    SCOPED_TRACE(round);
    std::mt19937 random = random_of(1, round);
    const std::string directory = scratch_ / ("round" + std::to_string(round));
    kill_at_random(directory, random, [&](Process&, const std::vector<pid_t>& ranks) {
      ::kill(ranks[random() % ranks.size()], SIGKILL);
    });
    expect_goes_on_to_the_same_end(directory);
  }
}

TEST_F(KillTest, KilledOverAndOverInOneDirectory) {
  std::mt19937 random = random_of(3, 0);
  for (int round = 0; round < 4 && finished_in(scratch_ / "out") < kSamples; ++round)
    kill_at_random(scratch_ / "out", random, [&](Process&, const std::vector<pid_t>& ranks) {
      ::kill(ranks[random() % ranks.size()], SIGKILL);
    });
  expect_goes_on_to_the_same_end(scratch_ / "out");
}

TEST_F(KillTest, AllKilledAtOnce) {
  for (unsigned round = 0; round < rounds(2); ++round) {
    SCOPED_TRACE(round);
    std::mt19937 random = random_of(2, round);
    const std::string directory = scratch_ / ("all" + std::to_string(round));
    kill_at_random(directory, random, [](Process& sweep, const std::vector<pid_t>& ranks) {
      sweep.signal(SIGKILL);
      for (const pid_t rank : ranks) ::kill(rank, SIGKILL);
    });
    expect_goes_on_to_the_same_end(directory);
  }
}

TEST_F(KillTest, SerialSweepKilledGoesOnUnderMpirun) {
  const std::string directory = scratch_ / "serial";
  Process sweep(standin(directory, kOptions));
  wait_for(sweep, directory, 5);
  sweep.signal(SIGKILL);
  sweep.wait();
  EXPECT_LT(finished_in(directory), kSamples);
  expect_goes_on_to_the_same_end(directory);
}

}  // namespace
}  // namespace cagetol
