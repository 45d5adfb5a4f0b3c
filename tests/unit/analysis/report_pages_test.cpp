// The pages of a report: what they say agrees with itself and with report.json, on screen and in
// print.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <regex>

#include "analysis/report/json_parts.hpp"
#include "analysis/report/report.hpp"
#include "tests/support/process.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_study.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// What a reader sees of a piece of HTML.
std::string text_of(const std::string& html) {
  return std::regex_replace(html, std::regex("<[^>]*>"), " ");
}

/// The bearing of the synthetic study, as `cagetol report` states it.
Json bearing() {
  return {{"name", "NU 205"},
          {"groups",
           {{{"title", "Load and speed"},
             {"entries",
              {{{"name", "radial load"}, {"value", 1000}, {"unit", "N"}},
               {{"name", "speed factor n dm"}, {"value", 234000.4}, {"unit", "mm/min"}},
               {{"name", "load ratio C/P"}, {"value", 28.6}, {"unit", "-"}}}}}}},
          {"model", {"Every roller moves in space."}},
          {"points", Json::array()},
          {"dimensions",
           {{{"key", "cage.pocket_width_mm"},
             {"nominal_mm", 7.65},
             {"capability", 1.31},
             {"mean_share", 0},
             {"counterpart", "the roller's diameter"},
             {"counterpart_mm", 7.62}}}},
          {"warnings", {"load.radial_N = 100 N is too light"}},
          {"strength", {{"fatigue_MPa", 165}, {"yield_MPa", 235}}},
          {"section", {{"radial_load_N", 1000}, {"inner_speed_rpm", 6000}, {"outer_speed_rpm", 0}}},
          {"drawing", nullptr}};
}

/// Fresh runs at IT11 for both dimensions, of which the first ones jam.
StudyData fresh_runs(std::size_t jammed) {
  StudyData study = make_synthetic_study({.rows = 200,
                                          .seed = 71,
                                          .replicate_share = 0,
                                          .failed_share = 0,
                                          .stress_limit = 1000,
                                          .whirl_limit = 100});
  study.plan.whole["candidates"] = {{{"tolerance_widths_mm", {0.09, 0.09}},
                                     {"grades", {"IT11", "IT11"}},
                                     {"scales", {0.9, 0.9}}}};
  study.plan.candidates.resize(1);
  study.plan.candidates[0] = {
      .tolerance_widths_mm = {0.09, 0.09}, .grades = {"IT11", "IT11"}, .scales = {0.9, 0.9}};
  std::fill(study.candidate.begin(), study.candidate.end(), 0);
  std::fill(study.status.begin(), study.status.end(), RunStatus::ok);
  for (Column& quantity : study.quantities)
    std::fill(quantity.values.begin(), quantity.values.end(), 50.0);
  for (std::size_t i = 0; i < jammed; ++i) study.status[i] = RunStatus::jammed;
  return study;
}

struct PageCase {
  const char* status;
  Json report;
};

std::vector<PageCase> cases() {
  const auto of = [](const SyntheticOptions& options) {
    return make_report(make_synthetic_study(options));
  };
  const StudyData study = make_synthetic_study();
  StudyData unlimited = make_synthetic_study({.rows = 60});
  unlimited.plan.limits.clear();
  return {{"recommended", of({})},
          {"confirmed", make_report(study, {fresh_runs(0)}, "DIR/mixture")},
          {"not_confirmed", make_report(study, {fresh_runs(30)}, "DIR/mixture")},
          {"none_meets", of({.rows = 1500, .stress_limit = 40})},
          {"open", of({.rows = 200, .failed_share = 0})},
          {"not_known", of({.rows = 1500, .failed_share = 1.0})},
          {"too_few_runs", of({.rows = 40})},
          {"no_limits", make_report(unlimited)},
          {"no_candidates", of({.rows = 60, .candidates = false})},
          {"no_yield", of({.rows = 200, .design = "grid"})},
          {"no_runs", make_report(select_samples(study, {}))}};
}

