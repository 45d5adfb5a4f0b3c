#include "analysis/tolerance/recommendation.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

struct Judged {
  YieldCurves curves;
  std::vector<BindingTest> tests;
  Recommendation recommendation;
};

Judged judge_study(const StudyData& study, std::size_t resamples = 300, double confidence = 0.95) {
  const auto joint = judge_all(study);
  const Resampling resampling(study, resamples);
  const MixtureWeights mixture = mixture_weights(study);
  Judged judged;
  judged.curves = yield_curves(study, mixture, joint, resampling, confidence);
  judged.tests = test_binding(study, mixture, judged.curves, joint, resampling);
  judged.recommendation =
      recommend_tolerance(study, mixture, judged.curves, judged.tests, joint, resampling);
  return judged;
}

TEST(YieldCurves, MaximumOfNormals) {
  const StudyData study =
      tolerance_standin(8000, 21, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  const Judged judged = judge_study(study, 2000, 0.999);
  for (const LevelYield& level : judged.curves.dimensions[0].levels) {
    const double exact = widest_pocket_yield(level.tolerance_width_mm);
    EXPECT_LE(level.yield.lower_bound, exact) << level.tolerance_width_mm;
    EXPECT_GE(level.yield.upper_bound, exact) << level.tolerance_width_mm;
    EXPECT_NEAR(level.yield.if_unknown_fail, exact, 0.03) << level.tolerance_width_mm;
  }
}

TEST(YieldCurves, HierarchicalLinear) {
  // Badness sum_p c_p (L + W_p) - limit is normal: yield Phi(limit / (s sqrt((sum c)^2 s_L^2 + sum
  // c^2 s_W^2))).
  StandinDimension width = kPrintedWidth;
  width.lot_sigma = 0.006;
  const auto badness = [](const StandinCage& cage) {
    return 2 * (cage.lot[0] + cage.pocket[0][1]) + (cage.lot[0] + cage.pocket[0][4]) - 0.03;
  };
  const double sigma = std::sqrt(9 * 0.006 * 0.006 + 5 * 0.01 * 0.01);
  for (const std::int64_t cages : {1, 5}) {
    const StudyData study =
        tolerance_standin(8000, 22, {width, kPrintedLength}, 0.95, badness, cages);
    const Judged judged = judge_study(study, 2000, 0.999);
    for (const LevelYield& level : judged.curves.dimensions[0].levels) {
      const double exact = gsl_cdf_ugaussian_P(0.03 / (sigma * level.tolerance_width_mm / 0.1));
      EXPECT_LE(level.yield.lower_bound, exact) << level.tolerance_width_mm;
      EXPECT_GE(level.yield.upper_bound, exact) << level.tolerance_width_mm;
    }
  }
}

/// Share of repeats in which the lower bound of the middle candidate is below its exact yield.
double bound_coverage(int repeats) {
  int held = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const StudyData study =
        tolerance_standin(1000, 500 + repeat, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
    held += judge_study(study, 200).curves.candidates[4].lower_bound <= widest_pocket_yield(0.09);
  }
  return static_cast<double>(held) / repeats;
}

TEST(YieldCurves, LowerBoundHolds) {
  EXPECT_GE(bound_coverage(60), 0.9);
}

TEST(NightlyYieldCurves, LowerBoundHoldsInAThousandRepeats) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  EXPECT_GE(bound_coverage(1000), 0.93);
}

