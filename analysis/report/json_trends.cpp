// The claims of the study's [[trend]] entries beside the differences its runs show.
#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/report/json_parts.hpp"
#include "analysis/response/claims.hpp"
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

/// Difference of a trend's quantity between its first level and another one.
PairedDifference difference_to(const Trend& trend, const ReportBasis& basis, const GridCells& cells,
                               std::size_t setting, double level) {
  const Column* column = find_quantity(basis.study, trend.quantity);
  const auto from = cells.find_level(trend.from), to = cells.find_level(level);
  std::vector<double> first, second;
  if (from) first = by_replicate(basis.study, cells.samples(setting, *from), column);
  if (to) second = by_replicate(basis.study, cells.samples(setting, *to), column);
  const std::size_t pairs = std::max(first.size(), second.size());
  first.resize(pairs, kUndefined);
  second.resize(pairs, kUndefined);
  return paired_difference(first, second, basis.confidence);
}

/// Of a deviation, without the last digits of the subtraction; null where there is none.
Json clearance_json(std::optional<double> nominal, double deviation) {
  return nominal ? number(std::round(1e9 * (*nominal + deviation)) / 1e9) : Json();
}

Json trend_json(const Trend& trend, const ReportBasis& basis, const GridCells& cells,
                std::size_t setting, std::optional<double> clearance) {
  const PairedDifference seen = difference_to(trend, basis, cells, setting, trend.to);
  const TrendFinding finding = judge_trend(trend, seen);
  Json path = Json::array();
  for (const std::size_t level : levels_towards(cells, trend.from, trend.to)) {
    const PairedDifference there = difference_to(trend, basis, cells, setting, cells.levels[level]);
    path.push_back({{"level", cells.levels[level]},
                    {"clearance", clearance_json(clearance, cells.levels[level])},
                    {"pairs", there.pairs},
                    {"difference", to_json(there.difference)},
                    {"verdict", trend_verdict_name(judge_trend(trend, there).verdict)}});
  }
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
          {"reason", finding.reason},
          {"path", path}};
}

TrendVerdict verdict_named(const std::string& name) {
  for (const auto verdict : {TrendVerdict::agrees, TrendVerdict::disagrees, TrendVerdict::undecided,
                             TrendVerdict::no_claim})
    if (name == trend_verdict_name(verdict)) return verdict;
  return TrendVerdict::no_values;
}

/// The place of a level on a path; nullptr where it is not there.
const Json* place_on(const Json& path, double level) {
  for (const Json& place : path)
    if (place["level"] == level) return &place;
  return nullptr;
}

bool is_upwards(const Json& row) {
  return row["to"].get<double>() > row["from"].get<double>();
}

/// Where all readings of a claim that go the same way hold, in one setting: ranges of levels, each
/// with the readings' differences at its first one.
Json held_json(const std::vector<const Json*>& rows, std::size_t setting) {
  const auto path_of = [&](const Json* row) -> const Json& {
    return (*row)["settings"][setting]["path"];
  };
  const Json& shortest =
      path_of(*std::min_element(rows.begin(), rows.end(), [&](const Json* a, const Json* b) {
        return path_of(a).size() < path_of(b).size();
      }));
  std::vector<Json> levels;
  std::vector<bool> holds;
  std::size_t undecided = 0;
  for (const Json& place : shortest) {
    bool common = true, agree = true, disagree = false;
    for (const Json* row : rows) {
      const Json* there = place_on(path_of(row), place["level"]);
      common = common && there != nullptr;
      agree = agree && there != nullptr &&
              (*there)["verdict"] == trend_verdict_name(TrendVerdict::agrees);
      disagree = disagree || (there != nullptr &&
                              (*there)["verdict"] == trend_verdict_name(TrendVerdict::disagrees));
    }
    if (!common) continue;
    levels.push_back({{"level", place["level"]}, {"clearance", place["clearance"]}});
    holds.push_back(agree);
    undecided += !agree && !disagree;
  }
  Json ranges = Json::array();
  for (const auto& [first, last] : unbroken(holds)) {
    Json differences = Json::array();
    for (const Json* row : rows)
      differences.push_back(
          {{"quantity", (*row)["quantity"]},
           {"unit", (*row)["unit"]},
           {"against", {{"level", (*row)["from"]}, {"clearance", (*row)["from_clearance"]}}},
           {"difference", (*place_on(path_of(row), levels[first]["level"]))["difference"]}});
    ranges.push_back({{"first", levels[first]},
                      {"last", levels[last]},
                      {"before", first > 0 ? levels[first - 1] : Json()},
                      {"to_the_end", last + 1 == levels.size()},
                      {"differences", differences}});
  }
  return {{"setting", rows[0]->at("settings")[setting]["setting"]},
          {"upwards", is_upwards(*rows[0])},
          {"levels", levels.size()},
          {"undecided_levels", undecided},
          {"ranges", ranges}};
}

