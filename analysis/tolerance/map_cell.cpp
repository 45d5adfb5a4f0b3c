#include "analysis/tolerance/map_cell.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

double or_beyond(const std::optional<double>& width) {
  return width.value_or(HUGE_VAL);
}

}  // namespace

bool same_answer(const CellAnswer& one, const CellAnswer& other) {
  return one.candidate == other.candidate && one.decides == other.decides;
}

CellAnswer cell_answer(const Screen& screen, std::size_t dimension,
                       const std::map<double, std::string>& candidates) {
  CellAnswer answer{.reach = screen.together[dimension]};
  const auto widest = [&](const std::optional<double>& width) {
    return std::distance(candidates.begin(), candidates.lower_bound(or_beyond(width))) - 1;
  };
  answer.candidate = widest(answer.reach.width_mm);
  answer.lower = widest(answer.reach.lower_mm);
  answer.upper = widest(answer.reach.upper_mm);
  answer.resolved = answer.upper - answer.lower <= 1;
  const auto& jam = answer.reach.jam_mm;
  if (jam) answer.causes.push_back({kJams, jam, jam, jam});
  for (const ScreenedLimit& limit : screen.limits) {
    const LimitReach& reach = limit.reach[dimension];
    if (reach.lower_mm)
      answer.causes.push_back({limit.quantity, reach.width_mm, reach.lower_mm, reach.upper_mm});
  }
  auto& causes = answer.causes;
  std::ranges::stable_sort(causes, {}, [](const CellCause& of) {
    return std::pair(or_beyond(of.width_mm), or_beyond(of.lower_mm));
  });
  for (CellCause& cause : causes)
    cause.may_decide =
        &cause == &causes[0] || or_beyond(cause.lower_mm) < or_beyond(causes[0].upper_mm);
  answer.certain =
      answer.lower == answer.upper && std::ranges::count(causes, true, &CellCause::may_decide) <= 1;
  if (!causes.empty() && answer.candidate + 1 < static_cast<long>(candidates.size()))
    answer.decides = causes[0].name;
  return answer;
}

}  // namespace cagetol
