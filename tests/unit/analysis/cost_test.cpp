#include "analysis/tolerance/cost.hpp"

#include <gtest/gtest.h>

#include "analysis/tolerance/campaign.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

TEST(Cost, LiesOnLinesThroughATable) {
  const CostTable table = {{0.1, 10}, {0.2, 6}, {0.4, 5}};
  EXPECT_DOUBLE_EQ(cost_of_tolerance(table, 0.1), 10);
  EXPECT_DOUBLE_EQ(cost_of_tolerance(table, 0.15), 8);
  EXPECT_DOUBLE_EQ(cost_of_tolerance(table, 0.3), 5.5);
  EXPECT_DOUBLE_EQ(cost_of_tolerance(table, 0.05), 10);
  EXPECT_DOUBLE_EQ(cost_of_tolerance(table, 1), 5);
}

/// Both dimensions matter: a cage fails when the sum of two deviations is too large.
StudyData two_that_matter() {
  const StandinDimension width{"cage.pocket_width_mm", 0, 0.01, {0.36, 0.9}},
      length{"cage.pocket_length_mm", 0, 0.01, {0.36, 0.9}};
  // Yields: both narrow 1.000, one wide 0.99, both wide 0.95.
  return tolerance_standin(4000, 5, {width, length}, 0.97, [](const StandinCage& cage) {
    return cage.pocket[0][0] + 0.9 * cage.pocket[1][0] - 0.0205;
  });
}

Recommendation recommendation_of(const StudyData& study) {
  const auto joint = judge_all(study);
  const Resampling resampling(study, 100);
  const ToleranceStudy tolerances = study_tolerances(study, joint, resampling);
  return recommend_tolerance(study, tolerances.mixture, tolerances.curves, tolerances.tests, joint,
                             resampling);
}

TEST(Cost, TheCheapestTakesThePlaceOfTheWidest) {
  StudyData study = two_that_matter();
  for (const std::size_t dear : {0, 1}) {
    study.plan.dimensions[dear].cost = {{0.036, 28}, {0.09, 12}};
    study.plan.dimensions[1 - dear].cost = {{0.036, 3.8}, {0.09, 2.1}};
    const Recommendation result = recommendation_of(study);
    ASSERT_TRUE(result.meets_target);
    EXPECT_NEAR(result.tolerances[dear].tolerance_width_mm, 0.09, 1e-12) << dear;
    EXPECT_NEAR(result.tolerances[1 - dear].tolerance_width_mm, 0.036, 1e-12) << dear;
    EXPECT_NEAR(result.cost.value(), 12 + 3.8, 1e-9);
  }
}

}  // namespace
}  // namespace cagetol
