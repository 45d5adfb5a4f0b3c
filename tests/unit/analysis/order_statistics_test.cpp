#include "analysis/statistics/order_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/summary.hpp"
#include "analysis/study/refused.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

TEST(OrderStatistics, WilksNumbersOfRuns) {
  EXPECT_EQ(wilks_runs(0.95, 0.95, 1), 59u);
  EXPECT_EQ(wilks_runs(0.95, 0.95, 2), 93u);
  EXPECT_EQ(wilks_runs(0.95, 0.95, 3), 124u);
  EXPECT_EQ(wilks_runs(0.99, 0.95, 1), 299u);
  EXPECT_EQ(wilks_runs(0.99, 0.95, 2), 473u);
  EXPECT_EQ(wilks_runs(0.99, 0.95, 3), 628u);
  EXPECT_EQ(wilks_runs(0.99865, 0.95, 1), 2218u);
}

TEST(OrderStatistics, WilksRankNeedsEnoughRuns) {
  EXPECT_EQ(wilks_rank(58, 0.95, 0.95), 0u);
  EXPECT_EQ(wilks_rank(59, 0.95, 0.95), 1u);
  EXPECT_EQ(wilks_rank(92, 0.95, 0.95), 1u);
  EXPECT_EQ(wilks_rank(93, 0.95, 0.95), 2u);
}

TEST(OrderStatistics, QuantilesByHand) {
  const std::vector<double> values = {30, 10, NAN, 20};
  const std::vector<double> equal(4, 1.0);
  const auto order = ascending_order(values);
  ASSERT_EQ(order, (std::vector<std::size_t>{1, 3, 0}));
  EXPECT_DOUBLE_EQ(weighted_quantile(values, order, equal, 0.5), 20);
  EXPECT_DOUBLE_EQ(weighted_quantile(values, order, equal, 1.0 / 3), 15);
  EXPECT_DOUBLE_EQ(weighted_quantile(values, order, equal, 0), 10);
  EXPECT_DOUBLE_EQ(weighted_quantile(values, order, equal, 1), 30);
  const std::vector<double> doubled = {1, 2, 1, 1};
  EXPECT_DOUBLE_EQ(weighted_quantile(values, order, doubled, 0.25), 10);
  EXPECT_DOUBLE_EQ(weighted_quantile(values, order, doubled, 0.625), 20);
}

TEST(OrderStatistics, WilksBoundIsRefusedForDependentRuns) {
  std::vector<double> values(200);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
  EXPECT_EQ(wilks_bound(plain_study(200), values, 0.95, 0.95),
            200.0 - static_cast<double>(wilks_rank(200, 0.95, 0.95)));
  EXPECT_THROW(wilks_bound(plain_study(200, "lhs"), values, 0.95, 0.95), Refused);
  EXPECT_THROW(wilks_bound(plain_study(200, "sobol"), values, 0.95, 0.95), Refused);
  EXPECT_THROW(wilks_bound(plain_study(200, "random", 4), values, 0.95, 0.95), Refused);
}

}  // namespace
}  // namespace cagetol