/// A claim from its rows: counted once, and where it holds.
Json claim_json(const std::vector<const Json*>& rows) {
  std::vector<TrendVerdict> readings;
  for (const Json* row : rows)
    for (const Json& seen : (*row)["settings"]) readings.push_back(verdict_named(seen["verdict"]));
  const Json& first = *rows[0];
  Json held = Json::array();
  for (std::size_t setting = 0; setting < first["settings"].size(); ++setting)
    for (const bool upwards : {false, true}) {
      std::vector<const Json*> same_way;
      for (const Json* row : rows)
        if (is_upwards(*row) == upwards && setting < (*row)["settings"].size())
          same_way.push_back(row);
      if (!same_way.empty() && first["expected"] != "unclear")
        held.push_back(held_json(same_way, setting));
    }
  return {{"claim", first["claim"]},
          {"source", first["source"]},
          {"key", first["key"]},
          {"key_unit", first["key_unit"]},
          {"verdict", claim_verdict_name(judge_claim(readings))},
          {"readings", readings.size()},
          {"agreeing", std::count(readings.begin(), readings.end(), TrendVerdict::agrees)},
          {"held", held}};
}

/// In order of first appearance.
Json claims_json(const Json& rows) {
  std::vector<std::vector<const Json*>> claims;
  for (const Json& row : rows) {
    const auto same = std::find_if(claims.begin(), claims.end(), [&](const auto& claim) {
      const Json& other = *claim[0];
      return other["claim"] == row["claim"] && other["source"] == row["source"] &&
             other["key"] == row["key"];
    });
    if (same == claims.end())
      claims.push_back({&row});
    else
      same->push_back(&row);
  }
  Json list = Json::array();
  for (const auto& claim : claims) list.push_back(claim_json(claim));
  return list;
}

}  // namespace

Json trends_json(const ReportBasis& basis) {
  Json rows = Json::array();
  std::map<std::string, int> verdicts, claim_verdicts;
  for (const Trend& trend : basis.study.plan.trends) {
    const auto cells = grid_cells(basis.study, trend.key);
    if (!cells) continue;
    const auto clearance = nominal_clearance(basis.study.plan, trend.key);
    const Column* column = find_quantity(basis.study, trend.quantity);
    Json row{
        {"claim", trend.claim},       {"source", trend.source},
        {"quantity", trend.quantity}, {"unit", column == nullptr ? "" : column->unit},
        {"key", trend.key},           {"key_unit", cells->unit},
        {"from", trend.from},         {"to", trend.to},
        {"expected", trend.expected}, {"by_share", trend.by_share},
        {"by_value", trend.by_value}, {"from_clearance", clearance_json(clearance, trend.from)}};
    row["settings"] = Json::array();
    for (std::size_t setting = 0; setting < cells->settings.size(); ++setting) {
      row["settings"].push_back(trend_json(trend, basis, *cells, setting, clearance));
      ++verdicts[row["settings"].back()["verdict"].get<std::string>()];
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return Json();
  Json claims = claims_json(rows);
  for (const Json& claim : claims) ++claim_verdicts[claim["verdict"].get<std::string>()];
  return {{"confidence", basis.confidence},
          {"claim_verdicts", claim_verdicts},
          {"claims", claims},
          {"verdicts", verdicts},
          {"rows", rows}};
}

}  // namespace cagetol
