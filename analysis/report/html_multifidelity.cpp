// What the runs of a cheap companion add.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/html_report.hpp"
#include "analysis/report/html_text.hpp"

namespace cagetol {
namespace {

std::string bracketed(const std::string& unit) {
  return unit.empty() || unit == "-" ? "" : " [" + escaped(unit) + "]";
}

/// As many digits as the error deserves, two of it.
std::string with_error(const Json& estimate) {
  const Json &value = estimate["value"], &error = estimate["standard_error"];
  if (!value.is_number() || !error.is_number() || !(error > 0)) return rounded(value);
  const int decimals =
      std::clamp(1 - static_cast<int>(std::floor(std::log10(error.get<double>()))), 0, 15);
  return fmt::format("{:.{}f} &plusmn; {:.{}f}", value.get<double>(), decimals, error.get<double>(),
                     decimals);
}

}  // namespace

std::string multifidelity_chapter(const Json& report) {
  const Json& part = report["multifidelity"];
  if (part.is_null()) return "";
  if (!part["problem"].is_null())
    return chapter("multifidelity", "Help from a cheaper model",
                   paragraph("The companion " + code(part["companion"].get<std::string>()) +
                             " is not used: " + escaped(part["problem"].get<std::string>()) + "."));
  std::vector<std::vector<std::string>> rows;
  for (const Json& quantity : part["quantities"])
    for (const Json& entry : quantity["statistics"])
      rows.push_back({escaped(readable(quantity["quantity"])) + bracketed(quantity["unit"]),
                      escaped(entry["statistic"].get<std::string>()), with_error(entry["plain"]),
                      with_error(entry["helped"]), rounded(entry["predicted_gain"]),
                      rounded(entry["achieved_gain"])});
  const double share = part["companion_runs"].get<double>() * part["cost_ratio"].get<double>() /
                       part["runs"].get<double>();
  return chapter(
      "multifidelity", "Help from a cheaper model",
      paragraph(fmt::format(
          "{} runs of a cheaper model ({}), the first {} of them on the study's own samples, took "
          "{:.2g} times the processor time of the study's runs. They serve as control variates: "
          "the estimates stay those of the study's model, only their scatter is smaller.",
          part["companion_runs"].dump(), escaped(part["companion"].get<std::string>()),
          part["runs"].dump(), share)) +
          table("ttnnnn",
                {"quantity", "", "study alone, with standard error", "with help", "gain predicted",
                 "gain achieved"},
                rows) +
          note(fmt::format(
              "Gain: variance of as many more runs of the study's model as the time of both would "
              "have bought, over the variance with help. Predicted from the first {} pairs; "
              "achieved "
              "when the runs are drawn again {} times. No gain is measured where less than 1.2 is "
              "predicted. Yields here are of one limit, among runs with a result.",
              part["pilot_pairs"].dump(), part["resamples"].dump())));
}

}  // namespace cagetol
