#include "analysis/compare/comparison.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "analysis/compare/change_tests.hpp"
#include "analysis/compare/holm.hpp"
#include "analysis/compare/matched_runs.hpp"
#include "analysis/statistics/paired_share.hpp"
#include "analysis/study/refused.hpp"
#include "distributions/basics/random_stream.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Holm, AdjustsInSteps) {
  // 4 * 0.01, 3 * 0.013 raised to the one before, 2 * 0.03, 1 * 0.5.
  EXPECT_THAT(holm_adjusted({0.03, 0.01, 0.5, 0.013}),
              ElementsAre(DoubleNear(0.06, 1e-12), DoubleNear(0.04, 1e-12), DoubleNear(0.5, 1e-12),
                          DoubleNear(0.04, 1e-12)));
  EXPECT_THAT(holm_adjusted({0.6, 0.7}), ElementsAre(1.0, 1.0));
}

TEST(Fisher, TastingTea) {
  // The lady tasting tea: 3 of 4 against 1 of 4, p = 34/70; 4 against 0, p = 2/70.
  EXPECT_NEAR(fisher_p_value({3, 4}, {1, 4}), 34.0 / 70, 1e-12);
  EXPECT_NEAR(fisher_p_value({4, 4}, {0, 4}), 2.0 / 70, 1e-12);
  EXPECT_DOUBLE_EQ(fisher_p_value({0, 50}, {0, 70}), 1);
}

TEST(McNemar, IsABinomialOfTheChanges) {
  EXPECT_DOUBLE_EQ(mcnemar_p_value(0, 0), 1);
  EXPECT_DOUBLE_EQ(mcnemar_p_value(0, 6), 2.0 / 64);
  EXPECT_NEAR(mcnemar_p_value(8, 1), 2 * 10.0 / 512, 1e-12);
}

TEST(ChangePValue, IsWelchsTest) {
  // Two samples of 4: means 2.5 and 6, variances 5/3 and 20/3. t = 3.5 / sqrt(25/12), 4.41 degrees
  // of freedom.
  const Linearised before{2.5, {1, 2, 3, 4}, {-1.5 / 4, -0.5 / 4, 0.5 / 4, 1.5 / 4}};
  const Linearised after{6, {5, 6, 7, 8}, {-3.0 / 4, -1.0 / 4, 1.0 / 4, 3.0 / 4}};
  const double a = 5.0 / 12, b = 20.0 / 12, freedom = (a + b) * (a + b) / (a * a / 3 + b * b / 3);
  EXPECT_NEAR(change_p_value(before, after, false),
              2 * gsl_cdf_tdist_Q(3.5 / std::sqrt(25.0 / 12), freedom), 1e-12);
  EXPECT_DOUBLE_EQ(change_p_value(before, before, true), 1);
}

/// Ten quantities of all kinds of scatter; `change` may alter a value.
using Change = std::function<double(std::size_t quantity, double value)>;
StudyData night(std::int64_t seed, std::int64_t rows = 300, const Change& change = {},
                std::int64_t draws = -1, std::int64_t cages_per_lot = 1) {
  StudyData study = plain_study(rows, "random", cages_per_lot, seed);
  study.plan.limits = {{"q0", {}, 1.5, "test", 1}, {"q5", {}, 4.0, "test", 1}};
  study.plan.whole = {{"scene", {{"load", 1}}}};
  for (std::size_t q = 0; q < 10; ++q) {
    Column column{"q" + std::to_string(q), "-", "test", {}};
    for (std::size_t i = 0; i < study.size(); ++i) {
      const auto stream = static_cast<std::uint32_t>(q);
      RandomStream own(static_cast<std::uint64_t>(draws < 0 ? seed : draws), Purpose::pocket, i,
                       stream);
      RandomStream lot(static_cast<std::uint64_t>(seed), Purpose::lot,
                       static_cast<std::uint64_t>(study.lot[i]), stream);
      double z = gsl_cdf_ugaussian_Pinv(own.next());
      if (cages_per_lot > 1) z = 0.6 * z + 0.8 * gsl_cdf_ugaussian_Pinv(lot.next());
      const double y = q % 3 == 0 ? z : q % 3 == 1 ? std::exp(0.8 * z) : z * z;
      column.values.push_back(change ? change(q, y) : y);
    }
    study.quantities.push_back(std::move(column));
  }
  return study;
}

/// Share of pairs of nights, nothing changed, that raise an alarm.
double false_alarms(int repeats, double error_rate, std::int64_t cages_per_lot) {
  int alarms = 0;
  for (int repeat = 0; repeat < repeats; ++repeat)
    alarms += !compare_studies(night(2 * repeat, 300, {}, -1, cages_per_lot),
                               night(2 * repeat + 1, 300, {}, -1, cages_per_lot), error_rate)
                   .same();
  return static_cast<double>(alarms) / repeats;
}