TEST(Recommendation, WidestToleranceThatMeetsTheTargetSnappedDown) {
  // Yields at 0.036, 0.058, 0.09, 0.15 mm: 1.0000, 0.99995, 0.9751, 0.5731. Tolerances in mm snap
  // to IT11 = 0.09 mm for 9 mm.
  const StudyData study =
      tolerance_standin(4000, 23, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  const Judged judged = judge_study(study);
  const Recommendation& result = judged.recommendation;
  ASSERT_TRUE(result.meets_target);
  EXPECT_NEAR(result.tolerances[0].tolerance_width_mm, 0.09, 1e-12);
  EXPECT_EQ(result.tolerances[0].grade, "IT11");
  EXPECT_GE(result.yield.lower_bound, 0.95);
  EXPECT_LE(result.yield.lower_bound, widest_pocket_yield(0.09));
}

TEST(Recommendation, ToleranceBetweenGradesIsJudgedAtTheGradeBelow) {
  StandinDimension width = kPrintedWidth;
  width.scales = {0.36, 0.75, 1.5};
  const StudyData study = tolerance_standin(4000, 24, {width, kPrintedLength}, 0.95, widest_pocket);
  const Recommendation result = judge_study(study).recommendation;
  ASSERT_TRUE(result.meets_target);
  EXPECT_NEAR(result.tolerances[0].tolerance_width_mm, 0.058, 1e-12);
  EXPECT_EQ(result.tolerances[0].grade, "IT10");
  EXPECT_GT(result.yield.if_unknown_fail, 0.995);
}

TEST(Recommendation, ToleranceOfAClearanceHasNoGrade) {
  // ISO 286 would give 9 mm IT11 = 0.09 mm; a clearance of 9 um has no nominal size.
  StandinDimension clearance = kPrintedWidth;
  clearance.key = "bearing.internal_clearance_um";
  clearance.scales = {0.36, 0.5, 0.95};
  const Recommendation result =
      judge_study(tolerance_standin(4000, 23, {clearance, kPrintedLength}, 0.95, widest_pocket))
          .recommendation;
  ASSERT_TRUE(result.possible);
  EXPECT_EQ(result.tolerances[0].grade, "");
  EXPECT_NEAR(result.tolerances[0].tolerance_width_mm,
              result.meets_target && result.candidate >= 4 ? 0.095 : 0.05, 1e-12);
}

/// Narrow and wide widths, each about the nominal value and in the zone that begins there.
StandinDimension widths_in_two_zones() {
  StandinDimension width = kPrintedWidth;
  width.scales = {0.36, 0.36, 0.9, 0.9};
  width.middles = {0, 0.018, 0, 0.045};
  return width;
}

TEST(YieldCurves, ZonesOfOneWidthAreTwoLevels) {
  const StudyData study =
      tolerance_standin(8000, 21, {widths_in_two_zones(), kPrintedLength}, 0.95, widest_pocket);
  const Judged judged = judge_study(study, 2000, 0.999);
  const auto& levels = judged.curves.dimensions[0].levels;
  ASSERT_EQ(levels.size(), 4u);
  for (const LevelYield& level : levels) {
    const double z = (0.026 - level.middle) / (0.1 * level.tolerance_width_mm);
    const double exact = std::pow(gsl_cdf_ugaussian_P(z), 13);
    EXPECT_LE(level.yield.lower_bound, exact) << level.grade;
    EXPECT_GE(level.yield.upper_bound, exact) << level.grade;
    EXPECT_NEAR(level.yield.if_unknown_fail, exact, 0.03) << level.grade;
  }
}

TEST(Recommendation, SaysInWhichZoneAWidthMeetsTheTarget) {
  const auto recommended = [](double sign) {
    const StudyData study = tolerance_standin(
        4000, 23, {widths_in_two_zones(), kPrintedLength}, 0.95, [sign](const StandinCage& cage) {
          double worst = -1;
          for (const double pocket : cage.pocket[0])
            worst = std::max(worst, sign * pocket - (sign > 0 ? 0.026 : 0.015));
          return worst;
        });
    return judge_study(study).recommendation;
  };
  const Recommendation centred = recommended(1), above = recommended(-1);
  ASSERT_TRUE(centred.meets_target && above.meets_target);
  EXPECT_NEAR(centred.tolerances[0].tolerance_width_mm, 0.09, 1e-12);
  EXPECT_EQ(centred.tolerances[0].grade, "IT11");  // snapped
  EXPECT_NEAR(above.tolerances[0].tolerance_width_mm, 0.09, 1e-12);
  EXPECT_EQ(above.tolerances[0].grade, "+0.09/+0");
  EXPECT_FALSE(above.tolerances[0].centre);
  // Narrower in the same zone.
  const auto narrower = [](const Recommendation& of) {
    for (const StepEffect& step : of.steps)
      if (step.key == kPrintedWidth.key) return step.to;
    return std::string();
  };
  EXPECT_EQ(narrower(centred), "0.036 mm");
  EXPECT_EQ(narrower(above), "+0.036/+0");
}

TEST(Recommendation, DimensionThatChangesNothingIsNotBinding) {
  int not_binding = 0, recommended = 0;
  const int repeats = 40;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Judged judged = judge_study(
        tolerance_standin(2000, 900 + repeat, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket),
        50);
    EXPECT_EQ(judged.tests[0].answer, Binding::binding);
    not_binding += judged.tests[1].answer == Binding::not_binding;
    recommended += !judged.recommendation.tolerances[1].not_binding;
  }
  EXPECT_GE(not_binding, 38);
  EXPECT_LE(recommended, 2);
}

