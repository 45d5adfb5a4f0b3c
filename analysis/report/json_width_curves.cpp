// How near each limit is over the width of each tolerance: quantiles of the runs at each width that
// the candidates have, the other dimensions as the rows drew them.
#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/report/json_parts.hpp"
#include "analysis/sensitivity/features.hpp"
#include "analysis/statistics/order_statistics.hpp"

namespace cagetol {
namespace {
constexpr long kFewestRuns = 8;  // for quantiles of 5 and 95 %

/// Number of runs with a value, their median and 5 and 95 % quantiles.
Json band_json(const std::vector<double>& values) {
  const auto order = ascending_order(values);
  const std::vector<double> equal(values.size(), 1.0);
  const auto defined =
      std::count_if(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
  return {{"runs", defined},
          {"median", number(weighted_quantile(values, order, equal, 0.5))},
          {"low", number(weighted_quantile(values, order, equal, 0.05))},
          {"high", number(weighted_quantile(values, order, equal, 0.95))}};
}

}  // namespace

Json width_curves_json(const ReportBasis& basis) {
  const StudyPlan& plan = basis.study.plan;
  Json dimensions = Json::array();
  for (std::size_t d = 0; d < plan.dimensions.size(); ++d) {
    using Zone = std::pair<double, double>;            // width, middle
    std::map<Zone, std::vector<std::size_t>> runs_at;  // of each tolerance
    std::map<Zone, std::string> grades;
    for (std::size_t i = 0; i < basis.runs.size(); ++i) {
      if (basis.runs.candidate[i] < 0) continue;
      const Candidate& drawn = plan.candidates[static_cast<std::size_t>(basis.runs.candidate[i])];
      const Zone zone(drawn.tolerance_widths_mm[d], drawn.middle(d));
      runs_at[zone].push_back(i);
      grades[zone] = drawn.grades[d];
    }
    Json limits = Json::array();
    for (const Limit& limit : plan.limits) {
      const Column* column = find_quantity(basis.runs, limit.quantity);
      if (column == nullptr) continue;
      const auto values = ok_values(basis.runs, column->values);
      Json bands = Json::array();
      for (const auto& [zone, runs] : runs_at) {
        std::vector<double> here;
        for (const std::size_t i : runs) here.push_back(values[i]);
        bands.push_back(band_json(here));
        if (bands.back()["runs"] < kFewestRuns) bands.back() = nullptr;
      }
      limits.push_back({{"quantity", limit.quantity},
                        {"unit", column->unit},
                        {"min", limit.minimum ? number(*limit.minimum) : Json()},
                        {"max", limit.maximum ? number(*limit.maximum) : Json()},
                        {"bands", bands}});
    }
    Json widths = Json::array(), names = Json::array();
    for (const auto& [zone, grade] : grades) widths.push_back(zone.first), names.push_back(grade);
    dimensions.push_back({{"key", plan.dimensions[d].key},
                          {"name", plain_name(plan.dimensions[d].key)},
                          {"tolerance_widths_mm", widths},
                          {"grades", names},
                          {"limits", limits}});
  }
  return dimensions;
}

}  // namespace cagetol
