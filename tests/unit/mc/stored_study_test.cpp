#include "mc/sweep/stored_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "mc/host/file_write.hpp"
#include "mc/study_file/file_seal.hpp"
#include "mc/study_file/h5.hpp"
#include "mc/study_file/hdf5_reader.hpp"
#include "mc/study_file/study_bytes.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_table.hpp"
#include "tests/support/process.hpp"
#include "tests/support/standin_study.hpp"
#include "tests/support/study_compare.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Entry {
  std::set<std::string> paths, without_meaning, with_time;
};

extern "C" herr_t list_object(hid_t root, const char* name, const H5O_info_t*,
                              void* data) noexcept {
  auto& entry = *static_cast<Entry*>(data);
  entry.paths.insert(name);
  H5O_info_t info;
  H5Oget_info_by_name2(root, name, &info, H5O_INFO_BASIC | H5O_INFO_TIME, H5P_DEFAULT);
  if (info.ctime != 0 || info.mtime != 0) entry.with_time.insert(name);
  const H5Handle object(H5Oopen(root, name, H5P_DEFAULT), H5Oclose, "open");
  if (info.type == H5O_TYPE_DATASET &&
      (H5Aexists(object, "unit") <= 0 || H5Aexists(object, "description") <= 0))
    entry.without_meaning.insert(name);
  return 0;
}

class StudyFileTest : public testing::Test {
 protected:
  StudyFileTest() : plan_(make_standin_plan({.samples = 30, .mean_ms = 0, .failure_share = 0.1})) {
    for (std::uint64_t id = 0; id < plan_.samples; id += id % 7 == 3 ? 2 : 1)
      outcomes_[id] = make_stored_outcome(id, plan_.job(plan_.draw(id), [] { return false; }),
                                          0.25 * double(id), int(id % 3));
  }
  std::string written(const std::string& name, const OutcomesById& outcomes) {
    const std::string path = scratch_ / name;
    write_study_file(path, plan_, outcomes, build_);
    return path;
  }
  Entry listed(const std::string& path) {
    Entry entry;
    const std::string bytes = read_study_bytes(path);
    const H5Handle file = open_h5_image(bytes);
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, list_object, &entry, H5O_INFO_BASIC);
    return entry;
  }
  ScratchDirectory scratch_;
  SweepPlan plan_;
  OutcomesById outcomes_;
  BuildInfo build_ = build_info();
};

TEST_F(StudyFileTest, GivesBackEveryOutcomeToTheBit) {
  const StudyFile file = read_study_file(written("study.h5", outcomes_));
  EXPECT_EQ(file.study_hash, plan_.study.hash);
  EXPECT_EQ(file.study_toml, plan_.study.resolved_toml);
  EXPECT_EQ(file.build, build_id(build_));
  ASSERT_EQ(file.outcomes.size(), outcomes_.size());
  for (const auto& [id, stored] : outcomes_) {
    EXPECT_THAT(outcome_differences(file.outcomes.at(id), stored), IsEmpty());
    EXPECT_EQ(file.outcomes.at(id).wall_s, stored.wall_s);
    EXPECT_EQ(file.outcomes.at(id).rank, stored.rank);
  }
}

TEST_F(StudyFileTest, SameOutcomesGiveTheSameBytes) {
  EXPECT_EQ(make_study_file(plan_, outcomes_, build_), make_study_file(plan_, outcomes_, build_));
}

TEST_F(StudyFileTest, ClockAndRankShowBelowTimingOnly) {
  OutcomesById other = outcomes_;
  for (auto& [id, stored] : other) stored.wall_s = 7, stored.rank = 9;
  const std::string first = written("a.h5", outcomes_), second = written("b.h5", other);
  EXPECT_NE(text_of(first), text_of(second));
  EXPECT_THAT(study_file_differences(first, second), IsEmpty());
}

TEST_F(StudyFileTest, TheComparisonSeesOneBitInOneRow) {
  OutcomesById other = outcomes_;
  double& value = other.at(8).quantities.at(1);
  value = std::nextafter(value, 2 * value);
  EXPECT_THAT(study_file_differences(written("a.h5", outcomes_), written("b.h5", other)),
              ElementsAre(std::string("quantities/") + quantity_table()[1].key + " differs"));
}

TEST_F(StudyFileTest, EveryDatasetSaysWhatItIsAndNoneWhenItWasMade) {
  const Entry entry = listed(written("study.h5", outcomes_));
  EXPECT_THAT(entry.without_meaning, IsEmpty());
  EXPECT_THAT(entry.with_time, IsEmpty());
}

/// The names in the tables of RESULTS_FORMAT.md, group by group.
std::set<std::string> documented_datasets(const std::string& format) {
  std::set<std::string> names;
  std::istringstream lines(format);
  std::string group;
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# ") && !group.empty()) break;  // another format
    if (std::regex_search(line, match, std::regex("^## /?([^ ]*)"))) group = match[1];
    if (group == "inputs/KEY") group = "inputs/cage.pocket_width_mm";
    if (!std::regex_search(line, match, std::regex("^\\| ([a-z_0-9]+(, [a-z_0-9]+)*) \\|")) ||
        group == "Root" || match[1] == "dataset" || match[1] == "attribute")
      continue;
    std::string cell = match[1];
    for (std::smatch name; std::regex_search(cell, name, std::regex("[a-z_0-9]+"));
         cell = name.suffix())
      names.insert(group + "/" + name.str());
  }
  return names;
}