TEST(Recommendation, NotBindingWithholdsNoToleranceThatPasses) {
  // Yields about 0.95, 0.93, 0.92 and 0.90 beside a target of 0.90: the dimensions change little,
  // and the widest tolerances may miss the target.
  StandinDimension width = kPrintedWidth, length = kPrintedLength;
  width.scales = {0.7, 0.76};
  length.scales = {0.7, 0.76};
  const auto badness = [](const StandinCage& cage) {
    const double widest = *std::max_element(cage.pocket[0].begin(), cage.pocket[0].end());
    const double longest = *std::max_element(cage.pocket[1].begin(), cage.pocket[1].end());
    return std::max(widest, longest) - 0.0195;
  };
  int passing = 0, widest_misses = 0;
  for (int repeat = 0; repeat < 60; ++repeat) {
    const StudyData study = tolerance_standin(500, 700 + repeat, {width, length}, 0.90, badness);
    const Judged judged = judge_study(study, 50);
    const auto meets = [&](const Yield& yield) {
      return yield.ess >= kFewestEffectiveRuns && yield.lower_bound >= 0.90;
    };
    const auto& candidates = judged.curves.candidates;
    if (std::none_of(candidates.begin(), candidates.end(), meets)) continue;
    ++passing;
    widest_misses += !meets(candidates.back());
    EXPECT_TRUE(judged.recommendation.meets_target) << repeat;
  }
  EXPECT_GE(passing, 20);
  EXPECT_GE(widest_misses, 5);
}

TEST(Recommendation, TooFewRunsLeaveADimensionUndecided) {
  const Judged judged = judge_study(
      tolerance_standin(120, 31, {kPrintedWidth, kPrintedLength}, 0.99, widest_pocket), 50);
  EXPECT_EQ(judged.tests[1].answer, Binding::undecided);
  EXPECT_FALSE(judged.recommendation.possible);  // fewer than 30 effective runs everywhere
}

