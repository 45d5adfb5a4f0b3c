#include "analysis/sensitivity/binned_shares.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "analysis/study/refused.hpp"
#include "distributions/basics/random_stream.hpp"
#include "tests/support/synthetic_study.hpp"
#include "tests/support/test_functions.hpp"

namespace cagetol {
namespace {

constexpr double kIshigami[] = {0.313905, 0.442411, 0};

struct Drawn {
  std::vector<std::vector<double>> inputs;
  std::vector<double> output;
};

template <class Function>
Drawn draw(std::size_t runs, std::size_t inputs, std::uint64_t seed, const Function& function) {
  Drawn drawn{std::vector<std::vector<double>>(inputs), {}};
  for (std::size_t i = 0; i < runs; ++i) {
    RandomStream stream(seed, Purpose::lot, i);
    std::vector<double> u(inputs);
    for (std::size_t d = 0; d < inputs; ++d) drawn.inputs[d].push_back(u[d] = stream.next());
    drawn.output.push_back(function(u));
  }
  return drawn;
}

double share_of(const std::vector<double>& feature, const std::vector<double>& output) {
  return binned_share(make_binning(feature), output, std::vector<double>(output.size(), 1.0));
}

TEST(Binning, EqualClassesAndTies) {
  std::vector<double> feature(100);
  for (std::size_t i = 0; i < 100; ++i) feature[i] = static_cast<double>((i * 37) % 100);
  EXPECT_EQ(make_binning(feature).bins, 5u);
  const Binning binning = make_binning(feature, 10);
  EXPECT_EQ(binning.bins, 10u);
  std::vector<int> count(10);
  for (const std::size_t bin : binning.bin_of) ++count[bin];
  EXPECT_EQ(count, std::vector<int>(10, 10));
  const Binning tied = make_binning(std::vector<double>{1, 1, 1, 1, 1, 2, 2, 3}, 4);
  EXPECT_EQ(tied.bin_of, (std::vector<std::size_t>{0, 0, 0, 0, 0, 1, 1, 2}));
  EXPECT_EQ(make_binning(std::vector<double>(9, 4.0)).bins, 1u);
}

TEST(BinnedShares, IshigamiAndGFunction) {
  const Drawn ishi = draw(16384, 3, 11, ishigami);
  for (std::size_t d = 0; d < 3; ++d)
    EXPECT_NEAR(share_of(ishi.inputs[d], ishi.output), kIshigami[d], 0.015) << d;
  const Drawn g = draw(16384, 8, 12, g_function);
  const double exact[] = {0.716193, 0.179048, 0.023676, 0.007162, 0, 0, 0, 0};
  for (std::size_t d = 0; d < 8; ++d)
    EXPECT_NEAR(share_of(g.inputs[d], g.output), exact[d], 0.015) << d;
}

TEST(BinnedShares, LotShareOfHierarchicalLinear) {
  // Y = sum_p c_p (L + W_p): lot share (sum c)^2 s_L^2 / ((sum c)^2 s_L^2 + sum c^2 s_W^2).
  const double c[] = {1, 0.5, -0.2, 0.7}, lot_sigma = 0.9, pocket_sigma = 1.3;
  double sum = 0, squares = 0;
  for (const double value : c) sum += value, squares += value * value;
  const Drawn drawn = draw(16384, 5, 13, [&](const std::vector<double>& u) {
    double y = 0;
    for (std::size_t p = 0; p < 4; ++p)
      y += c[p] * (lot_sigma * gsl_cdf_ugaussian_Pinv(u[0]) +
                   pocket_sigma * gsl_cdf_ugaussian_Pinv(u[p + 1]));
    return y;
  });
  const double lot = std::pow(sum * lot_sigma, 2), pockets = squares * std::pow(pocket_sigma, 2);
  EXPECT_NEAR(share_of(drawn.inputs[0], drawn.output), lot / (lot + pockets), 0.015);
  for (std::size_t p = 0; p < 4; ++p)
    EXPECT_NEAR(share_of(drawn.inputs[p + 1], drawn.output),
                std::pow(c[p] * pocket_sigma, 2) / (lot + pockets), 0.015);
}

TEST(BinnedShares, InputThatDoesNothingIsZeroOnAverage) {
  double sum = 0;
  const int repeats = 200;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Drawn drawn =
        draw(400, 2, 100 + static_cast<std::uint64_t>(repeat), [](const auto& u) { return u[0]; });
    sum += share_of(drawn.inputs[1], drawn.output) / repeats;
  }
  EXPECT_NEAR(sum, 0, 0.004);  // uncorrected: (P-1)/N = 0.0475
}

TEST(BinnedShares, RunsWithoutValueAreLeftOut) {
  Drawn drawn = draw(4000, 2, 14, [](const auto& u) { return u[0] + u[1]; });
  for (std::size_t i = 0; i < 4000; i += 3) drawn.output[i] = NAN;
  EXPECT_NEAR(share_of(drawn.inputs[0], drawn.output), 0.5, 0.03);
  EXPECT_TRUE(std::isnan(share_of(drawn.inputs[0], std::vector<double>(4000, 2.0))));
}

/// How often the 95 % interval holds the exact share, and how often the upper end for x3 is below
/// 0.03.
struct Coverage {
  double held[2] = {0, 0}, small = 0;
};
Coverage ishigami_coverage(int repeats, std::int64_t runs) {
  Coverage coverage;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Drawn drawn = draw(static_cast<std::size_t>(runs), 3,
                             1000 + static_cast<std::uint64_t>(repeat), ishigami);
    const Resampling resampling(plain_study(runs, "random", 1, repeat + 1), 300);
    for (std::size_t d = 0; d < 3; ++d) {
      const Estimate share =
          binned_share_estimate(make_binning(drawn.inputs[d]), drawn.output, resampling, 0.95);
      if (d < 2)
        coverage.held[d] +=
            (share.lower <= kIshigami[d] && kIshigami[d] <= share.upper) * 100.0 / repeats;
      else
        coverage.small += (share.upper < 0.03) * 100.0 / repeats;
    }
  }
  return coverage;
}

