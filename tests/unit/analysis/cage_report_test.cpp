#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "analysis/report/cage_peak.hpp"
#include "analysis/report/json_parts.hpp"
#include "analysis/report/report.hpp"
#include "tests/support/process.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

/// Ten runs of a flexible cage, three of them checked; sample 7 has the largest stress of those
/// that are ok.
StudyData flexible_study() {
  StudyData study = plain_study(10);
  study.plan.scene = {{"cage", {{"model", "flexible"}}}};
  study.provenance.study_hash = "0123";
  study.provenance.build = "this build";
  const double none = std::nan("");
  study.run.push_back({"cage_frequency_error", "-", "", std::vector<double>(10, none)});
  study.run.back().values[2] = 0.0004;
  study.run.back().values[5] = 0.0016;
  study.run.back().values[9] = 0.0010;
  study.quantities.push_back(
      {"cage_stress_peak_MPa", "MPa", "", {1, 2, 3, 4, 5, 6, 70, 60, none, 60}});
  study.status[6] = RunStatus::failed;
  return study;
}

Json field(std::int64_t sample) {
  const Json surface{{"name", "outer surface"}, {"across", {0, 1, 1, 0}},
                     {"up_mm", {0, 0, 1, 1}},   {"stress_MPa", {1, 2, 3, 61}},
                     {"cells", {{0, 1, 2, 3}}}, {"corners_mm", {0.5}}};
  return {
      {"study_hash", "0123"},
      {"build", "this build"},
      {"sample", sample},
      {"time_ms", 12.5},
      {"pocket", 4},
      {"station", "bar root, leading face"},
      {"stations_MPa", 60},
      {"pockets", 13},
      {"full", {{"stress_MPa", 61}, {"angle_deg", 110}, {"axial_mm", 4.5}, {"radius_mm", 18.5}}},
      {"surfaces", {surface, surface, surface}}};
}

TEST(CageReport, SaysHowFarTheModelIsFromFullSolves) {
  const Json report = make_report(flexible_study());
  const Json& accuracy = report.at("cage").at("accuracy");
  EXPECT_EQ(accuracy.at("samples_checked"), 3);
  EXPECT_EQ(accuracy.at("samples"), 10);
  EXPECT_DOUBLE_EQ(accuracy.at("largest_error"), 0.0016);
  EXPECT_DOUBLE_EQ(accuracy.at("mean_error"), 0.0010);
  const std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("<b>3</b> of 10 samples"));
  EXPECT_THAT(page, HasSubstr("<b>0.160 %</b> at most, 0.100 % on average"));
  EXPECT_THAT(page, HasSubstr("within 0.2 % on scattered pockets, 0.5 %"));
}

TEST(CageReport, SaysWhenNoSampleWasChecked) {
  StudyData study = flexible_study();
  study.run.back().values.assign(10, std::nan(""));
  const Json report = make_report(study);
  EXPECT_TRUE(report.at("cage").at("accuracy").at("largest_error").is_null());
  EXPECT_THAT(page_of(report), HasSubstr("No sample's cage was also solved in full"));
}

TEST(CageReport, HasNoChapterForARigidCage) {
  StudyData study = flexible_study();
  study.plan.scene["cage"]["model"] = "rigid";
  const Json report = make_report(study);
  EXPECT_TRUE(report.at("cage").is_null());
  EXPECT_THAT(page_of(report), testing::Not(HasSubstr("id=\"cage\"")));
}

TEST(CageReport, TheMostStressedSampleIsOkAndTheFirstOfEquals) {
  StudyData study = flexible_study();
  EXPECT_EQ(most_stressed_sample(study), 7);
  study.quantities.clear();
  EXPECT_FALSE(most_stressed_sample(study));
}

TEST(CageReport, ReadsTheFieldOfThatSampleAlone) {
  const ScratchDirectory scratch;
  const std::filesystem::path directory(scratch.path());
  const StudyData study = flexible_study();
  EXPECT_TRUE(read_cage_peak(directory, study).is_null());
  std::ofstream(cage_peak_file(directory)) << "{ broken";
  EXPECT_TRUE(read_cage_peak(directory, study).is_null());
  std::ofstream(cage_peak_file(directory)) << field(7);
  EXPECT_EQ(read_cage_peak(directory, study), field(7));
  std::ofstream(cage_peak_file(directory)) << field(6);
  EXPECT_TRUE(read_cage_peak(directory, study).is_null());
  for (const char* key : {"study_hash", "build"}) {
    Json other = field(7);
    other[key] = "another";
    std::ofstream(cage_peak_file(directory)) << other;
    EXPECT_TRUE(read_cage_peak(directory, study).is_null()) << key;
  }
}

TEST(CageReport, SaysWhatScatteringDiametersLeaveWrong) {
  StudyData study = flexible_study();
  EXPECT_TRUE(make_report(study).at("cage").at("thickness").is_null());
  study.plan.scene["cage"]["outer_diameter_mm"] = 43.4;
  study.plan.scene["cage"]["inner_diameter_mm"] = 37.4;
  study.inputs.push_back({"cage.outer_diameter_mm", "mm", {43.4}, {}, {}, {}, {}, false});
  InputColumns& outside = study.inputs.back();
  outside.value.assign(study.size(), 43.4);
  outside.lot.assign(study.size(), 0.0);
  outside.value[3] = 43.37;  // 0.5 % of 6 mm
  outside.lot[3] = -0.03;
  const Json report = make_report(study);
  EXPECT_NEAR(report.at("cage").at("thickness").at("largest_share").get<double>(), 0.005, 1e-9);
  EXPECT_THAT(page_of(report), HasSubstr("deviate by up to 0.5 % of the thickness"));
}

TEST(CageReport, DrawsTheField) {
  const Json report = make_report(flexible_study(), {}, "DIR", field(7));
  const std::string page = page_with_figures(report);
  EXPECT_THAT(page, HasSubstr("alt=\"cage_stress\""));
  EXPECT_THAT(page, HasSubstr("<b>60 MPa</b>"));
  EXPECT_THAT(page, HasSubstr("<b>61 MPa</b> at 110.0°"));
  EXPECT_THAT(page, HasSubstr("4.50 mm, radius 18.50 mm"));
}

}  // namespace
}  // namespace cagetol
