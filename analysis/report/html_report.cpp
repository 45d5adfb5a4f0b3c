#include "analysis/report/html_report.hpp"

#include <fmt/format.h>

#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

constexpr const char* kStyle = R"css(
:root { --ink: #1b1f24; --soft: #5a6470; --line: #d5dae0; --good: #00694c; --bad: #a13c00; }
* { box-sizing: border-box; }
body { font: 15px/1.45 "DejaVu Sans", "Segoe UI", Arial, sans-serif; color: var(--ink); margin: 0 auto; padding: 24px;
       max-width: 900px; }
h1 { font-size: 24px; margin: 0 0 4px; }
h2 { font-size: 19px; margin: 34px 0 8px; padding-bottom: 3px; border-bottom: 2px solid var(--line); }
h3 { font-size: 15px; margin: 18px 0 4px; }
p { margin: 6px 0; }
.note, figcaption { color: var(--soft); font-size: 13px; }
.verdict { border: 2px solid var(--line); border-left-width: 8px; padding: 10px 16px; margin: 12px 0; }
.verdict.yes { border-left-color: var(--good); }
.verdict.no { border-left-color: var(--bad); }
.verdict .say { font-size: 17px; }
.big { display: flex; flex-wrap: wrap; gap: 10px 34px; margin: 8px 0; }
.big div { min-width: 120px; }
.big b { display: block; font-size: 21px; }
.big span { color: var(--soft); font-size: 12.5px; }
.warning { border-left: 5px solid var(--bad); padding: 4px 12px; background: #fbf3ee; margin: 8px 0; }
table { border-collapse: collapse; width: 100%; margin: 8px 0; font-size: 13px; }
th, td { padding: 3px 7px; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; overflow-wrap: anywhere; }
th { border-bottom: 2px solid var(--line); font-weight: 600; overflow-wrap: normal; }
.n { text-align: right; font-variant-numeric: tabular-nums; overflow-wrap: normal; }
td.n { white-space: nowrap; }
small { color: var(--soft); font-size: 88%; }
code { font: 12px "DejaVu Sans Mono", Consolas, monospace; overflow-wrap: anywhere; }
figure { margin: 14px 0; }
figure img { width: 100%; height: auto; display: block; }
nav { font-size: 13px; color: var(--soft); }
nav a { color: var(--soft); margin-right: 12px; }
.columns { columns: 2; column-gap: 28px; font-size: 12px; }
.columns div { break-inside: avoid; display: flex; justify-content: space-between; gap: 8px; border-bottom: 1px dotted var(--line); }
@page { size: A4; margin: 15mm 14mm; }
@media print {
  body { max-width: none; padding: 0; font-size: 9.5pt; }
  nav { display: none; }
  h1 { font-size: 17pt; } h2 { font-size: 13pt; margin-top: 18pt; } h3 { font-size: 10.5pt; }
  h2, h3 { break-after: avoid; }
  .verdict .say { font-size: 11.5pt; } .big b { font-size: 14pt; } .big span { font-size: 8pt; }
  table { font-size: 8pt; } th, td { padding: 2px 4px; }
  thead { display: table-header-group; } tr, figure, .verdict { break-inside: avoid; }
  .note, figcaption { font-size: 8.5pt; } code { font-size: 7.5pt; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

std::string heading(const Json& report) {
  const Json& from = report["provenance"];
  const Json& outcomes = report["outcomes"];
  return fmt::format(
      "<header><h1>Tolerance report: {}</h1>\n<p class=\"note\">{} runs of {} planned, {} of them "
      "repeats with fresh noise; design "
      "<code>{}</code>; study <code>{}</code>, seed {}; cagetol {} ({})</p></header>\n"
      "<nav>{}{}<a href=\"#limits\">Limits</a><a href=\"#tolerance\">Yield and tolerance</a><a "
      "href=\"#contributors\">Contributors</a>"
      "<a href=\"#quantities\">Quantities</a><a href=\"#errors\">Error budget</a><a "
      "href=\"#failures\">Failures</a><a "
      "href=\"#convergence\">Convergence</a>"
      "<a href=\"#health\">Run health</a><a href=\"#provenance\">Where this comes from</a></nav>\n",
      escaped(from["study_name"]), rounded(outcomes["samples"]),
      rounded(outcomes["samples_planned"]), rounded(outcomes["noise_repeats"]),
      escaped(from["design"]), escaped(from["study_hash"]), from["seed"].dump(),
      escaped(from["tool_version"]), escaped(from["tool_commit"]),
      report["trends"].is_null() ? "" : "<a href=\"#trends\">Claimed trends</a>",
      report["cage"].is_null() ? "" : "<a href=\"#cage\">Flexible cage</a>");
}

}  // namespace

std::string html_report(const Json& report, const FigureSet& figures) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Tolerance "
      "report: " +
      escaped(report["provenance"]["study_name"]) + "</title>\n<style>" + kStyle +
      "</style></head><body>\n";
  page += heading(report);
  page += verdict_chapter(report);
  if (!figures.problem.empty())
    page += "<p class=\"warning\">Figures are missing or incomplete: " + escaped(figures.problem) +
            ". Install Debian's python3-matplotlib, then run <code>cagetol report DIR</code> "
            "again. The numbers are complete.</p>\n";
  page += trends_chapter(report);
  page += response_chapter(report, figures);
  page += confirmation_chapter(report);
  page += assumption_verdicts_chapter(report);
  page += limits_chapter(report);
  page += tolerance_chapter(report, figures);
  page += contributors_chapter(report, figures);
  page += quantities_chapter(report, figures);
  page += error_budget_chapter(report, figures);
  page += multifidelity_chapter(report);
  page += cage_chapter(report, figures);
  page += capability_chapter(report);
  page += failures_chapter(report);
  page += convergence_chapter(report, figures);
  page += health_chapter(report, figures);
  page += provenance_chapter(report);
  return page + "</body></html>\n";
}

}  // namespace cagetol
