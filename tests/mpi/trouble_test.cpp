// Directories and files in trouble: a message with file, reason and remedy, the documented exit
// code, nothing finished lost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>

#include "mc/sweep/sweep_directory.hpp"
#include "tests/mpi/standin.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class TroubleTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(run(standin(scratch_ / "whole")).code, 0); }
  /// A complete sweep in DIR.
  void sweep() { ASSERT_EQ(run(standin(directory_)).code, 0); }
  void expect_whole() {
    EXPECT_THAT(
        study_file_differences(study_file_of(scratch_ / "whole"), study_file_of(directory_)),
        IsEmpty());
  }
  ScratchDirectory scratch_;
  std::string directory_ = scratch_ / "out";
};

TEST_F(TroubleTest, AnotherStudyIsRefusedWithTheDifferenceNamed) {
  sweep();
  for (const int ranks : {0, 2}) {
    const auto command = standin(directory_, {"--load", "2000", "--samples", "50"});
    const Ended ended = run(ranks == 0 ? command : with_mpirun(ranks, command));
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.output, AllOf(HasSubstr(directory_ + ": holds the results of another study"),
                                    HasSubstr("samples: 40 stored, 50 now"),
                                    HasSubstr("scene.load.radial_N: 1000 stored, 2000 now"),
                                    HasSubstr("remedy")));
  }
  EXPECT_EQ(run(standin(directory_)).code, 0);
  expect_whole();
}

TEST_F(TroubleTest, AnotherStudyIsRefusedEvenWithoutTheStoredText) {
  sweep();
  fs::remove(stored_study_path(directory_));
  const Ended ended = run(standin(directory_, {"--load", "2000"}));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, HasSubstr("belongs to another study"));
}

TEST_F(TroubleTest, AnotherBuildIsRefusedWithBothNamed) {
  sweep();
  const std::string hash = read_journal(longest_journal(directory_)).header.study_hash;
  Journal(journal_directory(directory_), {hash, "cagetol 0.0.1 commit abc", 0}).started(1);
  const Ended ended = run(standin(directory_));
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output,
              AllOf(HasSubstr("another build"), HasSubstr("commit abc"), HasSubstr("remedy")));
}

TEST_F(TroubleTest, TwoSweepsOfOneDirectoryAreKeptApart) {
  Process first(standin(directory_, {"--mean-ms", "100000"}));
  while (first.running() && longest_journal(directory_).empty()) {
  }
  const Ended second = run(standin(directory_));
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.output, HasSubstr("another sweep is writing to this directory"));
}

TEST_F(TroubleTest, ATornJournalLosesOneSampleThatIsRunAgain) {
  sweep();
  fs::remove(study_file_of(directory_));
  const std::string journal = longest_journal(directory_);
  fs::resize_file(journal, fs::file_size(journal) - 5);
  const Ended ended = run(standin(directory_));
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.output, AllOf(HasSubstr(journal + ": the last record is torn"),
                                  HasSubstr("39 of 40 samples are already done")));
  expect_whole();
}

TEST_F(TroubleTest, ADamagedJournalIsNamedAndTheRestUsed) {
  sweep();
  fs::remove(study_file_of(directory_));
  const std::string journal = longest_journal(directory_);
  std::fstream(journal, std::ios::in | std::ios::out)
      .seekp(static_cast<long>(fs::file_size(journal) / 2))
      .write("\xa5", 1);  // in one record
  const Ended ended = run(with_mpirun(2, standin(directory_)));
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.output, AllOf(HasSubstr(journal + ": damaged at byte"),
                                  HasSubstr("39 of 40 samples are already done")));
  expect_whole();
}

TEST_F(TroubleTest, LostJournalsAreMadeUpForByTheStudyFile) {
  sweep();
  fs::remove(longest_journal(directory_));
  const Ended ended = run(standin(directory_, {"--abort-id", "3"}));
  EXPECT_EQ(ended.code, 0) << ended.output;
  EXPECT_THAT(ended.output, HasSubstr("holds 40 samples that no journal has"));
  EXPECT_EQ(finished_in(directory_), 40u);
  expect_whole();
}

TEST_F(TroubleTest, ATruncatedStudyFileIsBuiltAgain) {
  sweep();
  fs::resize_file(study_file_of(directory_), 3000);
  EXPECT_EQ(run(standin(directory_, {"--abort-id", "3"})).code, 0);
  expect_whole();
}

