// The trend page: claims of a source beside what the runs show.
#include <fmt/format.h>

#include <cmath>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

std::string signed_level(const Json& level) {
  const double value = level.get<double>();
  return fmt::format("{}{:g}", value > 0 ? "+" : "", value);
}

std::string expectation(const Json& row) {
  const std::string expected = row["expected"];
  const double share = row["by_share"], value = row["by_value"];
  if (expected == "unclear") return "contradicts itself";
  const bool level = expected == "level";
  const std::string within = level ? ", within " : ", by at least ";
  std::string text = level ? "stays level" : expected;
  if (share > 0) text += within + fmt::format("{:g} %", 100 * share);
  if (value > 0) text += within + fmt::format("{:g}{}", value, unit_suffix(row["unit"]));
  return text;
}

std::string relative_text(const Json& difference) {
  const Json& value = difference.at("value");
  return value.is_number() ? fmt::format("{:+.3g} %", 100 * value.get<double>()) : "-";
}

std::string colour(const std::string& verdict) {
  if (verdict == "agrees") return "<b style=\"color:var(--good)\">agrees</b>";
  if (verdict == "disagrees") return "<b style=\"color:var(--bad)\">disagrees</b>";
  return escaped(verdict);
}

std::string counts_text(const Json& verdicts) {
  std::string text;
  for (const auto& [verdict, count] : verdicts.items())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", escaped(verdict), rounded(count));
  return text;
}

}  // namespace

std::string trends_chapter(const Json& report) {
  const Json& trends = report["trends"];
  if (trends.is_null()) return {};
  const double confidence = 100 * trends["confidence"].get<double>();
  std::string body = paragraph("Verdicts: " + counts_text(trends["verdicts"]) + ".");
  const std::size_t settings = trends["rows"].front()["settings"].size();
  for (std::size_t s = 0; s < settings; ++s) {
    std::vector<std::vector<std::string>> rows;
    for (const Json& row : trends["rows"]) {
      const Json& seen = row["settings"][s];
      rows.push_back(
          {escaped(row["claim"]) + "<br><small>" + escaped(row["source"]) + "</small>",
           escaped(readable(row["quantity"])) + unit_suffix(row["unit"]),
           signed_level(row["from"]) + " to " + signed_level(row["to"]) +
               unit_suffix(row["key_unit"]),
           expectation(row), rounded(seen["from_mean"]), rounded(seen["to_mean"]),
           with_interval(seen["difference"]), relative_text(seen["relative_difference"]),
           colour(seen["verdict"]) + "<br><small>" + escaped(seen["reason"]) + "</small>"});
    }
    if (const std::string setting = trends["rows"].front()["settings"][s]["setting"];
        !setting.empty())
      body += "<h3>With " + escaped(setting) + "</h3>\n";
    body += table("tttnnnnnt",
                  {"claim", "quantity", "from, to", "expected", "mean before", "mean after",
                   "difference", "", "here"},
                  rows);
  }
  body += note(fmt::format(
      "Statistic: the k-th runs of both levels start alike; difference is the mean of their "
      "differences, small print its {:g} % interval by Student's t. A verdict needs the whole "
      "interval on one side; each interval holds by itself, so that of every twenty verdicts on "
      "noise alone one may be wrong. \"Contradicts itself\": no agreement can be claimed, ours is "
      "reported. Runs without a value are left out with their partner.",
      confidence));
  return chapter("trends", "What the source claims, and what these runs show", body);
}

}  // namespace cagetol
