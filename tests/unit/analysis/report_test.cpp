// report.json of small studies, number by number. Above 400 lines: one report, one part after
// another.
#include "analysis/report/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "analysis/report/json_parts.hpp"
#include "analysis/report/python_run.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_study.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

class Report : public testing::Test {
 protected:
  void SetUp() override {
    directory_ =
        std::filesystem::path(testing::TempDir()) /
        (std::string("report_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
         "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  int report_on(const StudyData& study, const ReportOptions& options = {}) {
    write_synthetic_study(study, directory_ / "study.h5");
    testing::internal::CaptureStdout();
    const int code = run_report(directory_, options);
    printed_ = testing::internal::GetCapturedStdout();
    return code;
  }

  std::filesystem::path directory_;
  std::string printed_;
};

const ReportOptions kNoPython{.python = "/nonexistent/python3"}, kNoFigures{.figures = false};

TEST_F(Report, WritesEverythingInOnePage) {
  ASSERT_EQ(report_on(make_synthetic_study()), 0);
  const std::string html = page_text(directory_ / "report.html");
  for (const char* title :
       {"What may be printed on the drawing", "Outcomes and limits", "Yield against tolerance",
        "What drives the quantities", "Statistics of every quantity", "Error budget",
        "Capability against the limits", "Failures and worst samples", "Are there enough runs?",
        "Run health", "Where this comes from"})
    EXPECT_THAT(html, testing::HasSubstr(title));
  EXPECT_THAT(html, testing::HasSubstr("cagetol replay DIR --sample"));
  EXPECT_THAT(html, testing::HasSubstr("contact.static_speed_m_s"));
  EXPECT_THAT(html, testing::HasSubstr("fatigue limit of the cage steel"));
  // Self-contained: every image is embedded, nothing is fetched.
  EXPECT_THAT(html, testing::Not(testing::HasSubstr("http")));
  EXPECT_THAT(html, testing::Not(testing::ContainsRegex("src=\"[^d]")));
  EXPECT_THAT(html, testing::Not(testing::ContainsRegex(">-?nan")));
  const std::regex figure("<figure");
  EXPECT_GE(
      std::distance(std::sregex_iterator(html.begin(), html.end(), figure), std::sregex_iterator()),
      9);
  EXPECT_FALSE(std::filesystem::exists(directory_ / "figures" / "pages.log"));
  EXPECT_THAT(printed_, testing::HasSubstr("Recommended: pocket width"));
}

TEST_F(Report, ShowsTheModelThatAPilotChose) {
  StudyData study = make_synthetic_study({.rows = 200});
  EXPECT_TRUE(make_report(study)["fidelity"].is_null());
  study.plan.whole["fidelity_decision"] = nlohmann::ordered_json::parse(
      R"({"rung": "coarse-5", "reason": "the cheapest", "shift": [{"quantity": "cage_slip_ratio",
          "rung": "coarse-3", "verdict": "biased", "shift": 0.5, "budget": 0.25},
          {"quantity": "cage_slip_ratio", "rung": "coarse-5", "verdict": "settled",
           "limit": "limit at most 0.02", "wrong_share": 2e-5, "allowed_wrong_share": 6e-4}],
          "assumption": "that tails are light"})");
  const auto report = make_report(study);
  EXPECT_EQ(report["fidelity"]["rung"], "coarse-5");
  const std::string html = page_of(report);
  EXPECT_THAT(html, testing::HasSubstr("Rung <b>coarse-5</b>: the cheapest."));
  EXPECT_THAT(html, testing::HasSubstr("0.500 (- to -)"));
  EXPECT_THAT(html, testing::HasSubstr("limit at most 0.02"));
  EXPECT_THAT(html, testing::HasSubstr("0.002 % (0.06 %)"));
  EXPECT_THAT(html, testing::HasSubstr("It assumes that tails are light"));
}

