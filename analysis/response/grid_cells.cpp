#include "analysis/response/grid_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/sensitivity/features.hpp"

namespace cagetol {
namespace {

std::vector<double> distinct(const std::vector<double>& values) {
  const std::set<double> ascending(values.begin(), values.end());
  return {ascending.begin(), ascending.end()};
}

/// Distinct group names in order of first appearance.
std::vector<std::string> group_names(const StudyDesign& design) {
  std::vector<std::string> names;
  for (const std::string& group : design.groups)
    if (std::find(names.begin(), names.end(), group) == names.end()) names.push_back(group);
  return names;
}

/// Group of a key's lot column; empty where it has none.
std::string group_of(const StudyDesign& design, const std::string& key) {
  for (std::size_t c = 0; c < design.columns.size(); ++c)
    if (design.columns[c] == key + ":lot") return design.groups[c];
  return {};
}

/// Design coordinate of the first column of a group, for each sample: equal where the level is.
std::vector<double> coordinate(const StudyData& study, const std::string& group) {
  const auto& groups = study.design.groups;
  const auto column =
      static_cast<std::size_t>(std::find(groups.begin(), groups.end(), group) - groups.begin());
  std::vector<double> values;
  for (std::size_t i = 0; i < study.size(); ++i)
    values.push_back(study.design.point[i * groups.size() + column]);
  return values;
}

/// "bearing misalignment z 2 mrad" for every input of the group that varies by lot.
std::string setting_text(const StudyData& study, const std::string& group, std::size_t sample) {
  std::string text;
  for (const InputColumns& input : study.inputs) {
    if (group_of(study.design, input.key) != group) continue;
    const double value = input.value[input.per_pocket ? sample * study.pockets : sample];
    text += fmt::format("{}{} {:.6g}{}", text.empty() ? "" : ", ", plain_name(input.key), value,
                        input.unit == "-" ? "" : " " + input.unit);
  }
  return text.empty() ? group : text;
}

}  // namespace

std::vector<std::size_t> GridCells::samples(std::size_t setting, std::size_t level) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < level_of.size(); ++i)
    if (level_of[i] == level && setting_of[i] == setting) found.push_back(i);
  return found;
}

std::optional<GridCells> grid_cells(const StudyData& study, const std::string& key) {
  const InputColumns* input = find_input(study, key);
  const std::string group = group_of(study.design, key);
  if (study.design.kind != "grid" || input == nullptr || group.empty() || study.size() == 0)
    return std::nullopt;
  GridCells cells;
  cells.key = key;
  cells.unit = input->unit;
  cells.levels = distinct(input->lot);
  for (const double deviation : input->lot)
    cells.level_of.push_back(static_cast<std::size_t>(
        std::lower_bound(cells.levels.begin(), cells.levels.end(), deviation) -
        cells.levels.begin()));
  cells.setting_of.assign(study.size(), 0);
  std::vector<std::string> words(study.size());
  for (const std::string& other : group_names(study.design)) {
    if (other == group) continue;
    const auto values = coordinate(study, other), levels = distinct(values);
    for (std::size_t i = 0; i < study.size(); ++i) {
      const auto level = std::lower_bound(levels.begin(), levels.end(), values[i]) - levels.begin();
      cells.setting_of[i] = cells.setting_of[i] * levels.size() + static_cast<std::size_t>(level);
      words[i] += (words[i].empty() ? "" : "; ") + setting_text(study, other, i);
    }
  }
  // Settings without a run yet have no name and no number.
  const std::set<std::size_t> used(cells.setting_of.begin(), cells.setting_of.end());
  for (const std::size_t setting : used) {
    const auto first = std::find(cells.setting_of.begin(), cells.setting_of.end(), setting);
    cells.settings.push_back(words[static_cast<std::size_t>(first - cells.setting_of.begin())]);
  }
  for (std::size_t& setting : cells.setting_of)
    setting = static_cast<std::size_t>(std::distance(used.begin(), used.find(setting)));
  return cells;
}

std::string response_key(const StudyData& study) {
  if (study.design.kind != "grid") return {};
  std::string best;
  std::size_t most = 1;
  for (const InputColumns& input : study.inputs)
    if (const auto levels = distinct(input.lot); levels.size() > most)
      most = levels.size(), best = input.key;
  return best;
}

}  // namespace cagetol
