#include "analysis/tolerance/centre_response.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

#include "analysis/tolerance/recommendation.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

/// Widths of 7.65 mm at five centres, 0.1 mm about it; the force is least at `best`, rises steeply
/// below it as in a closing film, and scatters by a quarter.
StudyData centred(double best, std::int64_t seed, std::int64_t rows = 600) {
  StandinDimension width = kPrintedWidth;
  width.lot_sigma = 0.01;
  width.scales = {0.58, 0.9};
  StudyData study = tolerance_standin(rows, seed, {width}, 0.9, widest_pocket);
  study.plan.dimensions[0].centres = {7.55, 7.60, 7.65, 7.70, 7.75};
  std::vector<Candidate> candidates;
  for (const Candidate& candidate : study.plan.candidates)
    for (const double centre : study.plan.dimensions[0].centres) {
      candidates.push_back(candidate);
      candidates.back().shifts = {centre - 7.65};
    }
  study.plan.candidates = candidates;
  study.inputs[0].nominal = {7.65};
  Column force{kCentreQuantity, "N", "", {}};
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::normal_distribution<double> scatter(0, 5);
  for (std::size_t i = 0; i < study.size(); ++i) {
    const std::size_t k = i % candidates.size();
    study.candidate[i] = static_cast<std::int64_t>(k);
    double& lot = study.inputs[0].lot[i];
    lot += candidates[k].shifts[0];
    const double away = (7.65 + lot - best) / 0.1;
    force.values.push_back(20 + 8 * away * away - 2 * away * away * away + scatter(random));
  }
  study.quantities.push_back(force);
  return study;
}

CentreResponse response_of(const StudyData& study) {
  return centre_response(study, 0, Resampling(study, 200), 0.95).value();
}

TEST(CentreResponse, FindsWhereTheForceIsLeast) {
  const CentreResponse response = response_of(centred(7.63, 5));
  EXPECT_LE(response.optimum.lower, 7.63);
  EXPECT_GE(response.optimum.upper, 7.63);
  EXPECT_NEAR(response.optimum.value, 7.63, 0.03);
  EXPECT_FALSE(response.at_end);
  ASSERT_EQ(response.means.size(), 5u);
  EXPECT_LT(response.means[2].mean, response.means[0].mean);
  for (const CentreMean& mean : response.means) EXPECT_GT(mean.runs, 80u);
}

TEST(CentreResponse, BreaksTheTieBetweenCentresOfOneTolerance) {
  for (const double best : {7.60, 7.70}) {
    const StudyData study = centred(best, 8, 2000);
    const auto joint = judge_all(study);
    const Resampling resampling(study, 100);
    const MixtureWeights mixture = mixture_weights(study);
    const YieldCurves curves = yield_curves(study, mixture, joint, resampling, 0.9);
    const auto tests = test_binding(study, mixture, curves, joint, resampling);
    const Recommendation chosen =
        recommend_tolerance(study, mixture, curves, tests, joint, resampling);
    ASSERT_TRUE(chosen.meets_target);
    EXPECT_NEAR(*chosen.tolerances[0].centre, best, 1e-9);
  }
}

TEST(CentreResponse, SaysWhenTheOptimumMayLieBeyondTheCentres) {
  EXPECT_TRUE(response_of(centred(7.5, 6)).at_end);
}

TEST(CentreResponse, NeedsCentresRunsAndTheQuantity) {
  StudyData study = centred(7.63, 7);
  EXPECT_FALSE(centre_response(centred(7.63, 7, 20), 0, Resampling(study, 50), 0.95));
  StudyData other = study;
  other.plan.dimensions[0].centres = {7.6, 7.7};
  EXPECT_FALSE(centre_response(other, 0, Resampling(other, 50), 0.95));
  other = study;
  other.quantities.pop_back();
  EXPECT_FALSE(centre_response(other, 0, Resampling(other, 50), 0.95));
}

TEST(CentreResponse, IntervalHoldsTheOptimumInFourHundredRepeats) {
  int covered = 0, narrow = 0;
  const int repeats = 400;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const double best = 7.60 + 0.1 * (repeat % 11) / 10;
    const Estimate optimum = response_of(centred(best, 1000 + repeat)).optimum;
    covered += optimum.lower <= best && best <= optimum.upper;
    narrow += optimum.upper - optimum.lower <= 0.2 / 3;
  }
  std::printf("optimum in its interval in %.3f of %d repeats, interval at most a third in %.3f\n",
              covered / double(repeats), repeats, narrow / double(repeats));
  EXPECT_GE(covered, 0.9 * repeats);
  EXPECT_GE(narrow, 0.9 * repeats);
}

}  // namespace
}  // namespace cagetol
