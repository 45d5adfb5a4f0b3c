#include "mc/sweep/journal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "tests/support/process.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const JournalHeader kHeader{"0123456789abcdef", "build 1", 3};

StoredOutcome outcome_of(std::uint64_t id) {
  StoredOutcome stored;
  stored.id = id;
  stored.status = Status::jammed;
  stored.reason = "roller 4 is 2.5 µm too large";
  stored.pocket = 4;
  stored.interference_um = 2.5;
  stored.quantities = {-0.0, std::numeric_limits<double>::quiet_NaN(), 1e-310 + double(id)};
  stored.run = {1.0 / 3, double(id)};
  stored.wall_s = 0.125;
  stored.rank = 3;
  return stored;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

/// Removing first spares the flush with which ext4 protects files that are overwritten.
void write_bytes(const std::string& path, const std::string& bytes) {
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

class JournalTest : public testing::Test {
 protected:
  /// A journal with samples 0 .. count-1 finished; its path.
  std::string written(std::uint64_t count) {
    Journal journal(scratch_.path(), kHeader);
    for (std::uint64_t id = 0; id < count; ++id) {
      journal.started(id);
      journal.finished(outcome_of(id));
    }
    return journal.path();
  }
  ScratchDirectory scratch_;
};

TEST_F(JournalTest, GivesBackWhatWasWritten) {
  const JournalContent content = read_journal(written(3));
  EXPECT_TRUE(content.readable);
  EXPECT_EQ(content.header.study_hash, kHeader.study_hash);
  EXPECT_EQ(content.header.build, kHeader.build);
  EXPECT_EQ(content.header.rank, 3);
  ASSERT_THAT(content.finished, SizeIs(3));
  for (std::uint64_t id = 0; id < 3; ++id) {
    EXPECT_EQ(content.finished[id].id, id);
    EXPECT_THAT(outcome_differences(content.finished[id], outcome_of(id)), IsEmpty());
    EXPECT_EQ(content.finished[id].wall_s, 0.125);
    EXPECT_EQ(content.finished[id].rank, 3);
  }
  EXPECT_THAT(content.lost, IsEmpty());
  EXPECT_THAT(content.notes, IsEmpty());
}

TEST_F(JournalTest, KnowsWhatWasInFlight) {
  {
    Journal journal(scratch_.path(), kHeader);
    for (const std::uint64_t id : {5, 6, 7}) journal.started(id);
    journal.finished(outcome_of(6));
    journal.dropped(7);
  }
  const JournalSet set = read_journals(scratch_.path());
  EXPECT_THAT(set.losses, ElementsAre(std::pair(5, 1)));
  EXPECT_THAT(set.finished, SizeIs(1));
}

TEST_F(JournalTest, CountsLossesOverSessionsUntilTheSampleIsFinished) {
  for (int session = 0; session < 2; ++session) Journal(scratch_.path(), kHeader).started(5);
  EXPECT_THAT(read_journals(scratch_.path()).losses, ElementsAre(std::pair(5, 2)));
  Journal(scratch_.path(), kHeader).finished(outcome_of(5));
  EXPECT_THAT(read_journals(scratch_.path()).losses, IsEmpty());
}

TEST_F(JournalTest, CutAnywhereLosesOnlyTheRecordThatWasCut) {
  const std::string path = written(4);
  const std::string whole = bytes_of(path);
  std::size_t before = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write_bytes(path, whole.substr(0, size));
    const JournalContent content = read_journal(path);
    ASSERT_GE(content.finished.size(), before) << size;
    before = content.finished.size();
    for (const StoredOutcome& stored : content.finished)
      ASSERT_THAT(outcome_differences(stored, outcome_of(stored.id)), IsEmpty()) << size;
  }
  EXPECT_EQ(before, 3u);
  EXPECT_THAT(read_journal(path).notes, ElementsAre(HasSubstr("last record is torn")));
}

TEST_F(JournalTest, DamageAnywhereLosesOnlyTheRecordThatWasHit) {
  const std::string path = written(4);
  const std::string whole = bytes_of(path);
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x41);
    write_bytes(path, damaged);
    const JournalContent content = read_journal(path);
    ASSERT_GE(content.finished.size(), 3u) << place;
    ASSERT_THAT(content.notes, testing::Not(IsEmpty())) << place;
    for (const StoredOutcome& stored : content.finished)
      ASSERT_THAT(outcome_differences(stored, outcome_of(stored.id)), IsEmpty()) << place;
  }
}

TEST_F(JournalTest, EverySingleBitIsGuarded) {
  const std::string path = written(3);
  std::string bytes = bytes_of(path);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const auto flip = [&] { bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8)); };
    flip();
    write_bytes(path, bytes);
    const JournalSet set = read_journals(scratch_.path(), &kHeader);
    ASSERT_THAT(set.notes, testing::Not(IsEmpty())) << bit;
    ASSERT_THAT(set.refused, IsEmpty()) << bit;
    ASSERT_TRUE(set.headers.empty() ? set.finished.empty() : set.finished.size() >= 2u) << bit;
    for (const auto& [id, stored] : set.finished)
      ASSERT_THAT(outcome_differences(stored, outcome_of(id)), IsEmpty()) << bit;
    flip();
  }
}

