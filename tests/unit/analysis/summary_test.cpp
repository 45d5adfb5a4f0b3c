#include "analysis/statistics/summary.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

#include "distributions/design.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

TEST(Summary, QuantilesOfScramblesAreCovered) {
  // Sum of two normal inputs, 8 scrambles of 32 points: a scramble has a third of a run beyond its
  // outer quantiles. Student's t over the scrambles' own quantiles covered 86.5 and 88 % there.
  constexpr int repeats = 500;
  DesignSpec spec;
  spec.kind = DesignKind::sobol;
  spec.rows = 256;
  spec.columns = {{Purpose::lot, 0, 0}, {Purpose::lot, 1, 0}};
  std::vector<double> held(std::size(kQuantileLevels));
  for (int repeat = 0; repeat < repeats; ++repeat) {
    spec.seed = static_cast<std::uint64_t>(repeat) + 1;
    const Design design(spec);
    StudyData study = plain_study(256, "sobol");
    study.design.scrambles = 8;
    std::vector<double> values, u(2);
    for (std::uint64_t row = 0; row < spec.rows; ++row) {
      design.point(row, u);
      values.push_back((gsl_cdf_ugaussian_Pinv(u[0]) + gsl_cdf_ugaussian_Pinv(u[1])) /
                       std::sqrt(2));
    }
    const Summary summary = summarise(study, values, Resampling(study, 0), 0.95);
    for (std::size_t q = 0; q < held.size(); ++q) {
      const double exact = gsl_cdf_ugaussian_Pinv(kQuantileLevels[q]);
      const Estimate& quantile = summary.quantiles[q];
      held[q] += (quantile.lower <= exact && exact <= quantile.upper) * 100.0 / repeats;
    }
  }
  for (std::size_t q = 0; q < held.size(); ++q) EXPECT_GE(held[q], 91) << kQuantileLevels[q];
}

}  // namespace
}  // namespace cagetol
