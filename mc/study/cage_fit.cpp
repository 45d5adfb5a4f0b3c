#include "mc/study/cage_fit.hpp"

#include <algorithm>

#include "mc/study/operating_points.hpp"

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

bool cage_fits(const Study& study, const Scene& scene) {
  if (study.scene.allow_interference) return true;
  const CageGaps gaps = gaps_in_service(study, scene);
  return std::all_of(gaps.begin(), gaps.end(), [](const std::vector<double>& place) {
    return std::all_of(place.begin(), place.end(), [](double gap) { return gap > 0; });
  });
}

}  // namespace cagetol
