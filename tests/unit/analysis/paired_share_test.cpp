#include "analysis/statistics/paired_share.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace cagetol {
namespace {

TEST(PairedShare, ByHand) {
  const PairedShare none = paired_share(100, 0, 0, 0.95);
  EXPECT_EQ(none.p_value, 1);
  EXPECT_EQ(none.change.value, 0);
  EXPECT_LT(none.change.lower, 0);
  EXPECT_DOUBLE_EQ(none.change.upper, -none.change.lower);
  // Six losses and no gain: 2 / 2^6.
  const PairedShare six = paired_share(300, 0, 6, 0.95);
  EXPECT_NEAR(six.p_value, 0.03125, 1e-12);
  EXPECT_DOUBLE_EQ(six.change.value, -0.02);
  EXPECT_LT(six.change.upper, 0.0005);
  // Clopper-Pearson at 1 - 0.005: the beta quantile of 7 and 294.
  EXPECT_NEAR(six.change.lower, -gsl_cdf_beta_Pinv(0.995, 7, 294), 1e-9);
  const PairedShare mirrored = paired_share(300, 6, 0, 0.95);
  EXPECT_DOUBLE_EQ(mirrored.change.lower, -six.change.upper);
  EXPECT_DOUBLE_EQ(mirrored.change.upper, -six.change.lower);
  EXPECT_EQ(paired_share(0, 0, 0, 0.95).p_value, 1);
}

/// All outcomes of n pairs.
std::vector<PairedShare> outcomes(unsigned n) {
  std::vector<PairedShare> all;
  for (unsigned g = 0; g <= n; ++g)
    for (unsigned l = 0; g + l <= n; ++l) all.push_back(paired_share(n, g, l, 0.95));
  return all;
}

double probability(const PairedShare& outcome, double gain, double lose) {
  const auto g = static_cast<unsigned>(outcome.gained), l = static_cast<unsigned>(outcome.lost);
  const double p[] = {gain, lose, 1 - gain - lose};
  const unsigned k[] = {g, l, static_cast<unsigned>(outcome.pairs) - g - l};
  return gsl_ran_multinomial_pdf(3, p, k);
}

TEST(PairedShare, IntervalCoversWhateverTheShares) {
  double minimum = 1;
  for (const unsigned n : {10u, 40u}) {
    const auto all = outcomes(n);
    for (double gain = 0; gain <= 0.5; gain += 0.05)
      for (double lose = 0; lose <= 0.5; lose += 0.05) {
        double covered = 0;
        for (const PairedShare& outcome : all)
          if (outcome.change.lower <= gain - lose + 1e-12 &&
              outcome.change.upper >= gain - lose - 1e-12)
            covered += probability(outcome, gain, lose);
        minimum = std::min(minimum, covered);
      }
  }
  std::printf("least coverage of the 95 %% interval: %.4f\n", minimum);
  EXPECT_GE(minimum, 0.95);
  EXPECT_LE(minimum, 0.98);  // not wider than it must be
}

TEST(PairedShare, TestKeepsItsLevelWhateverTheShareThatDiffers) {
  const auto all = outcomes(40);
  for (const double error : {0.05, 0.005}) {
    double most = 0;
    for (double each = 0.02; each <= 0.5; each += 0.02) {
      double alarms = 0;
      for (const PairedShare& outcome : all)
        if (outcome.p_value <= error) alarms += probability(outcome, each, each);
      most = std::max(most, alarms);
    }
    std::printf("most alarms at an error of %g: %.4f\n", error, most);
    EXPECT_LE(most, error);
    EXPECT_GE(most, 0.5 * error);
  }
}

}  // namespace
}  // namespace cagetol