TEST_F(StudyFileTest, HoldsWhatTheFormatDocumentsAndNothingElse) {
  const Entry entry = listed(written("study.h5", outcomes_));
  std::set<std::string> expected =
      documented_datasets(text_of(CAGETOL_SOURCE_DIR "/mc/RESULTS_FORMAT.md"));
  ASSERT_GT(expected.size(), 15u);
  expected.erase("inputs/cage.pocket_width_mm/noise");  // this input has none
  std::erase_if(expected, [](const std::string& name) {
    return name.starts_with("jam/");  // this study has no candidates
  });
  for (const std::string& name : expected) EXPECT_THAT(entry.paths, testing::Contains(name));
  for (const std::string& path : entry.paths) {
    const std::string group = path.substr(0, path.find('/'));
    if (group == "samples" || group == "study" || group == "timing") {
      EXPECT_TRUE(path == group || expected.contains(path)) << path << " is not documented";
    }
  }
}

TEST_F(StudyFileTest, HoldsTheRootAttributesThatTheFormatDocuments) {
  const std::string format = text_of(CAGETOL_SOURCE_DIR "/mc/RESULTS_FORMAT.md");
  const std::string path = written("study.h5", outcomes_);
  const Hdf5Reader file(read_study_bytes(path), path);
  for (const char* name :
       {"schema_version", "tool_version", "tool_commit", "build", "libraries", "study_name",
        "study_hash", "seed", "design", "rows_planned", "samples_planned", "pockets"}) {
    EXPECT_TRUE(file.has_attribute("/", name)) << name;
    EXPECT_THAT(format, HasSubstr(name));
  }
  EXPECT_EQ(file.integer_attribute("/", "schema_version"), kStudySchema);
  EXPECT_THAT(format, HasSubstr("schema version " + std::to_string(kStudySchema)));
}

TEST_F(StudyFileTest, HoldsTheOperatingPointOfTheNominalScene) {
  plan_.study.scene.operation.radial_load = 2500;
  const std::string path = written("study.h5", outcomes_);
  const Hdf5Reader file(read_study_bytes(path), path);
  const OperatingPoint at = operating_point(plan_.study.scene);
  for (const OperatingRow& row : operating_rows()) {
    const std::vector<double> values =
        file.reals(std::string("/operating_point/") + row.key).values;
    ASSERT_EQ(values.size(), 1U) << row.key;
    EXPECT_TRUE(values[0] == row.value(at) || std::isnan(row.value(at))) << row.key;
  }
  EXPECT_EQ(file.reals("/operating_point/equivalent_load_N").values[0], 2500);
}

TEST_F(StudyFileTest, NoSampleYetIsAStudyFileToo) {
  EXPECT_THAT(read_study_file(written("study.h5", {})).outcomes, IsEmpty());
}

TEST_F(StudyFileTest, TextsOfAnyLengthAreKept) {
  outcomes_.at(1).reason = std::string(kLongestReason, 'x');
  outcomes_.at(2).reason = "";
  plan_.study.resolved_toml += "# " + std::string(200000, 'y') + "\n";
  plan_.study.name = std::string(100000, 'z');
  plan_.study.resolved_json =
      R"({"inputs":[{"key":"cage.pocket_width_mm","lot":")" + std::string(100000, 'v') + "\"}]}";
  const StudyFile file = read_study_file(written("study.h5", outcomes_));
  EXPECT_EQ(file.outcomes.at(1).reason, outcomes_.at(1).reason);
  EXPECT_EQ(file.outcomes.at(2).reason, "");
  EXPECT_EQ(file.study_toml, plan_.study.resolved_toml);
}

TEST(StoredOutcomeTest, ALongReasonIsCutBetweenCharacters) {
  EXPECT_EQ(first_bytes("short", 5), "short");
  EXPECT_EQ(first_bytes("5 \u00b5m", 3), "5 ");
  EXPECT_EQ(first_bytes("5 \u00b5m", 4), "5 \u00b5");
  Outcome outcome;
  outcome.reason = std::string(5000, 'r');
  EXPECT_EQ(make_stored_outcome(0, outcome, 0, 0).reason.size(), kLongestReason);
}

TEST_F(StudyFileTest, ACutFileIsAnErrorNotACrash) {
  const std::string whole = text_of(written("study.h5", outcomes_));
  for (const std::size_t size : {0ul, 10ul, 600ul, whole.size() / 2, whole.size() - 1}) {
    const std::string path = scratch_ / "cut.h5";
    std::ofstream(path, std::ios::binary) << whole.substr(0, size);
    EXPECT_THROW(read_study_file(path), StudyFileError) << size;
  }
}

// Of a program that did not know today's quantities: said so, not called damaged.
TEST_F(StudyFileTest, OfAnOlderProgramIsRefusedWithTheReason) {
  const std::string path = written("study.h5", outcomes_);
  std::string bytes = text_of(path).substr(kSealSize);
  {
    const H5Handle file(H5LTopen_file_image(bytes.data(), bytes.size(), H5LT_FILE_IMAGE_OPEN_RW),
                        H5Fclose, "open");
    H5Ldelete(file, "quantities/cage_slip_ratio", H5P_DEFAULT);
    std::ofstream(path, std::ios::binary) << sealed_h5_image(file);
  }
  try {
    read_study_file(path);
    FAIL();
  } catch (const StudyFileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the file is of a cagetol without this quantity (build"));
    EXPECT_THAT(error.what(), HasSubstr("sweep the study again into another directory"));
  }
}

TEST_F(StudyFileTest, AnUnwritablePlaceLeavesTheOldFile) {
  const std::string path = written("study.h5", outcomes_);
  const std::string before = text_of(path);
  std::filesystem::create_directory(scratch_ / "taken");
  EXPECT_THROW(write_study_file(scratch_ / "taken", plan_, outcomes_, build_), WriteError);
  EXPECT_THROW(write_study_file(path + "/below", plan_, outcomes_, build_), WriteError);
  EXPECT_EQ(text_of(path), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch_.path()), {}), 2);
}

}  // namespace
}  // namespace cagetol
