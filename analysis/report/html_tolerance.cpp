// Yield against tolerance, and contributors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

/// ", about 7.6" where the centre is in question.
std::string centre_words(const Json& dimension, const Json& candidate, std::size_t d) {
  if (!dimension["nominal"].is_number()) return {};
  return fmt::format(", about {:.6g}",
                     dimension["nominal"].get<double>() + candidate["shifts"][d].get<double>());
}

std::string candidate_table(const Json& tolerance) {
  std::vector<std::string> headers;
  std::string columns;
  for (const Json& dimension : tolerance["dimensions"]) {
    headers.push_back(escaped(dimension["name"]));
    columns += 't';
  }
  for (const char* header :
       {"yield if runs without result fail", "… pass", "lower bound", "effective runs", "jams"})
    headers.emplace_back(header);
  columns += "nnnnn";
  std::vector<std::vector<std::string>> rows;
  for (const Json& candidate : tolerance["candidates"]) {
    const Json& yield = candidate["yield"];
    const bool shown = candidate["shown"],
               chosen = candidate["candidate"] == tolerance["chosen_candidate"];
    std::vector<std::string> row;
    for (std::size_t d = 0; d < candidate["bands_mm"].size(); ++d)
      row.push_back(fmt::format("{:.3f} mm {}{}", candidate["bands_mm"][d].get<double>(),
                                escaped(candidate["grades"][d]),
                                centre_words(tolerance["dimensions"][d], candidate, d)));
    row.push_back(shown ? percent(yield["if_unknown_fail"]) : "too few runs");
    row.push_back(shown ? percent(yield["if_unknown_pass"]) : "");
    row.push_back(shown ? percent(yield["lower_bound"]) : "");
    row.push_back(rounded(std::round(yield["effective_runs"].get<double>())) +
                  (candidate["pooled"].get<bool>() ? ", by its bands" : ""));
    row.push_back(candidate["jam_share"].is_number() ? percent(candidate["jam_share"]) : "-");
    if (chosen)
      for (std::string& cell : row) cell = "<b>" + cell + "</b>";
    rows.push_back(std::move(row));
  }
  return table(columns, headers, rows);
}

std::string binding_list(const Json& tolerance) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& dimension : tolerance["dimensions"])
    rows.push_back({escaped(dimension["name"]), escaped(dimension["binding"]),
                    fmt::format("{:.1f}", 100 * dimension["largest_loss"].get<double>()),
                    fmt::format("{:.1f}", 100 * dimension["largest_loss_bound"].get<double>()),
                    fmt::format("{:.1f}", 100 * dimension["allowed_loss"].get<double>())});
  return "<h3>Does the tolerance of a dimension change the yield?</h3>\n" +
         table("ttnnn",
               {"dimension", "answer", "largest loss seen [points]", "at most [points]",
                "margin over the target [points]"},
               rows) +
         note(
             "Yield at the narrowest candidate against each wider one, on the same runs. Binding: "
             "a difference is significant. Not binding: none is, the loss is certainly smaller "
             "than the margin of the narrowest over the target, and the widest combination that "
             "meets "
             "the target has this dimension at its widest. Undecided: neither.");
}

/// "0.42 mm", or what is said instead.
std::string band_text(const Json& band_mm, const char* instead) {
  return band_mm.is_number() ? fmt::format("{:.2f} mm", band_mm.get<double>()) : instead;
}

std::string jam_section(const Json& tolerance, const FigureSet& figures) {
  if (tolerance["jams"].empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const Json& jam : tolerance["jams"])
    rows.push_back({escaped(jam["name"]), band_text(jam["free_mm"], "none"),
                    band_text(jam["limit_mm"], "beyond what was drawn")});
  return "<h3>Where cages jam</h3>\n" +
         paragraph(
             "A roller larger than its pocket jams the cage whatever the bearing does. Geometry "
             "alone tells how often, at any band, so no run is needed.") +
         figure_html(
             figures, "jam_curves",
             "Share of cages that jam over the width of one tolerance about the nominal value "
             "of the study, all others at their narrowest. Above the dashed line jams alone miss "
             "the target; the dotted line "
             "is the band of the verdict.") +
         table("tnn", {"dimension", "no cage jams up to", "jams alone miss the target from"}, rows);
}

std::string strongest(const Json& output) {
  std::vector<Json> shares(output["shares"].begin(), output["shares"].end());
  std::erase_if(shares, [](const Json& share) { return !share["value"].is_number(); });
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Json& a, const Json& b) { return a["value"] > b["value"]; });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(shares.size(), 3); ++i) {
    if (shares[i]["lower"].is_number() && shares[i]["lower"].get<double>() <= 0) break;
    text += (text.empty() ? "" : "; ") + escaped(shares[i]["feature"]) + " " +
            percent_interval(shares[i]);
  }
  return text.empty() ? "none stands out" : text;
}

std::string noise_of(const Json& report, const Json& output) {
  for (const Json& quantity : report["quantities"])
    if (quantity["quantity"] == output["output"])
      return percent_interval(quantity["noise"]["share"]);
  return "-";
}