TEST(ReportPages, NoStatementOfTheFirstPageContradictsAnother) {
  for (const auto& [status, report] : cases()) {
    SCOPED_TRACE(status);
    ASSERT_EQ(report["verdict"]["status"], status);
    const std::string page = page_of(report), first = text_of(section_of(page, "verdict"));
    const bool printed = status == std::string("confirmed") || status == std::string("recommended");
    EXPECT_EQ(report["verdict"]["meets_target"].get<bool>() && !report["tolerance"].is_null(),
              printed);
    if (printed) {
      EXPECT_THAT(first, HasSubstr("What may be printed on the drawing"));
      EXPECT_THAT(first, HasSubstr("\u2265"));
      EXPECT_THAT(first, HasSubstr("full width"));
      EXPECT_THAT(first, Not(ContainsRegex("No tolerance|[Nn]o candidate|Not known")));
      EXPECT_EQ(first.find("unconfirmed") != std::string::npos,
                status == std::string("recommended"));
    } else {
      EXPECT_THAT(first, HasSubstr("No tolerance to print on the drawing yet"));
      EXPECT_THAT(first, Not(HasSubstr("\u2265")));
      EXPECT_THAT(first,
                  Not(ContainsRegex("Recommended|Confirmed|at this tolerance|, full width")));
      // What is missing, and the command that gets it.
      EXPECT_THAT(first, HasSubstr("What is missing"));
      EXPECT_FALSE(report["verdict"]["next"].empty());
      EXPECT_THAT(section_of(page, "verdict"), HasSubstr("<code class=\"command\">cagetol "));
    }
    if (status == std::string("open") || status == std::string("too_few_runs")) {
      EXPECT_THAT(text_of(page), Not(HasSubstr("Every quantity is known as well as wanted")));
    }
    EXPECT_THAT(page, Not(ContainsRegex(">-?nan|None<|Undefined")));
  }
}

TEST(ReportPages, ALateStatementDoesNotSayEnoughWhereTheFirstAsksForMore) {
  StudyData study = make_synthetic_study({.failed_share = 0});
  for (Column& quantity : study.quantities)
    for (double& value : quantity.values) value = std::isnan(value) ? value : 50;
  const auto statement = [&](const std::vector<StudyData>& attempts) {
    return text_of(section_of(page_of(make_report(study, attempts)), "convergence"));
  };
  EXPECT_THAT(statement({fresh_runs(0)}), HasSubstr("Every quantity is known as well as wanted"));
  EXPECT_THAT(statement({fresh_runs(30)}), HasSubstr("the verdict is not"));
}

TEST(ReportPages, EveryNumberIsOneOfReportJson) {
  const ScratchDirectory scratch;
  const auto problems = [&](const Json& report, const std::string& page) {
    std::ofstream(scratch / "report.json") << report;
    std::ofstream(scratch / "report.html") << page;
    Process check({"/usr/bin/python3", "-B",
                   CAGETOL_SOURCE_DIR "/tests/unit/analysis/numbers_of_pages.py",
                   scratch / "report.json", scratch / "report.html"});
    return check.wait() == 0 ? std::string() : check.output();
  };
  const StudyData study = make_synthetic_study();
  for (Json report :
       {make_report(study, {fresh_runs(30), fresh_runs(1)}, "DIR/mixture", {}, {}, {}, bearing()),
        make_report(make_synthetic_study({.rows = 300, .failed_share = 0.1}))}) {
    report["document"]["date"] = "1 May 2026";
    EXPECT_EQ(problems(report, page_of(report)), "");
  }
  // A number from elsewhere is found.
  Json report = make_report(study, {}, "DIR", {}, {}, {}, bearing());
  report["document"]["date"] = "1 May 2026";
  std::string page = page_of(report);
  const std::string known = "234000 mm/min";
  ASSERT_NE(page.find(known), std::string::npos);
  page.replace(page.find(known), 3, "279");
  EXPECT_THAT(problems(report, page), HasSubstr("279000"));
}

