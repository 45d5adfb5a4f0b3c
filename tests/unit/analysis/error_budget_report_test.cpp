#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "analysis/fidelity/model_ladder.hpp"
#include "analysis/report/json_parts.hpp"
#include "analysis/report/refining_ladder.hpp"
#include "analysis/report/report.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The first 24 runs of a study, its stress off by `shift`.
StudyData first_samples(const StudyData& study, double shift) {
  std::vector<std::size_t> keep;
  for (std::size_t i = 0; keep.size() < 24; ++i)
    if (study.status[i] == RunStatus::ok) keep.push_back(i);
  StudyData runs = select_samples(study, keep);
  for (double& value : runs.quantities[0].values) value += shift;
  return runs;
}

/// Refining the integrator lowers the stress by 3 MPa; the slices lose two runs; no mesh.
Json refining_ladder(const StudyData& study) {
  StudyData lossy = first_samples(study, 0);
  lossy.status[3] = lossy.status[8] = RunStatus::failed;
  ModelLadder ladder = make_model_ladder(
      {{.name = "integrator", .meaning = "integration tolerance 0.0005"},
       {.name = "slices", .meaning = "11 slices of a contact"},
       {.name = "as-run", .meaning = "the scene as it is"}},
      {first_samples(study, -3), lossy, first_samples(study, 0)}, {.study_samples = 1000});
  ladder.refining = true;
  ladder.study = study.plan.name;
  ladder.resolved_study = study.plan.whole;
  ladder.build = study.provenance.build;
  return ladder_json(ladder);
}

Json budget_of(const Json& report, const std::string& quantity) {
  for (const Json& entry : report["error_budget"]["quantities"])
    if (entry["quantity"] == quantity) return entry;
  return {};
}

TEST(ErrorBudgetReport, WithoutALadderItSaysHowToMeasure) {
  const Json report = make_report(make_synthetic_study());
  const Json stress = budget_of(report, "cage_stress_peak_MPa");
  EXPECT_EQ(stress["largest"], "statistical");
  EXPECT_EQ(stress["sources"][0]["standard_errors"], 1);
  EXPECT_TRUE(
      stress["sources"][1]["error"]["value"].is_number());  // noise of a standard deviation 2
  EXPECT_NEAR(stress["sources"][1]["error"]["value"].get<double>(), 2 / std::sqrt(1000.0), 0.02);
  EXPECT_EQ(stress["sources"][2]["state"], "not measured");
  EXPECT_TRUE(stress["sources"][2]["error"]["value"].is_null());
  EXPECT_TRUE(budget_of(report, "lambda_min").is_null());  // it has no mean
  const std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("cagetol ladder DIR/study.toml --refine -o DIR/ladder-refine"));
  EXPECT_THAT(
      page,
      HasSubstr("Errors of integrator, modes, slices, mesh and window are <b>not measured</b>"));
  // Below mixture/ in the directory of a recommendation.
  const Json staged = make_report(make_synthetic_study({.rows = 200}), {}, "DIR/mixture");
  EXPECT_EQ(staged["error_budget"]["evidence"]["command"],
            "cagetol ladder DIR/mixture/study.toml --refine -o DIR/mixture/ladder-refine");
}

TEST(ErrorBudgetReport, ShowsWhatTheLadderMeasured) {
  const StudyData study = make_synthetic_study();
  const Json report = make_report(study, {}, "DIR", {}, refining_ladder(study));
  EXPECT_EQ(report["error_budget"]["evidence"]["state"], "measured");
  const Json stress = budget_of(report, "cage_stress_peak_MPa");
  const Json &integrator = stress["sources"][2], &slices = stress["sources"][4];
  EXPECT_NEAR(integrator["error"]["value"].get<double>(), 3, 1e-9);  // as run minus refined
  EXPECT_EQ(integrator["state"], "resolved");
  EXPECT_EQ(stress["largest"], "integrator");
  EXPECT_EQ(slices["state"], "runs lost");
  EXPECT_EQ(slices["lost"], 2);
  EXPECT_EQ(stress["sources"][5]["state"], "not measured");
  const std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("first 24 samples"));
  EXPECT_THAT(page, HasSubstr("integration tolerance 0.0005"));
  EXPECT_THAT(page, HasSubstr("2 of its runs lost"));
  EXPECT_THAT(page, Not(HasSubstr("Another build")));
  Json other = refining_ladder(study);
  other["build"] = "another";
  EXPECT_THAT(page_of(make_report(study, {}, "DIR", {}, other)), HasSubstr("Another build"));
}

// Resolved errors of settings alone: the integrator's 3 MPa, not the runs that the slices lost.
TEST(KnownBias, IsTheSumOfResolvedErrors) {
  const StudyData study = make_synthetic_study();
  EXPECT_NEAR(known_bias(refining_ladder(study), study, "cage_stress_peak_MPa"), 3, 1e-9);
  EXPECT_EQ(known_bias(refining_ladder(study), study, "whirl_radius_ratio_p95"), 0);
  EXPECT_TRUE(std::isnan(known_bias({}, study, "cage_stress_peak_MPa")));
  EXPECT_TRUE(std::isnan(known_bias(refining_ladder(study), study, "unheard")));
}

TEST(ErrorBudgetReport, TakesNoOtherStudysLadder) {
  const StudyData study = make_synthetic_study({.rows = 200});
  Json other = refining_ladder(study);
  other["resolved_study"]["scene"]["load"]["radial_N"] = 3000;
  const Json report = make_report(study, {}, "DIR", {}, other);
  EXPECT_EQ(report["error_budget"]["evidence"]["state"], "another study");
  EXPECT_EQ(budget_of(report, "cage_stress_peak_MPa")["sources"][2]["state"], "not measured");
  EXPECT_THAT(page_of(report), HasSubstr("belongs to another study, synthetic: other values of "
                                         "<code>scene.load.radial_N</code>"));
  EXPECT_EQ(report["error_budget"]["evidence"]["differing_keys"],
            Json::array({"scene.load.radial_N"}));
  EXPECT_TRUE(std::isnan(known_bias(other, study, "cage_stress_peak_MPa")));
  Json climbing = refining_ladder(study);
  climbing["refining"] = false;
  EXPECT_THAT(page_of(make_report(study, {}, "DIR", {}, climbing)), HasSubstr("refines nothing"));
}

TEST(ErrorBudgetReport, IsReadBesideTheStudyAndDrawn) {
  const auto directory = std::filesystem::path(testing::TempDir()) / "error_budget_report";
  std::filesystem::create_directories(directory / "ladder-refine");
  const StudyData study = make_synthetic_study({.rows = 200});
  write_synthetic_study(study, directory / "study.h5");
  std::ofstream(directory / "ladder-refine" / "ladder.json") << refining_ladder(study);
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_report(directory), 0);
  testing::internal::GetCapturedStdout();
  EXPECT_TRUE(std::filesystem::exists(directory / "figures" / "error_budget.svg"));
  std::ifstream file(directory / "report.json");
  const Json quantities = Json::parse(file)["error_budget"]["quantities"];
  ASSERT_EQ(quantities.size(), 4u);
  for (const Json& quantity : quantities) EXPECT_EQ(quantity["sources"].size(), 7u);
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace cagetol
