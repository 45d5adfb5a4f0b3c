// The claims of the study's [[trend]] entries beside the differences its runs show.
#include <map>

#include "analysis/report/json_parts.hpp"
#include "analysis/response/grid_cells.hpp"
#include "analysis/response/trend_verdict.hpp"

namespace cagetol {
namespace {

/// Values of the runs of one cell by their replicate; NaN where the cell lacks one.
std::vector<double> by_replicate(const StudyData& study, const std::vector<std::size_t>& samples,
                                 const Column* column) {
  std::vector<double> values;
  for (const std::size_t i : samples) {
    const auto k = static_cast<std::size_t>(study.replicate[i]);
    if (values.size() <= k) values.resize(k + 1, kUndefined);
    if (column != nullptr) values[k] = column->values[i];
  }
  return values;
}

Json relative(const Estimate& estimate, double reference) {
  const double scale = std::abs(reference);
  if (!(scale > 0)) return to_json(Estimate{});
  return to_json(Estimate{estimate.value / scale, estimate.lower / scale, estimate.upper / scale});
}

Json trend_json(const Trend& trend, const ReportBasis& basis, const GridCells& cells,
                std::size_t setting) {
  const Column* column = find_quantity(basis.study, trend.quantity);
  const auto from = cells.find_level(trend.from), to = cells.find_level(trend.to);
  std::vector<double> first, second;
  if (from) first = by_replicate(basis.study, cells.samples(setting, *from), column);
  if (to) second = by_replicate(basis.study, cells.samples(setting, *to), column);
  const std::size_t pairs = std::max(first.size(), second.size());
  first.resize(pairs, kUndefined);
  second.resize(pairs, kUndefined);
  const PairedDifference seen = paired_difference(first, second, basis.confidence);
  const TrendFinding finding = judge_trend(trend, seen);
  return {{"setting", cells.settings[setting]},
          {"pairs", seen.pairs},
          {"pairs_without_value", seen.missing},
          {"from_mean", number(seen.first_mean)},
          {"to_mean", number(seen.second_mean)},
          {"difference", to_json(seen.difference)},
          {"relative_difference", relative(seen.difference, seen.first_mean)},
          {"change_claimed", number(finding.change)},
          {"identical", seen.identical},
          {"verdict", trend_verdict_name(finding.verdict)},
          {"reason", finding.reason}};
}

}  // namespace

Json trends_json(const ReportBasis& basis) {
  Json rows = Json::array();
  std::map<std::string, int> verdicts;
  for (const Trend& trend : basis.study.plan.trends) {
    const auto cells = grid_cells(basis.study, trend.key);
    if (!cells) continue;
    const Column* column = find_quantity(basis.study, trend.quantity);
    Json row{{"claim", trend.claim},       {"source", trend.source},
             {"quantity", trend.quantity}, {"unit", column == nullptr ? "" : column->unit},
             {"key", trend.key},           {"key_unit", cells->unit},
             {"from", trend.from},         {"to", trend.to},
             {"expected", trend.expected}, {"by_share", trend.by_share},
             {"by_value", trend.by_value}};
    row["settings"] = Json::array();
    for (std::size_t setting = 0; setting < cells->settings.size(); ++setting) {
      row["settings"].push_back(trend_json(trend, basis, *cells, setting));
      ++verdicts[row["settings"].back()["verdict"].get<std::string>()];
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return Json();
  return {{"confidence", basis.confidence}, {"verdicts", verdicts}, {"rows", rows}};
}

}  // namespace cagetol
