#include "analysis/study/study_data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "analysis/study/refused.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

class StudyDataFile : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::path(testing::TempDir()) /
                 testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(directory_);
    file_ = directory_ / "study.h5";
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  std::string message_of_reading() const {
    try {
      read_study_data(file_);
    } catch (const StudyFileError& error) {
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path directory_, file_;
};

TEST_F(StudyDataFile, ReadsWhatWasWritten) {
  SyntheticOptions options;
  options.rows = 40;
  const StudyData written = make_synthetic_study(options);
  write_synthetic_study(written, file_);
  const StudyData read = read_study_data(file_);
  EXPECT_EQ(read.id, written.id);
  EXPECT_EQ(read.lot, written.lot);
  EXPECT_EQ(read.candidate, written.candidate);
  EXPECT_EQ(read.status, written.status);
  EXPECT_EQ(read.reason, written.reason);
  EXPECT_EQ(read.provenance.study_hash, "00c0ffee00c0ffee");
  EXPECT_EQ(read.provenance.seed, 7);
  EXPECT_EQ(read.design.kind, "random");
  EXPECT_EQ(read.pockets, 13u);
  const InputColumns& width = *find_input(read, "cage.pocket_width_mm");
  EXPECT_TRUE(width.per_pocket);
  EXPECT_EQ(width.pocket, find_input(written, width.key)->pocket);
  EXPECT_EQ(width.nominal, std::vector<double>{7.65});
  EXPECT_FALSE(find_input(read, "start.cage_phase_deg")->per_pocket);
  EXPECT_EQ(find_quantity(read, "cage_slip_ratio")->unit, "-");
  EXPECT_THAT(find_quantity(read, "cage_slip_ratio")->description, testing::HasSubstr("kinematic"));
  EXPECT_EQ(read.plan.candidates.size(), 8u);
  EXPECT_EQ(read.plan.limits.size(), 2u);
  EXPECT_EQ(read.plan.limits[1].maximum, 1.1);
}

TEST_F(StudyDataFile, MissingFileSaysHowToMakeOne) {
  EXPECT_THAT(message_of_reading(),
              testing::AllOf(testing::HasSubstr("study.h5"), testing::HasSubstr("no such file"),
                             testing::HasSubstr("remedy"), testing::HasSubstr("cagetol sweep")));
}

TEST_F(StudyDataFile, TruncatedFileIsRefused) {
  write_synthetic_study(make_synthetic_study({.rows = 40}), file_);
  const auto size = std::filesystem::file_size(file_);
  for (const double part : {0.0, 0.001, 0.3, 0.9, 0.999}) {
    write_synthetic_study(make_synthetic_study({.rows = 40}), file_);
    std::filesystem::resize_file(file_,
                                 static_cast<std::uintmax_t>(part * static_cast<double>(size)));
    EXPECT_THAT(message_of_reading(), testing::HasSubstr("remedy")) << part;
  }
}

TEST_F(StudyDataFile, OtherKindOfFileIsRefused) {
  std::ofstream(file_) << "not an HDF5 file";
  EXPECT_THAT(message_of_reading(), testing::HasSubstr("HDF5"));
}

TEST_F(StudyDataFile, OtherSchemaVersionIsRefused) {
  StudyData study = make_synthetic_study({.rows = 40});
  study.provenance.schema_version = 3;
  write_synthetic_study(study, file_);
  EXPECT_THAT(message_of_reading(), testing::AllOf(testing::HasSubstr("schema version is 3"),
                                                   testing::HasSubstr("remedy")));
}

TEST_F(StudyDataFile, ColumnOfWrongLengthIsNamed) {
  StudyData study = make_synthetic_study({.rows = 40});
  study.quantities[2].values.pop_back();
  write_synthetic_study(study, file_);
  EXPECT_THAT(message_of_reading(), testing::HasSubstr("/quantities/cage_slip_ratio"));
}

TEST_F(StudyDataFile, BrokenJsonIsNamed) {
  StudyData study = make_synthetic_study({.rows = 40});
  study.plan.whole["limit"][0].erase("quantity");
  write_synthetic_study(study, file_);
  EXPECT_THAT(message_of_reading(), testing::HasSubstr("/study/json"));
}

TEST(StudyData, FirstRunsLeaveOutRepeatsAndRunsThatWereNotRun) {
  StudyData study = make_synthetic_study({.rows = 40});
  study.status[5] = RunStatus::not_run;
  const auto keep = first_runs(study);
  EXPECT_EQ(keep.size(), 39u);
  const StudyData runs = select_samples(study, keep);
  EXPECT_EQ(runs.id[5], 6);
  EXPECT_EQ(runs.inputs[0].pocket[5 * 13 + 2], study.inputs[0].pocket[6 * 13 + 2]);
}

}  // namespace
}  // namespace cagetol
