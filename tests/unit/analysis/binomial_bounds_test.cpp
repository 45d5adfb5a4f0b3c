#include "analysis/statistics/binomial_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cagetol {
namespace {

TEST(BinomialBounds, NoFailureInManyRuns) {
  EXPECT_NEAR(clopper_pearson_lower(300, 300, 0.95), 0.99006, 5e-6);
  EXPECT_NEAR(clopper_pearson_lower(1000, 1000, 0.95), 0.99701, 5e-6);
  EXPECT_NEAR(clopper_pearson_lower(3000, 3000, 0.95), 0.99900, 5e-6);
}

TEST(BinomialBounds, NoFailureIsTheRootOfTheError) {
  EXPECT_NEAR(clopper_pearson_lower(57, 57, 0.9), std::pow(0.1, 1.0 / 57), 1e-12);
}

TEST(BinomialBounds, UpperMirrorsLower) {
  EXPECT_NEAR(clopper_pearson_upper(3, 40, 0.95), 1 - clopper_pearson_lower(37, 40, 0.95), 1e-14);
  EXPECT_NEAR(clopper_pearson_upper(0, 100, 0.95), 0.029513, 1e-6);
}

TEST(BinomialBounds, EndsStayInside) {
  EXPECT_EQ(clopper_pearson_lower(0, 50, 0.95), 0);
  EXPECT_EQ(clopper_pearson_upper(50, 50, 0.95), 1);
  EXPECT_EQ(clopper_pearson_lower(0, 0, 0.95), 0);
}

TEST(BinomialBounds, TakesEffectiveNumbersOfTrials) {
  const double bound = clopper_pearson_lower(999 - 1e-6, 999, 0.95);
  EXPECT_NEAR(bound, std::pow(0.05, 1.0 / 999), 1e-6);
  EXPECT_LT(clopper_pearson_lower(95.5, 100.5, 0.95), clopper_pearson_lower(191, 201, 0.95));
}

}  // namespace
}  // namespace cagetol
