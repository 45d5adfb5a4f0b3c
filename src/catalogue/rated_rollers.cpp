#include "src/catalogue/rated_rollers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/catalogue/scene_text.hpp"
#include "src/input/input_error.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

constexpr double kUprated = 1.15;
constexpr double kFilled = 0.82;         // of the pitch circle
constexpr double kShortest = 0.86;       // L_we/D_we
constexpr double kLongest = 0.78;        // L_we/B
constexpr long kFewest = 6;              // rollers
constexpr double kLengthStep = 0.05e-3;  // [m]
constexpr double kDiameterStep = 0.5e-3;
constexpr double kMinimumFlange = 0.1, kMostFlange = 0.3;  // height of a flange over D_we

double rounded(double value, double step) {
  return step * std::round(value / step);
}

double worst(const RatedSet& set) {
  return std::max(std::abs(set.dynamic_error), std::abs(set.static_error));
}

/// C by ISO 281, raised where the catalogue's is.
double raised_rating(const CatalogueRow& row, const RatedRollers& rollers) {
  return (row.uprated ? kUprated : 1) * dynamic_rating(rollers);
}

RatedSet set_of(const CatalogueRow& row, const RollerDiameter& roller, long count) {
  RatedSet set{{count, roller.diameter, 1e-3, roller.pitch_diameter}};
  RatedRollers& r = set.rollers;
  const double for_dynamic = std::pow(row.dynamic_rating / raised_rating(row, r), 9.0 / 7),
               for_static = row.static_rating / static_rating(r);
  r.length = rounded(r.length * std::sqrt(for_dynamic * for_static), kLengthStep);
  set.dynamic_error = raised_rating(row, r) / row.dynamic_rating - 1;
  set.static_error = static_rating(r) / row.static_rating - 1;
  return set;
}

std::string percent(double share) {
  return number_text(std::round(1000 * share) / 10) + " %";
}

InputError unmet(const CatalogueRow& row, double error) {
  return InputError({}, "DESIGNATION", row.designation,
                    "no number and length of rollers give both load ratings: C by ISO 281 and C0 "
                    "by ISO 76 are off by up to " +
                        percent(error) + ", more than " + percent(kRatingError),
                    "write the scene by hand from the maker's drawing");
}

RollerDiameter diameter_of(const CatalogueRow& row, double diameter, bool from_ratings) {
  const double outer = row.inner_raceway + 2 * diameter;
  return {diameter, outer, (outer + row.inner_raceway) / 2, from_ratings};
}

}  // namespace

double rating_factor(const CatalogueRow& row) {
  return 1.1 * (row.uprated ? kUprated : 1);
}

long most_rollers(const RollerDiameter& roller) {
  return std::lround(
      std::floor(kFilled * std::numbers::pi * roller.pitch_diameter / roller.diameter));
}

RollerDiameter roller_diameter(const CatalogueRow& row) {
  if (!std::isnan(row.outer_raceway))
    return {(row.outer_raceway - row.inner_raceway) / 2, row.outer_raceway,
            (row.outer_raceway + row.inner_raceway) / 2};
  // D_1 = E - 2 h D_we, h the height of a flange over D_we.
  const double shoulder = row.outer_shoulder - row.inner_raceway;
  RollerDiameter best;
  double error = 1e9;
  for (double d = kDiameterStep * std::ceil(shoulder / (2 - 2 * kMinimumFlange) / kDiameterStep);
       d <= shoulder / (2 - 2 * kMostFlange); d += kDiameterStep) {
    const RollerDiameter tried = diameter_of(row, d, true);
    const double missed = worst(set_of(row, tried, most_rollers(tried)));
    if (missed < error) error = missed, best = tried;
  }
  if (!(error <= kRatingError)) throw unmet(row, error);
  return best;
}

RatedSet rated_set(const CatalogueRow& row, const RollerDiameter& roller, long most) {
  RatedSet set = set_of(row, roller, std::max(most, kFewest));
  while (set.rollers.count > kFewest && set.rollers.length < kShortest * roller.diameter)
    set = set_of(row, roller, set.rollers.count - 1);
  if (set.rollers.length > kLongest * row.width)
    throw InputError({}, "DESIGNATION", row.designation,
                     std::to_string(set.rollers.count) + " rollers would have to be " +
                         number_text(in_mm(set.rollers.length)) +
                         " mm long to give the load ratings, and the bearing is " +
                         number_text(in_mm(row.width)) + " mm wide",
                     "choose another --guidance or --cage, which leaves room for more rollers");
  if (worst(set) > kRatingError) throw unmet(row, worst(set));
  return set;
}

}  // namespace cagetol
