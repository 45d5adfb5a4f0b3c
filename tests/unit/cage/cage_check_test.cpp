#include "src/cage/table/cage_check.hpp"

#include <gtest/gtest.h>

#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

CageModel coarse_model(const std::vector<PocketDeviation>& deviations) {
  return std::get<CageModel>(make_cage_model(test::coarse_table(), deviations));
}

TEST(CageCheck, RepeatsToTheLastBitAndNamesTheMesh) {
  const auto deviations = test::scattered_pockets(11);
  const CageModel model = coarse_model(deviations);
  const CageCheck a = check_cage_model(test::coarse_table(), deviations, model);
  const CageCheck b = check_cage_model(test::coarse_table(), deviations, model);
  EXPECT_TRUE(a.frequency == b.frequency);
  EXPECT_EQ(a.largest_error, b.largest_error);
  EXPECT_GT(a.largest_error, 1e-6);  // the model is not the full solve
  EXPECT_LT(a.largest_error, 2e-3);
  EXPECT_EQ(3 * a.nodes, test::coarse_table().dofs);
  EXPECT_GT(a.seconds, 0);
}

/// The check sees a model that is not of these pockets, and looks at no mode above 20 kHz.
TEST(CageCheck, SeesAWrongModel) {
  const auto deviations = test::scattered_pockets(12);
  CageModel model = coarse_model(deviations);
  const double right = check_cage_model(test::coarse_table(), deviations, model).largest_error;
  ASSERT_GT(model.frequency[19], kCheckedFrequency);
  model.frequency[19] *= 2;
  EXPECT_EQ(check_cage_model(test::coarse_table(), deviations, model).largest_error, right);
  model.frequency[3] *= 1.02;
  EXPECT_NEAR(check_cage_model(test::coarse_table(), deviations, model).largest_error, 0.02, 2e-3);
}

}  // namespace
}  // namespace cagetol
