// The error budget: what each mean may be off by, source by source.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

std::string small(const std::string& html) {
  return "<small>" + html + "</small>";
}

std::string below(const std::string& html) {
  return "<br>" + small(html);
}

std::string in_standard_errors(const Json& source) {
  const Json& share = source["standard_errors"];
  return share.is_number() ? below(rounded(share) + " SE") : "";
}

std::string source_text(const Json& source, bool largest) {
  const std::string state = source["state"];
  if (state == "not measured") return small("not measured");
  if (state == "runs lost") return small(fmt::format("{} of its runs lost", source["lost"].dump()));
  std::string text;
  if (source["bound"] == 0)
    text = "0";
  else if (state == "unresolved")
    text = "below &plusmn;" + rounded(source["bound"]);
  else if (source["source"] == "statistical" || source["source"] == "noise")
    text = "&plusmn;" + rounded(source["error"]["value"]);
  else
    text = (source["error"]["value"] > 0 ? "+" : "") + with_interval(source["error"]);
  text += in_standard_errors(source);
  return largest ? "<b>" + text + "</b>" : text;
}

/// The largest source of each quantity with a limit, in words.
std::string largest_list(const Json& budget) {
  std::string items;
  for (const Json& quantity : budget["quantities"]) {
    if (quantity["limited"] == false) continue;
    std::string open;
    for (const Json& name : quantity["open"])
      open += (open.empty() ? "" : ", ") + escaped(name.get<std::string>());
    items += fmt::format("<li>{}: {}{}</li>\n", escaped(readable(quantity["quantity"])),
                         quantity["largest"].is_null()
                             ? "nothing is resolved"
                             : "<b>" + escaped(quantity["largest"].get<std::string>()) + "</b>",
                         open.empty() ? "" : "; not resolved, so perhaps larger: " + open);
  }
  return items.empty()
             ? ""
             : "<p>The largest of the errors that were measured:</p>\n<ul>" + items + "</ul>\n";
}

std::string budget_table(const Json& budget, bool limited) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> headers = {"quantity, mean"};
  std::string columns = "t";
  for (const Json& quantity : budget["quantities"]) {
    if (quantity["limited"] != limited) continue;
    rows.push_back({escaped(readable(quantity["quantity"])) +
                    below(rounded(quantity["mean"]) + unit_suffix(quantity["unit"]))});
    for (const Json& source : quantity["sources"]) {
      rows.back().push_back(source_text(source, source["source"] == quantity["largest"]));
      if (rows.size() > 1) continue;
      headers.push_back(escaped(source["source"].get<std::string>()));
      columns += "n";
    }
  }
  if (rows.empty()) return {};
  return table(columns, headers, rows);
}

std::string refined_text(const Json& evidence) {
  std::string list;
  for (const Json& refined : evidence["refined"])
    list += fmt::format("{}{} - {}, {} times the time", list.empty() ? "" : "; ",
                        escaped(refined["setting"]), escaped(refined["meaning"]),
                        rounded(refined["cost_ratio"]));
  return list;
}

constexpr std::size_t kKeysShown = 3;

std::string keys_text(const Json& evidence) {
  const Json& keys = evidence["differing_keys"];
  std::string text;
  for (std::size_t k = 0; k < std::min(keys.size(), kKeysShown); ++k)
    text += (k > 0 ? ", " : "") + code(keys[k]);
  return keys.size() > kKeysShown ? text + fmt::format(" and {} more", keys.size() - kKeysShown)
                                  : text;
}

std::string evidence_text(const Json& evidence) {
  const std::string state = evidence["state"];
  if (state == "measured")
    return paragraph(fmt::format(
               "What the settings of the model are worth was measured with this study's first {} "
               "samples: as run, and again with one setting refined: {}.",
               rounded(evidence["samples"]), refined_text(evidence))) +
           (evidence["another_build"] == true
                ? "<p class=\"warning\">Another build of the program measured it than ran this "
                  "study.</p>\n"
                : "");
  const std::string directory = code(evidence["directory"]);
  const std::string why =
      state == "another study"
          ? fmt::format("What lies in {} belongs to another study, {}: other values of {}. ",
                        directory, escaped(evidence["study"]), keys_text(evidence))
      : state == "not measured" ? ""
                                : "What lies in " + directory + " refines nothing. ";
  return "<p class=\"warning\">" + why +
         "Errors of integrator, modes, slices, mesh and window are <b>not measured</b>. This "
         "measures them, then make the report again: " +
         code(evidence["command"]) + "</p>\n";
}

}  // namespace

std::string error_budget_chapter(const Json& report, const FigureSet& figures) {
  const Json& budget = report["error_budget"];
  if (budget["quantities"].empty()) return {};
  const double confidence = 100 * budget["confidence"].get<double>();
  std::string body = evidence_text(budget["evidence"]) + largest_list(budget);
  body += figure_html(
      figures, "error_budget",
      fmt::format(
          "Errors of the means in standard errors, with {:g} % intervals. Filled: resolved, with "
          "all settings of the quantity tested together; open: may be zero. Grey: what other "
          "samples would do (one standard error), "
          "dark bar: what fresh starts of the same cages would. A filled mark right of the band: "
          "the study's mean is too large, and more runs would not mend it.",
          confidence));
  const std::string decided = budget_table(budget, true), others = budget_table(budget, false);
  body += decided;
  if (!others.empty())
    body += (decided.empty() ? "" : "<h3>Quantities without limits</h3>\n") + others;
  body += note(fmt::format(
      "Errors of the mean, in the quantity's unit and in standard errors of the mean (SE); small "
      "print: {0:g} % interval. Statistical: one SE. Noise: the part of it that fresh starts of "
      "the same cages make, from the rows that ran more than once (<code>extra_replicates</code>). "
      "The others: mean as run minus mean with that one setting refined, from pairs of the same "
      "samples; positive: the study's mean is too large. \"Below\": not told from zero, with all "
      "settings of the quantity tested together (Holm); shown is the far end of the interval. "
      "Largest (bold): by that end, of the resolved ones only; the statistical error counts with "
      "the half width of its {0:g} % interval. "
      "What no refined setting reaches - laws of contact and friction, film, what a further "
      "refinement would add - is in no column, and errors of settings need not add up. A rigid "
      "cage has no mesh: its column is then part of modes. A peak grows with its window: there "
      "the column says how much, not that the limit's window is wrong.",
      confidence));
  return chapter("errors", "Error budget", body);
}

}  // namespace cagetol