TEST_F(Report, ShowsEachLimitOverTheWidthsAndNamesTheNearest) {
  const StudyData study = make_synthetic_study();
  const auto report = make_report(study);
  const auto& width = report["tolerance"]["width_curves"][0];
  ASSERT_EQ(width["key"], "cage.pocket_width_mm");
  const auto& stress = width["limits"][0];
  ASSERT_EQ(stress["quantity"], "cage_stress_peak_MPa");
  EXPECT_EQ(stress["max"], 100);
  // By the formula wider tolerances stress more; each band is that of the runs at its width.
  for (std::size_t level = 1; level < width["tolerance_widths_mm"].size(); ++level)
    EXPECT_GT(stress["bands"][level]["high"], stress["bands"][level - 1]["high"]);
  const double widest = width["tolerance_widths_mm"].back();
  std::vector<double> values;
  for (std::size_t i = 0; i < study.size(); ++i)
    if (study.status[i] == RunStatus::ok && study.replicate[i] == 0 && study.candidate[i] >= 0 &&
        study.plan.candidates[static_cast<std::size_t>(study.candidate[i])]
                .tolerance_widths_mm[0] == widest)
      values.push_back(find_quantity(study, "cage_stress_peak_MPa")->values[i]);
  std::sort(values.begin(), values.end());
  EXPECT_EQ(stress["bands"].back()["runs"], values.size());
  EXPECT_NEAR(stress["bands"].back()["median"], values[values.size() / 2], 1);
  std::string grounds;
  for (const std::string ground : report["verdict"]["grounds"]) grounds += ground;
  double least = HUGE_VAL;
  std::string nearest;
  for (const auto& entry : report["capability"])
    if (entry["cpk"]["value"] < least) least = entry["cpk"]["value"], nearest = entry["quantity"];
  EXPECT_THAT(grounds, testing::HasSubstr(
                           "Nearest limit, in standard deviations of the runs: " + nearest + ","));
}

TEST_F(Report, CountsMissesByLots) {
  EXPECT_TRUE(make_report(make_synthetic_study({.rows = 200}))["outcomes"]["lots"].is_null());
  StudyData study = make_synthetic_study({.rows = 400, .cages_per_lot = 20, .failed_share = 0});
  Column& stress = *std::find_if(study.quantities.begin(), study.quantities.end(),
                                 [](Column& c) { return c.name == "cage_stress_peak_MPa"; });
  Column& whirl = *std::find_if(study.quantities.begin(), study.quantities.end(),
                                [](Column& c) { return c.name == "whirl_radius_ratio_p95"; });
  for (std::size_t i = 0; i < study.size(); ++i) {
    study.status[i] = RunStatus::ok;
    whirl.values[i] = 0.9;
    // In lot 3 every cage misses, in lot 5 the first five of twenty.
    const bool missed = study.lot[i] == 3 || (study.lot[i] == 5 && study.row[i] % 20 < 5);
    stress.values[i] = missed ? 150 : 60;
  }
  const auto lots = make_report(study)["outcomes"]["lots"];
  EXPECT_EQ(lots["lots"], 20);
  EXPECT_EQ(lots["misses"], 25);
  EXPECT_EQ(lots["with_misses"], 2);
  EXPECT_EQ(lots["median_yield"], 1);
  EXPECT_EQ(lots["worst_yield"], 0);
  EXPECT_EQ(lots["yield_of_the_worst_twentieth"], 0.75);
}

TEST_F(Report, SameStudySameBytes) {
  report_on(make_synthetic_study({.rows = 400}), kNoPython);
  const std::string first = page_text(directory_ / "report.json"),
                    page = page_text(directory_ / "report.html");
  report_on(make_synthetic_study({.rows = 400}), kNoPython);
  EXPECT_EQ(first, page_text(directory_ / "report.json"));
  EXPECT_EQ(page, page_text(directory_ / "report.html"));
}

TEST_F(Report, VerdictHasItsKeys) {
  report_on(make_synthetic_study(), {.python = "/nonexistent/python3", .json_to_stdout = true});
  const auto verdict = nlohmann::json::parse(printed_).at("verdict");
  EXPECT_EQ(verdict.at("tolerances").at("cage.pocket_width_mm").at("grade"), "IT11");
  EXPECT_DOUBLE_EQ(verdict.at("tolerances").at("cage.pocket_width_mm").at("tolerance_width_mm"),
                   0.09);
  EXPECT_TRUE(verdict.at("tolerances")
                  .at("cage.pocket_length_mm")
                  .at("grade")
                  .is_null());  // length changes nothing: never recommended
  EXPECT_EQ(verdict.at("not_binding"), nlohmann::json({"cage.pocket_length_mm"}));
  EXPECT_TRUE(verdict.at("confirmation").is_null());
  EXPECT_GE(verdict.at("yield_lower_bound"), 0.95);
  EXPECT_DOUBLE_EQ(verdict.at("confidence"), 0.95);
  EXPECT_THAT(verdict.at("statement").get<std::string>(), testing::HasSubstr("Unconfirmed"));
}

