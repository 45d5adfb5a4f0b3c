#include "src/cage/mesh/cage_grid.hpp"

#include <algorithm>
#include <cmath>

#include "src/cage/mesh/sector_polynomial.hpp"

namespace cagetol {
namespace {

/// Steps from the middle of the grid to its end, where the range of the nominal table ends. Half a
/// step in both directions shifts peak stresses by less than 3 % (tests/ACCURACY.md).
constexpr GridPoint kSteps{.width = 4, .length = 6};

/// Width and length of one step [m].
PocketDeviation grid_step(const CageDimensions& nominal) {
  const PocketDeviation range = table_range(nominal);
  return {.width = range.width / static_cast<double>(kSteps.width),
          .length = range.length / static_cast<double>(kSteps.length)};
}

}  // namespace

CageDimensions cage_at(const CageDimensions& nominal, const GridPoint& point) {
  const PocketDeviation step = grid_step(nominal);
  CageDimensions cage = nominal;
  cage.pocket_width += static_cast<double>(point.width) * step.width;
  cage.pocket_length += static_cast<double>(point.length) * step.length;
  return cage;
}

GridPoint nearest_point(const CageDimensions& nominal,
                        const std::vector<PocketDeviation>& deviations) {
  if (cage_fault(nominal, deviations)) return {};
  const PocketDeviation step = grid_step(nominal);
  const auto nearest = [&](double PocketDeviation::*dimension, long most) {
    double sum = 0;
    for (const PocketDeviation& deviation : deviations) sum += deviation.*dimension;
    const double steps = sum / static_cast<double>(deviations.size()) / (step.*dimension);
    return std::clamp(std::lround(steps), -most, most);
  };
  const GridPoint point{.width = nearest(&PocketDeviation::width, kSteps.width),
                        .length = nearest(&PocketDeviation::length, kSteps.length)};
  return cage_fault(cage_at(nominal, point), {PocketDeviation{}}) ? GridPoint{} : point;
}

}  // namespace cagetol
