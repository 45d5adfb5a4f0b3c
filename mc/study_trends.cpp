#include "mc/study_trends.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "mc/study_inputs.hpp"
#include "mc/study_keys.hpp"
#include "mc/study_limits.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

// Levels are given in files by people: the last digits of a grid's arithmetic do not count.
constexpr double kSameLevel = 1e-9;

const KeyInfo& info(const std::string& name) {
  return info_of(trend_keys(), "trend." + name);
}

std::string required_text(const toml::table& entry, const std::string& name,
                          const std::string& file) {
  const auto* node = entry.get(name);
  if (!node)
    throw InputError(place_of(entry, file), "trend." + name, "", "this is missing",
                     "add " + name + " = \"...\": " + info(name).meaning);
  return text_value(info(name), *node, file);
}

void read_levels(const toml::table& entry, const std::string& file, Trend& trend) {
  const auto* node = entry.get("between");
  const auto* levels = node ? node->as_array() : nullptr;
  if (!levels || levels->size() != 2 || !(*levels)[0].is_number() || !(*levels)[1].is_number())
    throw InputError(place_of(node ? *node : entry, file), "trend.between",
                     node ? shown(*node) : "", "expected two deviations",
                     "write between = [0, -0.2]: from the first to the second, in the key's unit");
  trend.from = number_value(info("between"), (*levels)[0], file);
  trend.to = number_value(info("between"), (*levels)[1], file);
}

Trend read_trend(const toml::table& entry, const std::string& file, const Study& study) {
  Trend trend;
  trend.claim = required_text(entry, "claim", file);
  trend.source = required_text(entry, "source", file);
  trend.quantity = required_text(entry, "quantity", file);
  if (quantity_index(trend.quantity) < 0)
    throw no_such_quantity(*entry.get("quantity"), "trend.quantity", trend.quantity, file);
  trend.expected = required_text(entry, "expected", file);
  trend.key = required_text(entry, "key", file);
  if (find_input_scope(study.inputs, trend.key + ":lot").input < 0)
    throw InputError(place_of(*entry.get("key"), file), "trend.key", trend.key,
                     "this key does not vary by lot in this study",
                     "name a key of the scene that has a law `lot`");
  read_levels(entry, file, trend);
  if (const auto* node = entry.get("by_share"))
    trend.by_share = number_value(info("by_share"), *node, file);
  if (const auto* node = entry.get("by_value"))
    trend.by_value = number_value(info("by_value"), *node, file);
  if (trend.by_share > 0 && trend.by_value > 0)
    throw InputError(place_of(entry, file), "trend", shown(entry),
                     "by_share and by_value are both given", "keep one");
  if (trend.expected == "level" && trend.by_share == 0 && trend.by_value == 0)
    throw InputError(place_of(entry, file), "trend", shown(entry),
                     "nothing says how small a change counts as none",
                     "add by_share (of the quantity's mean) or by_value (in its unit)");
  return trend;
}

}  // namespace

std::vector<Trend> read_trends(const toml::table& root, const std::string& file,
                               const Study& study) {
  std::vector<Trend> trends;
  for (const auto* entry : table_entries(root, "trend", trend_keys(), file)) {
    if (study.design != "grid")
      throw InputError(place_of(*entry, file), "trend", shown(*entry),
                       "trends compare levels, and this design has none",
                       "write design = \"grid\" and grid_levels");
    trends.push_back(read_trend(*entry, file, study));
  }
  return trends;
}

void check_trend_levels(const Study& study, const Sampler& sampler, const toml::table& root,
                        const std::string& file) {
  for (const Trend& trend : study.trends) {
    const auto input =
        static_cast<std::size_t>(find_input_scope(study.inputs, trend.key + ":lot").input);
    std::set<double> levels;
    for (std::uint64_t row = 0; row < static_cast<std::uint64_t>(study.samples); ++row)
      levels.insert(sampler.draw(row).inputs[input].lot[0]);
    for (const double wanted : {trend.from, trend.to}) {
      const double span = *levels.rbegin() - *levels.begin();
      if (std::any_of(levels.begin(), levels.end(),
                      [&](double level) { return std::abs(level - wanted) <= kSameLevel * span; }))
        continue;
      std::string known;
      for (const double level : levels) known += (known.empty() ? "" : ", ") + number_text(level);
      throw InputError(place_of(*find_node(root, "trend"), file), "trend.between",
                       number_text(wanted), "the grid has no such level of " + trend.key,
                       "its levels are " + known);
    }
  }
}

toml::table trend_table(const Trend& trend) {
  return toml::table{{"claim", trend.claim},       {"quantity", trend.quantity},
                     {"key", trend.key},           {"between", toml::array{trend.from, trend.to}},
                     {"expected", trend.expected}, {"by_share", trend.by_share},
                     {"by_value", trend.by_value}, {"source", trend.source}};
}

}  // namespace cagetol
