// Share of no feature: linear laws whose residual variance is known.
#include "analysis/sensitivity/unexplained_share.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "distributions/basics/random_stream.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

/// Of five features, two of the lot and three of the cage, three drive the output: straight lines and
/// a parabola. Half of the rest is that of the lot.
struct FittedCages {
  std::vector<Feature> features = std::vector<Feature>(5);
  std::vector<double> output;
};
FittedCages draw_fitted(std::size_t runs, std::size_t cages_per_lot, double unexplained,
                        int repeat) {
  FittedCages drawn;
  std::vector<double> lot(3);
  for (std::size_t i = 0; i < runs; ++i) {
    RandomStream stream(300 + static_cast<std::uint64_t>(repeat), Purpose::lot, i);
    const auto normal = [&] { return gsl_cdf_ugaussian_Pinv(stream.next()); };
    std::vector<double> x(5);
    for (double& value : x) value = normal();
    if (i % cages_per_lot == 0)
      for (double& value : lot) value = normal();
    x[0] = lot[0], x[1] = lot[1];
    for (std::size_t f = 0; f < 5; ++f) drawn.features[f].values.push_back(x[f]);
    const double explained = 0.8 * x[0] + 0.36 * (x[2] * x[2] - 1) / std::sqrt(2) + 0.48 * x[3];
    drawn.output.push_back(std::sqrt(1 - unexplained) * explained +
                           std::sqrt(unexplained / 2) * (lot[2] + normal()));
  }
  return drawn;
}

/// Mean estimate, and the percentage of 400 repeats whose interval holds the share.
std::pair<double, double> unexplained_coverage(std::size_t runs, std::size_t cages_per_lot,
                                               double share) {
  double mean = 0, held = 0;
  for (int repeat = 0; repeat < 400; ++repeat) {
    const FittedCages drawn = draw_fitted(runs, cages_per_lot, share, repeat);
    const Resampling resampling(plain_study(static_cast<std::int64_t>(runs), "random",
                                            static_cast<std::int64_t>(cages_per_lot), repeat + 1),
                                2);
    const Estimate estimate = unexplained_share(drawn.features, drawn.output, resampling, 0.95);
    mean += estimate.value / 400;
    held += (estimate.lower <= share && share <= estimate.upper) / 4.0;
  }
  return {mean, held};
}

TEST(UnexplainedShare, IntervalsCoverTheTruth) {
  for (const double share : {0.15, 0.5, 0.85, 1.0})
    for (const std::size_t cages : {1, 5}) {
      const auto [mean, held] = unexplained_coverage(300, cages, share);

      EXPECT_NEAR(mean, share, 0.04) << share << " " << cages;
      EXPECT_GE(held, 90) << share << " " << cages;
    }
}

TEST(UnexplainedShare, RunsWithoutValueAreLeftOut) {
  FittedCages drawn = draw_fitted(600, 1, 0.5, 0);
  for (std::size_t i = 0; i < 600; i += 3) drawn.output[i] = NAN;
  const Resampling resampling(plain_study(600), 2);
  const double share = unexplained_share(drawn.features, drawn.output, resampling, 0.95).value;
  EXPECT_NEAR(share, 0.5, 0.08);
}

TEST(UnexplainedShare, FewRunsLeaveItUndefined) {
  const FittedCages drawn = draw_fitted(8, 1, 0.5, 0);
  const Resampling resampling(plain_study(8), 2);
  EXPECT_TRUE(std::isnan(unexplained_share(drawn.features, drawn.output, resampling, 0.95).value));
}

}  // namespace
}  // namespace cagetol
