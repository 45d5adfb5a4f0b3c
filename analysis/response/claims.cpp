#include "analysis/response/claims.hpp"

#include <algorithm>

namespace cagetol {
namespace {

/// The roller's dimension that lies in a dimension of the pocket.
struct Fit {
  const char *pocket, *roller;
};
constexpr Fit kFits[] = {{"cage.pocket_width_mm", "diameter_mm"},
                         {"cage.pocket_length_mm", "length_mm"}};

/// A number, or the one that all elements of an array share.
std::optional<double> single_number(const nlohmann::ordered_json& value) {
  if (value.is_number()) return value.get<double>();
  if (!value.is_array() || value.empty() || !value[0].is_number()) return std::nullopt;
  if (std::any_of(value.begin(), value.end(), [&](const auto& each) { return each != value[0]; }))
    return std::nullopt;
  return value[0].get<double>();
}

}  // namespace

const char* claim_verdict_name(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::agrees:
      return "agrees";
    case ClaimVerdict::in_part:
      return "agrees in part";
    case ClaimVerdict::disagrees:
      return "disagrees";
    case ClaimVerdict::undecided:
      return "undecided";
    case ClaimVerdict::no_claim:
      return "no claim";
    case ClaimVerdict::no_values:
      return "no values";
  }
  return "unknown";
}

ClaimVerdict judge_claim(std::span<const TrendVerdict> readings) {
  const auto count = [&](TrendVerdict verdict) {
    return static_cast<std::size_t>(std::count(readings.begin(), readings.end(), verdict));
  };
  if (count(TrendVerdict::no_values) == readings.size()) return ClaimVerdict::no_values;
  if (count(TrendVerdict::no_claim) > 0) return ClaimVerdict::no_claim;
  const std::size_t agreeing = count(TrendVerdict::agrees);
  if (agreeing == readings.size()) return ClaimVerdict::agrees;
  if (agreeing > 0) return ClaimVerdict::in_part;
  return count(TrendVerdict::disagrees) > 0 ? ClaimVerdict::disagrees : ClaimVerdict::undecided;
}

std::vector<std::size_t> levels_towards(const GridCells& cells, double from, double to) {
  std::vector<std::size_t> levels;
  const auto start = cells.find_level(from);
  if (!start) return levels;
  if (to > from)
    for (std::size_t l = *start + 1; l < cells.levels.size(); ++l) levels.push_back(l);
  else
    for (std::size_t l = *start; l-- > 0;) levels.push_back(l);
  return levels;
}

std::vector<std::pair<std::size_t, std::size_t>> unbroken(const std::vector<bool>& holds) {
  std::vector<std::pair<std::size_t, std::size_t>> rows;
  for (std::size_t i = 0; i < holds.size(); ++i) {
    if (!holds[i]) continue;
    if (i > 0 && holds[i - 1])
      rows.back().second = i;
    else
      rows.emplace_back(i, i);
  }
  return rows;
}

std::optional<double> nominal_clearance(const StudyPlan& plan, const std::string& key) {
  const auto fit = std::find_if(std::begin(kFits), std::end(kFits),
                                [&](const Fit& f) { return key == f.pocket; });
  if (fit == std::end(kFits) || !plan.scene.contains("roller") ||
      !plan.scene["roller"].contains(fit->roller))
    return std::nullopt;
  const auto roller = single_number(plan.scene["roller"][fit->roller]);
  for (const InputPlan& input : plan.inputs)
    if (input.key == key && roller) {
      const auto pocket = single_number(input.nominal);
      if (pocket) return *pocket - *roller;
    }
  return std::nullopt;
}

}  // namespace cagetol
