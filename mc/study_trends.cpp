#include "mc/study_trends.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "mc/operating_points.hpp"
#include "mc/study_inputs.hpp"
#include "mc/study_keys.hpp"
#include "mc/study_limits.hpp"
#include "src/quantities/quantity_labels.hpp"

namespace cagetol {
namespace {

// Levels are given in files by people: the last digits of a grid's arithmetic do not count.
constexpr double kSameLevel = 1e-9;

constexpr std::uint64_t kMostLevels = 10000;

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
  const std::vector<std::string> labels = quantity_labels(study);
  if (labelled_index(trend.quantity, labels) < 0)
    throw no_such_quantity(*entry.get("quantity"), "trend.quantity", trend.quantity, file, labels);
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

/// The lot deviations that the grid's levels give to an input. Rows with one level and one
/// candidate have equal deviations: so many rows are drawn as there are levels and candidates, not
/// the whole grid.
std::set<double> levels_of(const Study& study, const Sampler& sampler, std::size_t input,
                           const toml::table& root, const std::string& file) {
  const Design& design = sampler.design();
  const std::string column = study.inputs[input].key + ":lot";
  const auto names = design_columns(study).names;
  const auto found = std::find(names.begin(), names.end(), column);
  std::set<double> levels;
  if (found == names.end()) {  // a law of zero width
    levels.insert(sampler.draw(0).inputs[input].lot[0]);
    return levels;
  }
  const auto group = design.spec().columns[static_cast<std::size_t>(found - names.begin())].group;
  const auto& counts = design.spec().grid_levels;
  std::uint64_t stride = 1;
  for (std::size_t g = group + 1; g < counts.size(); ++g) stride *= counts[g];
  const std::uint64_t period = stride * counts[group], periods = design.rows() / period;
  const std::uint64_t candidates = std::max<std::size_t>(1, study.candidates.size());
  if (counts[group] > kMostLevels)
    throw InputError(place_of(*find_node(root, "grid_levels"), file), "grid_levels",
                     std::to_string(counts[group]),
                     "trends compare levels of " + study.inputs[input].key + ", and of these " +
                         std::to_string(kMostLevels) + " are the most",
                     "use fewer levels, or leave [[trend]] out");
  for (std::uint64_t level = 0; level < counts[group]; ++level) {
    std::set<std::uint64_t> drawn;  // candidates met with this level
    for (std::uint64_t turn = 0; turn < std::min(periods, candidates); ++turn)
      for (std::uint64_t step = 0; step < std::min(stride, candidates); ++step) {
        const std::uint64_t row = turn * period + level * stride + step;
        if (drawn.insert(row % candidates).second)
          levels.insert(sampler.draw(row).inputs[input].lot[0]);
      }
  }
  return levels;
}

std::string listed(const std::set<double>& levels) {
  constexpr std::size_t most = 20;
  std::string text;
  std::size_t count = 0;
  for (const double level : levels) {
    if (++count > most) return text + ", ... (" + std::to_string(levels.size()) + " in all)";
    text += (text.empty() ? "" : ", ") + number_text(level);
  }
  return text;
}

}  // namespace

std::vector<Trend> read_trends(const toml::table& root, const std::string& file,
                               const Study& study) {
  std::vector<Trend> trends;
  for (const auto* entry : table_entries(root, "trend", trend_keys(), file)) {
    if (study.design != DesignKind::grid)
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
    const std::set<double> levels = levels_of(study, sampler, input, root, file);
    for (const double wanted : {trend.from, trend.to}) {
      const double span = *levels.rbegin() - *levels.begin();
      if (std::any_of(levels.begin(), levels.end(),
                      [&](double level) { return std::abs(level - wanted) <= kSameLevel * span; }))
        continue;
      throw InputError(place_of(*find_node(root, "trend"), file), "trend.between",
                       number_text(wanted), "the grid has no such level of " + trend.key,
                       "its levels are " + listed(levels));
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
