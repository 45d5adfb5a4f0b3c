#include "analysis/tolerance/mixture_weights.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/tolerance/yield_curve.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

const StandinDimension kMixedWidth{"cage.pocket_width_mm", 0.009, 0.009, {0.36, 0.58, 0.9, 1.5}};
const StandinDimension kMixedLength{"cage.pocket_length_mm", 0.009, 0.009, {0.36, 0.9}};

double no_badness(const StandinCage&) {
  return -1;
}

TEST(MixtureWeights, ByHand) {
  // Two candidates, two samples: p_0 = (3, 1), p_1 = (1, 1).
  const std::vector<std::vector<double>> logs = {{std::log(3), 0}, {0, 0}};
  const std::vector<double> halves = {0.5, 0.5};
  const auto weights = weights_of_densities(logs, halves);
  EXPECT_DOUBLE_EQ(weights[0][0], 1.5);
  EXPECT_DOUBLE_EQ(weights[1][0], 0.5);
  EXPECT_DOUBLE_EQ(weights[0][1], 1);
  EXPECT_DOUBLE_EQ(effective_sample_size(weights[0]), 2.5 * 2.5 / (1.5 * 1.5 + 1));
  const std::vector<double> three_of_four = {1, 1, 1, 0}, one_of_three = {2, 0, 0};
  EXPECT_DOUBLE_EQ(effective_sample_size(three_of_four), 3);
  EXPECT_DOUBLE_EQ(effective_sample_size(one_of_three), 1);
}

TEST(MixtureWeights, SurviveDensitiesInManyDimensions) {
  const std::vector<std::vector<double>> logs = {{-2000, 900}, {-2003, 800}};
  const std::vector<double> halves = {0.5, 0.5};
  const auto weights = weights_of_densities(logs, halves);
  EXPECT_NEAR(weights[0][0], 2 / (1 + std::exp(-3)), 1e-12);
  EXPECT_NEAR(weights[0][1], 2, 1e-12);
}

TEST(MixtureWeights, MeanOneAndBoundedByTheNumberOfCandidates) {
  const StudyData study = tolerance_standin(8000, 3, {kMixedWidth, kMixedLength}, 0.95, no_badness);
  const MixtureWeights mixture = mixture_weights(study);
  ASSERT_EQ(mixture.candidate.size(), 8u);
  for (const auto& weights : mixture.candidate) {
    double sum = 0;
    for (const double weight : weights) {
      EXPECT_LE(weight, 8 * (1 + 1e-12));
      sum += weight;
    }
    EXPECT_NEAR(sum / 8000, 1, 0.06);
    EXPECT_GE(effective_sample_size(weights), 8000 / 8 * 0.95);
  }
  // Over the candidates the weights of one sample average to one, exactly.
  for (std::size_t i = 0; i < 8000; i += 97) {
    double sum = 0;
    for (const auto& weights : mixture.candidate) sum += weights[i];
    EXPECT_NEAR(sum / 8, 1, 1e-12);
  }
}

TEST(MixtureWeights, ScalesOfACandidateGiveItsWeights) {
  const StudyData study = tolerance_standin(200, 3, {kMixedWidth, kMixedLength}, 0.95, no_badness);
  const MixtureWeights mixture = mixture_weights(study);
  const auto weights = weights_of_scales(study, mixture, study.plan.candidates[5].scales);
  for (std::size_t i = 0; i < weights.size(); ++i)
    EXPECT_NEAR(weights[i], mixture.candidate[5][i], 1e-9);
}

TEST(MixtureWeights, CorrelatedLotsCarryTheCopula) {
  // Two lots with correlation rho: the density is the bivariate normal one.
  StandinDimension width = kMixedWidth, length = kMixedLength;
  width.pocket_sigma = length.pocket_sigma = 0;
  StudyData study = tolerance_standin(160, 4, {width, length}, 0.95, no_badness);
  const double rho = 0.6;
  study.plan.correlations = {{"cage.pocket_width_mm:lot", "cage.pocket_length_mm:lot", rho}};
  const MixtureWeights mixture = mixture_weights(study);
  const auto log_density = [&](std::size_t i, const std::vector<double>& s) {
    const double x = study.inputs[0].lot[i] / (0.009 * s[0]),
                 y = study.inputs[1].lot[i] / (0.009 * s[1]);
    return -(x * x - 2 * rho * x * y + y * y) / (2 * (1 - rho * rho)) - std::log(s[0] * s[1]);
  };
  const auto& candidates = study.plan.candidates;
  for (std::size_t i = 0; i < 160; i += 13) {
    const double expected =
        log_density(i, candidates[1].scales) - log_density(i, candidates[6].scales);
    EXPECT_NEAR(std::log(mixture.candidate[1][i] / mixture.candidate[6][i]), expected, 1e-6);
  }
}

TEST(MixtureWeights, MeasuredValuesHaveNoDensity) {
  StudyData study = tolerance_standin(80, 3, {kMixedWidth, kMixedLength}, 0.95, no_badness);
  study.plan.inputs[0].lot = {{"law", "empirical"}, {"values", {-0.01, 0.0, 0.01}}};
  const MixtureWeights mixture = mixture_weights(study);
  EXPECT_NE(mixture.note.find("measured"), std::string::npos);
  for (std::size_t i = 0; i < 80; ++i)
    EXPECT_DOUBLE_EQ(mixture.candidate[2][i], study.candidate[i] == 2 ? 8 : 0);
}

TEST(MixtureWeights, LawsOfEarlierVersionsHaveNoDensity) {
  StudyData study = tolerance_standin(80, 3, {kMixedWidth, kMixedLength}, 0.95, no_badness);
  study.plan.inputs[0].lot = {{"law", "gamma"}, {"shape", 2}, {"scale", 1}};
  EXPECT_NE(mixture_weights(study).note.find("does not know"), std::string::npos);
}

// Fails: a pocket wider by 26 um. Does not fit: one narrower by 30 um.
TEST(MixtureWeights, OfCagesThatFitGiveTheYieldOfAll) {
  const StandinDimension width{"cage.pocket_width_mm", 0, 0.012, {0.6, 1, 1.6}};
  StudyData all = tolerance_standin(60000, 11, {width}, 0.95, widest_pocket);
  std::vector<std::size_t> fitting;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto first = all.inputs[0].pocket.begin() + static_cast<std::ptrdiff_t>(13 * i);
    if (*std::min_element(first, first + 13) > -0.03) fitting.push_back(i);
  }
  StudyData runs = select_samples(all, fitting);
  runs.plan.redraw_jams = true;
  std::vector<double> yields;
  for (const double scale : width.scales) {
    const double above = gsl_cdf_gaussian_Q(-0.03, 0.012 * scale);
    runs.jam.candidate.push_back(1 - std::pow(above, 13));
    yields.push_back(std::pow(above - gsl_cdf_gaussian_Q(0.026, 0.012 * scale), 13));
  }
  EXPECT_GT(runs.jam.candidate[2], 0.5);
  const auto joint = judge_all(runs);
  const YieldCurves curves =
      yield_curves(runs, mixture_weights(runs), joint, Resampling(runs, 50), 0.95);
  for (std::size_t k = 0; k < 3; ++k) {
    const Yield& yield = curves.candidates[k];
    EXPECT_NEAR(yield.if_unknown_fail, yields[k],
                4 * std::sqrt(yields[k] * (1 - yields[k]) / yield.ess))
        << k;
    EXPECT_NEAR(yield.fits, 1 - runs.jam.candidate[k], 1e-15);
  }
}

}  // namespace
}  // namespace cagetol