TEST(Recommendation, RunsWithoutAJudgementDecideNothing) {
  StudyData study =
      tolerance_standin(2000, 34, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  StudyData some = study;
  for (std::size_t i = 0; i < study.size(); ++i) {
    study.quantities[0].values[i] = kUndefined;
    if (i % 9 == 0) some.status[i] = RunStatus::censored;
  }
  for (const BindingTest& test : judge_study(study, 50).tests) {
    EXPECT_EQ(test.answer, Binding::undecided);
    EXPECT_GT(test.largest_loss_bound, 0.3);
  }
  const Judged judged = judge_study(some, 50);
  EXPECT_EQ(judged.tests[0].answer, Binding::binding);
  EXPECT_NE(judged.tests[1].answer, Binding::binding);
  EXPECT_GT(judged.tests[1].largest_loss, 0.02);  // passing where the narrow tolerances weigh more
}

TEST(Recommendation, AllJammedIsNotCalledNotBinding) {
  StudyData study =
      tolerance_standin(2000, 35, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  study.status.assign(study.size(), RunStatus::jammed);
  for (const BindingTest& test : judge_study(study, 50).tests)
    EXPECT_EQ(test.answer, Binding::undecided);
}

// More jams cost no good cages where there are none.
TEST(Recommendation, JamsBindNothingWhereEveryCageThatFitsMissesALimit) {
  StudyData study =
      tolerance_standin(2000, 35, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  study.plan.redraw_jams = true;
  for (std::size_t k = 0; k < study.plan.candidates.size(); ++k)
    study.jam.candidate.push_back(0.01 * static_cast<double>(k));
  EXPECT_EQ(judge_study(study, 50).tests[0].answer, Binding::binding);
  for (double& value : study.quantities[0].values) value += 1e3;
  for (const BindingTest& test : judge_study(study, 50).tests)
    EXPECT_EQ(test.answer, Binding::undecided);
  // One that meets it, of the widest tolerances: its weight at narrow ones is nothing.
  const auto last = std::find(study.candidate.begin(), study.candidate.end(),
                              static_cast<std::int64_t>(study.plan.candidates.size()) - 1);
  study.quantities[0].values[static_cast<std::size_t>(last - study.candidate.begin())] = -1e3;
  for (const BindingTest& test : judge_study(study, 50).tests)
    EXPECT_EQ(test.answer, Binding::undecided);
}

TEST(Recommendation, FewLotsDecideNothing) {
  // All runs of a lot share its deviations: one lot has no scatter to tell an effect from chance.
  StandinDimension width = kPrintedWidth;
  width.lot_sigma = 0.01;
  for (const std::int64_t lots : {1, 4}) {
    const StudyData study =
        tolerance_standin(1200, 36, {width, kPrintedLength}, 0.95, widest_pocket, 1200 / lots);
    for (const BindingTest& test : judge_study(study, 50).tests)
      EXPECT_EQ(test.answer, Binding::undecided) << lots;
  }
}

TEST(Recommendation, NothingMeetsTheTarget) {
  const auto always_bad = [](const StandinCage& cage) {
    return cage.pocket[0][0] + 0.5 * std::abs(cage.pocket[0][1]);
  };
  const Judged judged = judge_study(
      tolerance_standin(2000, 32, {kPrintedWidth, kPrintedLength}, 0.95, always_bad), 50);
  EXPECT_TRUE(judged.recommendation.possible);
  EXPECT_FALSE(judged.recommendation.meets_target);
}

TEST(Recommendation, LostRunsNeverRaiseIt) {
  StudyData study =
      tolerance_standin(2000, 33, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  const Recommendation before = judge_study(study).recommendation;
  for (std::size_t i = 0; i < study.size(); i += 9)
    if (study.quantities[0].values[i] > 0) study.status[i] = RunStatus::failed;
  for (std::size_t i = 4; i < study.size(); i += 50) study.status[i] = RunStatus::censored;
  const Recommendation after = judge_study(study).recommendation;
  EXPECT_LE(after.yield.lower_bound, before.yield.lower_bound + 1e-12);
  EXPECT_LE(after.tolerances[0].tolerance_width_mm, before.tolerances[0].tolerance_width_mm);
}

TEST(Recommendation, NarrowingTheDimensionThatMattersPays) {
  const StudyData study =
      tolerance_standin(4000, 23, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  const Judged judged = judge_study(study);
  for (const StepEffect& step : judged.recommendation.steps) {
    if (step.key != "cage.pocket_width_mm") continue;
    const bool wider = step.to == "0.15 mm";
    const double exact = widest_pocket_yield(wider ? 0.15 : 0.058) - widest_pocket_yield(0.09);
    EXPECT_NEAR(step.change, exact, 0.8 * (step.upper - step.lower))
        << step.to;  // three standard errors
  }
}

}  // namespace
}  // namespace cagetol