TEST(ReportPages, LimitedQuantitiesComeFirstAndLabelsAreNoContributors) {
  StudyData study = make_synthetic_study({.rows = 400});
  study.quantities.push_back({"cage_stress_peak_station", "-", "a label", {}});
  study.quantities.push_back({"ring_tilt_mean_mrad", "mrad", "the same in every run", {}});
  for (std::size_t i = 0; i < study.size(); ++i) {
    const double width = study.inputs[0].lot.empty() ? 0 : study.inputs[0].lot[i];
    study.quantities[study.quantities.size() - 2].values.push_back(width > 0 ? 38 : 97);
    study.quantities.back().values.push_back(0.3 * (1 + 1e-16 * static_cast<double>(i % 3)));
  }
  const Json report = make_report(study);
  const std::string page = page_of(report);
  const std::string drives = text_of(section_of(page, "contributors")),
                    statistics = text_of(section_of(page, "quantities"));
  EXPECT_THAT(drives, Not(HasSubstr("stress peak station")));
  EXPECT_THAT(drives, HasSubstr("not explained by any feature"));
  EXPECT_THAT(drives, HasSubstr("variance over one run of each of"));
  EXPECT_LT(drives.find("cage stress peak"), drives.find("cage slip ratio"));
  EXPECT_LT(statistics.find("whirl radius ratio p95"), statistics.find("cage slip ratio"));
  const std::size_t same = statistics.find("The same in every run");
  ASSERT_NE(same, std::string::npos);
  EXPECT_NE(statistics.find("ring tilt mean", same), std::string::npos);
  EXPECT_EQ(statistics.find("ring tilt mean"), statistics.find("ring tilt mean", same));
}

TEST(ReportPages, NoNoiseAboveTheWholeVariance) {
  Json report = make_report(make_synthetic_study({.rows = 200}));
  for (Json& quantity : report["quantities"])
    quantity["noise"]["share"] = {{"value", 1.42}, {"lower", 0.14}, {"upper", 5.43}};
  const std::string drives = text_of(section_of(page_of(report), "contributors"));
  EXPECT_THAT(drives, HasSubstr("all of it (above 14 %)"));
  EXPECT_THAT(drives, Not(HasSubstr("142 %")));
}

TEST(ReportPages, NoIndexWhereNothingIsAtStakeAndNoWorstSamplesThatMeet) {
  const Json report =
      make_report(make_synthetic_study({.rows = 400, .stress_limit = 1e5, .whirl_limit = 50}));
  const std::string page = page_of(report);
  const std::string capability = text_of(section_of(page, "capability")),
                    failures = text_of(section_of(page, "failures"));
  EXPECT_THAT(capability, HasSubstr("Cpk is not given because the limit lies"));
  EXPECT_THAT(failures, HasSubstr("The run nearest to each limit that none misses"));
  EXPECT_THAT(failures, Not(HasSubstr("miss a limit most")));
  EXPECT_THAT(failures, HasSubstr("cagetol replay DIR --sample"));
}

TEST(ReportPages, ABandHasItsLimitsOfSizeAndTheScatterItHoldsFor) {
  Json report = make_report(make_synthetic_study());
  ASSERT_EQ(report["verdict"]["status"], "recommended");
  const Json& widths = report["tolerance"]["tolerances"];
  ASSERT_EQ(widths[0]["tolerance_width_mm"], 0.09);
  add_limits_of_size(bearing(), report["tolerance"]);
  const Json& size = widths[0]["size"];
  EXPECT_DOUBLE_EQ(size["minimum_mm"], 7.605);
  EXPECT_DOUBLE_EQ(size["maximum_mm"], 7.695);
  EXPECT_FALSE(size["takes_counterpart"]);
  EXPECT_FALSE(widths[1].contains("size"));  // of another key
  Json shifted = report;
  Json off = bearing();
  off["dimensions"][0]["mean_share"] = -0.6;
  add_limits_of_size(off, shifted["tolerance"]);
  EXPECT_DOUBLE_EQ(shifted["tolerance"]["tolerances"][0]["size"]["mean_mm"], -0.054);
  shifted["tolerance"]["tolerances"][0]["fit"] = {{"share", 0.999},     {"offset_mm", 0.0045},
                                                  {"off_centre", 0.99}, {"lot_share", 0.5},
                                                  {"pockets_alone", 1}, {"lots_alone", 1}};
  EXPECT_THAT(text_of(section_of(page_of(shifted), "verdict")),
              AllOf(HasSubstr("its mean -54 µm beside the middle and outside of the tolerance"),
                    HasSubstr("with its mean further off by 4 µm")));
  const std::string first = text_of(section_of(page_of(report), "verdict"));
  EXPECT_THAT(first, HasSubstr("7.65 \u00b10.045 mm (IT11, js11)"));
  EXPECT_THAT(first, HasSubstr("7.605 to 7.695 mm: full width 0.090 mm"));
  EXPECT_THAT(first, HasSubstr("Pp 1.31. Print that requirement with the tolerance"));
  EXPECT_THAT(first, HasSubstr("7.605 mm, is less than the roller&#39;s diameter of 7.62 mm"));
}