TEST(Comparison, RaisesFewFalseAlarms) {
  // 50 statistics and more, each tested: without Holm an alarm would be the rule.
  EXPECT_LE(false_alarms(150, 0.1, 1), 0.17);
}

TEST(NightlyComparison, RaisesNoMoreFalseAlarmsThanPromised) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  EXPECT_LE(false_alarms(2000, 0.05, 1), 0.06);
  EXPECT_LE(false_alarms(1000, 0.05, 3), 0.07);
}

/// Slip, whirl and the like: some runs lie ten or a hundred times beyond the middle one.
StudyData heavy_night(std::int64_t seed, std::int64_t rows) {
  return night(seed, rows, [](std::size_t q, double y) {
    return q % 3 == 0 ? std::exp(1.6 * y) : q % 3 == 1 ? y * y : std::round(0.3 * y);
  });
}

TEST(Comparison, HeavyTailsRaiseFewFalseAlarms) {
  for (const std::int64_t rows : {8, 16, 32, 64}) {
    int alarms = 0;
    constexpr int repeats = 150;
    for (int repeat = 0; repeat < repeats; ++repeat)
      alarms +=
          !compare_studies(heavy_night(2 * repeat, rows), heavy_night(2 * repeat + 1, rows), 0.01)
               .same();
    EXPECT_LE(alarms, 6) << rows << " rows: 1.5 are to be expected";  // P(more) = 1e-4
  }
}

TEST(NightlyComparison, HeavyTailsRaiseNoMoreFalseAlarmsThanPromised) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  for (const std::int64_t rows : {8, 16, 32, 64, 128, 230}) {
    int alarms = 0;
    constexpr int repeats = 1000;
    for (int repeat = 0; repeat < repeats; ++repeat)
      alarms +=
          !compare_studies(heavy_night(2 * repeat, rows), heavy_night(2 * repeat + 1, rows), 0.01)
               .same();
    EXPECT_LE(alarms, 18) << rows;  // 10 are promised; P(more than 18) = 0.7 %
    RecordProperty("alarms_" + std::to_string(rows), alarms);
  }
}

TEST(Comparison, WhatHardlyEverVariesIsTestedExactly) {
  const auto with_runs = [](std::int64_t seed, std::size_t others) {
    StudyData study = plain_study(480, "random", 1, seed);
    Column column{"rare", "-", "test", std::vector<double>(480, 1.0)};
    for (std::size_t i = 0; i < others; ++i) column.values[7 * i] = 1.5;
    study.quantities.push_back(column);
    return study;
  };
  for (const std::int64_t other_seed : {1, 2}) {  // the same cages, and others
    EXPECT_TRUE(compare_studies(with_runs(1, 0), with_runs(other_seed, 2), 0.01).same());
    EXPECT_TRUE(compare_studies(with_runs(1, 2), with_runs(other_seed, 0), 0.01).same());
    EXPECT_FALSE(compare_studies(with_runs(1, 0), with_runs(other_seed, 40), 0.01).same());
  }
  // A constant that is another one now.
  StudyData moved = with_runs(2, 0);
  for (double& y : moved.quantities[0].values) y = 2;
  const Comparison result = compare_studies(with_runs(1, 0), moved, 0.01);
  for (const StatisticChange& statistic : result.statistics) {
    if (statistic.statistic == "mean") {
      EXPECT_TRUE(statistic.changed);
    }
    if (statistic.statistic == "standard deviation") {
      EXPECT_FALSE(statistic.changed);
    }
  }
}

/// Share of nights in which a change is found, in the quantity where it is.
double power(int repeats, std::size_t quantity, const std::function<double(double)>& change,
             bool same_seed) {
  int found = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const auto changed = [&](std::size_t q, double y) { return q == quantity ? change(y) : y; };
    const std::int64_t seed = 2 * repeat;
    const Comparison result =
        compare_studies(night(seed), night(same_seed ? seed : seed + 1, 300, changed), 0.05);
    for (const StatisticChange& statistic : result.statistics)
      if (statistic.changed) {
        found += statistic.quantity == "q" + std::to_string(quantity);
        break;
      }
  }
  return static_cast<double>(found) / repeats;
}

TEST(Comparison, FindsChanges) {
  // A mean moved by 0.4 sigma is 4.9 standard errors of a difference of 300 runs each.
  EXPECT_GE(power(
                30, 0, [](double y) { return y + 0.4; }, false),
            0.8);
  EXPECT_GE(power(
                30, 3, [](double y) { return 1.35 * y; }, false),
            0.8);
  // Scatter of a heavy tail: doubled deviations of a lognormal.
  EXPECT_GE(power(
                30, 1, [](double y) { return 1 + 2 * (y - 1); }, false),
            0.8);
  // The same cages pair by pair: a fiftieth of sigma is seen.
  EXPECT_GE(power(
                10, 0, [](double y) { return y + 0.02; }, true),
            0.99);
}