TEST_F(Report, SaysWhatToInstallWherePythonFails) {
  const auto complaint = [&](const ReportOptions& options) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(report_on(make_synthetic_study({.rows = 200}), options), 0);
    EXPECT_TRUE(std::filesystem::exists(directory_ / "report.json"));
    EXPECT_TRUE(std::filesystem::exists(directory_ / "yield.csv"));
    return testing::internal::GetCapturedStderr();
  };
  std::ofstream(directory_ / "report.html") << "of an earlier report";
  EXPECT_THAT(complaint(kNoPython),
              testing::AllOf(testing::HasSubstr("report.html is not written"),
                             testing::HasSubstr("/nonexistent/python3"),
                             testing::HasSubstr("python3-jinja2"),
                             testing::HasSubstr("report.json and the CSV tables are complete")));
  EXPECT_FALSE(std::filesystem::exists(directory_ / "report.html"));
  EXPECT_THAT(complaint({.python = "/bin/false"}), testing::HasSubstr("ended with code 1"));
  // Where figures alone cannot be drawn, the page says so and is complete otherwise.
  const auto lacking = directory_ / "lacking";
  std::filesystem::create_directories(lacking);
  std::ofstream(lacking / "draw.py") << "def main(report, output):\n    import no_such_module\n";
  std::filesystem::copy(ReportOptions{}.figures_dir / "common.py", lacking);
  EXPECT_THAT(complaint({.figures_dir = lacking}),
              testing::AllOf(testing::HasSubstr("no_such_module"),
                             testing::HasSubstr("python3-matplotlib")));
  EXPECT_THAT(page_text(directory_ / "report.html"),
              testing::AllOf(testing::HasSubstr("figures are missing: No module named"),
                             testing::HasSubstr("Where this comes from")));
}

TEST_F(Report, PythonRunsIsolated) {
  // A module of the same name on PYTHONPATH must not take the place of Python's own, and the
  // figures still find the modules beside them.
  const auto scripts = directory_ / "scripts", foreign = directory_ / "foreign",
             drawn = directory_ / "drawn";
  for (const auto& folder : {scripts, foreign, drawn}) std::filesystem::create_directories(folder);
  std::ofstream(foreign / "json.py") << "raise SystemExit('foreign code ran')\n";
  std::ofstream(scripts / "beside.py") << "TEXT = '<svg/>'\n";
  std::ofstream(scripts / "draw.py")
      << "import json, pathlib, sys\n"
         "sys.path.insert(0, str(pathlib.Path(__file__).parent))\n"
         "import beside\n"
         "assert sys.flags.isolated\n"
         "pathlib.Path(sys.argv[2], 'a.svg').write_text(beside.TEXT)\n";
  ASSERT_EQ(setenv("PYTHONPATH", foreign.c_str(), 1), 0);
  const PythonRun run =
      run_python(ReportOptions{}.python, scripts / "draw.py",
                 {(directory_ / "report.json").string(), drawn.string()}, drawn / "draw.log");
  unsetenv("PYTHONPATH");
  EXPECT_EQ(run.problem, "");
  EXPECT_EQ(file_text(drawn / "a.svg"), "<svg/>");
}

TEST_F(Report, TextsOfAStudyAreNoMarkup) {
  const std::string markup = "<script>alert('x')</script>\" onload=\"alert(1)";
  StudyData study = make_synthetic_study({.rows = 200});
  study.provenance.study_name += markup;
  study.provenance.tool_version += markup;
  study.provenance.tool_commit += markup;
  study.provenance.build += markup;
  study.provenance.study_hash += markup;
  study.provenance.files.push_back(markup);
  for (Limit& limit : study.plan.limits) limit.source += markup;
  for (Column& column : study.quantities) column.unit += markup, column.description += markup;
  for (InputColumns& input : study.inputs) input.unit += markup;
  for (std::string& reason : study.reason) reason += markup;
  study.plan.whole["scene"]["name"] = markup;
  study.plan.whole["scene"]["cage"][markup] = markup;
  const std::string html = page_of(make_report(study));
  EXPECT_THAT(html, testing::HasSubstr("&lt;script&gt;alert(&#39;x&#39;)"));
  EXPECT_THAT(html, testing::Not(testing::HasSubstr("<script")));
  EXPECT_THAT(html, testing::Not(testing::HasSubstr("\" onload=")));
}