std::string groups_table(const Json& groups) {
  const std::string refused = groups["refused"];
  if (!refused.empty()) return "<p class=\"warning\">" + escaped(refused) + "</p>\n";
  std::string html;
  for (const Json& output : groups["outputs"]) {
    std::vector<std::vector<std::string>> rows;
    const bool totals = groups["design"] == "pick-freeze";
    for (const Json& group : output["groups"]) {
      if (totals)
        rows.push_back({escaped(group["group"]), percent_interval(group["first_order"]),
                        percent_interval(group["total"])});
      else
        rows.push_back(
            {escaped(group["group"]), rounded(group["mean_magnitude"]), rounded(group["scatter"])});
    }
    html += "<h3>" + escaped(readable(output["output"])) + "</h3>\n" +
            (totals ? table("tnn", {"group", "alone", "alone and in interactions"}, rows)
                    : table("tnn", {"group", "mean effect, in magnitude", "scatter of the effect"},
                            rows));
  }
  return html;
}

}  // namespace

std::string tolerance_chapter(const Json& report, const FigureSet& figures) {
  const Json& tolerance = report["tolerance"];
  if (!tolerance.is_object()) return {};
  std::string body =
      figure_html(figures, "yield_curves",
                  "Yield over the width of each tolerance, the other dimensions taken from all "
                  "their candidates in equal parts. Below each band: ISO 286 grade and, in "
                  "brackets, the effective number of runs behind the point. A curve that falls "
                  "towards the right is a dimension that pays to narrow; a flat one does not.");
  body += figure_html(
      figures, "yield_map",
      "Both tolerances together: estimated yield, its lower bound (≥), effective runs. Purple is a "
      "bound above the target, orange one below, as where runs are few: fresh runs decide. The "
      "frame marks the combination of the verdict. "
      "Widest means: the largest product of the bands of the dimensions that matter.");
  body += candidate_table(tolerance);
  body += note(fmt::format(
      "All runs count for every candidate, each with the weight that its deviations have under "
      "that tolerance. The effective number of runs says how many equally "
      "weighted runs would tell as much; below {} a figure is not shown as a result. Runs without "
      "a result count as failing in the lower bound ({}). A candidate with too few runs of its "
      "own is estimated as the product of the yields of its bands, which claims nothing by itself.",
      rounded(tolerance["fewest_effective_runs"]), escaped(report["verdict"]["yield"]["method"])));
  if (!tolerance["note"].get<std::string>().empty())
    body += "<p class=\"warning\">" + escaped(tolerance["note"]) + "</p>\n";
  body += binding_list(tolerance);
  body += jam_section(tolerance, figures);
  body += centre_responses_section(tolerance, figures);
  body += centres_section(tolerance, figures);
  return chapter("tolerance", "Yield against tolerance", body);
}

std::string contributors_chapter(const Json& report, const FigureSet& figures) {
  const Json& contributors = report["contributors"];
  if (contributors["features"].empty() || contributors["outputs"].empty()) return {};
  std::string body = paragraph(fmt::format(
      "Share of a quantity's variance that goes when the feature of the cage is held. Features of "
      "one dimension depend on each other (a lot that is narrow has narrow smallest "
      "pockets): their shares overlap and do not add up to 100 %. Shares of quantities are among "
      "the {} of cages whose run gave a result.",
      percent(report["outcomes"]["success_share"])));
  body +=
      figure_html(figures, "pareto",
                  "The largest contributors to passing the limits, to jams, and to each limited "
                  "quantity, with intervals. A bar whose interval reaches zero may be nothing.");
  std::vector<std::vector<std::string>> rows;
  for (const Json& output : contributors["outputs"])
    rows.push_back(
        {escaped(readable(output["output"])), strongest(output), noise_of(report, output)});
  body += table(
      "ttn", {"quantity", "strongest contributors (share of variance, interval)", "noise"}, rows);
  body += note(
      "Noise: share of the variance between two runs of the same cage from another start, from the "
      "repeated rows; no tolerance can remove it.");
  body += figure_html(
      figures, "responses",
      "How each deciding quantity follows its strongest contributor: means of twelve classes with "
      "two standard errors. Look for a bend: beyond it the dimension costs.");
  body += figure_html(
      figures, "matrix",
      "Contributors by quantity: dark cells are what a quantity depends on (shares of 5 % and more "
      "are printed). An empty column is a feature that no quantity feels.");
  const std::string map =
      figure_html(figures, "pocket_map",
                  "Share of the variance explained by each single pocket, numbered around the "
                  "cage: a long bar is a pocket that matters more than its neighbours.");
  body += map.empty() ? paragraph(
                            "Single pockets: no pocket explains more of a quantity than its "
                            "neighbours do beyond chance, so no map is shown.")
                      : map;
  body += groups_table(contributors["groups"]);
  rows.clear();
  for (const Json& feature : contributors["features"])
    rows.push_back(
        {escaped(feature["name"]), escaped(feature["definition"]), escaped(feature["unit"])});
  body += "<h3>What the features mean</h3>\n" + table("ttt", {"feature", "meaning", "unit"}, rows);
  return chapter("contributors", "What drives the quantities", body);
}

}  // namespace cagetol
