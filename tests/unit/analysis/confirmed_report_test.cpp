// The report on the stages of a recommendation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
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
              HasSubstr("Confirmed: pocket width 0.090 mm (IT11)"));
  EXPECT_THAT(page(), HasSubstr("Fresh runs at the recommended tolerance"));
  EXPECT_THAT(page(), HasSubstr("Capability at this tolerance"));
  EXPECT_THAT(page(), HasSubstr("cagetol replay DIR/mixture --sample"));
  EXPECT_THAT(page(), testing::Not(testing::ContainsRegex(">-?nan")));
  const auto& centres = json.at("tolerance").at("centres");
  EXPECT_EQ(centres.at("dimensions").size(), 2u);
  EXPECT_EQ(centres.at("dimensions")[0].at("points").size(), 9u);
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