TEST(Comparison, TheSameRunsAreTheSame) {
  const Comparison result = compare_studies(night(4), night(4), 0.5);
  EXPECT_TRUE(result.paired);
  EXPECT_TRUE(result.same());
  for (const StatisticChange& statistic : result.statistics) EXPECT_EQ(statistic.p_value, 1);
}

TEST(Comparison, WhatRoundingMovesIsNoChange) {
  const auto moved = [](double by) {
    return compare_studies(night(1), night(1, 300, [by](auto, double y) { return y * (1 + by); }),
                           0.01);
  };
  EXPECT_TRUE(moved(1e-12).same());
  EXPECT_FALSE(moved(1e-6).same());
}

TEST(Comparison, PairsOfTheSameCagesWithOtherNoiseRaiseFewAlarms) {
  int alarms = 0;
  for (int repeat = 0; repeat < 60; ++repeat)
    alarms +=
        !compare_studies(night(9, 300, {}, 3 * repeat), night(9, 300, {}, 3 * repeat + 1), 0.1)
             .same();
  EXPECT_LE(alarms, 13);
}

TEST(Comparison, SeesJamsAndLostRuns) {
  StudyData after = night(1);
  for (std::size_t i = 0; i < 40; ++i) after.status[5 * i] = RunStatus::failed;
  const Comparison result = compare_studies(night(2), after, 0.01);
  EXPECT_EQ(result.statistics.front().statistic, "share without result");
  EXPECT_TRUE(result.statistics.front().changed);
}

std::string refusal_of(const StudyData& before, const StudyData& after) {
  try {
    compare_studies(before, after, 0.01);
  } catch (const Refused& refusal) {
    return refusal.what();
  }
  return "no refusal";
}

TEST(Comparison, RefusesWhatIsNotOneStudy) {
  StudyData other = night(2);
  other.plan.whole["scene"]["load"] = 2;
  EXPECT_THAT(refusal_of(night(1), other), HasSubstr("scene.load: 1 and 2"));
  other = night(2);
  other.plan.whole["seed"] = 7;  // how much is run, not what
  EXPECT_EQ(refusal_of(night(1), other), "no refusal");
  other.quantities[0].unit = "N";
  EXPECT_THAT(refusal_of(night(1), other), HasSubstr("q0 is in - in one and in N in the other"));
  EXPECT_THAT(refusal_of(night(1), select_samples(night(2), {})),
              HasSubstr("has fewer than two runs"));
  other = night(2);
  other.design.kind = "grid";
  EXPECT_THAT(refusal_of(other, other), HasSubstr("`grid`"));
}

TEST(Comparison, ComparesDespiteKeysWhenAsked) {
  StudyData other = night(2);
  other.plan.whole["scene"]["load"] = 2;
  const Comparison result = compare_studies(night(1), other, 0.01, true);
  EXPECT_THAT(result.notes, ElementsAre("scene.load: 1 and 2"));
  EXPECT_FALSE(result.statistics.empty());
}

TEST(Comparison, NotesWhatOnlyOneHas) {
  StudyData other = night(2);
  other.plan.whole["scene"]["new_key"] = 2;
  other.quantities.pop_back();
  EXPECT_THAT(compare_studies(night(1), other, 0.01).notes,
              ElementsAre("scene.new_key is a key of only one of the two",
                          "q9 is a quantity of only one of the two"));
}

const MatchedRuns& pairs_of(const std::vector<MatchedRuns>& all, const std::string& quantity) {
  for (const MatchedRuns& pairs : all)
    if (pairs.quantity == quantity) return pairs;
  throw std::out_of_range(quantity);
}

TEST(MatchedRunsTest, StandBesideTheirRowWhateverTheirOrder) {
  StudyData reference = night(1, 4), runs = night(1, 4);
  reference.quantities[0].values = {10, 11, 12, 13};
  runs.quantities[0].values = {20, 21, 22, 23};
  std::swap(runs.row[0], runs.row[3]);
  runs.row[2] = 99;  // a row that the reference has not; its own then has no partner
  const auto all = matched_runs(reference, runs);
  ASSERT_EQ(all.size(), reference.quantities.size());
  const MatchedRuns& pairs = pairs_of(all, "q0");
  EXPECT_THAT(pairs.reference, ElementsAre(10, 11, 12, 13));
  EXPECT_EQ(pairs.values[0], 23);
  EXPECT_EQ(pairs.values[1], 21);
  EXPECT_TRUE(std::isnan(pairs.values[2]));
  EXPECT_EQ(pairs.values[3], 20);
  runs.quantities.erase(runs.quantities.begin());
  EXPECT_THROW(pairs_of(matched_runs(reference, runs), "q0"), std::out_of_range);
}

TEST(MatchedRunsTest, CagesOfOneLotAreNotIndependent) {
  EXPECT_FALSE(share_lots(night(1)));
  EXPECT_TRUE(share_lots(night(1, 300, {}, -1, 3)));
}

}  // namespace
}  // namespace cagetol
