#include "analysis/report/csv_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/report/write_text.hpp"
#include "analysis/sensitivity/features.hpp"
#include "analysis/study/judgement.hpp"
#include "analysis/tolerance/limit_margin.hpp"

namespace cagetol {
namespace {

/// Quoted where the text would break the line apart.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string cell(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

std::string cell(const Json& value) {
  if (value.is_null()) return {};
  return value.is_string() ? cell(value.get<std::string>()) : value.dump();
}

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + cells[i];
  return text + "\n";
}

std::string named(const std::string& name, const std::string& unit) {
  return cell(unit.empty() || unit == "-" ? name : name + " [" + unit + "]");
}

const char* judgement_name(Judgement judgement) {
  if (judgement == Judgement::meets) return "meets";
  return judgement == Judgement::misses ? "misses" : "unknown";
}

std::string samples_csv(const StudyData& study) {
  const auto features = cage_features(study);
  const auto joint = judge_all(study);
  std::vector<std::string> header = {"id",        "row",    "replicate", "lot",
                                     "candidate", "status", "limits"};
  for (const Feature& feature : features) header.push_back(named(feature.name, feature.unit));
  for (const Column& column : study.quantities) header.push_back(cell(column.name));
  std::string text = line(header);
  for (std::size_t i = 0; i < study.size(); ++i) {
    std::vector<std::string> cells;
    for (const std::int64_t whole :
         {study.id[i], study.row[i], study.replicate[i], study.lot[i], study.candidate[i]})
      cells.push_back(std::to_string(whole));
    cells.emplace_back(run_status_name(study.status[i]));
    cells.emplace_back(study.plan.limits.empty() ? "" : judgement_name(joint[i]));
    for (const Feature& feature : features) cells.push_back(cell(feature.values[i]));
    for (const Column& column : study.quantities) cells.push_back(cell(column.values[i]));
    text += line(cells);
  }
  return text;
}

void add_estimate(std::vector<std::string>& cells, const Json& estimate) {
  for (const char* key : {"value", "lower", "upper"}) cells.push_back(cell(estimate.at(key)));
}

std::string quantities_csv(const Json& report) {
  std::string text =
      "quantity,unit,runs_with_value,mean,mean_lower,mean_upper,standard_deviation,standard_"
      "deviation_lower,standard_deviation_upper";
  if (!report["quantities"].empty())
    for (const Json& quantile : report["quantities"][0]["statistics"]["quantiles"]) {
      const double level = quantile["level"];
      text += fmt::format(",q{0:g},q{0:g}_lower,q{0:g}_upper", 100 * level);
    }
  text += ",bound_of_95_quantile,noise_share,noise_share_lower,noise_share_upper\n";
  for (const Json& quantity : report["quantities"]) {
    const Json& statistics = quantity["statistics"];
    std::vector<std::string> cells = {cell(quantity["quantity"]), cell(quantity["unit"]),
                                      cell(statistics["runs_with_value"])};
    add_estimate(cells, statistics["mean"]);
    add_estimate(cells, statistics["standard_deviation"]);
    for (const Json& quantile : statistics["quantiles"]) add_estimate(cells, quantile);
    cells.push_back(cell(statistics["bound_of_95_quantile"]));
    add_estimate(cells, quantity["noise"]["share"]);
    text += line(cells);
  }
  return text;
}

std::string yield_csv(const Json& report) {
  const std::vector<const char*> keys = {"if_unknown_fail", "if_unknown_pass", "lower_bound",
                                         "upper_bound", "effective_runs"};
  std::string text =
      "what,yield_if_unknown_fail,yield_if_unknown_pass,lower_bound,upper_bound,effective_runs,"
      "shown\n";
  const auto add = [&](const std::string& what, const Json& yield, bool shown) {
    std::vector<std::string> cells = {cell(what)};
    for (const char* key : keys) cells.push_back(cell(yield.at(key)));
    cells.emplace_back(shown ? "yes" : "no");
    text += line(cells);
  };
  for (const Json& limit : report["limits"]["each"])
    add("limit " + limit["quantity"].get<std::string>(), limit["yield"], true);
  add("all limits as sampled", report["limits"]["joint"], true);
  if (!report["tolerance"].is_object()) return text;
  const Json& dimensions = report["tolerance"]["dimensions"];
  for (const Json& dimension : dimensions)
    for (const Json& level : dimension["levels"])
      add(fmt::format("{} {} mm {}", dimension["key"].get<std::string>(),
                      level["tolerance_width_mm"].get<double>(), level["grade"].get<std::string>()),
          level["yield"], level["shown"]);
  for (const Json& candidate : report["tolerance"]["candidates"]) {
    std::string what = "candidate";
    for (std::size_t d = 0; d < candidate["tolerance_widths_mm"].size(); ++d)
      what += fmt::format(" {} {} mm {}", dimensions[d]["key"].get<std::string>(),
                          candidate["tolerance_widths_mm"][d].get<double>(),
                          candidate["grades"][d].get<std::string>());
    add(what, candidate["yield"], candidate["shown"]);
  }
  return text;
}

std::string limit_curves_csv(const Json& curves) {
  std::string text =
      "quantity,side,value,what,yield_if_unknown_fail,yield_if_unknown_pass,lower_bound,"
      "upper_bound,effective_runs,shown\n";
  for (const Json& curve : curves)
    for (const Json& candidate : curve["candidates"])
      for (std::size_t i = 0; i < curve["values"].size(); ++i) {
        std::vector<std::string> cells = {cell(curve["quantity"]), cell(curve["side"]),
                                          cell(curve["values"][i]), cell(candidate["name"])};
        for (const char* key : {"if_unknown_fail", "if_unknown_pass", "lower_bound", "upper_bound"})
          cells.push_back(cell(candidate[key][i]));
        cells.push_back(cell(candidate["effective_runs"]));
        cells.emplace_back(candidate["shown"] ? "yes" : "no");
        text += line(cells);
      }
  return text;
}

}  // namespace

