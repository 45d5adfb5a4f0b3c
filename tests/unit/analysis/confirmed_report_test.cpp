// The report on the stages of a recommendation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "analysis/report/report.hpp"
#include "analysis/statistics/binomial_bounds.hpp"
#include "tests/support/process.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class ConfirmedReport : public testing::Test {
 protected:
  void SetUp() override { write(make_synthetic_study({.rows = 1200}), "mixture"); }

  void write(const StudyData& study, const std::string& stage) const {
    fs::create_directories(scratch_ / stage);
    write_synthetic_study(study, scratch_ / (stage + "/study.h5"));
  }

  /// Fresh runs at IT11 for both; the limits are never missed, except by the first `missing` runs.
  void write_attempt(int number, std::size_t missing) const {
    StudyData study = make_synthetic_study({.rows = 200,
                                            .seed = 70 + number,
                                            .replicate_share = 0,
                                            .failed_share = 0,
                                            .stress_limit = 1000,
                                            .whirl_limit = 100});
    study.plan.whole["candidates"] = {{{"tolerance_widths_mm", {0.09, 0.09}},
                                       {"grades", {"IT11", "IT11"}},
                                       {"scales", {0.9, 0.9}}}};
    std::fill(study.candidate.begin(), study.candidate.end(), 0);
    std::fill(study.status.begin(), study.status.end(), RunStatus::ok);
    for (Column& quantity : study.quantities)
      std::fill(quantity.values.begin(), quantity.values.end(), 50.0);
    for (std::size_t i = 0; i < missing; ++i) study.status[i] = RunStatus::jammed;
    write(study, "confirm-" + std::to_string(number));
  }

  nlohmann::json report() {
    testing::internal::CaptureStdout();
    run_report(scratch_.path(), {.figures = false});
    testing::internal::GetCapturedStdout();
    std::ifstream stream(scratch_ / "report.json");
    return nlohmann::json::parse(stream);
  }
  std::string page() const { return page_text(scratch_ / "report.html"); }

  ScratchDirectory scratch_;
};

TEST_F(ConfirmedReport, TheVerdictIsThatOfTheFreshRuns) {
  write_attempt(1, 0);
  const auto json = report();
  const auto& verdict = json.at("verdict");
  EXPECT_EQ(verdict.at("tolerances").at("cage.pocket_width_mm"),
            nlohmann::json({{"tolerance_width_mm", 0.09}, {"grade", "IT11"}}));
  EXPECT_TRUE(
      verdict.at("tolerances").at("cage.pocket_length_mm").at("grade").is_null());  // not binding
  EXPECT_EQ(verdict.at("confirmation").at("runs"), 200);
  EXPECT_EQ(verdict.at("confirmation").at("passed"), true);
  EXPECT_EQ(verdict.at("meets_target"), true);
  // Two attempts are planned by default: each at 97.5 %.
  EXPECT_NEAR(verdict.at("yield_lower_bound"), clopper_pearson_lower(200, 200, 0.975), 1e-12);
  EXPECT_THAT(verdict.at("statement").get<std::string>(),
              HasSubstr("Confirmed: pocket width 7.65 ±0.045 mm (IT11, js11)"));
  EXPECT_THAT(page(), HasSubstr("Fresh runs at the recommended tolerance"));
  EXPECT_THAT(page(), HasSubstr("Capability at this tolerance"));
  EXPECT_THAT(page(), HasSubstr("cagetol replay DIR/mixture --sample"));
  EXPECT_THAT(page(), testing::Not(testing::ContainsRegex(">-?nan")));
  const auto& centres = json.at("tolerance").at("centres");
  EXPECT_EQ(centres.at("dimensions").size(), 2u);
  EXPECT_EQ(centres.at("dimensions")[0].at("points").size(), 9u);
}

TEST_F(ConfirmedReport, AnAttemptWhoseRunsWereSeenBeforeItsLimitsConfirmsNothing) {
  write_attempt(1, 0);
  const auto own = judgement_of(read_study_data(scratch_ / "confirm-1/study.h5").plan);
  std::ofstream(scratch_ / "confirm-1/judged_by.json") << own.dump();
  EXPECT_EQ(report().at("verdict").at("status"), "confirmed");
  auto other = own;
  other["limits"][0]["max"] = 999;
  std::ofstream(scratch_ / "confirm-1/judged_by.json") << other.dump();
  const auto json = report();
  const auto& verdict = json.at("verdict");
  EXPECT_EQ(verdict.at("status"), "judged_again");
  EXPECT_EQ(verdict.at("meets_target"), false);
  EXPECT_TRUE(verdict.at("tolerances").at("cage.pocket_width_mm").at("grade").is_null());
  EXPECT_THAT(verdict.at("headline").get<std::string>(),
              HasSubstr("Judged again, not confirmed: pocket width 7.65 ±0.045 mm (IT11, js11)"));
  EXPECT_THAT(verdict.at("next")[0].at("command").get<std::string>(),
              testing::AllOf(HasSubstr("cagetol recommend STUDY -o OTHER_DIR --set seed="),
                             HasSubstr("candidates=[\"IT11\"]")));
  EXPECT_THAT(page(), testing::AllOf(HasSubstr("No tolerance to print on the drawing yet"),
                                     HasSubstr("judged again")));
}