TEST_F(Report, ContributorsAreFound) {
  const StudyData study = make_synthetic_study();
  const auto report = make_report(study);
  for (const auto& output : report.at("contributors").at("outputs")) {
    std::string best;
    double largest = 0;
    for (const auto& share : output.at("shares"))
      if (share.at("value").is_number() && share.at("value") > largest)
        largest = share.at("value"), best = share.at("feature");
    const auto& rest = output.at("not_explained");
    if (output.at("output") == "whirl_radius_ratio_p95") {
      EXPECT_EQ(best, "pocket width: from cage to cage");
      // Noise of 0.02 beside 0.006 times the lot's deviation.
      for (const auto& quantity : report.at("quantities"))
        if (quantity.at("quantity") == output.at("output")) {
          const double sigma = quantity.at("statistics").at("standard_deviation").at("value");
          EXPECT_NEAR(rest.at("value"), std::pow(0.02 / sigma, 2), 0.02);
          EXPECT_LT(rest.at("lower"), std::pow(0.02 / sigma, 2));
          EXPECT_GT(rest.at("upper"), std::pow(0.02 / sigma, 2));
        }
    } else if (output.at("output") == "cage_slip_ratio") {
      EXPECT_EQ(best, "pocket squareness: within-cage scatter");
    }
  }
  EXPECT_EQ(report.at("contributors").at("variance_of"),
            "one run of each of 1000 cages, their tolerances drawn from all candidates");
  const auto pockets = report.at("contributors").at("pockets");
  ASSERT_EQ(pockets.size(),
            1u);  // pocket 4 drives the pocket force, and no other pocket stands out anywhere
  EXPECT_EQ(pockets[0].at("output"), "pocket_force_peak_N");
  const auto shares = pockets[0].at("shares").get<std::vector<double>>();
  EXPECT_EQ(std::max_element(shares.begin(), shares.end()) - shares.begin(), 4);
}

TEST_F(Report, FewRunsShowNoSharesAndNoEmptyFigure) {
  const auto drives = "What drives the limited quantities is told from 30 runs on";
  const auto report = make_report(make_synthetic_study({.rows = 29, .replicate_share = 0}));
  EXPECT_TRUE(report.at("contributors").at("features").empty());
  const std::string html = page_of(report);
  EXPECT_THAT(html, testing::HasSubstr(drives));
  EXPECT_THAT(html, testing::Not(testing::HasSubstr("over the width of a tolerance")));
  EXPECT_THAT(html, testing::Not(testing::HasSubstr("same estimated yield")));
  const auto more = make_report(make_synthetic_study({.rows = 30, .replicate_share = 0}));
  EXPECT_FALSE(more.at("contributors").at("features").empty());
}

TEST_F(Report, StudiesThatLackThings) {
  StudyData bare = make_synthetic_study({.rows = 60, .replicate_share = 0, .candidates = false});
  EXPECT_EQ(report_on(bare, kNoPython), 0);
  bare.plan.whole["limit"] = nlohmann::json::array();
  bare.inputs.clear();
  bare.plan.whole["inputs"] = nlohmann::json::array();
  EXPECT_EQ(report_on(bare, kNoPython), 0);
  EXPECT_THAT(printed_, testing::HasSubstr("no limits"));
  EXPECT_EQ(report_on(make_synthetic_study({.rows = 1, .replicate_share = 0}), kNoPython), 0);
  StudyData all_failed = make_synthetic_study({.rows = 50, .failed_share = 1.0});
  EXPECT_EQ(report_on(all_failed, kNoPython), 0);
  const auto joint = make_report(all_failed).at("limits").at("joint");
  EXPECT_EQ(joint.at("if_unknown_fail"), 0);
  StudyData empty = select_samples(make_synthetic_study({.rows = 10}), {});
  EXPECT_EQ(report_on(empty, kNoPython), 0);
  EXPECT_EQ(report_on(make_synthetic_study({.rows = 200, .cages_per_lot = 4}), kNoPython), 0);
  EXPECT_EQ(report_on(make_synthetic_study({.rows = 200, .design = "grid"}), kNoPython), 0);
}

