// Samples that kill their process, throw, or meet a wall-clock limit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mc/sweep/stored_study.hpp"
#include "tests/mpi/standin.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class BadSampleTest : public testing::Test {
 protected:
  Ended sweep(int ranks, const std::vector<std::string>& options) {
    const auto command = standin(scratch_ / "out", options);
    return run(ranks == 0 ? command : with_mpirun(ranks, command));
  }
  OutcomesById outcomes() { return read_study_file(study_file_of(scratch_ / "out")).outcomes; }
  ScratchDirectory scratch_;
};

TEST_F(BadSampleTest, OneThatAbortsTwiceRunsAloneAndIsPoisoned) {
  const std::vector<std::string> options = {"--abort-id", "7"};
  EXPECT_NE(sweep(2, options).code, 0);
  EXPECT_NE(sweep(2, options).code, 0);
  const Ended third = sweep(2, options);
  EXPECT_EQ(third.code, 0) << third.output;
  EXPECT_THAT(third.output, HasSubstr("sample 7 is poisoned"));
  const OutcomesById stored = outcomes();
  ASSERT_EQ(stored.size(), 40u);
  for (const auto& [id, outcome] : stored)
    EXPECT_EQ(outcome.status == Status::poisoned, id == 7) << id;
  EXPECT_EQ(stored.at(7).reason, "the process running this sample alone died of SIGABRT");
}

TEST_F(BadSampleTest, PoisonedInAnyHistoryGivesTheSameFile) {
  const std::vector<std::string> options = {"--abort-id", "7"};
  for (int start = 0; start < 3; ++start) sweep(3, options);
  for (int start = 0; start < 3; ++start) run(standin(scratch_ / "serial", options));
  EXPECT_THAT(
      study_file_differences(study_file_of(scratch_ / "serial"), study_file_of(scratch_ / "out")),
      IsEmpty());
}

TEST_F(BadSampleTest, OneThatExitsIsPoisonedToo) {
  for (int start = 0; start < 3; ++start) sweep(0, {"--exit-id", "0"});
  ASSERT_EQ(outcomes().size(), 40u);
  EXPECT_EQ(outcomes().at(0).reason,
            "the process running this sample alone ended itself with exit code 9");
}

TEST_F(BadSampleTest, OneThatIsKilledFromOutsideIsNotBlamed) {
  for (int start = 0; start < 2; ++start) EXPECT_EQ(sweep(0, {"--kill-id", "7"}).code, 137);
  const Ended third = sweep(0, {"--kill-id", "7"});
  EXPECT_EQ(third.code, 75);
  EXPECT_THAT(third.output, HasSubstr("ended from outside by SIGKILL"));
  EXPECT_EQ(outcomes().size(), 39u);
  EXPECT_EQ(sweep(0, {}).code, 0);
  EXPECT_EQ(outcomes().size(), 40u);
}

TEST_F(BadSampleTest, OneThatThrowsHasFailed) {
  EXPECT_EQ(sweep(2, {"--throw-id", "7"}).code, 0);
  EXPECT_EQ(outcomes().at(7).status, Status::failed);
  EXPECT_EQ(outcomes().at(7).reason, "the stand-in throws");
}

TEST_F(BadSampleTest, OneOverItsWallClockLimitIsRunAgainNextTime) {
  const Ended first = sweep(2, {"--late-id", "7"});
  EXPECT_EQ(first.code, 75);
  EXPECT_THAT(first.output, HasSubstr("integration.wall_budget_s"));
  EXPECT_FALSE(outcomes().contains(7));
  EXPECT_EQ(sweep(2, {}).code, 0);
  EXPECT_EQ(outcomes().at(7).status, Status::ok);
}

}  // namespace
}  // namespace cagetol
