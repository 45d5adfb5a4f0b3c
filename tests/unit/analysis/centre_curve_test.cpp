#include "analysis/tolerance/centre_curve.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

CentreCurves curves_of(const StudyData& study, const std::vector<double>& tolerance_widths_mm) {
  return centre_curves(study, mixture_weights(study), {tolerance_widths_mm, {}}, judge_all(study),
                       Resampling(study, 1000), 0.999);
}

// Fails beyond lot + pocket = 0.03 mm: yield Phi((0.03 - c) / (0.01 s sqrt 2)) with the lot moved
// by c. The tolerance of 0.1 s has a sigma of 0.01 s, so a step of 1/32 is 0.3 sigma.
const StandinDimension kCurvedWidth{"cage.pocket_width_mm", 0.01, 0.01, {0.9, 1.5, 2.2}},
    kCurvedLength{"cage.pocket_length_mm", 0.01, 0.01, {0.9, 1.5}};

StudyData study_of_sum(std::int64_t rows) {
  return tolerance_standin(
      rows, 8, {kCurvedWidth, kCurvedLength}, 0.95,
      [](const StandinCage& cage) { return cage.lot[0] + cage.pocket[0][2] - 0.03; });
}

TEST(CentreCurves, FollowTheExactYield) {
  const CentreCurves curves = curves_of(study_of_sum(12000), {0.09, 0.09});
  ASSERT_EQ(curves.dimensions.size(), 2u);
  int shown = 0;
  for (const CentreYield& centre : curves.dimensions[0]) {
    if (centre.ess < kFewestEffectiveRuns) continue;
    ++shown;
    const double exact = gsl_cdf_ugaussian_P((0.03 - centre.shifts_mm[0]) / (0.009 * std::sqrt(2)));
    EXPECT_LE(centre.yield.lower_bound, exact) << centre.shifts_mm[0];
    EXPECT_GE(centre.yield.upper_bound, exact) << centre.shifts_mm[0];
    EXPECT_EQ(centre.shifts_mm[1], 0);
  }
  EXPECT_GE(shown, 5);
  for (const CentreYield& centre : curves.map)
    if (centre.ess >= kFewestEffectiveRuns) {
      const double exact =
          gsl_cdf_ugaussian_P((0.03 - centre.shifts_mm[0]) / (0.009 * std::sqrt(2)));
      EXPECT_LE(centre.yield.lower_bound, exact);
      EXPECT_GE(centre.yield.upper_bound, exact);
    }
  EXPECT_EQ(curves.map.size(), 25u);
}

TEST(CentreCurves, LoseEffectiveRunsWithTheDistance) {
  const CentreCurves curves = curves_of(study_of_sum(1500), {0.09, 0.09});
  const auto& points = curves.dimensions[0];
  for (std::size_t i = 4; i < 8; ++i) EXPECT_GT(points[i].ess, points[i + 1].ess);
  EXPECT_LT(points[8].ess, 0.5 * points[4].ess);
}

}  // namespace
}  // namespace cagetol