TEST(BinnedShares, IntervalsCoverIshigami) {
  const Coverage coverage = ishigami_coverage(60, 4096);
  // Three standard errors of 60 repeats below the 93 % that a thousand repeats give.
  EXPECT_GE(coverage.held[0], 83);
  EXPECT_GE(coverage.held[1], 83);
  EXPECT_GE(coverage.small, 90);
}

TEST(NightlyBinnedShares, IntervalsCoverInAThousandRepeats) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  const Coverage coverage = ishigami_coverage(1000, 4096);
  for (const double held : coverage.held) {
    EXPECT_GE(held, 92);
    EXPECT_LE(held, 98);
  }
  EXPECT_GE(coverage.small, 95);
  RecordProperty("held_x1", std::to_string(coverage.held[0]));
  RecordProperty("held_x2", std::to_string(coverage.held[1]));
  RecordProperty("small_x3", std::to_string(coverage.small));
}

/// Percentage of repeats whose 95 % interval holds the share of a normal input X: Y = r f(X) +
/// noise, f a straight line or a parabola of unit variance.
double normal_coverage(double share, bool parabola, std::int64_t runs, int repeats) {
  double held = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Drawn drawn =
        draw(static_cast<std::size_t>(runs), 2, 5000 + static_cast<std::uint64_t>(repeat),
             [&](const auto& u) {
               const double x = gsl_cdf_ugaussian_Pinv(u[0]);
               const double f = parabola ? (x * x - 1) / std::sqrt(2) : x;
               return std::sqrt(share) * f + std::sqrt(1 - share) * gsl_cdf_ugaussian_Pinv(u[1]);
             });
    std::vector<double> normal;
    for (const double u : drawn.inputs[0]) normal.push_back(gsl_cdf_ugaussian_Pinv(u));
    const Resampling resampling(plain_study(runs, "random", 1, repeat + 1), 200);
    const Estimate estimate =
        binned_share_estimate(make_binning(normal), drawn.output, resampling, 0.95);
    held += (estimate.lower <= share && share <= estimate.upper) * 100.0 / repeats;
  }
  return held;
}

TEST(BinnedShares, IntervalsCoverDominantNormalInputs) {
  // Three standard errors of 100 repeats below 95 %.
  for (const double share : {0.95, 0.83}) EXPECT_GE(normal_coverage(share, false, 500, 100), 88);
}

TEST(NightlyBinnedShares, IntervalsCoverNormalInputs) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  for (const double share : {0.95, 0.83, 0.5, 0.1})
    for (const std::int64_t runs : {128, 500, 2000}) {
      const double line = normal_coverage(share, false, runs, 400);
      const double parabola = normal_coverage(share, true, runs, 400);
      // Three standard errors below what 600 repeats gave. Few classes lose more of a
      // parabola, whose outer runs weigh most.
      EXPECT_GE(line, runs < 500 ? 89 : 91.5) << share << " " << runs;
      EXPECT_GE(parabola, runs < 500 ? 78.5 : 83.5) << share << " " << runs;
      RecordProperty(fmt::format("line_{}_{}", share, runs), fmt::format("{:.1f}", line));
      RecordProperty(fmt::format("parabola_{}_{}", share, runs), fmt::format("{:.1f}", parabola));
    }
}

