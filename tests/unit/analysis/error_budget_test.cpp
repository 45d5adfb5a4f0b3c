#include "analysis/fidelity/error_budget.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/paired_difference.hpp"
#include "distributions/basics/random_stream.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

RefinedShift shift_of(const std::string& setting, double shift, double half) {
  return {.setting = setting, .shift = {shift, shift - half, shift + half}, .pairs = 24};
}

const ReportedMean kReportedMean{
    .standard_error = 0.1, .runs = 100, .noise_deviation = 0.5, .noise_share = {0.25, 0.16, 0.36}};

TEST(ErrorBudget, ByHand) {
  RefinedShift lossy = shift_of("slices", -9, 0.1);
  lossy.usable = false;
  lossy.lost = 3;
  const std::vector<RefinedShift> shifts = {shift_of("window", 0.25, 0.15), lossy,
                                            shift_of("integrator", -0.4, 0.1),
                                            shift_of("modes", 0.1, 0.3)};
  const ErrorBudget budget = error_budget(kReportedMean, shifts, 0.95);
  ASSERT_EQ(budget.sources.size(), 7u);
  const ErrorSource &statistical = budget.sources[0], &noise = budget.sources[1],
                    &integrator = budget.sources[2], &modes = budget.sources[3],
                    &slices = budget.sources[4], &mesh = budget.sources[5],
                    &window = budget.sources[6];
  EXPECT_EQ(statistical.error.value, 0.1);
  EXPECT_EQ(statistical.share, 1);
  EXPECT_NEAR(statistical.bound, 0.196, 1e-4);
  EXPECT_DOUBLE_EQ(noise.error.value, 0.05);  // 0.5 / sqrt(100)
  EXPECT_DOUBLE_EQ(noise.error.lower, 0.04);
  EXPECT_DOUBLE_EQ(noise.error.upper, 0.06);
  EXPECT_DOUBLE_EQ(noise.share, 0.5);
  EXPECT_EQ(integrator.state, ErrorState::resolved);
  EXPECT_DOUBLE_EQ(integrator.error.value, 0.4);  // refining lowers the mean: it is too large
  EXPECT_DOUBLE_EQ(integrator.error.lower, 0.3);
  EXPECT_DOUBLE_EQ(integrator.error.upper, 0.5);
  EXPECT_DOUBLE_EQ(integrator.bound, 0.5);
  EXPECT_DOUBLE_EQ(integrator.share, 4);
  EXPECT_EQ(modes.state, ErrorState::unresolved);
  EXPECT_DOUBLE_EQ(modes.bound, 0.4);
  EXPECT_DOUBLE_EQ(modes.share, 4);  // of its bound
  EXPECT_EQ(slices.state, ErrorState::lost);
  EXPECT_EQ(slices.lost, 3u);
  EXPECT_TRUE(std::isnan(slices.error.value));
  EXPECT_EQ(mesh.state, ErrorState::not_measured);
  EXPECT_TRUE(std::isnan(mesh.error.value));
  EXPECT_TRUE(std::isnan(mesh.share));
  EXPECT_EQ(window.state, ErrorState::resolved);
  EXPECT_DOUBLE_EQ(window.error.value, -0.25);
  EXPECT_EQ(budget.largest, "integrator");
  EXPECT_THAT(budget.open, IsEmpty());
}

TEST(ErrorBudget, AnUnresolvedSourceIsNeverTheLargest) {
  const std::vector<RefinedShift> shifts = {shift_of("integrator", -0.4, 0.1),
                                            shift_of("modes", 0.9, 1.0)};
  const ErrorBudget budget = error_budget(kReportedMean, shifts, 0.95);
  EXPECT_EQ(budget.largest, "integrator");
  EXPECT_THAT(budget.open, ElementsAre("modes"));
  // Against a shift that is certain but small the statistical error wins.
  const ErrorBudget small =
      error_budget(kReportedMean, std::vector{shift_of("modes", 0.05, 0.01)}, 0.95);
  EXPECT_EQ(small.sources[3].state, ErrorState::resolved);
  EXPECT_EQ(small.largest, "statistical");
  // Noise is part of the statistical error, and no rival of it.
  ReportedMean noisy = kReportedMean;
  noisy.noise_deviation = 2;
  EXPECT_EQ(error_budget(noisy, {}, 0.95).largest, "statistical");
}

TEST(ErrorBudget, WhatWasNotMeasuredIsNotZero) {
  const ErrorBudget budget = error_budget({}, {}, 0.95);
  for (const ErrorSource& source : budget.sources) {
    EXPECT_EQ(source.state, ErrorState::not_measured) << source.name;
    EXPECT_TRUE(std::isnan(source.error.value)) << source.name;
  }
  EXPECT_EQ(budget.largest, "");
  // One pair, or none, tells nothing; a setting that changes no bit of any run has no error.
  RefinedShift single{.setting = "slices", .shift = {0.3, kUndefined, kUndefined}, .pairs = 1};
  const ErrorBudget more = error_budget({}, std::vector{single, shift_of("window", 0, 0)}, 0.95);
  EXPECT_EQ(more.sources[4].state, ErrorState::not_measured);
  EXPECT_EQ(more.sources[6].state, ErrorState::unresolved);
  EXPECT_EQ(more.sources[6].bound, 0);
  EXPECT_TRUE(std::isnan(more.sources[6].share));  // there is no standard error to compare with
  EXPECT_THAT(more.open, IsEmpty());
}

TEST(ErrorBudget, FiveIntervalsThatJustMissZeroResolveNothing) {
  std::vector<RefinedShift> shifts;
  for (const auto name : kRefinedSettings) shifts.push_back(shift_of(std::string(name), 1.01, 1));
  const ErrorBudget five = error_budget(kReportedMean, shifts, 0.95);
  EXPECT_EQ(five.largest, "statistical");
  EXPECT_EQ(five.open.size(), 5u);
  EXPECT_EQ(error_budget(kReportedMean, std::vector{shifts[2]}, 0.95).largest, "slices");
}

/// 24 samples as run and refined in each setting, unit noise of their own on each, `bias` on modes.
std::vector<RefinedShift> drawn_shifts(std::uint32_t repeat, double bias) {
  RandomStream draws(11, Purpose::noise, repeat, 0);
  const auto normal = [&] { return gsl_cdf_ugaussian_Pinv(draws.next()); };
  std::vector<double> as_run(24);
  for (double& value : as_run) value = normal();
  std::vector<RefinedShift> shifts;
  for (const auto name : kRefinedSettings) {
    std::vector<double> refined(24);
    for (double& value : refined) value = normal() + (name == "modes" ? bias : 0);
    refined[repeat % 24] = kUndefined;  // a run that failed
    const PairedDifference paired = paired_difference(as_run, refined, 0.95);
    shifts.push_back(
        {.setting = std::string(name), .shift = paired.difference, .pairs = paired.pairs});
  }
  return shifts;
}

TEST(ErrorBudget, SeldomNamesASourceByChance) {
  const ReportedMean sure{.standard_error = 0.01, .runs = 10000};
  int named = 0, found = 0;
  for (std::uint32_t repeat = 0; repeat < 400; ++repeat) {
    named += error_budget(sure, drawn_shifts(repeat, 0), 0.95).largest != "statistical";
    const ErrorBudget biased = error_budget(sure, drawn_shifts(repeat, 1.5), 0.95);
    found += biased.largest == "modes";
  }
  EXPECT_LE(named, 33);  // 20 are expected at most, three standard deviations more; one by one 70
  EXPECT_GE(found, 370);
}

}  // namespace
}  // namespace cagetol
