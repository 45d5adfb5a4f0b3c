#include "analysis/statistics/resampling.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/summary.hpp"
#include "distributions/basics/random_stream.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

double normal(RandomStream& stream) {
  return gsl_cdf_ugaussian_Pinv(stream.next());
}

/// Mean of cages that share a lot part of variance 1, with parts of their own of variance 0.25.
std::vector<double> lot_values(const StudyData& study, std::uint64_t repeat) {
  std::vector<double> values;
  for (std::size_t i = 0; i < study.size(); ++i) {
    RandomStream lot(repeat, Purpose::lot, static_cast<std::uint64_t>(study.lot[i]));
    RandomStream own(repeat, Purpose::pocket, static_cast<std::uint64_t>(study.row[i]));
    values.push_back(normal(lot) + 0.5 * normal(own));
  }
  return values;
}

TEST(Resampling, SameStudySameInterval) {
  const StudyData study = plain_study(100);
  const auto values = lot_values(study, 1);
  const auto mean = [&](std::span<const double> w) { return weighted_mean(values, w); };
  const Estimate first = Resampling(study, 200).estimate(mean, 0.95),
                 second = Resampling(study, 200).estimate(mean, 0.95);
  EXPECT_EQ(first.lower, second.lower);
  EXPECT_EQ(first.upper, second.upper);
  EXPECT_LT(first.lower, first.value);
  EXPECT_GT(first.upper, first.value);
}

TEST(Resampling, IntervalOfMeanCoversWithLots) {
  int covered = 0;
  const int repeats = 200;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const StudyData study = plain_study(240, "random", 4, repeat + 1);
    const auto values = lot_values(study, static_cast<std::uint64_t>(repeat));
    const Estimate mean =
        Resampling(study, 200)
            .estimate([&](std::span<const double> w) { return weighted_mean(values, w); }, 0.95);
    covered += mean.lower <= 0 && 0 <= mean.upper;
  }
  EXPECT_GE(covered, 180);
  EXPECT_LE(covered, 199);
}

TEST(Resampling, StandardErrorOfAMeanOfLots) {
  // Four cages to a lot: variance 1 / lots + 0.25 / cages; independent cages would give 0.07.
  const StudyData study = plain_study(240, "random", 4);
  const auto values = lot_values(study, 5);
  const Resampling resampling(study, 1000);
  EXPECT_NEAR(resampling.standard_error(
                  [&](std::span<const double> w) { return weighted_mean(values, w); }),
              std::sqrt(1.0 / 60 + 0.25 / 240), 0.02);
  EXPECT_TRUE(std::isnan(
      Resampling(plain_study(240, "grid"), 1000).standard_error([](std::span<const double>) {
        return 1.0;
      })));
}

TEST(Resampling, FormerDesignsHaveNoInterval) {
  for (const char* design : {"grid", "sobol"}) {
    const StudyData study = plain_study(40, design);
    const std::vector<double> values(40, 1.0);
    const Estimate mean =
        Resampling(study, 100)
            .estimate([&](std::span<const double> w) { return weighted_mean(values, w); }, 0.95);
    EXPECT_EQ(mean.value, 1) << design;
    EXPECT_TRUE(std::isnan(mean.lower)) << design;
  }
}

TEST(Resampling, SaysWhyThereAreNoIntervals) {
  EXPECT_EQ(Resampling(plain_study(40, "random", 10), 20).description(),
            "none: 4 lots, fewer than 8, say too little of their scatter");
  EXPECT_EQ(Resampling(plain_study(40, "sobol"), 20).description(),
            "none: this program knows no interval of this design");
}

TEST(Resampling, SaysThatItDoesNotSeeTheGainOfALatinHypercube) {
  EXPECT_NE(Resampling(plain_study(40, "lhs"), 20).description().find("Latin hypercube gains"),
            std::string::npos);
  EXPECT_EQ(Resampling(plain_study(40), 20).description().find("Latin"), std::string::npos);
}

TEST(Resampling, IndependenceNeedsRandomRowsWithLotsOfTheirOwn) {
  std::string why;
  EXPECT_TRUE(independent_runs(plain_study(50)));
  EXPECT_FALSE(independent_runs(plain_study(50, "lhs"), &why));
  EXPECT_NE(why.find("lhs"), std::string::npos);
  EXPECT_FALSE(independent_runs(plain_study(50, "random", 2), &why));
  EXPECT_NE(why.find("lot"), std::string::npos);
}

}  // namespace
}  // namespace cagetol
