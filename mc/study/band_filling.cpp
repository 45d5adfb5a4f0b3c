#include "mc/study/band_filling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

/// Below it 4.5 % of a centred normal law's parts and more lie outside their band.
constexpr double kLeastCapability = 2.0 / 3;

/// Ends of lot and pocket together about the nominal value.
bool ends_within(const UncertainInput& input, double band_mm) {
  double low = 0, high = 0;
  for (const auto* law : {&input.lot, &input.pocket})
    if (*law) {
      const Interval ends = support(**law);
      low += ends.lower;
      high += ends.upper;
    }
  const double half = band_mm / 2 * (1 + 1e-9);
  return low >= -half && high <= half;
}

void add_counterpart(const Scene& scene, BandFilling& filling) {
  if (filling.key == "cage.pocket_width_mm") {
    filling.counterpart = "the roller's diameter";
    filling.counterpart_mm =
        1e3 * *std::max_element(scene.roller.diameter.begin(), scene.roller.diameter.end());
  } else if (filling.key == "cage.pocket_length_mm") {
    filling.counterpart = "the roller's length";
    filling.counterpart_mm = 1e3 * scene.roller.length;
  }
}

}  // namespace

std::vector<BandFilling> band_fillings(const Study& study) {
  std::vector<BandFilling> fillings;
  for (const ToleranceDimension& dimension : study.tolerance.dimensions)
    for (const UncertainInput& input : study.inputs) {
      if (input.key != dimension.key) continue;
      BandFilling filling;
      filling.key = input.key;
      filling.band_mm = dimension.band_mm;
      const auto [least, most] = std::minmax_element(input.nominal.begin(), input.nominal.end());
      if (*least == *most) filling.nominal_mm = *least;
      filling.deviation_mm = std::hypot(input.lot ? standard_deviation(*input.lot) : 0,
                                        input.pocket ? standard_deviation(*input.pocket) : 0);
      filling.capability = dimension.band_mm / (6 * filling.deviation_mm);
      filling.within = ends_within(input, dimension.band_mm);
      add_counterpart(study.scene, filling);
      fillings.push_back(filling);
    }
  return fillings;
}

std::vector<std::string> band_warnings(const Study& study) {
  std::vector<std::string> warnings;
  for (const BandFilling& filling : band_fillings(study))
    if (filling.capability < kLeastCapability && !filling.within)
      warnings.push_back(fmt::format(
          "{}: so many parts lie outside their band that no inspection would pass them; give "
          "band_mm of the drawing that the laws were measured under, or narrower laws",
          filling.key));
  return warnings;
}

std::vector<std::string> band_notes(const Study& study) {
  std::vector<std::string> notes;
  const auto fillings = band_fillings(study);
  for (std::size_t d = 0; d < fillings.size(); ++d) {
    const BandFilling& filling = fillings[d];
    double narrowest = std::numeric_limits<double>::infinity(), reached = 0;
    for (const Candidate& candidate : study.candidates) {
      const double shift = candidate.shifts.empty() ? 0 : candidate.shifts[d];
      const double smallest = filling.nominal_mm + shift - candidate.bands_mm[d] / 2;
      if (!(smallest < filling.counterpart_mm) || candidate.bands_mm[d] >= narrowest) continue;
      narrowest = candidate.bands_mm[d];
      reached = smallest;
    }
    if (std::isfinite(narrowest))
      notes.push_back(fmt::format(
          "{}: from a band of {:.6g} mm on, a part inside its band may be as small as {:.6g} mm, "
          "less than {} of {:.6g} mm; that such parts are rare is what the laws say (Cp = {:.2f}), "
          "not the drawing",
          filling.key, narrowest, reached, filling.counterpart, filling.counterpart_mm,
          filling.capability));
  }
  return notes;
}

}  // namespace cagetol
