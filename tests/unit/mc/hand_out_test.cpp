#include "mc/ranks/hand_out.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mc/host/progress.hpp"

namespace cagetol {
namespace {

RunMessage finished(Status status) {
  return {.ending = Ending::finished, .status = status, .wall_s = 0.5};
}

TEST(WorkListTest, GivesEachSampleOnceInOrder) {
  WorkList list({3, 5, 9}, {});
  EXPECT_EQ(list.exchange({}), 3u);
  EXPECT_EQ(list.exchange({}), 5u);
  EXPECT_EQ(list.exchange(finished(Status::ok)), 9u);
  EXPECT_EQ(list.exchange(finished(Status::jammed)), std::nullopt);
  EXPECT_EQ(list.state().tally.done, 2u);
  EXPECT_EQ(list.state().tally.jammed, 1u);
  EXPECT_EQ(list.state().tally.failures(), 0u);
  EXPECT_EQ(list.state().busy_s, 1.0);
}

TEST(WorkListTest, CountsOnTopOfWhatWasDoneBefore) {
  WorkList list({1}, Tally{.done = 7, .failed = 2});
  list.exchange(finished(Status::poisoned));
  EXPECT_EQ(list.state().tally.done, 8u);
  EXPECT_EQ(list.state().tally.failures(), 3u);
}

TEST(WorkListTest, GivesNothingAfterAnyReasonToStop) {
  WorkList stopped({1, 2}, {}), interrupted({1, 2}, {}), full({1, 2}, {}), draining({1, 2}, {});
  stopped.stop();
  EXPECT_EQ(stopped.exchange({}), std::nullopt);
  EXPECT_EQ(interrupted.exchange({.ending = Ending::interrupted}), std::nullopt);
  EXPECT_EQ(full.exchange({.ending = Ending::cannot_write}), std::nullopt);
  EXPECT_TRUE(full.state().cannot_write);
  EXPECT_EQ(draining.exchange({.draining = true}), std::nullopt);
  EXPECT_EQ(draining.exchange({}), std::nullopt) << "for the other ranks too";
}

TEST(WorkListTest, ASampleWithoutOutcomeIsNotDone) {
  WorkList list({1, 2}, {});
  EXPECT_EQ(list.exchange({.ending = Ending::no_outcome}), 1u);
  EXPECT_EQ(list.state().tally.done, 0u);
  EXPECT_EQ(list.state().without_outcome, 1u);
}

TEST(CompletedPrefixTest, EndsWithTheMissThatUsesUpTheAllowed) {
  // Whatever order the samples come in: 1, 3 and 4 miss, one may.
  const std::map<std::uint64_t, bool> misses = {
      {0, false}, {1, true}, {2, false}, {3, true}, {4, true}};
  for (std::vector<std::uint64_t> order = {0, 1, 2, 3, 4};
       std::ranges::next_permutation(order).found;) {
    CompletedPrefix prefix(1);
    for (const std::uint64_t id : order) prefix.add(id, misses.at(id));
    EXPECT_TRUE(prefix.used_up());
    EXPECT_EQ(prefix.size(), 4u);
  }
  CompletedPrefix open(1);
  for (const std::uint64_t id : {4, 3, 1}) open.add(id, true);
  EXPECT_FALSE(open.used_up()) << "sample 0 may be lost";
  CompletedPrefix none;
  none.add(0, true);
  EXPECT_FALSE(none.used_up());
}

TEST(WorkListTest, GivesNothingMoreOnceTheAllowedAreUsedUp) {
  WorkList list({0, 1, 2, 3}, {}, CompletedPrefix(0));
  EXPECT_EQ(list.exchange({}), 0u);
  EXPECT_EQ(list.exchange({}), 1u);
  EXPECT_EQ(list.exchange({.ending = Ending::finished, .id = 1, .misses = true}), 2u);
  EXPECT_EQ(list.exchange({.ending = Ending::finished, .id = 0}), std::nullopt);
  EXPECT_EQ(list.state().prefix.size(), 2u);
}

TEST(ProgressTest, SaysHowFarHowFastAndHowLong) {
  Tally tally{.done = 120, .jammed = 1, .failed = 2};
  EXPECT_EQ(progress_text(tally, 20, 1000, 50),
            "120/1000 done, 2/s, 1 jammed, 2 failed, 7 min 20 s left");
  tally.done = 1000;
  EXPECT_EQ(progress_text(tally, 0, 1000, 100), "1000/1000 done, 10/s, 1 jammed, 2 failed");
  EXPECT_EQ(progress_text({}, 0, 10, 0), "0/10 done");
  EXPECT_EQ(progress_bar(0), "[                    ]   0 %");
  EXPECT_EQ(progress_bar(0.5), "[##########          ]  50 %");
  EXPECT_EQ(progress_bar(1), "[####################] 100 %");
}

TEST(LookoutRest, LosesLeastBetweenLooksAndWaiting) {
  const double look = 40e-6;
  for (const int others : {1, 3, 63})
    for (const double sample : {0.02, 0.1, 0.2}) {
      const double rest = lookout_rest(sample, others);
      if (rest <= 0.3e-3 || rest >= 5e-3) continue;
      const auto lost = [&](double r) { return look / r + others * r / (2 * sample); };
      EXPECT_LT(lost(rest), lost(1.1 * rest)) << sample << " s, " << others;
      EXPECT_LT(lost(rest), lost(0.9 * rest)) << sample << " s, " << others;
    }
}

TEST(LookoutRest, IsLongAloneAndNeverLongerThanAKillAllows) {
  EXPECT_EQ(lookout_rest(0.1, 0), lookout_rest(1e4, 1));
  EXPECT_LE(lookout_rest(1e4, 1), 0.05);
  EXPECT_GE(lookout_rest(0, 5), 0.1e-3);
}

}  // namespace
}  // namespace cagetol
