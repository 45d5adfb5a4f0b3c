// What a report says of the measured parts that laws were read from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/report/json_parts.hpp"
#include "analysis/report/report.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Widths of cages of three pockets, mean 0.001 times their number; the second value of the first
/// cage is missing.
Json measured_input(int cages, bool centred = false) {
  Json names = Json::array(), values = Json::array(), cage = Json::array();
  for (int c = 0; c < cages; ++c) {
    names.push_back("K" + std::to_string(c + 1));
    for (const double own : {-0.002, 0.0, 0.002}) {
      cage.push_back(c);
      values.push_back(c == 0 && own == 0 ? 99 : 0.001 * c + own);
    }
  }
  return {{"key", "cage.pocket_width_mm"},
          {"unit", "mm"},
          {"measured",
           {{"file", "shop.csv"},
            {"hash", "0123456789abcdef"},
            {"column", "width"},
            {"group", "cage"},
            {"fitted", false},
            {"centred", centred},
            {"offset", 0.005},
            {"names", names},
            {"values", values},
            {"cage", cage},
            {"gaps", {1}},
            {"remarks", {"line 3 is left out"}}}}};
}

StudyData study_with(const Json& input, std::int64_t rows = 240) {
  StudyData study = make_synthetic_study({.rows = rows, .replicate_share = 0, .failed_share = 0});
  study.plan.whole["inputs"] = Json::array({input});
  return study;
}

TEST(MeasuredReport, HasScatterCapabilityAndDriftOfTheParts) {
  const Json report = make_report(study_with(measured_input(12)));
  const Json& measured = report["measured"][0];
  EXPECT_EQ(measured["parts"], 35);
  const Json& process = measured["process"];
  // Each cage: 8e-6 over its pockets, the first of two included; 35 - 12 of freedom.
  const double own = std::sqrt(12 * 8e-6 / 23);
  EXPECT_NEAR(process["pocket_sigma"]["value"], own, 1e-9);
  EXPECT_NEAR(process["mean"]["value"], 0.0055, 1e-9);
  EXPECT_EQ(process["tolerance_width"], 0.1);
  EXPECT_NEAR(process["cp"]["value"], 0.1 / 6 / own, 1e-6);
  EXPECT_NEAR(process["cpk"]["value"], (0.05 - 0.0055) / 3 / own, 1e-6);
  const double total = std::hypot(own, process["cage_sigma"]["value"].get<double>());
  EXPECT_NEAR(process["ppk"]["value"], (0.05 - 0.0055) / 3 / total, 1e-6);
  EXPECT_LT(process["pp"]["lower"], process["pp"]["value"]);
  EXPECT_GT(process["pp"]["upper"], process["pp"]["value"]);
  EXPECT_LT(process["outside_ppm"]["value"], process["outside_ppm"]["upper"]);
  EXPECT_NEAR(measured["drift"]["value"], 0.011, 1e-9);
  EXPECT_GT(measured["drift"]["lower"], 0.0109);
}

TEST(MeasuredReport, TakesTheMeanOfThePartsWhereItIsSubtracted) {
  const Json report = make_report(study_with(measured_input(12, true)));
  EXPECT_NEAR(report["measured"][0]["process"]["mean"]["value"], 0.0055 + 0.005, 1e-9);
}

TEST(MeasuredReport, SaysInTheVerdictWhereCagesAreFew) {
  const auto few = make_report(study_with(measured_input(9)))["verdict"];
  EXPECT_THAT(few["statement"].get<std::string>(), HasSubstr("measured of 9 cages: fewer than 10"));
  EXPECT_THAT(few["grounds"].get<std::vector<std::string>>(), Contains(HasSubstr("of 9 cages")));
  const auto enough = make_report(study_with(measured_input(10)))["verdict"];
  EXPECT_THAT(enough["statement"].get<std::string>(), Not(HasSubstr("fewer than 10")));
}

TEST(MeasuredReport, NamesTheCagesAtRiskFirst) {
  StudyData study = study_with(measured_input(12), 24);
  EXPECT_TRUE(make_report(study)["measured_cages"].empty());
  study.plan.whole["measured_in_turn"] = true;
  for (Column& quantity : study.quantities)
    if (quantity.name == "whirl_radius_ratio_p95")
      for (std::size_t i = 0; i < study.size(); ++i)
        quantity.values[i] = study.row[i] == 4 ? 1.3 : study.row[i] % 12 == 7 ? 1.2 : 0.9;
    else
      std::fill(quantity.values.begin(), quantity.values.end(), 60.0);
  std::fill(study.status.begin(), study.status.end(), RunStatus::ok);
  const Json report = make_report(study);
  const Json& cages = report["measured_cages"];
  ASSERT_EQ(cages.size(), 12u);
  EXPECT_EQ(cages[0]["cage"], "K8");
  EXPECT_EQ(cages[0]["missed"], 2);
  EXPECT_EQ(cages[0]["runs"], 2);
  EXPECT_EQ(cages[0]["quantity"], "whirl_radius_ratio_p95");
  EXPECT_EQ(cages[1]["cage"], "K5");
  EXPECT_EQ(cages[1]["missed"], 1);
  EXPECT_EQ(cages[1]["extreme"], 1.3);
  EXPECT_EQ(cages[2]["missed"], 0);
}

TEST(MeasuredReport, ShowsThemOnAPageOfTheirOwn) {
  StudyData study = study_with(measured_input(12), 24);
  study.plan.whole["measured_in_turn"] = true;
  const std::string page = page_with_figures(make_report(study));
  EXPECT_THAT(page, AllOf(HasSubstr("The measured parts"), HasSubstr("shop.csv"),
                          HasSubstr("0123456789abcdef"), HasSubstr("12 cages"),
                          HasSubstr("Line 3 is left out."), HasSubstr("the mean drifts")));
  EXPECT_THAT(page, AllOf(HasSubstr("Which of the measured cages is at risk"), HasSubstr("K12"),
                          HasSubstr("alt=\"process\"")));
  EXPECT_THAT(page_of(make_report(make_synthetic_study({.rows = 60}))),
              Not(HasSubstr("The measured parts")));
}

}  // namespace
}  // namespace cagetol