void write_csv_tables(const std::filesystem::path& directory, const StudyData& study,
                      const Json& report) {
  write_text(directory / "samples.csv", samples_csv(study));
  write_text(directory / "quantities.csv", quantities_csv(report));
  write_text(directory / "yield.csv", yield_csv(report));
  if (report.contains("limit_curves"))
    write_text(directory / "limit_curves.csv", limit_curves_csv(report["limit_curves"]));
}

std::string worst_csv(const StudyData& study, std::size_t count, const std::string& quantity) {
  struct Run {
    std::size_t at = 0;
    double margin = std::numeric_limits<double>::infinity();
    std::string limit = {};
  };
  std::vector<Run> order;
  for (std::size_t i = 0; i < study.size(); ++i) {
    Run run{i};
    if (study.status[i] == RunStatus::jammed) run.margin = -run.margin, run.limit = "jam";
    for (const Limit& limit : study.plan.limits) {
      const Column* column = find_quantity(study, limit.quantity);
      if (!column || (!quantity.empty() && limit.quantity != quantity)) continue;
      const double margin = margin_of(limit, column->values[i]);
      if (margin < run.margin) run.margin = margin, run.limit = limit.quantity;
    }
    if (!run.limit.empty()) order.push_back(std::move(run));
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Run& a, const Run& b) { return a.margin < b.margin; });
  order.resize(std::min(order.size(), count));
  std::vector<std::string> header = {"id", "status", "nearest limit", "margin"};
  for (const Limit& limit : study.plan.limits) header.push_back(cell(limit.quantity));
  for (const InputColumns& input : study.inputs)
    for (std::size_t j = 0; j < (input.per_pocket ? study.pockets : 1); ++j)
      header.push_back(
          named(input.per_pocket ? fmt::format("{}[{}]", input.key, j) : input.key, input.unit));
  std::string text = line(header);
  for (const Run& run : order) {
    std::vector<std::string> cells = {std::to_string(study.id[run.at]),
                                      run_status_name(study.status[run.at]), cell(run.limit),
                                      std::isinf(run.margin) ? "" : cell(run.margin)};
    for (const Limit& limit : study.plan.limits) {
      const Column* column = find_quantity(study, limit.quantity);
      cells.push_back(column ? cell(column->values[run.at]) : "");
    }
    for (const InputColumns& input : study.inputs) {
      const std::size_t width = input.per_pocket ? study.pockets : 1;
      for (std::size_t j = 0; j < width; ++j)
        cells.push_back(cell(input.value[run.at * width + j]));
    }
    text += line(cells);
  }
  return text;
}

}  // namespace cagetol
