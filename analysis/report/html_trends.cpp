// The trend page: claims of a source beside what the runs show.
#include <fmt/format.h>

#include <algorithm>

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

std::string verdict_text(const std::string& verdict) {
  const std::string colour = verdict == "agrees"      ? ";font-weight:600;color:var(--good)"
                             : verdict == "disagrees" ? ";font-weight:600;color:var(--bad)"
                                                      : "";
  return "<span style=\"white-space:nowrap" + colour + "\">" + escaped(verdict) + "</span>";
}

std::string counts_text(const Json& verdicts) {
  std::string text;
  for (const auto& [verdict, count] : verdicts.items())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", escaped(verdict), rounded(count));
  return text;
}

/// In order of first appearance. Trends over different keys have different settings.
std::vector<std::string> settings_of(const Json& trends) {
  std::vector<std::string> settings;
  for (const Json& row : trends["rows"])
    for (const Json& seen : row["settings"])
      if (const std::string setting = seen["setting"];
          std::find(settings.begin(), settings.end(), setting) == settings.end())
        settings.push_back(setting);
  return settings;
}

/// "0.1 mm of clearance", or the deviation where the dimension leaves no clearance.
std::string place_text(const Json& place, const std::string& unit) {
  return place["clearance"].is_null()
             ? signed_level(place["level"]) + unit_suffix(unit)
             : fmt::format("{:g}{}", place["clearance"].get<double>(), unit_suffix(unit));
}

std::string interval_text(const Json& difference) {
  return fmt::format("{} ({} to {})", rounded(difference["value"]), rounded(difference["lower"]),
                     rounded(difference["upper"]));
}

/// "from 0.002 mm (not yet at 0.005 mm) to -0.01 mm, the last level", with the differences there.
std::string range_text(const Json& range, const std::string& unit) {
  const std::string first = place_text(range["first"], unit),
                    last = place_text(range["last"], unit);
  std::string text = first == last ? "at " + first : "from " + first + " to " + last;
  if (range["to_the_end"]) text += ", the last level";
  if (!range["before"].is_null()) text += " (not at " + place_text(range["before"], unit) + ")";
  text += "<small>";
  for (const Json& at : range["differences"])
    text += fmt::format("<br>at {} against {}: {} {}{}", first, place_text(at["against"], unit),
                        escaped(readable(at["quantity"])), interval_text(at["difference"]),
                        unit_suffix(at["unit"]));
  return text + "</small>";
}

/// Where a claim holds, setting by setting.
std::string held_text(const Json& claim) {
  const std::string unit = claim["key_unit"];
  std::string text;
  for (const Json& held : claim["held"]) {
    const std::string setting = held["setting"];
    std::string here;
    for (const Json& range : held["ranges"])
      here += (here.empty() ? "" : "<br>and ") + range_text(range, unit);
    const auto levels = held["levels"].get<std::size_t>(),
               undecided = held["undecided_levels"].get<std::size_t>();
    if (here.empty())
      here = undecided == 0 ? fmt::format("never (levels tried: {})", levels)
                            : fmt::format("nowhere for certain (levels tried: {}, undecided at {})",
                                          levels, undecided);
    text += (text.empty() ? "" : "<br>") +
            (setting.empty() ? "" : "<i>" + escaped(setting) + ":</i> ") + here;
  }
  return text.empty() ? "-" : text;
}

std::string claims_table(const Json& claims) {
  std::vector<std::vector<std::string>> rows;
  bool clearances = false;
  for (const Json& claim : claims) {
    rows.push_back({escaped(claim["claim"]) + "<br><small>" + escaped(claim["source"]) + "</small>",
                    verdict_text(claim["verdict"]),
                    fmt::format("{} of {}", rounded(claim["agreeing"]), rounded(claim["readings"])),
                    held_text(claim)});
    for (const Json& held : claim["held"])
      for (const Json& range : held["ranges"])
        clearances = clearances || !range["first"]["clearance"].is_null();
  }
  return table("ttnt",
               {"claim", "here", "readings that agree",
                clearances ? "holds, by the pocket's clearance" : "holds, by the level"},
               rows);
}

std::vector<std::string> table_row(const Json& row, const Json& seen) {
  return {
      escaped(row["claim"]) + "<br><small>" + escaped(row["source"]) + "</small>",
      escaped(readable(row["quantity"])) + unit_suffix(row["unit"]),
      signed_level(row["from"]) + " to " + signed_level(row["to"]) + unit_suffix(row["key_unit"]),
      expectation(row),
      rounded(seen["from_mean"]) + " → " + rounded(seen["to_mean"]),
      with_interval(seen["difference"]),
      relative_text(seen["relative_difference"]),
      verdict_text(seen["verdict"]) + "<br><small>" + escaped(seen["reason"]) + "</small>"};
}

}  // namespace

std::string trends_chapter(const Json& report) {
  const Json& trends = report["trends"];
  if (trends.is_null()) return {};
  const double confidence = 100 * trends["confidence"].get<double>();
  std::string body =
      paragraph("Claims: " + counts_text(trends["claim_verdicts"]) +
                ". Their readings, each in one quantity, between two levels, in one setting: " +
                counts_text(trends["verdicts"]) + ".") +
      claims_table(trends["claims"]) +
      note(fmt::format(
          "A claim counts once: it agrees where all its readings between the levels it is made for "
          "agree, in part where some do, disagrees where none agrees and one disagrees. It holds "
          "at a level where all its readings agree there; levels are tried one after another, from "
          "the nearest to the last of the grid, each with its own {:g} % intervals.",
          confidence));
  for (const std::string& setting : settings_of(trends)) {
    std::vector<std::vector<std::string>> rows;
    for (const Json& row : trends["rows"])
      for (const Json& seen : row["settings"])
        if (seen["setting"] == setting) rows.push_back(table_row(row, seen));
    if (!setting.empty()) body += "<h3>With " + escaped(setting) + "</h3>\n";
    body += table("tttttnnt",
                  {"claim", "quantity", "from, to", "expected", "means", "difference", "", "here"},
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
