// The report on alternatives of assumptions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "analysis/report/report.hpp"
#include "analysis/tolerance/assumption_plan.hpp"
#include "tests/support/process.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class AssumptionReport : public testing::Test {
 protected:
  void SetUp() override {
    write(make_synthetic_study({.rows = 1200}), "mixture");
    write(fresh_runs(200, 0, 50), "confirm-1");
  }

  void write(const StudyData& study, const std::string& stage) const {
    fs::create_directories(scratch_ / stage);
    write_synthetic_study(study, scratch_ / (stage + "/study.h5"));
  }
  /// Cages of IT11 with these values of every quantity, of which the first ones jam.
  static StudyData fresh_runs(std::int64_t runs, std::size_t jammed, double value) {
    StudyData study = make_synthetic_study({.rows = runs,
                                            .seed = 71,
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
      std::fill(quantity.values.begin(), quantity.values.end(), value);
    for (std::size_t i = 0; i < jammed; ++i) study.status[i] = RunStatus::jammed;
    return study;
  }
  AssumptionPlan write_plan(std::size_t runs) const {
    const AssumptionPlan plan{
        1,
        runs,
        72,
        150,
        0.5,
        {{"lubrication.race_layer_um", "um", "nobody measured it", 5, 50, 5, 20},
         {"lubrication.race_layer_um", "um", "nobody measured it", 5, 50, 50, 20},
         {"cage.guide_clearance_mm", "mm", "a guess", 0.1, 0.3, 0.1, kUndefined}}};
    std::ofstream(scratch_ / "assumptions.json") << to_json(plan).dump(1);
    return plan;
  }
  void write_alternative(const AssumptionPlan& plan, std::size_t k, const StudyData& runs) const {
    write(runs, alternative_directory(plan, plan.alternatives[k]));
  }

  nlohmann::json report(const nlohmann::ordered_json& bearing = {}) const {
    testing::internal::CaptureStdout();
    run_report(scratch_.path(),
               {.bearing = [&](const fs::path&) { return bearing; }, .figures = false});
    testing::internal::GetCapturedStdout();
    std::ifstream stream(scratch_ / "report.json");
    return nlohmann::json::parse(stream);
  }
  std::string page() const { return page_text(scratch_ / "report.html"); }

  ScratchDirectory scratch_;
};

TEST_F(AssumptionReport, TheVerdictSaysUnderWhichAlternativesItHolds) {
  const AssumptionPlan plan = write_plan(200);
  write_alternative(plan, 0, fresh_runs(200, 0, 53));
  write_alternative(plan, 1, fresh_runs(200, 100, 50));
  write_alternative(plan, 2, fresh_runs(200, 9, 50));
  const auto json = report();
  const auto& verdicts = json.at("assumption_verdicts");
  EXPECT_EQ(verdicts.at("holds"), 1);
  EXPECT_EQ(verdicts.at("fails"), 1);
  EXPECT_EQ(verdicts.at("not_resolved"), 1);
  EXPECT_EQ(verdicts.at("measure_first"), "lubrication.race_layer_um");
  const auto& first = verdicts.at("alternatives").at(0);
  EXPECT_EQ(first.at("verdict"), "holds");
  EXPECT_EQ(first.at("unit"), "um");
  EXPECT_EQ(first.at("high"), 50);
  EXPECT_EQ(first.at("quantities").at(0).at("change").at("value"), 3);
  EXPECT_TRUE(first.at("quantities").at(0).at("change_by_tolerance").at("value").is_number());
  const auto& last = verdicts.at("alternatives").at(2);
  EXPECT_TRUE(last.at("nominal").is_null());
  EXPECT_GT(last.at("runs_needed"), 200);
  EXPECT_EQ(last.at("yield_change").at("lost"), 9);
  EXPECT_TRUE(last.at("yield_change").at("named"));
  EXPECT_THAT(json.at("verdict").at("statement").get<std::string>(),
              AllOf(HasSubstr("Confirmed"), HasSubstr("holds under 1 of 3 alternatives"),
                    HasSubstr("fails under lubrication.race_layer_um = 50"),
                    HasSubstr("not resolved under cage.guide_clearance_mm = 0.1")));
  EXPECT_THAT(page(), AllOf(HasSubstr("What nobody knows"), HasSubstr("the tolerance"),
                            Not(testing::ContainsRegex(">-?nan"))));
}

TEST_F(AssumptionReport, ShowsWhatRunsTakeWhereTheSceneSaysAuto) {
  const AssumptionPlan plan = write_plan(200);
  for (const std::size_t k : {0, 2}) write_alternative(plan, k, fresh_runs(200, 0, 50));
  const auto json = report(
      {{"points", nlohmann::json::array()},
       {"assumed",
        {{"lubrication.race_layer_um", {{"value", 7}, {"unit", "um"}, {"automatic", false}}},
         {"cage.guide_clearance_mm", {{"value", 0.21}, {"unit", "mm"}, {"automatic", true}}}}}});
  const auto& verdicts = json.at("assumption_verdicts");
  EXPECT_EQ(verdicts.at("alternatives").at(0).at("nominal"), 20);  // as it was run
  EXPECT_EQ(verdicts.at("alternatives").at(1).at("nominal"), 0.21);
  EXPECT_EQ(verdicts.at("ranges").at(1).at("value"), 0.21);
  EXPECT_THAT(page(), AllOf(HasSubstr(">20 µm<"), HasSubstr(">auto: 0.21 mm<")));
}

TEST_F(AssumptionReport, RunsOfOtherCagesAreNoPairs) {
  const AssumptionPlan plan = write_plan(200);
  StudyData other = fresh_runs(200, 0, 50);
  other.provenance.seed += 1;
  write_alternative(plan, 0, other);
  StudyData part = fresh_runs(200, 0, 50);
  part.design.samples_planned = 250;
  write_alternative(plan, 1, part);
  write_alternative(plan, 2, fresh_runs(200, 0, 50));
  const auto json = report();
  EXPECT_EQ(json.at("assumption_verdicts").at("judged"), 1);
  EXPECT_THAT(json.at("verdict").at("statement").get<std::string>(),
              HasSubstr("holds under 1 of 1 alternatives of the assumptions. 2 are not run yet."));
}

TEST_F(AssumptionReport, RangesThatNobodyJudgedAreNamed) {
  write_plan(0);
  const auto json = report();
  EXPECT_EQ(json.at("assumption_verdicts").at("judged"), 0);
  EXPECT_THAT(json.at("verdict").at("statement").get<std::string>(),
              HasSubstr("Not judged under the 3 alternatives"));
  EXPECT_THAT(page(), HasSubstr("recommend.assumption_samples=auto does it, 150 runs"));
  EXPECT_THAT(page(), HasSubstr("Assumptions that nobody has judged"));
  fs::remove(scratch_ / "assumptions.json");
  EXPECT_TRUE(report().at("assumption_verdicts").is_null());
}

TEST(AssumptionTable, ShowsRanges) {
  StudyData study = make_synthetic_study({.rows = 200});
  study.plan.scene["assumption"] = {
      {{"key", "lubrication.race_layer_um"}, {"note", "why"}, {"low", 5}, {"high", 50}},
      {{"key", "cage.width_mm"}, {"note", "why"}}};
  EXPECT_THAT(page_of(make_report(study)), HasSubstr(">5 to 50<"));
  const nlohmann::ordered_json flooded = {
      {"points", nlohmann::json::array()},
      {"assumed",
       {{"lubrication.race_layer_um",
         {{"value", "flooded"}, {"unit", "um"}, {"automatic", true}}}}}};
  const auto report = make_report(study, {}, "DIR", {}, {}, {}, flooded);
  EXPECT_EQ(report.at("assumptions").at("ranged").at(0).at("value"), "flooded");
  EXPECT_THAT(page_of(report), AllOf(HasSubstr(">auto: flooded<"), HasSubstr("flooded (5 to 50)")));
}

TEST(AssumptionPlan, IsReadAsWrittenAndSaysWhatItTakes) {
  AssumptionPlan plan{2, 300, 72, 150, 0.5, {{"a.b_um", "um", "why", 1, 2, 1.5, 1.7}}};
  EXPECT_EQ(to_json(assumption_plan_of(to_json(plan))), to_json(plan));
  EXPECT_EQ(alternative_directory(plan, plan.alternatives[0]), "assume-2-300/a.b_um-1.5");
  EXPECT_THAT(
      assumption_plan_text(plan),
      AllOf(HasSubstr("300 runs under each of 1 alternatives, 300 in all, about 2 min"),
            HasSubstr("One whose yield is that of confirm-2 is settled by about 150 runs")));
  plan.runs = 0;
  EXPECT_THAT(assumption_plan_text(plan), HasSubstr("72 runs under each of 1 alternatives, 72 in"));
  plan.attempt = 0;
  EXPECT_THAT(assumption_plan_text(plan), HasSubstr("no tolerance was tried"));
  plan.alternatives.clear();
  EXPECT_EQ(assumption_plan_text(plan), "");
}

}  // namespace
}  // namespace cagetol