TEST(ReportPages, AToleranceAboveTheNominalValueIsPrintedAsOnADrawing) {
  StandinDimension width = kPrintedWidth;
  width.scales = {0.36, 0.9, 1.5};
  width.middles = {0.018, 0.045, 0.075};
  const auto beyond_a_tenth = [](const StandinCage& cage) {
    return *std::max_element(cage.pocket[0].begin(), cage.pocket[0].end()) - 0.1;
  };
  Json report =
      make_report(tolerance_standin(2000, 23, {width, kPrintedLength}, 0.95, beyond_a_tenth));
  ASSERT_EQ(report["verdict"]["status"], "recommended");
  EXPECT_EQ(report["tolerance"]["tolerances"][0]["drawing"], "9 +0.09/+0 mm");
  EXPECT_EQ(report["tolerance"]["candidates"][0]["drawings"][0], "9 +0.036/+0 mm");
  EXPECT_EQ(report["tolerance"]["dimensions"][0]["levels"][1]["grade"], "+0.09/+0");
  EXPECT_THAT(report["verdict"]["statement"].get<std::string>(),
              HasSubstr("Recommended: pocket width 9 +0.09/+0 mm"));
  add_limits_of_size({{"dimensions",
                       {{{"key", "cage.pocket_width_mm"},
                         {"nominal_mm", 9},
                         {"capability", 1.3},
                         {"mean_share", 0},
                         {"counterpart", "the roller's diameter"},
                         {"counterpart_mm", 8.99}}}}},
                     report["tolerance"]);
  const Json& size = report["tolerance"]["tolerances"][0]["size"];
  EXPECT_NEAR(size["minimum_mm"], 9, 1e-12);
  EXPECT_NEAR(size["maximum_mm"], 9.09, 1e-12);
  EXPECT_TRUE(size["takes_counterpart"]);
  EXPECT_THAT(text_of(section_of(page_of(report), "verdict")), HasSubstr("9.000 to 9.090 mm"));
}

TEST(ReportPages, ClearanceChainsStandBesideEachOther) {
  Json report = make_report(make_synthetic_study());
  report["bearing"] = bearing();
  report["bearing"]["chains"] = {{{"name", "roller to both bars"},
                                  {"keys", {"cage.pocket_width_mm"}},
                                  {"nominal_um", 150},
                                  {"worst_um", {98, 202}},
                                  {"rss_um", {99.6, 200.4}},
                                  {"sampled_um", {121, 181}},
                                  {"cages", 20000},
                                  {"levels", {0.00135, 0.99865}}}};
  const std::string page = text_of(section_of(page_of(report), "operating"));
  EXPECT_THAT(page, HasSubstr("98 to 202"));
  EXPECT_THAT(page, HasSubstr("100 to 200"));
  EXPECT_THAT(page, HasSubstr("121 to 181"));
  EXPECT_THAT(page, HasSubstr("sampled: 0.135 to 99.865 % of 20000 drawn cages"));
}

TEST(ReportPages, ASweepThatWasStoppedAsksForTheSameCommand) {
  const StudyData study = make_synthetic_study({.rows = 1500});
  std::vector<std::size_t> there(40);
  std::iota(there.begin(), there.end(), 0u);
  const Json report = make_report(select_samples(study, there), {}, "DIR/mixture");
  const std::string first = text_of(section_of(page_of(report), "verdict"));
  EXPECT_THAT(first, HasSubstr("The runs are not finished: 40 of "));
  EXPECT_THAT(first, HasSubstr("cagetol recommend STUDY -o DIR"));
  EXPECT_THAT(first, Not(HasSubstr("OTHER_DIR --set")));
}

TEST(ReportPages, TheOperatingPointKeepsToItsPageAndTheAppendixTakesWarnings) {
  Json report = make_report(make_synthetic_study());
  report["bearing"] = bearing();
  report["bearing"]["warnings"] = Json::array();
  for (int k = 0; k < 6; ++k)
    report["bearing"]["warnings"].push_back("warning " + std::to_string(k));
  const std::string page = page_of(report);
  const std::string front = text_of(section_of(page, "operating"));
  EXPECT_THAT(front, AllOf(HasSubstr("warning 3."), Not(HasSubstr("warning 4."))));
  EXPECT_THAT(front, HasSubstr("Further warnings, 2 in all"));
  EXPECT_THAT(
      text_of(section_of(page, "model")),
      AllOf(HasSubstr("warning 4."), HasSubstr("warning 5."), Not(HasSubstr("warning 3."))));
}