TEST(ReportVerdict, SaysWhereRunsWithoutAJudgementLeaveItOpen) {
  const auto verdict =
      make_report(make_synthetic_study({.rows = 1500, .failed_share = 1.0})).at("verdict");
  EXPECT_THAT(
      verdict.at("statement"),
      testing::HasSubstr("Not known whether a candidate tolerance meets the target: 1492 of "
                         "1500 runs give no judgement, and the yield lies between 0 % and "
                         "100.0 %, as they fail or pass"));
  EXPECT_TRUE(verdict.at("not_binding").empty());
}

TEST_F(Report, NoYieldFromAGrid) {
  EXPECT_EQ(report_on(make_synthetic_study({.rows = 800, .design = "grid"}), kNoPython), 0);
  EXPECT_THAT(printed_,
              testing::HasSubstr("No yield and no tolerance: the rows of a `grid` design"));
  const auto report = nlohmann::json::parse(page_text(directory_ / "report.json"));
  EXPECT_FALSE(report.at("verdict").at("meets_target"));
  EXPECT_TRUE(report.at("verdict").at("yield_lower_bound").is_null());
  EXPECT_TRUE(report.at("limits").at("joint").at("if_unknown_fail").is_null());
  EXPECT_TRUE(report.at("tolerance").is_null());
  EXPECT_TRUE(report.at("capability").empty());
  EXPECT_THAT(page_text(directory_ / "report.html"),
              testing::Not(testing::ContainsRegex(">-?nan")));
}

TEST(ReportVerdict, DimensionsOfDifferentPartsKeepTheirNames) {
  StandinDimension cage = kPrintedWidth, roller = kPrintedLength;
  cage.key = "cage.pocket_length_mm";
  roller.key = "roller.length_mm";
  const auto report = make_report(tolerance_standin(2000, 23, {cage, roller}, 0.95, widest_pocket));
  const auto& verdict = report.at("verdict");
  EXPECT_EQ(verdict.at("tolerances").at("cage.pocket_length_mm").at("grade"), "IT11");
  EXPECT_TRUE(verdict.at("tolerances").at("roller.length_mm").at("grade").is_null());
  EXPECT_THAT(verdict.at("statement"),
              testing::HasSubstr("pocket length 9 ±0.045 mm (IT11, js11)"));
  EXPECT_THAT(verdict.at("statement"),
              testing::HasSubstr("roller length 9 ±0.045 mm (IT11, js11)"));
}

TEST(ReportConvergence, OneRunIsNotEnoughWhateverItsYield) {
  for (const double badness : {-1.0, 1.0}) {
    const auto report = make_report(tolerance_standin(1, 23, {kPrintedWidth, kPrintedLength}, 0.95,
                                                      [&](const StandinCage&) { return badness; }));
    const auto& row = report.at("convergence").at("rows").at(0);
    ASSERT_EQ(row.at("quantity"), "joint yield");
    EXPECT_NEAR(row.at("half_width").get<double>(), 0.95, 1e-9);
    EXPECT_GT(row.at("runs_still_needed").get<double>(), 1000);
  }
}

