#include "mc/study/cage_fit.hpp"

#include <algorithm>
#include <cmath>

#include "mc/study/operating_points.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {

CageGaps gaps_in_service(const Study& study, const Scene& scene) {
  if (study.points.empty()) return cage_gaps(scene);
  CageGaps least = cage_gaps(at_operating_point(scene, study.points.front()));
  for (std::size_t p = 1; p < study.points.size(); ++p) {
    const CageGaps gaps = cage_gaps(at_operating_point(scene, study.points[p]));
    for (std::size_t place = 0; place < kGapPlaces; ++place)
      for (std::size_t j = 0; j < gaps[place].size(); ++j)
        least[place][j] = std::min(least[place][j], gaps[place][j]);
  }
  return least;
}

GapSlopes gap_slopes(const Study& study, const UncertainInput& input) {
  double step = 0;
  for (const auto* law : {&input.lot, &input.pocket, &input.noise})
    if (*law) step = std::hypot(step, standard_deviation(**law));
  const auto gaps_at = [&](double deviation) {
    Scene scene = study.scene;
    std::vector<double> values = input.nominal;
    for (double& value : values) value += deviation;
    set_key_numbers(*find_key(scene_keys(), input.key), values, scene);
    return gaps_in_service(study, scene);
  };
  const CageGaps above = gaps_at(step), below = gaps_at(-step);
  GapSlopes slopes{};
  for (std::size_t place = 0; place < kGapPlaces; ++place)
    if (!above[place].empty() && std::abs(above[place][0] - below[place][0]) > kSmallestEffect)
      slopes[place] = (above[place][0] - below[place][0]) / (2 * step);
  return slopes;
}

bool cage_fits(const Study& study, const Scene& scene) {
  if (study.scene.allow_interference) return true;
  const CageGaps gaps = gaps_in_service(study, scene);
  return std::all_of(gaps.begin(), gaps.end(), [](const std::vector<double>& place) {
    return std::all_of(place.begin(), place.end(), [](double gap) { return gap > 0; });
  });
}

}  // namespace cagetol
