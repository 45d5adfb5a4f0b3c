// The simulation of many ranks, where its result is known.
#include "tests/mpi/hand_out_simulation.hpp"

#include <gtest/gtest.h>

namespace cagetol {
namespace {

TEST(HandOutSimulation, WithoutCostsOnlyTheLastSamplesAreLost) {
  const HandOutPrediction predicted = predict_hand_out(10, 100, 1000, {.latency_s = 0});
  EXPECT_GT(predicted.efficiency, 0.99);
  EXPECT_STREQ(predicted.largest_loss().name, "last samples");
}

TEST(HandOutSimulation, RankZeroCannotAnswerMoreThanItsTimeAllows) {
  // 100 answers a second for ranks that would report 1000 times; a tenth of the time goes into
  // beats.
  const HandOutPrediction predicted = predict_hand_out(100, 0.1, 100, {.message_s = 0.01});
  EXPECT_NEAR(predicted.efficiency, 0.09, 0.01);
  EXPECT_GT(predicted.server_busy, 0.9);
  EXPECT_STREQ(predicted.largest_loss().name, "waiting for answers");
}

TEST(HandOutSimulation, AFileThatTakesAsLongAsTheSweepHalvesTheEfficiency) {
  const HandOutPrediction predicted = predict_hand_out(100, 1, 100, {.file_sample_s = 0.01});
  EXPECT_NEAR(predicted.efficiency, 0.5, 0.03);
  EXPECT_STREQ(predicted.largest_loss().name, "study.h5");
}

TEST(HandOutSimulation, LossesAndEfficiencyMakeUpTheWhole) {
  const HandOutPrediction predicted =
      predict_hand_out(200, 0.5, 50, {1e-5, 1e-4, 1e-3, 1e-4, 1e-3, 5e-5});
  double whole = predicted.efficiency;
  for (const auto& loss : predicted.losses) whole += loss.share;
  EXPECT_NEAR(whole, 1, 0.02);
}

}  // namespace
}  // namespace cagetol
