#include "mc/sweep/sweep_directory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "src/input/input_error.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/process.hpp"
#include "tests/support/standin_study.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(StudyDifferencesTest, NamesKeysWithOldAndNewValue) {
  const std::string stored = "samples = 10\nseed = 1\n[scene.load]\nradial_N = 1000.0\n";
  EXPECT_THAT(study_differences(stored, stored), IsEmpty());
  EXPECT_THAT(
      study_differences(stored, "samples = 20\n[scene.load]\nradial_N = 1000.0\nramp_s = 0.5\n"),
      ElementsAre("samples: 10 stored, 20 now", "scene.load.ramp_s: absent stored, 0.5 now",
                  "seed: 1 stored, absent now"));
}

TEST(StudyDifferencesTest, SeesTheLastNumberOfALongList) {
  std::string list = "values = [0.0";
  for (int i = 0; i < 500; ++i) list += ", 1.25";
  const auto differences = study_differences(list + ", 1.0]", list + ", 2.0]");
  ASSERT_THAT(differences, testing::SizeIs(1));
  // Long values are shown from where they part.
  EXPECT_THAT(differences[0], testing::ContainsRegex("1\\.0 \\].*2\\.0 \\]"));
}

/// A finished sweep of a stand-in study, its samples in two journals.
class SweepDirectoryTest : public testing::Test {
 protected:
  SweepDirectoryTest() : plan_(make_standin_plan({.samples = 12, .mean_ms = 0})) {
    { const SweepDirectory created(directory_, plan_.study, build_); }
    OutcomesById outcomes;
    for (int part = 0; part < 2; ++part) {
      Journal journal(journal_directory(directory_), {plan_.study.hash, build_id(build_), part});
      journals_.push_back(journal.path());
      for (std::uint64_t id = part == 0 ? 0 : 8; id < (part == 0 ? 8u : 12u); ++id) {
        outcomes[id] =
            make_stored_outcome(id, plan_.job(plan_.draw(id), [] { return false; }), 0.5, part);
        journal.finished(outcomes[id]);
      }
    }
    write_study_file(file_, plan_, outcomes, build_);
  }
  std::string message() {
    try {
      SweepDirectory(directory_, plan_.study, build_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  void flip(const std::string& path, std::size_t bit) {
    const std::string damaged = with_flipped_bit(file_bytes(path), bit);
    std::ofstream(path, std::ios::binary) << damaged;
  }

  ScratchDirectory scratch_;
  std::string directory_ = scratch_ / "out", file_ = study_file_path(directory_);
  SweepPlan plan_;
  BuildInfo build_ = build_info();
  std::vector<std::string> journals_;
};

TEST_F(SweepDirectoryTest, StudyH5IsNotOpenedWhereJournalsAreComplete) {
  for (const std::size_t bit : {3u, 5000u, 40000u}) flip(file_, bit);
  const SweepDirectory opened(directory_, plan_.study, build_);
  EXPECT_THAT(opened.stored().finished, SizeIs(12));
  EXPECT_THAT(opened.stored().notes, IsEmpty());
}

TEST_F(SweepDirectoryTest, ASoundStudyH5MakesUpForLostJournals) {
  fs::remove(journals_[1]);
  const SweepDirectory opened(directory_, plan_.study, build_);
  EXPECT_THAT(opened.stored().finished, SizeIs(12));
  EXPECT_THAT(opened.only_in_study_file(), SizeIs(4));
  EXPECT_THAT(opened.stored().notes, ElementsAre(HasSubstr("holds 4 samples that no journal has")));
}

TEST_F(SweepDirectoryTest, ADamagedStudyH5LosesNothingThatJournalsHave) {
  fs::remove(journals_[1]);
  flip(file_, 40000);
  const SweepDirectory opened(directory_, plan_.study, build_);
  EXPECT_THAT(opened.stored().finished, SizeIs(8));
  EXPECT_THAT(opened.stored().notes,
              ElementsAre(AllOf(HasSubstr(file_ + ": damaged (its checksum does not match"),
                                HasSubstr("run again"))));
}

TEST_F(SweepDirectoryTest, ADamagedStudyH5WithoutJournalsIsRefusedWithWhatIsLost) {
  for (const std::string& journal : journals_) fs::remove(journal);
  flip(file_, 40000);
  const std::string before = file_bytes(file_);
  EXPECT_THAT(message(), AllOf(HasSubstr(file_), HasSubstr("its checksum does not match"),
                               HasSubstr("its results cannot be taken over"), HasSubstr("remedy"),
                               HasSubstr("remove study.h5")));
  EXPECT_EQ(file_bytes(file_), before);
  fs::remove(file_);
  EXPECT_EQ(message(), "no error");
}

TEST_F(SweepDirectoryTest, ADamagedStudyTomlIsWrittenAgainWhereResultsCarryTheHash) {
  const std::string path = stored_study_path(directory_);
  const std::string right = file_bytes(path);
  const std::vector<std::string> texts = {"", "samples = = 3", "samples = 13\n", right + " ",
                                          std::string("\0\xff", 2)};
  for (const std::string& damaged : texts) {
    for (const bool with_journals : {true, false}) {
      std::ofstream(path, std::ios::binary) << damaged;
      if (!with_journals) fs::rename(journal_directory(directory_), scratch_ / "away");
      const SweepDirectory opened(directory_, plan_.study, build_);
      EXPECT_THAT(opened.stored().notes,
                  testing::Contains(AllOf(HasSubstr(path), HasSubstr("written again"))));
      EXPECT_EQ(file_bytes(path), right);
      if (with_journals) continue;
      fs::remove_all(journal_directory(directory_));
      fs::rename(scratch_ / "away", journal_directory(directory_));
    }
  }
}

TEST_F(SweepDirectoryTest, OtherLimitsAreNoOtherStudy) {
  Study judged = plan_.study;
  judged.resolved_toml += "[[limit]]\nmax = 3.0\nquantity = 'cage_slip_ratio'\n";
  const SweepDirectory opened(directory_, judged, build_);
  EXPECT_THAT(opened.stored().finished, SizeIs(12));
  EXPECT_EQ(file_bytes(stored_study_path(directory_)), judged.resolved_toml);
}

TEST_F(SweepDirectoryTest, ARefusalNamesWhatMovesRunsAlone) {
  const Study given = make_standin_plan({.samples = 12, .radial_load = 77}).study;
  Study other = given;
  other.resolved_toml += "[[limit]]\nmax = 3.0\nquantity = 'cage_slip_ratio'\n";
  try {
    const SweepDirectory opened(directory_, other, build_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("scene.load.radial_N: 1000 stored, 77 now"));
    EXPECT_THAT(error.what(), testing::Not(HasSubstr("limit")));
  }
}

TEST_F(SweepDirectoryTest, AStudyTomlOfNobodyIsRefusedAndLeftAlone) {
  for (const std::string& journal : journals_) fs::remove(journal);
  fs::remove(file_);
  const std::string path = stored_study_path(directory_);
  std::ofstream(path) << "[[no toml";
  EXPECT_THAT(message(), AllOf(HasSubstr(path), HasSubstr(directory_ + " holds no results"),
                               HasSubstr("remedy: remove this file")));
  EXPECT_EQ(file_bytes(path), "[[no toml");
  std::ofstream(path) << "samples = 13\n";
  EXPECT_THAT(message(), HasSubstr("samples: 13 stored, 12 now"));
}

TEST_F(SweepDirectoryTest, LeftoversOfDeadProcessesAreRemoved) {
  const std::string dead = file_ + ".part999999999",
                    living = file_ + ".part" + std::to_string(::getppid()),
                    other = directory_ + "/notes.parts";
  for (const std::string& path : {dead, living, other}) std::ofstream(path) << "x";
  EXPECT_EQ(message(), "no error");
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(living));
  EXPECT_TRUE(fs::exists(other));
  std::ofstream(dead) << "x";
  remove_stale_parts(directory_, std::chrono::hours(1));
  EXPECT_TRUE(fs::exists(dead)) << "too young";
}

}  // namespace
}  // namespace cagetol
