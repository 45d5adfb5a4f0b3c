#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/report/companion.hpp"
#include "analysis/report/json_parts.hpp"
#include "analysis/report/report.hpp"
#include "distributions/random_stream.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

constexpr const char* kQuantity = "ring_displacement_mean_um";

double normal(std::int64_t id, std::uint32_t stream) {
  return gsl_cdf_ugaussian_Pinv(
      uniform(9, Purpose::noise, static_cast<std::uint64_t>(id), stream, 0));
}

/// Runs whose quantity is 20 + x + noise, x a normal deviate of the sample; each takes `seconds`.
StudyData runs_of(std::int64_t rows, double noise, double seconds) {
  StudyData runs = plain_study(rows);
  Column column{kQuantity, "um", "", {}}, other{"cage_slip_ratio", "-", "", {}};
  InputColumns input;
  input.key = "load.radial_N";
  for (std::int64_t id = 0; id < rows; ++id) {
    const double x = normal(id, 1);
    input.value.push_back(1000 + 100 * x);
    column.values.push_back(20 + x + noise * normal(id, 2));
    other.values.push_back(normal(id, noise > 0 ? 3 : 4));
  }
  runs.inputs = {input};
  runs.quantities = {other, column};
  runs.timing = {{"wall_s", "s", "", std::vector<double>(static_cast<std::size_t>(rows), seconds)}};
  runs.plan.limits = {{.quantity = kQuantity, .minimum = {}, .maximum = 21, .source = "test"}};
  runs.plan.whole["fidelity_samples"] = 100;
  return runs;
}

TEST(MultifidelityReport, ShowsEstimatesErrorsAndGains) {
  const StudyData study = runs_of(300, 0.1, 1);
  EXPECT_TRUE(make_report(study)["multifidelity"].is_null());
  EXPECT_EQ(section_of(page_of(make_report(study)), "multifidelity"), "");
  const StudyData companion = runs_of(6000, 0, 0.01);
  const Json report = make_report(study, {}, "DIR", {}, {}, companion);
  const Json& part = report["multifidelity"];
  EXPECT_TRUE(part["problem"].is_null());
  EXPECT_EQ(part["companion_runs"], 6000);
  EXPECT_DOUBLE_EQ(part["cost_ratio"].get<double>(), 0.01);
  EXPECT_EQ(part["pilot_pairs"], 100);
  ASSERT_EQ(part["quantities"].size(), 2u);
  const Json& limited = part["quantities"][0];  // first, whatever the order in the file
  EXPECT_EQ(limited["quantity"], kQuantity);
  // r^2 = 1 / 1.01, M / N = 20, w = 0.01: 1 / (1.2 (1 - 0.95 / 1.01)) = 14.
  const Json& mean = limited["statistics"][0];
  EXPECT_NEAR(mean["predicted_gain"].get<double>(), 14, 1.5);
  EXPECT_NEAR(mean["achieved_gain"].get<double>(), 14, 4);
  EXPECT_NEAR(mean["helped"]["value"].get<double>(), 20,
              4 * mean["helped"]["standard_error"].get<double>());
  EXPECT_LT(mean["helped"]["standard_error"].get<double>(),
            0.3 * mean["plain"]["standard_error"].get<double>());
  const Json& yield = limited["statistics"][2];
  EXPECT_EQ(yield["statistic"], "yield");
  const double truth = gsl_cdf_ugaussian_P(1 / std::sqrt(1.01));
  EXPECT_NEAR(yield["helped"]["value"].get<double>(), truth,
              4 * yield["helped"]["standard_error"].get<double>());
  EXPECT_GT(yield["achieved_gain"].get<double>(), 2);
  // The other quantity has nothing in common: no gain, and none is measured.
  EXPECT_LT(part["quantities"][1]["statistics"][0]["predicted_gain"].get<double>(), 1.2);
  EXPECT_TRUE(part["quantities"][1]["statistics"][0]["achieved_gain"].is_null());
  EXPECT_EQ(part["quantities"][1]["statistics"].size(), 2u);  // no yield without a limit
  const std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("6000 runs of a cheaper model"));
  EXPECT_THAT(page, HasSubstr("0.2 times the processor time"));
  EXPECT_EQ(report.dump(), make_report(study, {}, "DIR", {}, {}, companion).dump());
}

TEST(MultifidelityReport, LeavesOutRunsWithoutAResult) {
  StudyData study = runs_of(300, 0.1, 1);
  for (std::size_t k = 0; k < 300; k += 10) study.status[k] = RunStatus::failed;
  const Json report = make_report(study, {}, "DIR", {}, {}, runs_of(6000, 0, 0.01));
  const Json& mean = report["multifidelity"]["quantities"][0]["statistics"][0];
  EXPECT_EQ(mean["lost"], 30);
  EXPECT_GT(mean["achieved_gain"].get<double>(), 7);
}

TEST(MultifidelityReport, TakesNoOtherSamples) {
  const StudyData study = runs_of(300, 0.1, 1);
  const auto problem = [&](const std::function<void(StudyData&)>& spoil) {
    StudyData companion = runs_of(400, 0, 0.01);
    spoil(companion);
    return companion_problem(study, companion);
  };
  EXPECT_EQ(problem([](StudyData&) {}), "");
  EXPECT_THAT(problem([](StudyData& runs) { runs.inputs[0].value[7] += 1e-9; }),
              HasSubstr("differ from the study's in load.radial_N"));
  EXPECT_THAT(problem([](StudyData& runs) { runs.id[3] = 500; }), HasSubstr("not those"));
  EXPECT_THAT(problem([](StudyData& runs) { runs.provenance.build = "another"; }),
              HasSubstr("another build"));
  EXPECT_THAT(problem([](StudyData& runs) { runs.inputs.clear(); }), HasSubstr("not those"));
  StudyData companion = runs_of(400, 0, 0.01);
  companion.id[3] = 500;
  EXPECT_THAT(page_of(make_report(study, {}, "DIR", {}, {}, companion)),
              HasSubstr("is not used: its samples are not those of the study"));
}

}  // namespace
}  // namespace cagetol
