// Signals end a sweep early without losing what is finished.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "mc/sweep/journal.hpp"
#include "mc/sweep/stored_study.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "tests/mpi/standin.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// mpirun takes a second to pass SIGTERM on: enough samples to be interrupted in. Run times are no
// part of the study.
constexpr std::size_t kSamples = 300;
const std::vector<std::string> kOptions = {"--samples", "300", "--mean-ms", "60"};
const std::vector<std::string> kFastOptions = {"--samples", "300", "--mean-ms", "0.2"};

class SignalTest : public testing::Test {
 protected:
  /// Sends the signal to a running sweep when some samples are done; its end.
  Ended interrupted(const std::vector<std::string>& command, int number) {
    Process sweep(command);
    wait_for(sweep, directory_, 6);
    sweep.signal(number);
    const int code = sweep.wait();
    return {code, sweep.output()};
  }

  void expect_stored_and_goes_on() {
    const std::size_t finished = finished_in(directory_);
    EXPECT_LT(finished, kSamples);
    EXPECT_EQ(read_study_file(study_file_of(directory_)).outcomes.size(), finished);
    EXPECT_THAT(read_journals(journal_directory(directory_)).losses, IsEmpty());
    ASSERT_EQ(run(with_mpirun(2, standin(directory_, kFastOptions))).code, 0);
    ASSERT_EQ(run(standin(scratch_ / "whole", kFastOptions)).code, 0);
    EXPECT_THAT(
        study_file_differences(study_file_of(scratch_ / "whole"), study_file_of(directory_)),
        IsEmpty());
  }

  ScratchDirectory scratch_;
  std::string directory_ = scratch_ / "out";
};

TEST_F(SignalTest, Usr1ToMpirunDrains) {
  const Ended ended = interrupted(with_mpirun(3, standin(directory_, kOptions)), SIGUSR1);
  EXPECT_EQ(ended.code, 75) << ended.output;
  EXPECT_THAT(ended.output, HasSubstr("start the same command again to go on"));
  expect_stored_and_goes_on();
}

TEST_F(SignalTest, Usr1ToASerialSweepDrains) {
  EXPECT_EQ(interrupted(standin(directory_, kOptions), SIGUSR1).code, 75);
  expect_stored_and_goes_on();
}

TEST_F(SignalTest, Usr1ToOneRankDrainsAll) {
  Process sweep(with_mpirun(3, standin(directory_, kOptions)));
  const auto ranks = ranks_of(sweep, 3);
  wait_for(sweep, directory_, 6);
  ::kill(ranks.at(1), SIGUSR1);
  EXPECT_EQ(sweep.wait(), 75);
  expect_stored_and_goes_on();
}

TEST_F(SignalTest, TermToMpirunLosesNothing) {
  // mpirun has an exit code of its own for this; what counts is what is stored.
  const Ended ended = interrupted(with_mpirun(3, standin(directory_, kOptions)), SIGTERM);
  EXPECT_NE(ended.code, 0);
  expect_stored_and_goes_on();
}

TEST_F(SignalTest, InterruptToMpirunLosesNothing) {
  EXPECT_NE(interrupted(with_mpirun(3, standin(directory_, kOptions)), SIGINT).code, 0);
  expect_stored_and_goes_on();
}

TEST_F(SignalTest, TermToASerialSweepEndsWith75) {
  EXPECT_EQ(interrupted(standin(directory_, kOptions), SIGTERM).code, 75);
  expect_stored_and_goes_on();
}

TEST_F(SignalTest, TermDropsALongSampleInsteadOfWaiting) {
  const std::vector<std::string> options = {"--samples", "3", "--mean-ms", "1000000"};
  Process sweep(standin(directory_, options));
  while (sweep.running() && longest_journal(directory_).empty()) {
  }
  sweep.signal(SIGTERM);
  EXPECT_EQ(sweep.wait(), 75);
  EXPECT_THAT(read_study_file(study_file_of(directory_)).outcomes, IsEmpty());
}

}  // namespace
}  // namespace cagetol
