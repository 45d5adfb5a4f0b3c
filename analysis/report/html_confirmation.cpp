// Fresh runs at the recommended tolerance; yield against the centre of a tolerance.
#include <fmt/format.h>

#include <cmath>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {

std::string confirmation_chapter(const Json& report) {
  const Json& confirmation = report["confirmation"];
  if (!confirmation.is_object()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const Json& attempt : confirmation["attempts"]) {
    std::string bands;
    for (const Json& band : attempt["bands"])
      bands += (bands.empty() ? "" : "<br>") +
               fmt::format("{}{} {:.3f} mm {}", escaped(band["name"]),
                           band["centre"].is_number()
                               ? fmt::format(" {:g},", band["centre"].get<double>())
                               : std::string(),
                           band["band_mm"].get<double>(), escaped(band["grade"]));
    rows.push_back({escaped(attempt["stage"]), bands, rounded(attempt["runs"]),
                    rounded(attempt["meeting_runs"]), rounded(attempt["jammed_runs"]),
                    rounded(attempt["unknown_runs"]), rounded(attempt["allowed_failures"]),
                    percent(attempt["yield"]["lower_bound"]),
                    attempt["passed"].get<bool>() ? "<b>confirmed</b>" : "not confirmed"});
  }
  std::string body = table("ttnnnnnnt",
                           {"attempt", "tolerance", "fresh runs", "meet all limits", "jammed",
                            "without result", "may fail", "yield, lower bound", ""},
                           rows);
  body += note(fmt::format(
      "{} attempts were planned beforehand; each bound is exact (Clopper-Pearson) at {:.6g} % "
      "confidence, so that all together they hold with {:.6g} %. Jams and runs without a result "
      "count as failing.",
      rounded(confirmation["attempts_planned"]),
      100 * confirmation["confidence_each"].get<double>(),
      100 * report["verdict"]["confidence"].get<double>()));
  rows.clear();
  for (const Json& passed : confirmation["passed_over"])
    rows.push_back({escaped(passed["name"]), escaped(passed["reason"]),
                    passed["command"].is_null()
                        ? std::string()
                        : "<code>" + escaped(passed["command"]) + "</code>"});
  if (!rows.empty())
    body += "<h3>Wider candidates passed over</h3>\n" +
            table("ttt", {"candidate", "why no attempt tried it", "what would confirm it"}, rows);
  rows.clear();
  for (const Json& entry : confirmation["capability"])
    rows.push_back({escaped(readable(entry["quantity"])), with_interval(entry["cp"]),
                    with_interval(entry["cpk"]), with_interval(entry["pp"]),
                    with_interval(entry["ppk"]), rounded(entry["outside_ppm"]),
                    rounded(std::round(entry["outside_ppm_lower"].get<double>())) + " to " +
                        rounded(std::round(entry["outside_ppm_upper"].get<double>()))});
  body += "<h3>Capability at this tolerance</h3>\n" +
          table("tnnnnnn",
                {"quantity", "Cp", "Cpk", "Pp", "Ppk", "outside the limits [ppm]", "bounds [ppm]"},
                rows) +
          note("From the fresh runs of the last attempt alone.");
  return chapter("confirmation", "Fresh runs at the recommended tolerance", body);
}

std::string centre_responses_section(const Json& tolerance, const FigureSet& figures) {
  if (tolerance["centre_responses"].empty()) return {};
  std::string body = "<h3>Force over the centre of the tolerance</h3>\n" +
                     figure_html(figures, "centre_responses",
                                 "Peak force on a pocket over the nominal value: means of the runs "
                                 "nearest to each centre with two standard errors, the fit, and "
                                 "the optimum with its interval (band).");
  for (const Json& response : tolerance["centre_responses"]) {
    const Json& optimum = response["optimum"];
    const bool known = optimum["lower"].is_number() && optimum["upper"].is_number();
    body += paragraph(fmt::format(
        "{}: the force is least at {:.4g} {}{}.{}", escaped(response["name"]),
        optimum["value"].get<double>(), escaped(response["unit"]),
        known ? fmt::format(", {:.4g} to {:.4g} with {:g} % confidence",
                            optimum["lower"].get<double>(), optimum["upper"].get<double>(),
                            100 * tolerance["confidence"].get<double>())
              : std::string(),
        response["at_end"].get<bool>()
            ? " That is the end of the centres studied: it may lie beyond."
            : ""));
  }
  return body;
}

std::string centres_section(const Json& tolerance, const FigureSet& figures) {
  if (!tolerance["centres"].is_object()) return {};
  const Json& centres = tolerance["centres"];
  if (const std::string why = centres["note"]; !why.empty())
    return "<p class=\"warning\">" + escaped(why) + "</p>\n";
  std::string body = figure_html(
      figures, "centre_curves",
      "Yield when a dimension is not set to its nominal value, at the width of the verdict and "
      "with the other dimensions centred. In brackets the effective number of runs. A curve that "
      "peaks beside zero is a nominal value that may be moved.");
  body += figure_html(figures, "centre_map",
                      "Both centres together: estimated yield and effective runs.");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t d = 0; d < centres["dimensions"].size(); ++d)
    for (const Json& point : centres["dimensions"][d]["points"])
      if (point["shown"].get<bool>())
        rows.push_back({escaped(centres["dimensions"][d]["name"]),
                        fmt::format("{:+.1f}", 1e3 * point["shifts_mm"][d].get<double>()),
                        percent(point["yield"]["if_unknown_fail"]),
                        percent(point["yield"]["lower_bound"]),
                        rounded(std::round(point["effective_runs"].get<double>()))});
  if (rows.empty())
    return paragraph("Yield against the centre: too few effective runs beside the nominal value.");
  return "<h3>Yield against the centre of the tolerance</h3>\n" + body +
         table("tnnnn",
               {"dimension", "centre beside the nominal value [µm]", "yield", "lower bound",
                "effective runs"},
               rows);
}

}  // namespace cagetol
