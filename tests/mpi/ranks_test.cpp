// Any number of ranks gives the same study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mc/sweep/stored_study.hpp"
#include "tests/mpi/standin.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class RanksTest : public testing::TestWithParam<int> {};

TEST_P(RanksTest, GiveTheStudyFileOfASerialRunToTheBit) {
  const ScratchDirectory scratch;
  ASSERT_EQ(run(standin(scratch / "serial")).code, 0);
  const Ended ended = run(with_mpirun(GetParam(), standin(scratch / "mpi")));
  ASSERT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(
      study_file_differences(study_file_of(scratch / "serial"), study_file_of(scratch / "mpi")),
      IsEmpty());
  EXPECT_EQ(read_study_file(study_file_of(scratch / "mpi")).outcomes.size(), 40u);
}

INSTANTIATE_TEST_SUITE_P(Ranks, RanksTest, testing::Values(1, 2, 3));

/// Dozens of ranks on each core: whoever waits must sleep, and nobody may count as lost.
TEST(ManyRanks, SixtyFourOnFewCoresGiveTheStudyFileOfASerialRunToTheBit) {
  const ScratchDirectory scratch;
  const std::vector<std::string> options = {"--samples", "300", "--mean-ms", "20"};
  ASSERT_EQ(run(standin(scratch / "serial", {"--samples", "300", "--mean-ms", "0.1"})).code, 0);
  const Ended ended = run(with_mpirun(64, standin(scratch / "mpi", options)));
  ASSERT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(
      study_file_differences(study_file_of(scratch / "serial"), study_file_of(scratch / "mpi")),
      IsEmpty());
}

TEST(HandOutTest, EveryRankTakesPart) {
  const ScratchDirectory scratch;
  ASSERT_EQ(run(with_mpirun(3, standin(scratch / "out", {"--mean-ms", "20"}))).code, 0);
  std::vector<int> runs(3);
  for (const auto& [id, stored] : read_study_file(study_file_of(scratch / "out")).outcomes)
    ++runs.at(static_cast<std::size_t>(stored.rank));
  EXPECT_THAT(runs, testing::Each(testing::Gt(2)));
}

TEST(HandOutTest, MoreRanksThanSamplesIsFine) {
  const ScratchDirectory scratch;
  const Ended ended = run(with_mpirun(3, standin(scratch / "out", {"--samples", "1"})));
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_EQ(finished_in(scratch / "out"), 1u);
}

TEST(HandOutTest, ACompleteSweepStartedAgainRunsNothing) {
  const ScratchDirectory scratch;
  ASSERT_EQ(run(standin(scratch / "out")).code, 0);
  const std::string journal = longest_journal(scratch / "out");
  // A sample that would abort shows that none is run.
  const Ended again = run(with_mpirun(2, standin(scratch / "out", {"--abort-id", "0"})));
  EXPECT_EQ(again.code, 0) << again.output;
  EXPECT_THAT(again.output, HasSubstr("40 of 40 samples are already done"));
  EXPECT_EQ(longest_journal(scratch / "out"), journal);
}

TEST(HandOutTest, ABadStudyIsReportedOnceWithCode2) {
  const ScratchDirectory scratch;
  for (const bool mpi : {false, true}) {
    auto command = standin(scratch / "out", {"--bad-study"});
    const Ended ended = run(mpi ? with_mpirun(3, command) : command);
    EXPECT_EQ(ended.code, 2);
    const auto first = ended.output.find("cagetol: study.toml:3: sigma = -1: must not be negative");
    ASSERT_NE(first, std::string::npos) << ended.output;
    EXPECT_EQ(ended.output.find("must not be negative", first + 50), std::string::npos);
  }
}

TEST(ExitCodeTest, AFaultOfTheProgramEndsWith70) {
  const ScratchDirectory scratch;
  for (const bool mpi : {false, true}) {
    auto command = standin(scratch / "out", {"--fault"});
    const Ended ended = run(mpi ? with_mpirun(2, command) : command);
    EXPECT_EQ(ended.code, 70);
    EXPECT_THAT(ended.output, HasSubstr("cagetol: unexpected: no such row"));
  }
}

TEST(ExitCodeTest, ThreeWhenMoreSamplesFailThanTheStudyAllows) {
  const ScratchDirectory scratch;
  const Ended ended = run(with_mpirun(2, standin(scratch / "out", {"--failure-share", "0.3"})));
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.output, HasSubstr("the study allows 10 %"));
  EXPECT_THAT(ended.output, HasSubstr("remedy"));
}

TEST(ExitCodeTest, JamsAreResultsNotFailures) {
  const ScratchDirectory scratch;
  const Ended ended = run(standin(scratch / "out"));
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.output, HasSubstr("jammed"));
}

}  // namespace
}  // namespace cagetol
