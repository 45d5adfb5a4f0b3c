#include "mc/study/tolerance_filling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

/// Below it 4.5 % of a centred normal law's parts and more lie outside their tolerance.
constexpr double kMinimumCapability = 2.0 / 3;

/// Ends of lot and pocket together about the nominal value.
bool ends_within(const UncertainInput& input, double tolerance_width_mm) {
  double low = 0, high = 0;
  for (const auto* law : {&input.lot, &input.pocket})
    if (*law) {
      const Interval ends = support(**law);
      low += ends.lower;
      high += ends.upper;
    }
  const double half = tolerance_width_mm / 2 * (1 + 1e-9);
  return low >= -half && high <= half;
}

void add_counterpart(const Scene& scene, ToleranceFilling& filling) {
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

std::vector<ToleranceFilling> tolerance_fillings(const Study& study) {
  std::vector<ToleranceFilling> fillings;
  for (const ToleranceDimension& dimension : study.tolerance.dimensions)
    for (const UncertainInput& input : study.inputs) {
      if (input.key != dimension.key) continue;
      ToleranceFilling filling;
      filling.key = input.key;
      filling.tolerance_width_mm = dimension.tolerance_width_mm;
      const auto [minimum, most] = std::minmax_element(input.nominal.begin(), input.nominal.end());
      if (*minimum == *most) filling.nominal_mm = *minimum;
      filling.deviation_mm = std::hypot(input.lot ? standard_deviation(*input.lot) : 0,
                                        input.pocket ? standard_deviation(*input.pocket) : 0);
      filling.mean_mm =
          (input.lot ? mean(*input.lot) : 0) + (input.pocket ? mean(*input.pocket) : 0);
      filling.capability = dimension.tolerance_width_mm / (6 * filling.deviation_mm);
      filling.within = ends_within(input, dimension.tolerance_width_mm);
      add_counterpart(study.scene, filling);
      fillings.push_back(filling);
    }
  return fillings;
}

std::vector<std::string> tolerance_warnings(const Study& study) {
  std::vector<std::string> warnings;
  for (const ToleranceFilling& filling : tolerance_fillings(study)) {
    if (std::abs(filling.mean_mm) > filling.tolerance_width_mm / 2)
      warnings.push_back(fmt::format(
          "{}: the mean of its laws lies {:.4g} mm from the nominal value, outside their tolerance "
          "of {:.4g} mm, and every candidate scales both; give the nominal value that the parts "
          "have, centred = true for measured ones, or the tolerance_width_mm that they fill",
          filling.key, filling.mean_mm, filling.tolerance_width_mm));
    if (filling.capability < kMinimumCapability && !filling.within)
      warnings.push_back(fmt::format(
          "{}: so many parts lie outside their tolerance that no inspection would pass them; give "
          "tolerance_width_mm of the drawing that the laws were measured under, or narrower laws",
          filling.key));
  }
  return warnings;
}

std::vector<std::string> tolerance_notes(const Study& study) {
  std::vector<std::string> notes;
  const auto fillings = tolerance_fillings(study);
  for (std::size_t d = 0; d < fillings.size(); ++d) {
    const ToleranceFilling& filling = fillings[d];
    double narrowest = std::numeric_limits<double>::infinity(), reached = 0;
    for (const Candidate& candidate : study.candidates) {
      const double smallest =
          filling.nominal_mm + candidate.shift(d) - candidate.tolerance_widths_mm[d] / 2;
      if (!(smallest < filling.counterpart_mm) || candidate.tolerance_widths_mm[d] >= narrowest)
        continue;
      narrowest = candidate.tolerance_widths_mm[d];
      reached = smallest;
    }
    if (std::isfinite(narrowest))
      notes.push_back(fmt::format(
          "{}: from a tolerance of {:.6g} mm on, a part inside its tolerance may be as small as "
          "{:.6g} mm, "
          "less than {} of {:.6g} mm; that such parts are rare is what the laws say (Pp = {:.2f}), "
          "not the drawing",
          filling.key, narrowest, reached, filling.counterpart, filling.counterpart_mm,
          filling.capability));
  }
  return notes;
}

}  // namespace cagetol