// A report by another limit beside the study's own, which stays as it is.
TEST_F(ConfirmedReport, OfOtherLimitsStandsInAFolderOfItsOwn) {
  write_attempt(1, 0);
  report();
  const auto bytes = [&](const std::string& name) {
    std::ifstream stream(scratch_ / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string before = bytes("report.json"), runs = bytes("mixture/study.h5");
  const auto restate = [](StudyPlan& plan) {
    for (Limit& limit : plan.limits)
      if (limit.quantity == "cage_stress_peak_MPa") limit.maximum = 90;
    plan.target_yield = 0.5;
  };
  fs::create_directories(scratch_ / "judged/tight.made/left by a kill");
  for (int time = 0; time < 2; ++time) {
    testing::internal::CaptureStdout();
    run_report(scratch_.path(),
               {.figures = false, .into = scratch_ / "judged/tight", .restate = restate});
    EXPECT_THAT(testing::internal::GetCapturedStdout(),
                HasSubstr("cage_stress_peak_MPa at least 20 MPa and at most 90 MPa, target 50 % in "
                          "place of cage_stress_peak_MPa at least 20 MPa and at most 100 MPa, "));
    EXPECT_EQ(std::distance(fs::directory_iterator(scratch_ / "judged"), {}), 1);
  }
  EXPECT_EQ(bytes("report.json"), before);
  EXPECT_EQ(bytes("mixture/study.h5"), runs);
  const auto json = nlohmann::json::parse(bytes("judged/tight/report.json"));
  EXPECT_EQ(json.at("verdict").at("target_yield"), 0.5);
  ASSERT_EQ(json.at("limit_curves").size(), 3u);
  EXPECT_EQ(json.at("limit_curves")[1].at("bound"), 90);
  EXPECT_THAT(bytes("judged/tight/limit_curves.csv"), HasSubstr("cage_stress_peak_MPa,max,90.0,"));
  // Counted over the runs: a jam misses, a failed run has no judgement.
  const StudyData all = read_study_data(scratch_ / "mixture/study.h5");
  const StudyData first = select_samples(all, first_runs(all));
  double meeting = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double stress = find_quantity(first, "cage_stress_peak_MPa")->values[i];
    meeting += first.status[i] == RunStatus::ok && stress >= 20 && stress <= 90 &&
               find_quantity(first, "whirl_radius_ratio_p95")->values[i] <= 1.1;
  }
  EXPECT_DOUBLE_EQ(json.at("limits").at("joint").at("if_unknown_fail"),
                   meeting / static_cast<double>(first.size()));
}

TEST_F(ConfirmedReport, AVerdictNearTheTargetSaysThatItWasClose) {
  const auto close = [&](std::size_t failing) {
    write_attempt(1, failing);
    return report().at("verdict").at("close").size();
  };
  EXPECT_EQ(close(0), 0u);
  EXPECT_EQ(close(60), 0u);  // surely below the target
  EXPECT_EQ(close(15), 1u);  // not confirmed, though it may meet the target
  EXPECT_THAT(report().at("verdict").at("statement").get<std::string>(),
              HasSubstr("Close to the target"));
}

TEST_F(ConfirmedReport, WiderCandidatesThatNoAttemptTriedAreNamed) {
  write_attempt(1, 0);
  const auto hopeless = report().at("confirmation").at("passed_over");
  ASSERT_EQ(hopeless.size(), 1u);
  EXPECT_EQ(hopeless[0].at("name"), "pocket width IT12, pocket length IT11");
  EXPECT_THAT(hopeless[0].at("reason").get<std::string>(), HasSubstr("is below the target"));
  EXPECT_TRUE(hopeless[0].at("command").is_null());
  EXPECT_THAT(page(), HasSubstr("Wider candidates, and why they are not it"));
  // Nearly three quarters of its cages meet the limits: for a target of 65 % it could be confirmed.
  StudyData study = make_synthetic_study({.rows = 1200});
  study.plan.whole["tolerance"]["target_yield"] = 0.65;
  write(study, "mixture");
  const auto json = report();
  const auto& wider = json.at("confirmation").at("passed_over");
  ASSERT_EQ(wider.size(), 1u);
  EXPECT_GT(wider[0].at("runs_needed"), 50);
  EXPECT_THAT(wider[0].at("command").get<std::string>(), HasSubstr("candidates=[\"IT12\"]"));
  EXPECT_THAT(json.at("verdict").at("statement").get<std::string>(),
              HasSubstr("Passed over: pocket width IT12, pocket length IT11"));
}

TEST_F(ConfirmedReport, AFailedAttemptIsShownAndNamesNoTolerance) {
  write_attempt(1, 30);
  auto json = report();
  EXPECT_EQ(json.at("verdict").at("confirmation").at("passed"), false);
  EXPECT_EQ(json.at("verdict").at("confirmation").at("meeting_runs"), 170);
  EXPECT_TRUE(json.at("verdict")
                  .at("tolerances")
                  .at("cage.pocket_width_mm")
                  .at("tolerance_width_mm")
                  .is_null());
  EXPECT_THAT(json.at("verdict").at("statement").get<std::string>(),
              HasSubstr("No tolerance is confirmed after 1 of 2 planned attempts"));
  write_attempt(2, 0);
  json = report();
  EXPECT_EQ(json.at("confirmation").at("attempts").size(), 2u);
  EXPECT_EQ(json.at("verdict").at("confirmation").at("attempts"), 2);
  EXPECT_EQ(json.at("verdict").at("confirmation").at("passed"), true);
}

TEST_F(ConfirmedReport, AnUnfinishedAttemptConfirmsNothing) {
  write_attempt(1, 0);
  StudyData part = read_study_data(scratch_ / "confirm-1/study.h5");
  part.design.samples_planned = 250;
  write(part, "confirm-1");
  EXPECT_TRUE(report().at("verdict").at("confirmation").is_null());
}

}  // namespace
}  // namespace cagetol