TEST_F(TroubleTest, AForeignJournalThatAppearsDuringASweepIsLeftOutAndNamed) {
  ASSERT_EQ(run(standin(scratch_ / "foreign", {"--load", "2000", "--mean-ms", "0"})).code, 0);
  const fs::path foreign = longest_journal(scratch_ / "foreign");
  const std::string there = journal_directory(directory_) + "/" + foreign.filename().string();
  Process sweep(standin(directory_, {"--mean-ms", "20", "--rebuild", "0.05"}));
  wait_for(sweep, directory_, 1);
  fs::copy_file(foreign, there);
  EXPECT_EQ(sweep.wait(), 0);
  EXPECT_THAT(sweep.output(),
              AllOf(HasSubstr(there + ": belongs to another study"), HasSubstr("remedy")));
  expect_whole();
  EXPECT_EQ(run(standin(directory_)).code, 2) << "the next start refuses it";
}

TEST_F(TroubleTest, JournalsRemovedDuringASweepAreMissedAtItsEnd) {
  Process sweep(standin(directory_, {"--mean-ms", "20"}));
  wait_for(sweep, directory_, 3);
  fs::remove(longest_journal(directory_));
  EXPECT_EQ(sweep.wait(), 75);
  EXPECT_THAT(sweep.output(), HasSubstr("the journals hold 0 of the 40 samples done"));
  EXPECT_EQ(run(standin(directory_)).code, 0);
  expect_whole();
}

TEST_F(TroubleTest, ARankOfMpiCannotStartASweep) {
  std::vector<std::string> command = standin(directory_);
  command.insert(command.begin(), CAGETOL_BINARY_DIR "/mpi_parent");
  const Ended ended = run(with_mpirun(1, command));
  EXPECT_EQ(ended.code, 2) << ended.output;
  EXPECT_THAT(ended.output, AllOf(HasSubstr("is itself a rank of MPI"), HasSubstr("remedy: ")));
  EXPECT_EQ(run(command).code, 0);  // MPI without a launcher has no place to hand on
}

TEST_F(TroubleTest, AnUnusableDirectoryIsBadInput) {
  std::ofstream(scratch_ / "file") << "in the way";
  for (const std::string& place : {scratch_ / "file", scratch_ / "file/below"}) {
    const Ended ended = run(standin(place));
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.output, AllOf(HasSubstr("cagetol: " + place), HasSubstr("remedy")));
  }
}

TEST_F(TroubleTest, AFileSizeLimitLosesNothing) {
  const Ended limited = run(standin(directory_), [] {
    const rlimit tight{10000, 10000};
    setrlimit(RLIMIT_FSIZE, &tight);
  });
  EXPECT_EQ(limited.code, 75);
  EXPECT_THAT(limited.output, AllOf(HasSubstr(journal_directory(directory_)),
                                    HasSubstr("File too large"), HasSubstr("remedy")));
  EXPECT_GT(finished_in(directory_), 5u);
  EXPECT_EQ(run(standin(directory_)).code, 0);
  expect_whole();
}

TEST_F(TroubleTest, AFullDiskLosesNothing) {
  fs::create_directory(directory_);
  if (::mount("tmpfs", directory_.c_str(), "tmpfs", 0, "size=32k") != 0)
    GTEST_SKIP() << "only root may mount a small disk";
  for (const int ranks : {0, 2}) {
    const auto command = standin(directory_);
    // The journal finds room, study.h5 does not; the second time a new journal finds none either.
    const Ended full = run(ranks == 0 ? command : with_mpirun(ranks, command));
    EXPECT_EQ(full.code, 75) << full.output;
    EXPECT_THAT(full.output,
                AllOf(HasSubstr("No space left on device"), HasSubstr("free some space")));
  }
  EXPECT_GT(finished_in(directory_), 5u);
  std::ofstream(directory_ + "/filler") << std::string(100000, 'x');
  EXPECT_EQ(run(standin(directory_)).code, 75) << "no room for a journal either";
  ::mount("tmpfs", directory_.c_str(), "tmpfs", MS_REMOUNT, "size=4m");
  EXPECT_EQ(run(standin(directory_)).code, 0);
  expect_whole();
  ::umount(directory_.c_str());
}

}  // namespace
}  // namespace cagetol
