// What a grid shows over the levels of one dimension: every quantity. Bands are the 5 and 95 % quantiles over the runs of a cell.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/json_parts.hpp"
#include "analysis/response/grid_cells.hpp"
#include "analysis/sensitivity/features.hpp"
#include "analysis/statistics/order_statistics.hpp"
#include "analysis/statistics/paired_difference.hpp"

namespace cagetol {
namespace {

double quantile_of(const std::vector<double>& values, double p) {
  const std::vector<double> equal(values.size(), 1.0);
  return weighted_quantile(values, ascending_order(values), equal, p);
}

bool has_values(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
}

/// `make(samples)` for every cell: a list by setting of lists by level.
template <class Make>
Json for_cells(const GridCells& cells, Make make) {
  Json settings = Json::array();
  for (std::size_t setting = 0; setting < cells.settings.size(); ++setting) {
    Json levels = Json::array();
    for (std::size_t level = 0; level < cells.levels.size(); ++level)
      levels.push_back(make(cells.samples(setting, level)));
    settings.push_back(std::move(levels));
  }
  return settings;
}

/// Values of a cell's runs by their replicate; NaN where there is none.
std::vector<double> by_replicate(const StudyData& study, const Column& column,
                                 const std::vector<std::size_t>& samples) {
  const auto most = *std::max_element(study.replicate.begin(), study.replicate.end());
  std::vector<double> values(static_cast<std::size_t>(most) + 1, kUndefined);
  for (const std::size_t i : samples)
    values[static_cast<std::size_t>(study.replicate[i])] = column.values[i];
  return values;
}

/// How a quantity goes over the levels, from paired differences: the k-th runs of all cells start
/// alike. It rises where it does from the first level to the last and no step certainly falls.
const char* course_of(const std::vector<std::vector<double>>& levels, double confidence) {
  const PairedDifference whole = paired_difference(levels.front(), levels.back(), confidence);
  bool rises = false, falls = false, identical = whole.identical;
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const PairedDifference step = paired_difference(levels[l - 1], levels[l], confidence);
    rises = rises || step.difference.lower > 0;
    falls = falls || step.difference.upper < 0;
    identical = identical && step.identical;
  }
  if (identical) return "unchanged";
  if (rises && falls) return "not monotone";
  if (whole.difference.lower > 0 && !falls) return "rises";
  if (whole.difference.upper < 0 && !rises) return "falls";
  return "undecided";
}

/// `error_rate`: chance that a course of nothing but noise is called one.
Json courses_of(const ReportBasis& basis, const Column& column, const GridCells& cells,
                double error_rate) {
  Json courses = Json::array();
  for (std::size_t setting = 0; setting < cells.settings.size(); ++setting) {
    std::vector<std::vector<double>> levels;
    for (std::size_t level = 0; level < cells.levels.size(); ++level)
      levels.push_back(by_replicate(basis.study, column, cells.samples(setting, level)));
    courses.push_back(course_of(levels, 1 - error_rate));
  }
  return courses;
}

/// The band, and the mean with its interval.
Json cell_json(const std::vector<double>& values, double confidence) {
  Json json = band_json(values);
  const std::vector<double> nothing(values.size(), 0.0);
  json["mean"] = to_json(paired_difference(nothing, values, confidence).difference);
  return json;
}

Json quantities_of(const ReportBasis& basis, const GridCells& cells) {
  Json list = Json::array();
  const auto& all = basis.study.quantities;
  const auto courses =
      static_cast<std::size_t>(std::count_if(
          all.begin(), all.end(), [](const Column& column) { return has_values(column.values); })) *
      cells.settings.size();
  // All courses together are right with the report's confidence (Bonferroni).
  const double error_rate =
      (1 - basis.confidence) / static_cast<double>(std::max<std::size_t>(1, courses));
  for (const Column& column : all) {
    if (!has_values(column.values)) continue;
    list.push_back({{"quantity", column.name},
                    {"unit", column.unit},
                    {"course", courses_of(basis, column, cells, error_rate)},
                    {"cells", for_cells(cells, [&](const std::vector<std::size_t>& samples) {
                       std::vector<double> values;
                       for (const std::size_t i : samples) values.push_back(column.values[i]);
                       return cell_json(values, basis.confidence);
                     })}});
  }
  return list;
}

}  // namespace

Json band_json(const std::vector<double>& values) {
  const auto defined =
      std::count_if(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
  return {{"runs", defined},
          {"median", number(quantile_of(values, 0.5))},
          {"low", number(quantile_of(values, 0.05))},
          {"high", number(quantile_of(values, 0.95))}};
}

Json response_json(const ReportBasis& basis) {
  const auto cells = grid_cells(basis.study, response_key(basis.study));
  if (!cells) return Json();
  const InputColumns* input = find_input(basis.study, cells->key);
  return {{"key", cells->key},
          {"name", plain_name(cells->key)},
          {"unit", cells->unit},
          {"nominal", input->nominal.empty() ? Json() : number(input->nominal.front())},
          {"levels", cells->levels},
          {"settings", cells->settings},
          {"confidence", basis.confidence},
          {"quantities", quantities_of(basis, *cells)}};
}

}  // namespace cagetol