TEST(ReportPages, OfAnotherVersionOfTheNumbersAreRefused) {
  Json report = {{"report_version", 2}};
  EXPECT_THAT(page_of(report), AllOf(HasSubstr("report.html is not written"),
                                     HasSubstr("has report_version 2"), HasSubstr("build both")));
}

/// The pages of a PDF as text.
std::vector<std::string> pdf_pages(const std::filesystem::path& pdf) {
  const std::filesystem::path file = pdf.string() + ".text";
  Process({"/usr/bin/pdftotext", "-layout", pdf, file}).wait();
  const std::string text = page_text(file);
  std::vector<std::string> pages;
  for (std::size_t at = 0, end; (end = text.find('\f', at)) != std::string::npos; at = end + 1)
    pages.push_back(text.substr(at, end - at));
  return pages;
}

TEST(ReportPages, ArePrintedInTwoFilesWithTitleBlockContentsAndPageNumbers) {
  if (Process({"/usr/bin/python3", "-c", "import weasyprint"}).wait() != 0)
    GTEST_SKIP() << "Debian's weasyprint is not installed";
  if (!std::filesystem::exists("/usr/bin/pdftotext"))
    GTEST_SKIP() << "pdftotext (Debian's poppler-utils) is not installed";
  const ScratchDirectory scratch;
  write_synthetic_study(make_synthetic_study({.rows = 400}), scratch / "study.h5");
  testing::internal::CaptureStdout();
  run_report(scratch.path(), {.bearing = [](const auto&) { return bearing(); },
                              .figures = false,
                              .pdf = true,
                              .document = Json{{"customer", "W\u00e4lz & <S\u00f6hne>"},
                                               {"drawing", "4711"},
                                               {"date", "2026-01-02"}}});
  EXPECT_THAT(testing::internal::GetCapturedStdout(),
              AllOf(HasSubstr("report.pdf"), HasSubstr("appendix.pdf")));
  const auto front = pdf_pages(scratch / "report.pdf"), back = pdf_pages(scratch / "appendix.pdf");
  ASSERT_GE(front.size(), 2u);
  EXPECT_LE(front.size(), 4u);
  EXPECT_THAT(front[0], AllOf(HasSubstr("What may be printed on the drawing"),
                              HasSubstr("W\u00e4lz & <S\u00f6hne>"), HasSubstr("2026-01-02"),
                              Not(HasSubstr("checked by"))));
  std::string sent;
  for (const std::string& page : front) sent += page;
  EXPECT_THAT(sent, AllOf(HasSubstr("Operating point"), HasSubstr("Limits and their sources")));
  ASSERT_GT(back.size(), 3u);
  EXPECT_THAT(back[0], AllOf(HasSubstr("Appendix to the tolerance report: synthetic"),
                             HasSubstr("4711"), ContainsRegex("Error budget *\\.+ *[0-9]+")));
  std::string all = sent;
  for (const auto* pages : {&front, &back})
    for (std::size_t k = 0; k < pages->size(); ++k) {
      EXPECT_THAT(pages->at(k), AllOf(HasSubstr("olerance report: synthetic"),
                                      HasSubstr("page " + std::to_string(k + 1) + " of " +
                                                std::to_string(pages->size()))))
          << "page " << k + 1;
      if (pages == &back) all += pages->at(k);
    }
  // Long words stand whole in their columns.
  for (const char* word : {"cage_stress_peak_MPa", "revolutions", "confirm"})
    EXPECT_THAT(all, HasSubstr(word));
}

TEST(ReportPages, NameTheDayWhereTheDocumentDoesNotAndTheNumberOfStudyAndBuild) {
  Json report = make_report(make_synthetic_study());
  EXPECT_THAT(text_of(section_of(page_of(report), "verdict")), ContainsRegex("20[0-9][0-9]-[0-9]"));
  const std::string number = report.at("document").at("number");
  EXPECT_THAT(number, testing::MatchesRegex("[^-]+-[^-]*"));
  report["document"]["date"] = "1 May";
  EXPECT_THAT(text_of(section_of(page_of(report), "verdict")),
              AllOf(HasSubstr("1 May"), HasSubstr(number)));
}

}  // namespace
}  // namespace cagetol
