// The verdict under alternatives of assumptions.
#include <fmt/format.h>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

/// As input files have it.
std::string plain(const Json& value) {
  return fmt::format("{}", value.get<double>());
}

std::string key_with_value(const Json& alternative) {
  return code(alternative["key"].get<std::string>()) + " = " + plain(alternative["value"]);
}

std::string points(const Json& change) {
  return fmt::format("{:+.1f}<br><small>{:+.1f} to {:+.1f}</small>",
                     100 * change["value"].get<double>(), 100 * change["lower"].get<double>(),
                     100 * change["upper"].get<double>()) +
         (change["named"].get<bool>() ? " <b>*</b>" : "");
}

std::string verdict_table(const Json& verdicts) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& each : verdicts["alternatives"]) {
    const std::string verdict = each["verdict"];
    rows.push_back(
        {key_with_value(each), each["nominal"].is_null() ? "auto" : plain(each["nominal"]),
         rounded(each["meeting_runs"]) + " of " + rounded(each["runs"]),
         percent(each["lower_bound"]) + " to " + percent(each["upper_bound"]),
         points(each["yield_change"]), verdict == "holds" ? verdict : "<b>" + verdict + "</b>",
         rounded(each["runs_needed"])});
  }
  return table("tnnnntn",
               {"alternative", "in the study", "meet all limits", "yield, bounds",
                "change of the yield [points]", "target", "runs that would settle it"},
               rows);
}

/// Rows of alternatives, columns of limited quantities.
std::string quantity_table_of(const Json& alternatives) {
  const Json& first = alternatives.front()["quantities"];
  if (first.empty()) return {};
  std::vector<std::string> headers = {"mean change by"};
  std::vector<std::string> tolerance = {"<b>the tolerance</b>"};
  for (const Json& quantity : first) {
    const std::string unit = quantity["unit"];
    headers.push_back(escaped(readable(quantity["quantity"])) +
                      (unit.empty() || unit == "-" ? "" : " [" + escaped(unit) + "]"));
    const Json& change = quantity["change_by_tolerance"];
    tolerance.push_back(change.is_null() ? "-" : with_interval(change));
  }
  std::vector<std::vector<std::string>> rows = {tolerance};
  for (const Json& each : alternatives) {
    std::vector<std::string> row = {key_with_value(each)};
    for (const Json& quantity : each["quantities"])
      row.push_back(with_interval(quantity["change"]));
    rows.push_back(std::move(row));
  }
  return "<h3>Limited quantities under each alternative</h3>\n" +
         table("t" + std::string(first.size(), 'n'), headers, rows) +
         note(
             "Mean difference to the confirming runs of the same cages and starts, with its "
             "interval. By the tolerance: from the narrowest candidate to the tolerance of the "
             "verdict, from the mixture.");
}

}  // namespace

std::string assumption_verdicts_chapter(const Json& report) {
  const Json& verdicts = report["assumption_verdicts"];
  if (!verdicts.is_object()) return {};
  std::string body = paragraph(escaped(verdicts["statement"]));
  if (verdicts["alternatives"].empty())
    return chapter("assumed", "What nobody knows", body + paragraph(escaped(verdicts["text"])));
  body += verdict_table(verdicts);
  body += note(fmt::format(
      "Each row changes one assumed value to an end of its range, with the cages and starts of {}. "
      "Every alternative is a state of knowledge with a yield of its own; no yield mixes them. "
      "<b>holds</b>: the exact lower bound at {:.6g} % confidence reaches the target of {:.6g} %; "
      "<b>fails</b>: the upper bound at {:.6g} %, its error shared by the alternatives, lies below "
      "it. <b>*</b>: the change of the yield is not zero (McNemar's exact test; false alarms at "
      "most 5 % over all alternatives). Runs that would settle it: if the yield is as estimated, "
      "with 90 % probability; give them as <code>recommend.assumption_samples</code>.",
      escaped(verdicts["attempt"]), 100 * verdicts["lower_confidence"].get<double>(),
      100 * report["verdict"]["target_yield"].get<double>(),
      100 * verdicts["upper_confidence"].get<double>()));
  return chapter("assumed", "What nobody knows",
                 body + quantity_table_of(verdicts["alternatives"]));
}

}  // namespace cagetol