TEST_F(JournalTest, NothingIsTakenFromJournalsOfAnotherStudyOrBuild) {
  const std::string own = written(1);
  std::vector<std::string> foreign;
  for (const JournalHeader& header : {JournalHeader{"another hash", kHeader.build, 3},
                                      JournalHeader{kHeader.study_hash, "b", 3}}) {
    Journal journal(scratch_.path(), header);
    journal.finished(outcome_of(0));
    journal.finished(outcome_of(7));
    foreign.push_back(journal.path());
  }
  JournalHeader owner = kHeader;
  owner.rank = 0;  // does not matter
  const JournalSet set = read_journals(scratch_.path(), &owner);
  EXPECT_THAT(set.finished, ElementsAre(testing::Key(0)));
  EXPECT_THAT(set.headers, ElementsAre(testing::Key(own)));
  EXPECT_THAT(set.refused,
              testing::UnorderedElementsAre(testing::Key(foreign[0]), testing::Key(foreign[1])));
  EXPECT_THAT(read_journals(scratch_.path()).finished, SizeIs(2));
}

TEST_F(JournalTest, AFolderWithAJournalsNameIsNamed) {
  std::filesystem::create_directory(scratch_ / "folder.journal");
  EXPECT_THAT(read_journals(scratch_.path()).notes,
              testing::Contains(HasSubstr("folder.journal: cannot be read")));
}

TEST_F(JournalTest, DamageInTheMiddleIsNamedWithItsPlace) {
  const std::string path = written(4);
  std::string bytes = bytes_of(path);
  bytes[bytes.size() / 2] ^= 1;
  write_bytes(path, bytes);
  EXPECT_THAT(read_journal(path).notes,
              ElementsAre(testing::AllOf(HasSubstr(path + ": damaged at byte"),
                                         HasSubstr("the records after them used"))));
}

TEST_F(JournalTest, ForeignFilesAreNamedAndLeftOut) {
  write_bytes(scratch_ / "a.journal", "no journal at all");
  write_bytes(scratch_ / "b.journal", "");
  const JournalSet set = read_journals(scratch_.path());
  EXPECT_THAT(set.headers, IsEmpty());
  EXPECT_THAT(set.notes, testing::Contains(HasSubstr("a.journal: does not start like a journal")));
}

TEST_F(JournalTest, EverySessionHasAFileOfItsOwn) {
  const std::string first = written(1), second = written(2);
  EXPECT_NE(first, second);
  EXPECT_THAT(read_journals(scratch_.path()).finished, SizeIs(2));
}

TEST_F(JournalTest, EmptyJournalsLeaveNoFile) {
  const std::string path = Journal(scratch_.path(), kHeader).path();
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(JournalTest, TwoResultsOfOneSampleAreNamed) {
  written(1);
  StoredOutcome other = outcome_of(0);
  other.quantities[0] = 0.0;
  Journal(scratch_.path(), kHeader).finished(other);
  EXPECT_THAT(
      read_journals(scratch_.path()).notes,
      ElementsAre(HasSubstr("sample 0 was run twice with different results (quantities[0]")));
}

TEST_F(JournalTest, FailedWriteLeavesWholeRecordsAndCanBeRepeated) {
  struct sigaction ignore {
  }, before{};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &ignore, &before);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  std::string path;
  {
    Journal journal(scratch_.path(), kHeader);
    path = journal.path();
    journal.finished(outcome_of(0));
    const rlimit tight{std::filesystem::file_size(path) + 20, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &tight);
    try {
      journal.finished(outcome_of(1));
      ADD_FAILURE() << "no error";
    } catch (const WriteError& error) {
      EXPECT_THAT(error.what(), testing::AllOf(HasSubstr(path), HasSubstr("File too large"),
                                               HasSubstr("remedy")));
    }
    setrlimit(RLIMIT_FSIZE, &old);
    EXPECT_THAT(read_journal(path).notes, IsEmpty());
    journal.finished(outcome_of(2));
  }
  sigaction(SIGXFSZ, &before, nullptr);
  const JournalContent content = read_journal(path);
  EXPECT_THAT(content.notes, IsEmpty());
  ASSERT_THAT(content.finished, SizeIs(2));
  EXPECT_EQ(content.finished[1].id, 2u);
}

TEST_F(JournalTest, UnusableDirectoryIsAnErrorWithRemedy) {
  try {
    Journal(scratch_ / "missing", kHeader);
    ADD_FAILURE() << "no error";
  } catch (const WriteError& error) {
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

}  // namespace
}  // namespace cagetol
