#include "analysis/sensitivity/morris.hpp"

#include <cmath>
#include <map>

#include "analysis/study/design_blocks.hpp"
#include "analysis/study/refused.hpp"

namespace cagetol {
namespace {

/// Column by which two neighbouring rows of a trajectory differ first; npos for equal points.
std::size_t first_moved(const StudyDesign& design, std::size_t before, std::size_t after) {
  const std::size_t width = design.columns.size();
  for (std::size_t c = 0; c < width; ++c)
    if (design.point[before * width + c] != design.point[after * width + c]) return c;
  return std::string::npos;
}

ElementaryEffects effects_of(const std::string& group, const std::vector<double>& effects) {
  ElementaryEffects result{group, effects.size()};
  const auto count = static_cast<double>(effects.size());
  if (effects.empty()) return result;
  result.mean = result.mean_magnitude = 0;
  for (const double effect : effects) {
    result.mean += effect / count;
    result.mean_magnitude += std::abs(effect) / count;
  }
  if (effects.size() < 2) return result;
  double square = 0;
  for (const double effect : effects) square += (effect - result.mean) * (effect - result.mean);
  result.scatter = std::sqrt(square / (count - 1));
  return result;
}

}  // namespace

std::vector<ElementaryEffects> elementary_effects(const StudyData& runs,
                                                  std::span<const double> output) {
  if (runs.design.kind != "morris")
    throw Refused("elementary effects need a morris design, this is `" + runs.design.kind + "`");
  const auto length = static_cast<std::int64_t>(design_blocks(runs).rows_per_base);
  const std::size_t width = runs.design.columns.size();
  std::map<std::string, std::vector<double>> effects;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const bool neighbours = runs.row[i] == runs.row[i - 1] + 1 && runs.row[i] % length != 0;
    if (!neighbours || std::isnan(output[i]) || std::isnan(output[i - 1])) continue;
    const std::size_t column = first_moved(runs.design, i - 1, i);
    if (column == std::string::npos) continue;
    const double delta =
        runs.design.point[i * width + column] - runs.design.point[(i - 1) * width + column];
    effects[runs.design.groups[column]].push_back((output[i] - output[i - 1]) / delta);
  }
  std::vector<ElementaryEffects> all;
  for (const std::string& group : group_names(runs.design))
    all.push_back(effects_of(group, effects[group]));
  return all;
}

}  // namespace cagetol
