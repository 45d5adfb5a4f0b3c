// Single bits flipped at random in study.h5 and in journals: never a wrong result, never a crash.
// CAGETOL_FLIPS says how many of each kind (1000 in the nights), CAGETOL_FLIPS_FROM where to go on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "mc/sweep/sweep_directory.hpp"
#include "tests/mpi/standin.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

unsigned number_from(const char* variable, unsigned usual) {
  const char* asked = std::getenv(variable);
  return asked == nullptr ? usual : static_cast<unsigned>(std::atoi(asked));
}

void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

const std::vector<std::string> kSmallSweep = {"--samples", "16", "--mean-ms", "0"};

class FlipTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run(standin(directory_, kSmallSweep)).code, 0);
    study_ = file_bytes(file_);
    journal_file_ = longest_journal(directory_);
    journal_ = file_bytes(journal_file_);
  }
  /// Calls `test` with `whole` after one bit was flipped, another one each time.
  template <class Test>
  void each_flip(const std::string& whole, Test test) {
    const unsigned first = number_from("CAGETOL_FLIPS_FROM", 0);
    for (unsigned round = first; round < first + number_from("CAGETOL_FLIPS", 6); ++round) {
      std::mt19937_64 random(round);
      const std::size_t bit = random() % (8 * whole.size());
      SCOPED_TRACE("round " + std::to_string(round) + ", bit " + std::to_string(bit));
      test(with_flipped_bit(whole, bit));
      if (HasFatalFailure()) return;
    }
  }
  std::string cagetol_ = CAGETOL_BINARY_DIR "/cagetol";
  ScratchDirectory scratch_;
  std::string directory_ = scratch_ / "out", file_ = study_file_of(directory_);
  std::string journal_file_, study_, journal_;
};

TEST_F(FlipTest, OfStudyH5BesideItsJournals) {
  each_flip(study_, [&](const std::string& damaged) {
    write_file(file_, damaged);
    const Ended ended = run(standin(directory_, kSmallSweep));
    ASSERT_EQ(ended.code, 0) << ended.output;
    ASSERT_EQ(file_bytes(file_), study_);
  });
}

TEST_F(FlipTest, OfStudyH5Alone) {
  fs::remove(journal_file_);
  each_flip(study_, [&](const std::string& damaged) {
    write_file(file_, damaged);
    const std::vector<std::vector<std::string>> readers = {
        standin(directory_, kSmallSweep),
        {cagetol_, "report", directory_},
        {cagetol_, "replay", directory_, "--sample", "1"},
        {cagetol_, "compare", directory_, directory_}};
    for (const auto& reader : readers) {
      const Ended ended = run(reader);
      ASSERT_EQ(ended.code, 2) << reader[1] << ": " << ended.output;
      ASSERT_THAT(ended.output, testing::AllOf(HasSubstr(file_ + ": "), HasSubstr("remedy")));
    }
    ASSERT_EQ(file_bytes(file_), damaged);
  });
}

TEST_F(FlipTest, OfAJournal) {
  const std::string right = scratch_ / "right.h5";
  fs::rename(file_, right);
  each_flip(journal_, [&](const std::string& damaged) {
    fs::remove_all(journal_directory(directory_));
    fs::create_directory(journal_directory(directory_));
    fs::remove(file_);
    write_file(journal_file_, damaged);
    const Ended ended = run(standin(directory_, kSmallSweep));
    ASSERT_EQ(ended.code, 0) << ended.output;
    ASSERT_THAT(ended.output, HasSubstr(journal_file_ + ": "));
    ASSERT_THAT(study_file_differences(right, file_), IsEmpty());
  });
}

}  // namespace
}  // namespace cagetol
