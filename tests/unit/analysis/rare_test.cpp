#include "analysis/tolerance/rare.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/binomial_bounds.hpp"
#include "analysis/statistics/pareto_bound.hpp"
#include "tests/support/rare_responses.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

/// Cages at one tolerance with a quantity y <= limit; 1 ppm of the cages jam.
StudyData cages(std::size_t rows, std::size_t repeats, double limit) {
  StudyData study = plain_study(static_cast<std::int64_t>(rows * repeats));
  for (std::size_t i = 0; i < study.size(); ++i) {
    study.row[i] = study.lot[i] = static_cast<std::int64_t>(i % rows);
    study.replicate[i] = static_cast<std::int64_t>(i / rows);
    study.candidate[i] = 0;
  }
  study.plan.redraw_jams = true;
  study.plan.limits = {{"y", {}, limit, "stand-in", 1}};
  study.plan.dimensions = {{"width", 0.1}};
  study.plan.candidates = {{{0.1}, {""}, {1}}};
  study.jam.candidate = {1e-6};
  study.jam.error = {1e-8};
  study.inputs = {{"width", "mm", {7.65}, {}, {}, {}, {}, false}};
  study.quantities = {{"y", "-", "", {}}};
  return study;
}

/// y = 0.8 x + 0.6 e, x the deviation of the width in standard deviations, e noise of the start.
StudyData straight(std::size_t rows, std::size_t repeats, double limit, std::uint64_t seed) {
  StudyData study = cages(rows, repeats, limit);
  const auto x = normal_values(seed, rows), e = normal_values(seed + 1000, rows * repeats);
  for (std::size_t i = 0; i < study.size(); ++i) {
    study.inputs[0].lot.push_back(0.009 * x[i % rows]);
    study.inputs[0].value.push_back(7.65 + 0.009 * x[i % rows]);
    study.quantities[0].values.push_back(0.8 * x[i % rows] + 0.6 * e[i]);
  }
  return study;
}

TEST(Rare, CountsOfRunsAreThoseOfTheirFormulas) {
  EXPECT_EQ(showing_runs(63e-6, 0.95), 47550);
  EXPECT_NEAR(showing_runs(1e-6, 0.95), 3.0e6, 0.01e6);
}

TEST(Rare, TheRouteOfALimitFollowsFromItsDistanceAndTheBudget) {
  const auto route = [](double limit, RareSettings settings) {
    return rare_routes(straight(50, 2, limit, 3), settings)[0].route;
  };
  EXPECT_EQ(route(12, {}), RareRoute::extrapolated);
  EXPECT_EQ(route(4, {}), RareRoute::unstated);
  EXPECT_EQ(route(12, {.fresh_runs = 999}), RareRoute::unstated);
  EXPECT_EQ(route(4, {.target = 0.003, .fresh_runs = 998}), RareRoute::counted);
  EXPECT_EQ(route(4, {.target = 0.003, .fresh_runs = 997}), RareRoute::unstated);
}

// Noise of .85 and a limit that one in a hundred thousand exceeds.
TEST(Rare, ANearLimitOfNoiseIsNotStated) {
  for (std::uint64_t repeat = 0; repeat < 200; ++repeat) {
    const RareResponse& response = kRareResponses[4];
    StudyData pilot = cages(50, 1, response.level);
    pilot.quantities[0].values = response_values(response, repeat, 50);
    EXPECT_EQ(rare_routes(pilot, {})[0].route, RareRoute::unstated) << repeat;
  }
}

TEST(Rare, BoundsHoldOneByOneAndTogether) {
  const StudyData pilot = straight(50, 2, 8, 1);
  StudyData fresh = straight(1000, 1, 8, 2);
  fresh.plan.limits.push_back({"y", -4.2, {}, "stand-in", 1});
  StudyData both = pilot;
  both.plan.limits = fresh.plan.limits;
  const Rare far = judge_rare(pilot, fresh, {});
  ASSERT_EQ(far.limits.size(), 1u);
  EXPECT_GE(far.limits[0].upper, 1e-6);
  EXPECT_LT(far.limits[0].upper, 2e-4);
  EXPECT_EQ(far.limits[0].exact_upper, clopper_pearson_upper(0, 1000, 0.95));
  EXPECT_NEAR(far.limits[0].noise, 0.36, 0.15);
  EXPECT_NEAR(far.upper, far.limits[0].upper + 1.01e-6, 1e-10);
  EXPECT_DOUBLE_EQ(far.jams_upper, 1.01e-6);
  const Rare near = judge_rare(both, fresh, {});
  EXPECT_TRUE(std::isnan(near.limits[1].upper));
  EXPECT_TRUE(std::isnan(near.upper));  // of all limits nothing is stated where one is not
  EXPECT_GT(near.exact_upper, clopper_pearson_upper(0, 1000, 0.95));
  // Two limits: each bound at half of the error.
  both.plan.limits[1].minimum = fresh.plan.limits[1].minimum = -8;
  const Rare two = judge_rare(both, fresh, {});
  EXPECT_GT(two.upper, two.limits[0].upper + two.limits[1].upper + two.jams_upper);
}

TEST(Rare, ARunThatMissesOrIsLostLeavesTheExactBoundAtLeast) {
  const StudyData pilot = straight(50, 2, 8, 1);
  StudyData fresh = straight(1000, 1, 8, 2);
  fresh.quantities[0].values[7] = 9;
  EXPECT_GE(judge_rare(pilot, fresh, {}).limits[0].upper, clopper_pearson_upper(1, 1000, 0.95));
  fresh.quantities[0].values[7] = 0;
  fresh.status[7] = RunStatus::failed;
  const Rare lost = judge_rare(pilot, fresh, {});
  EXPECT_EQ(lost.lost, 1u);
  EXPECT_GE(lost.limits[0].upper, clopper_pearson_upper(1, 1000, 0.95));
  EXPECT_GE(lost.upper, clopper_pearson_upper(1, 1000, 0.95));
}

// y = .8 x + .6 e at w times the width is as a sample of that width.
TEST(Rare, CurvesFollowTheWidth) {
  const StudyData pilot = straight(50, 2, 8, 1), fresh = straight(4000, 1, 8, 5);
  const RareLimit limit = judge_rare(pilot, fresh, {.fresh_runs = 4000}).limits[0];
  ASSERT_EQ(limit.upper_at.size(), 1u);
  EXPECT_DOUBLE_EQ(limit.upper_at[0][2], limit.upper);
  const auto x = normal_values(5, 4000), e = normal_values(1005, 4000);
  for (std::size_t w = 0; w < std::size(kRareWidths); ++w) {
    std::vector<double> wider;
    for (std::size_t i = 0; i < x.size(); ++i)
      wider.push_back(0.8 * kRareWidths[w] * x[i] + 0.6 * e[i]);
    const double bound = extrapolated_bound(wider, 8, 0.95);
    EXPECT_NEAR(std::log(limit.upper_at[0][w] / bound), 0, 0.4) << kRareWidths[w];
  }
  EXPECT_GT(limit.upper_at[0].back(), 20 * limit.upper);
}

}  // namespace
}  // namespace cagetol
