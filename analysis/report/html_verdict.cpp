// First page: what may be printed on the drawing, how sure, which dimension pays; then outcomes and
// limits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

std::string fact(const std::string& big, const std::string& small) {
  return "<div><b>" + big + "</b><span>" + small + "</span></div>";
}

std::string band_facts(const Json& report) {
  std::string facts;
  if (!report["tolerance"].is_object()) return facts;
  for (const Json& band : report["tolerance"]["bands"]) {
    const std::string name = band["name"];
    const std::string grade = band["grade"];
    if (band["not_binding"].get<bool>())
      facts += fact("not binding", escaped(name) + ", within the range studied");
    else
      facts += fact(fmt::format("{:.3f} mm {}", band["band_mm"].get<double>(), escaped(grade)),
                    escaped(name) +
                        (band["centre"].is_number()
                             ? fmt::format(", nominal {:g}", band["centre"].get<double>())
                             : std::string()) +
                        ", full width" +
                        (band["widest_studied"].get<bool>() ? "; nothing wider was studied" : ""));
  }
  return facts;
}

std::string confirmation_fact(const Json& confirmation) {
  if (confirmation.is_null()) return fact("unconfirmed", "no fresh runs at this tolerance yet");
  const bool passed = confirmation["passed"];
  return fact(passed ? "confirmed" : "not confirmed",
              fmt::format("by {} of {} fresh runs at this tolerance, attempt {}",
                          rounded(confirmation["meeting_runs"]), rounded(confirmation["runs"]),
                          rounded(confirmation["attempts"])));
}

/// Which dimension pays: the change of yield for one step narrower or wider.
std::string steps_table(const Json& report) {
  if (!report["tolerance"].is_object() || report["tolerance"]["steps"].empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const Json& step : report["tolerance"]["steps"]) {
    const auto points = [&](const char* key) {
      return fmt::format("{:+.1f}", 100 * step[key].get<double>());
    };
    const bool clear = step["lower"].get<double>() > 0 || step["upper"].get<double>() < 0;
    rows.push_back({escaped(step["name"]), escaped(step["from"]) + " → " + escaped(step["to"]),
                    points("change"), points("lower") + " to " + points("upper"),
                    clear ? "yes" : "not told apart from none"});
  }
  return "<h3>Which dimension pays</h3>\n" +
         table("ttnnt", {"dimension", "from → to", "change of yield [points]", "interval", "real?"},
               rows) +
         note(
             "One step narrower or wider in one dimension, all others as in the verdict, compared "
             "on the same runs.");
}

/// Where the first jams are met, in one line.
std::string jam_line(const Json& report) {
  if (!report["tolerance"].is_object()) return {};
  std::string places;
  for (const Json& jam : report["tolerance"]["jams"])
    if (jam["limit_mm"].is_number())
      places += fmt::format("{}{} {:.2f} mm", places.empty() ? "" : ", ", escaped(jam["name"]),
                            jam["limit_mm"].get<double>());
  if (places.empty()) return {};
  return paragraph(
      "Rollers larger than their pockets: by geometry alone, jams miss the target from these bands "
      "on, whatever the other limits say: " +
      places + ".");
}

}  // namespace