/// Cages in lots: Y = sqrt(share) X + what the lot does else + what the cage does else. X is a
/// feature of the lot, or half of it of the cage.
struct InLots {
  std::vector<double> feature, output;
};
InLots draw_in_lots(std::size_t cages_per_lot, bool of_lot, double share, int repeat) {
  InLots drawn;
  const auto normal = [](RandomStream& stream) { return gsl_cdf_ugaussian_Pinv(stream.next()); };
  double shared = 0, lot_effect = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    RandomStream stream(9000 + static_cast<std::uint64_t>(repeat), Purpose::lot, i);
    const double own = normal(stream), cage_effect = normal(stream);
    if (i % cages_per_lot == 0) shared = normal(stream), lot_effect = normal(stream);
    drawn.feature.push_back(of_lot ? shared : std::sqrt(0.5) * (shared + own));
    drawn.output.push_back(std::sqrt(share) * drawn.feature.back() +
                           std::sqrt(0.5 * (1 - share)) * (lot_effect + cage_effect));
  }
  return drawn;
}

/// Mean estimate and the percentage of 300 repeats whose interval holds the share.
std::pair<double, double> lot_coverage(std::size_t cages_per_lot, bool of_lot, double share) {
  double mean = 0, held = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    const InLots drawn = draw_in_lots(cages_per_lot, of_lot, share, repeat);
    const Resampling resampling(
        plain_study(200, "random", static_cast<std::int64_t>(cages_per_lot), repeat + 1), 200);
    const Estimate estimate = binned_share_estimate(
        make_binning(drawn.feature, 0, resampling.lot_of()), drawn.output, resampling, 0.95);
    mean += estimate.value / 300;
    held += (estimate.lower <= share && share <= estimate.upper) / 3.0;
  }
  return {mean, held};
}

TEST(BinnedShares, NullFeaturesOfLotsHaveNoShare) {
  for (const std::size_t cages : {1, 2, 5, 10, 20})
    for (const bool of_lot : {true, false}) {
      const auto [mean, held] = lot_coverage(cages, of_lot, 0);
      EXPECT_NEAR(mean, 0, 0.03) << cages << " " << of_lot;
      EXPECT_GE(held, 91.5) << cages << " " << of_lot;
    }
}

TEST(BinnedShares, OfFeaturesOfLotsAreHeldWhereLotsAreMany) {
  for (const std::size_t cages : {1, 2, 5}) {
    const auto [mean, held] = lot_coverage(cages, true, 0.3);
    EXPECT_NEAR(mean, 0.3, 0.03) << cages;
    EXPECT_GE(held, 91) << cages;
  }
}

TEST(Binning, CountsTheValuesOfALotOnce) {
  std::vector<std::size_t> lot;
  std::vector<double> shared, own;
  for (std::size_t i = 0; i < 400; ++i) {
    lot.push_back(i / 4);
    shared.push_back(static_cast<double>(i / 4));
    own.push_back(static_cast<double>(i));
  }
  EXPECT_EQ(make_binning(shared, 0, lot).bins, bin_count(100));
  EXPECT_EQ(make_binning(own, 0, lot).bins, bin_count(400));
}

TEST(ResponseCurve, StandardErrorOfLots) {
  // Two lots of 50 runs alike: two values, whose mean has the standard error 1.
  std::vector<std::size_t> lot;
  std::vector<double> feature(100, 3.0), output;
  for (std::size_t i = 0; i < 100; ++i) lot.push_back(i / 50), output.push_back(i < 50 ? 0 : 2);
  EXPECT_NEAR(response_curve(feature, output, 1, lot)[0].standard_error, 1, 1e-12);
  EXPECT_NEAR(response_curve(feature, output, 1)[0].standard_error, std::sqrt(1 / 99.0), 1e-12);
}

TEST(ResponseCurve, FollowsTheFunction) {
  const Drawn drawn = draw(3000, 2, 15, [](const auto& u) { return u[0] * u[0]; });
  const auto points = response_curve(drawn.inputs[0], drawn.output, 10);
  ASSERT_EQ(points.size(), 10u);
  for (const ResponsePoint& point : points)
    EXPECT_NEAR(point.mean, point.feature * point.feature, 0.002);
}

}  // namespace
}  // namespace cagetol
