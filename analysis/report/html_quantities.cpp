// Statistics, capability, convergence and run health.
#include <fmt/format.h>

#include <cmath>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

/// Estimate at a level of the quantiles of a quantity.
const Json& quantile_of(const Json& statistics, double level) {
  for (const Json& quantile : statistics["quantiles"])
    if (quantile["level"] == level) return quantile;
  return statistics["quantiles"].front();
}

}  // namespace

std::string quantities_chapter(const Json& report, const FigureSet& figures) {
  std::string body = figure_html(
      figures, "limited_quantities",
      "Runs by value, for the quantities with limits (dashed). What lies beyond a line fails.");
  std::vector<std::vector<std::string>> rows, missing;
  for (const Json& quantity : report["quantities"]) {
    const Json& statistics = quantity["statistics"];
    if (statistics["runs_with_value"].get<double>() == 0) {
      // What a point or a phase leaves out says nothing new.
      if (quantity["quantity"].get<std::string>().find('@') != std::string::npos) continue;
      missing.push_back({escaped(readable(quantity["quantity"])), escaped(quantity["definition"])});
      continue;
    }
    rows.push_back(
        {escaped(readable(quantity["quantity"])) + unit_suffix(quantity["unit"]),
         with_interval(statistics["mean"]), with_interval(statistics["standard_deviation"]),
         with_interval(quantile_of(statistics, 0.05)), with_interval(quantile_of(statistics, 0.5)),
         with_interval(quantile_of(statistics, 0.95)), rounded(statistics["bound_of_95_quantile"]),
         rounded(statistics["runs_with_value"])});
  }
  body += table("tnnnnnnn",
                {"quantity", "mean", "standard deviation", "5 % quantile", "median",
                 "95 % quantile", "95 % quantile is below", "runs"},
                rows);
  std::string refused;
  for (const Json& quantity : report["quantities"])
    if (const std::string reason = quantity["statistics"]["bound_refused"];
        !reason.empty() && quantity["statistics"]["runs_with_value"].get<double>() > 0)
      refused = reason;
  body += note(fmt::format(
      "Small print: {:g} % interval ({}). \"95 % quantile is below\": holds with {:g} % confidence "
      "whatever the law of the quantity{}. Runs as sampled, "
      "all candidates mixed; runs without a result have no value here.",
      100 * report["intervals"]["confidence"].get<double>(), escaped(report["intervals"]["method"]),
      100 * report["intervals"]["confidence"].get<double>(),
      refused.empty() ? "" : "; " + escaped(refused)));
  body += figure_html(figures, "other_quantities",
                      "Runs by value for all other quantities. A second hump or a long tail is "
                      "worth a look at its worst runs.");
  if (!missing.empty())
    body +=
        "<h3>Not defined in this scene</h3>\n" + table("tt", {"quantity", "definition"}, missing);
  return chapter("quantities", "Statistics of every quantity", body);
}

std::string capability_chapter(const Json& report) {
  if (report["capability"].empty()) return {};
  std::vector<std::vector<std::string>> rows;
  std::string refused;
  for (const Json& entry : report["capability"]) {
    rows.push_back({escaped(readable(entry["quantity"])), with_interval(entry["cp"]),
                    with_interval(entry["cpk"]), with_interval(entry["pp"]),
                    with_interval(entry["ppk"]), rounded(entry["outside_ppm"]),
                    rounded(std::round(entry["outside_ppm_lower"].get<double>())) + " to " +
                        rounded(std::round(entry["outside_ppm_upper"].get<double>()))});
    if (const std::string reason = entry["percentile_refused"]; !reason.empty()) refused = reason;
  }
  std::string body = table(
      "tnnnnnn", {"quantity", "Cp", "Cpk", "Pp", "Ppk", "outside the limits [ppm]", "bounds [ppm]"},
      rows);
  body += note(
      "Cp and Pp need limits on both sides. Cpk is meant for bell-shaped scatter; Ppk takes the "
      "percentiles 0.135 %, 50 % and 99.865 % as they are and suits skewed "
      "quantities. The bounds count runs without a result as inside (lower) and outside (upper). "
      "Runs as sampled, all candidates mixed." +
      (refused.empty() ? std::string()
                       : " Pp and Ppk are missing where " + escaped(refused) + "."));
  return chapter("capability", "Capability against the limits", body);
}

std::string convergence_chapter(const Json& report, const FigureSet& figures) {
  const Json& convergence = report["convergence"];
  if (convergence["rows"].empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const Json& row : convergence["rows"])
    rows.push_back({escaped(readable(row["quantity"])), escaped(row["statistic"]),
                    rounded(row["value"]), rounded(row["half_width"]),
                    rounded(row["target_half_width"]), rounded(row["runs_still_needed"])});
  std::string body;
  if (const Json& limiting = convergence["limiting"]; limiting.is_object())
    body += limiting["runs_still_needed"].get<double>() > 0
                ? paragraph(fmt::format("The limiting quantity is <b>{}</b> ({}): about {} more "
                                        "runs until it is known as well as wanted.",
                                        escaped(readable(limiting["quantity"])),
                                        escaped(limiting["statistic"]),
                                        rounded(limiting["runs_still_needed"])))
                : paragraph("Every quantity is known as well as wanted.");
  body += table("ttnnnn",
                {"quantity", "statistic", "value", "half width of its interval", "wanted",
                 "runs still needed"},
                rows);
  body +=
      note(fmt::format("Wanted: means within {:g} %, 95 % quantiles within {:g} % of their value, "
                       "the yield's bounds within half of the failures the target allows. "
                       "An interval shrinks with the square root of the runs.",
                       100 * convergence["mean_precision"].get<double>(),
                       100 * convergence["quantile_precision"].get<double>()));
  body += figure_html(
      figures, "convergence",
      "Estimates from the first part of the runs, doubled at each point, with their intervals. "
      "They should settle inside the earlier bands; a drift means too few runs.");
  return chapter("convergence", "Are there enough runs?", body);
}

std::string health_chapter(const Json& report, const FigureSet& figures) {
  if (report["health"].empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const Json& entry : report["health"])
    rows.push_back({escaped(readable(entry["field"])) + unit_suffix(entry["unit"]),
                    rounded(entry["median"]), rounded(entry["quantile_95"]),
                    rounded(entry["largest"]), escaped(entry["definition"])});
  std::string body =
      figure_html(figures, "health",
                  "Work and accuracy of the runs. The energy residual and the static consistency "
                  "error should be small and without outliers: an outlier is a run whose "
                  "contacts were not resolved.");
  body += table("tnnnt", {"field", "median", "95 % of runs below", "largest", "meaning"}, rows);
  return chapter("health", "Run health", body);
}

}  // namespace cagetol