TEST_F(Report, TablesHaveALineForEveryRow) {
  report_on(make_synthetic_study({.rows = 100}), kNoPython);
  const auto lines = [&](const char* name) {
    const std::string text = page_text(directory_ / name);
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(lines("samples.csv"), 1 + 115);
  EXPECT_EQ(lines("quantities.csv"), 1 + 5);
  EXPECT_EQ(lines("yield.csv"), 1 + 2 + 1 + 6 + 8);
}

TEST_F(Report, TimesMoveNothing) {
  StudyData study = make_synthetic_study({.rows = 40});
  const auto written = [&](const char* name) {
    report_on(study, kNoPython);
    return page_text(directory_ / name);
  };
  const std::string report = written("report.json"), samples = written("samples.csv");
  for (double& seconds : study.timing.at(0).values) seconds *= 1.7;
  EXPECT_EQ(written("report.json"), report);
  EXPECT_EQ(written("samples.csv"), samples);
}

TEST_F(Report, ShowsRareFailuresThatItsOwnLimitsJudged) {
  const StudyData study = make_synthetic_study({.rows = 40});
  write_synthetic_study(study, directory_ / "study.h5");
  nlohmann::ordered_json rare = {
      {"judgement", judgement_of(read_study_data(directory_ / "study.h5").plan)},
      {"runs", 1000},
      {"lost", 0},
      {"target", 63e-6},
      {"relative_error", 0.3},
      {"counting_runs", 47550},
      {"counting_hours", 2.5},
      {"measuring_runs", 176356},
      {"dimensions", nlohmann::ordered_json::array()}};
  rare["rows"].push_back({{"name", "stress, at most 100"},
                          {"quantity", "stress"},
                          {"lower", 0},
                          {"upper", 21e-6},
                          {"exact_upper", 0.002991},
                          {"if_normal", 1e-9},
                          {"how", "extrapolated"}});
  std::filesystem::create_directory(directory_ / "rare");
  const auto page = [&] {
    std::ofstream(directory_ / "rare" / "rare.json") << rare.dump();
    report_on(study, kNoFigures);
    return page_text(directory_ / "report.html");
  };
  EXPECT_THAT(page(), testing::HasSubstr("<td class=\"n\">21</td><td class=\"n\">2991</td>"));
  EXPECT_THAT(page(), testing::HasSubstr("47550 fresh runs"));
  rare["judgement"]["confidence"] = 0.9;
  EXPECT_THAT(page(), testing::Not(testing::HasSubstr("47550 fresh runs")));
}

TEST_F(Report, DirectoryWithoutStudyIsNamed) {
  EXPECT_THROW(run_report(directory_), StudyFileError);
}

// Counted by hand: "a" is 1, 2, ..., 100 in the runs, "b" 100 less that.
TEST(LimitCurves, CountTheRunsWithin) {
  StudyData runs = plain_study(100);
  Column a{"a", "N", "counts", {}}, b{"b", "N", "counts down", {}};
  for (int i = 1; i <= 100; ++i) {
    a.values.push_back(i);
    b.values.push_back(100 - i);
  }
  runs.quantities = {a, b};
  runs.plan.limits = {{.quantity = "a", .minimum = 3, .maximum = 42.5},
                      {.quantity = "b", .maximum = 89.5}};
  const Json curves = limit_curves_json(runs);
  ASSERT_EQ(curves.size(), 3u);
  const std::vector<std::string> sides = {"min", "max", "max"};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(curves[c]["side"], sides[c]);
    const std::vector<double> values = curves[c]["values"];
    EXPECT_EQ(std::count(values.begin(), values.end(), curves[c]["bound"].get<double>()), 1);
    EXPECT_GE(values.size(), 20u);
    for (std::size_t v = 0; v < values.size(); ++v) {
      double within = 0;
      for (int i = 1; i <= 100; ++i)
        within += i >= (c == 0 ? values[v] : 3) && i <= (c == 1 ? values[v] : 42.5) &&
                  100 - i <= (c == 2 ? values[v] : 89.5);
      EXPECT_DOUBLE_EQ(curves[c]["candidates"][0]["if_unknown_fail"][v], within / 100) << values[v];
    }
  }
}

// Weights of the mixture stay as drawn: at the study's own bound a candidate has its own yield.
TEST(LimitCurves, MeetTheYieldOfACandidateAtTheBound) {
  const StudyData study = make_synthetic_study({.rows = 600, .replicate_share = 0});
  const Json report = make_report(study), curves = limit_curves_json(study);
  ASSERT_EQ(curves.size(), 3u);
  for (const Json& curve : curves) {
    const std::vector<double> values = curve["values"];
    const auto at = std::find(values.begin(), values.end(), curve["bound"].get<double>());
    ASSERT_NE(at, values.end());
    const auto& candidates = report["tolerance"]["candidates"];
    ASSERT_EQ(curve["candidates"].size(), candidates.size());
    for (std::size_t k = 0; k < candidates.size(); ++k)
      EXPECT_EQ(curve["candidates"][k]["if_unknown_fail"][at - values.begin()],
                candidates[k]["yield"]["if_unknown_fail"]);
  }
}

}  // namespace
}  // namespace cagetol