std::string verdict_chapter(const Json& report) {
  const Json& verdict = report["verdict"];
  const bool meets = verdict["meets_target"];
  std::string facts = band_facts(report);
  if (verdict["yield_lower_bound"].is_number()) {
    facts += fact("≥ " + percent(verdict["yield_lower_bound"]),
                  fmt::format("yield, with {:g} % confidence (target {:g} %)",
                              100 * verdict["confidence"].get<double>(),
                              100 * verdict["target_yield"].get<double>()));
    facts +=
        fact(percent(verdict["yield"]["if_unknown_fail"]),
             fmt::format("estimated yield from {} effective runs",
                         rounded(std::round(verdict["yield"]["effective_runs"].get<double>()))));
  }
  facts += confirmation_fact(verdict["confirmation"]);
  if (const Json& tolerance = report["tolerance"];
      tolerance.is_object() && tolerance["cost"].is_number())
    facts += fact(rounded(tolerance["cost"]), "cost of these tolerances, as the study states it");
  std::string body = fmt::format(
      "<div class=\"verdict {}\"><p class=\"say\">{}</p><div class=\"big\">{}</div></div>\n",
      meets ? "yes" : "no", escaped(verdict["statement"]), facts);
  if (!verdict["undecided"].empty()) {
    std::string names;
    for (const Json& dimension : report["tolerance"]["dimensions"])
      if (std::find(verdict["undecided"].begin(), verdict["undecided"].end(), dimension["key"]) !=
          verdict["undecided"].end())
        names += (names.empty() ? "" : ", ") + escaped(dimension["name"]);
    body += paragraph(
        "No effect of these dimensions is significant, but one as large as the margin over the "
        "target is not excluded; they are treated as if they mattered: " +
        names + ".");
  }
  body += jam_line(report);
  body += steps_table(report);
  return chapter("verdict", "What may be printed on the drawing", body);
}

std::string limits_chapter(const Json& report) {
  const Json& outcomes = report["outcomes"];
  std::vector<std::vector<std::string>> rows;
  for (const Json& count : outcomes["counts"])
    if (count["samples"].get<double>() > 0)
      rows.push_back({escaped(count["status"]), rounded(count["rows"]), rounded(count["samples"])});
  std::string body = table("tnn", {"outcome", "cages (first runs)", "all runs with repeats"}, rows);
  body += note(
      "A jammed cage counts as not meeting the limits. Runs that failed or ran out of steps have "
      "no result: every yield is given "
      "twice, as if all of them failed and as if all of them passed. None is dropped.");
  if (outcomes["failed_share"].get<double>() > outcomes["allowed_failure_share"].get<double>())
    body += "<p class=\"warning\">" + percent(outcomes["failed_share"]) +
            " of the runs gave no result, more than the " +
            percent(outcomes["allowed_failure_share"]) + " that the study allows.</p>\n";
  const Json& limits = report["limits"];
  if (limits["each"].empty())
    return chapter("limits", "Outcomes", body + paragraph("The study states no limits."));
  rows.clear();
  const auto number_or_dash = [](const Json& value) {
    return value.is_number() ? rounded(value) : std::string("-");
  };
  const auto yield_cells = [](const Json& yield) -> std::vector<std::string> {
    return {percent(yield["if_unknown_fail"]), percent(yield["if_unknown_pass"]),
            percent(yield["lower_bound"]) + " to " + percent(yield["upper_bound"])};
  };
  const auto add = [&](std::vector<std::string> cells, const Json& yield) {
    for (const auto& cell : yield_cells(yield)) cells.push_back(cell);
    rows.push_back(std::move(cells));
  };
  for (const Json& limit : limits["each"])
    add({escaped(readable(limit["quantity"])),
         escaped(limit["text"]) + (limit.contains("note") ? "<br>" + escaped(limit["note"]) : ""),
         escaped(limit["source"]), rounded(limit["cage_revolutions"]),
         number_or_dash(limit["median"]), number_or_dash(limit["worst"])},
        limit["yield"]);
  add({"<b>all together</b>", "", "", "", "", ""}, limits["joint"]);
  body += "<h3>Limits and yield of the scatter as sampled</h3>\n" +
          table("tttnnnnnn",
                {"quantity", "limit", "source of the limit", "cage rev.", "median run",
                 "run nearest to the limit or beyond", "yield if runs without result fail",
                 "… pass", "bounds"},
                rows);
  body += note(fmt::format(
      "Yield: share of cages of which one run, over the cage revolutions stated, meets the limit. "
      "Bounds: each one-sided at {:g} % "
      "confidence ({}). {}",
      100 * report["verdict"]["confidence"].get<double>(), escaped(limits["joint"]["method"]),
      report["tolerance"].is_object()
          ? "These runs mix all candidate tolerances; the yield of each candidate follows below."
          : ""));
  return chapter("limits", "Outcomes and limits", body);
}

}  // namespace cagetol
