#include "analysis/sensitivity/pick_freeze.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/sensitivity/morris.hpp"
#include "analysis/sensitivity/noise_share.hpp"
#include "analysis/study/design_blocks.hpp"
#include "analysis/study/refused.hpp"
#include "distributions/design.hpp"
#include "tests/support/synthetic_study.hpp"
#include "tests/support/test_functions.hpp"

namespace cagetol {
namespace {

/// A study whose rows are those of the design, one column a group.
StudyData study_of_design(DesignKind kind, std::uint64_t bases, std::uint32_t columns,
                          bool noise_group = false) {
  DesignSpec spec;
  spec.kind = kind;
  spec.seed = 5;
  for (std::uint32_t c = 0; c < columns; ++c) spec.columns.push_back({Purpose::lot, 100 + c, 0, c});
  if (noise_group) spec.groups = columns + 1;
  const std::uint64_t groups = noise_group ? columns + 1 : columns;
  spec.rows = bases * (kind == DesignKind::morris ? groups + 1 : groups + 2);
  const Design design(spec);
  StudyData study = plain_study(static_cast<std::int64_t>(design.rows()), design_name(kind));
  std::vector<double> u(columns);
  for (std::uint64_t row = 0; row < design.rows(); ++row) {
    design.point(row, u);
    study.design.point.insert(study.design.point.end(), u.begin(), u.end());
  }
  for (std::uint32_t c = 0; c < columns; ++c) {
    study.design.columns.push_back("x" + std::to_string(c) + ":lot");
    study.design.groups.push_back("x" + std::to_string(c) + ":lot");
  }
  return study;
}

template <class Function>
std::vector<double> outputs_of(const StudyData& study, const Function& function) {
  std::vector<double> outputs;
  const std::size_t width = study.design.columns.size();
  for (std::size_t i = 0; i < study.size(); ++i)
    outputs.push_back(function(std::span(study.design.point).subspan(i * width, width)));
  return outputs;
}

TEST(PickFreeze, IshigamiFirstOrderAndTotals) {
  const StudyData study = study_of_design(DesignKind::pick_freeze, 16384, 3);
  const auto shares = pick_freeze_shares(study, outputs_of(study, ishigami), 0, 0.95, 100);
  const double first[] = {0.313905, 0.442411, 0}, total[] = {0.557589, 0.442411, 0.243684};
  ASSERT_EQ(shares.size(), 3u);
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_NEAR(shares[g].first_order.value, first[g], 0.03) << g;
    EXPECT_NEAR(shares[g].total.value, total[g], 0.04) << g;
    EXPECT_LT(shares[g].total.lower, shares[g].total.upper);
    EXPECT_NEAR(0.5 * (shares[g].total.lower + shares[g].total.upper), total[g], 0.04) << g;
  }
}

TEST(PickFreeze, GFunctionTotals) {
  const StudyData study = study_of_design(DesignKind::pick_freeze, 8192, 8);
  const auto shares = pick_freeze_shares(study, outputs_of(study, g_function), 0, 0.95, 20);
  const double first[] = {0.716193, 0.179048, 0.023676, 0.007162},
               total[] = {0.787144, 0.242198, 0.034317, 0.010460};
  for (std::size_t g = 0; g < 4; ++g) {
    EXPECT_NEAR(shares[g].first_order.value, first[g], 0.03) << g;
    EXPECT_NEAR(shares[g].total.value, total[g], 0.02) << g;
  }
}

/// Root mean square error of the first order of a group over 200 designs of 64 bases: Y = x0 + sqrt(c)
/// x1 + noise, all of the same law, c and noise shares of the variance.
double error_of_first_order(std::size_t group, double share, double noise) {
  const StudyData whole = study_of_design(DesignKind::pick_freeze, 64 * 200, 2);
  const std::size_t rows = 64 * 4;
  double square = 0;
  for (std::size_t part = 0; part < 200; ++part) {
    StudyData study = plain_study(rows, "pick-freeze");
    study.design = whole.design;
    const auto first = whole.design.point.begin() + static_cast<std::ptrdiff_t>(part * rows * 2);
    study.design.point.assign(first, first + rows * 2);
    auto outputs = outputs_of(study, [&](std::span<const double> u) {
      return std::sqrt(1 - share - noise) * u[0] + std::sqrt(share) * u[1];
    });
    for (std::size_t i = 0; i < rows; ++i)
      outputs[i] += std::sqrt(noise) * RandomStream(3, Purpose::noise, part * rows + i).next();
    const double value =
        pick_freeze_shares(study, outputs, noise, 0.95, 1)[group].first_order.value;
    square += std::pow(value - (group == 0 ? 1 - share - noise : share), 2) / 200;
  }
  return std::sqrt(square);
}

TEST(PickFreeze, SmallFirstOrdersAreSharp) {
  // From 1 - E[(f(B) - f(AB))^2] / (2 Var) the errors of the small share are 0.12, 0.13 and 0.15.
  EXPECT_LT(error_of_first_order(1, 0.02, 0), 0.035);  // sqrt((1 - 0.98^2) / 64) = 0.025
  EXPECT_LT(error_of_first_order(1, 0.02, 0.1), 0.075);
  EXPECT_LT(error_of_first_order(1, 0.02, 0.5), 0.13);
  EXPECT_LT(error_of_first_order(0, 0.02, 0), 0.03);  // the large one beside it
}

TEST(PickFreeze, NoiseIsTakenOut) {
  // Y = x0 + x1 + noise of the same variance as both together: half of the variance is noise.
  const StudyData study = study_of_design(DesignKind::pick_freeze, 8192, 2);
  auto outputs = outputs_of(study, [](std::span<const double> u) { return u[0] + u[1]; });
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    RandomStream stream(3, Purpose::noise, i);
    outputs[i] += std::sqrt(2.0) * (stream.next() - 0.5);
  }
  const auto shares = pick_freeze_shares(study, outputs, 0.5, 0.95, 20);
  EXPECT_NEAR(shares[0].total.value, 0.25, 0.02);
  EXPECT_NEAR(shares[0].first_order.value, 0.25, 0.02);
  EXPECT_NEAR(pick_freeze_shares(study, outputs, 0, 0.95, 20)[0].total.value, 0.75, 0.02);
}

TEST(PickFreeze, GroupOfNoiseHasItsOwnRows) {
  const StudyData study = study_of_design(DesignKind::pick_freeze, 16, 2, true);
  EXPECT_THAT(design_blocks(study).groups, testing::ElementsAre("x0:lot", "x1:lot", "noise"));
}

TEST(PickFreeze, CorrelatedGroupsAreRefused) {
  StudyData study = study_of_design(DesignKind::pick_freeze, 16, 2);
  const auto outputs = outputs_of(study, [](std::span<const double> u) { return u[0]; });
  study.plan.correlations = {{"x0:lot", "x1:lot", 0.5}};
  EXPECT_THROW(pick_freeze_shares(study, outputs, 0, 0.95, 10), Refused);
  study.plan.correlations[0].rho = 0;
  EXPECT_NO_THROW(pick_freeze_shares(study, outputs, 0, 0.95, 10));
}

TEST(PickFreeze, OtherDesignsAreRefused) {
  const StudyData study = plain_study(20);
  const std::vector<double> outputs(20, 1.0);
  EXPECT_THROW(pick_freeze_shares(study, outputs, 0, 0.95, 10), Refused);
  EXPECT_THROW(elementary_effects(study, outputs), Refused);
  StudyData random_points = study_of_design(DesignKind::pick_freeze, 16, 2);
  for (std::size_t i = 0; i < random_points.design.point.size(); ++i)
    random_points.design.point[i] = static_cast<double>(i);
  EXPECT_THROW(design_blocks(random_points), Refused);
}

TEST(Morris, LinearFunctionHasConstantEffects) {
  const StudyData study = study_of_design(DesignKind::morris, 12, 3);
  const auto effects = elementary_effects(
      study, outputs_of(study, [](std::span<const double> u) { return 3 * u[0] - 2 * u[1]; }));
  ASSERT_EQ(effects.size(), 3u);
  EXPECT_EQ(effects[0].steps, 12u);
  EXPECT_NEAR(effects[0].mean, 3, 1e-12);
  EXPECT_NEAR(effects[1].mean, -2, 1e-12);
  EXPECT_NEAR(effects[1].mean_magnitude, 2, 1e-12);
  EXPECT_NEAR(effects[0].scatter, 0, 1e-12);
  EXPECT_NEAR(effects[2].mean_magnitude, 0, 1e-12);
}

TEST(NoiseShare, VarianceWithinRowsOverTheWhole) {
  StudyData study = plain_study(2000);
  std::vector<double> outputs;
  for (std::int64_t id = 0; id < 2400; ++id) {
    if (id >= 2000) {
      study.id.push_back(id);
      study.row.push_back(id - 2000);
      study.replicate.push_back(1);
    }
    RandomStream cage(1, Purpose::lot, static_cast<std::uint64_t>(id % 2000)),
        noise(1, Purpose::noise, static_cast<std::uint64_t>(id));
    outputs.push_back(3 * cage.next() + noise.next());
  }
  const NoiseShare noise = noise_share(study, outputs, 0.95);
  EXPECT_EQ(noise.rows, 400u);
  EXPECT_NEAR(noise.share.value, 0.1, 0.02);
  EXPECT_NEAR(noise.standard_deviation, std::sqrt(1.0 / 12), 0.02);
  EXPECT_LT(noise.share.lower, 0.1);
  EXPECT_GT(noise.share.upper, 0.1);
  EXPECT_EQ(noise_share(plain_study(5), std::vector<double>(5, 1.0), 0.95).rows, 0u);
}

/// Percentage of 4000 studies of `rows` rows, `pairs` of them run twice, whose interval holds the
/// noise share; half of the rest of the variance is that of lots, where they have several rows.
double noise_coverage(double share, std::int64_t rows, std::int64_t pairs, std::int64_t in_lot) {
  double held = 0;
  StudyData study = plain_study(rows, "random", in_lot);
  for (std::int64_t row = 0; row < pairs; ++row) {
    study.id.push_back(rows + row);
    study.row.push_back(row * rows / pairs);
    study.lot.push_back(study.row.back() / in_lot);
    study.replicate.push_back(1);
  }
  const double lot_part = in_lot > 1 ? 0.5 : 0;
  for (std::uint64_t repeat = 0; repeat < 4000; ++repeat) {
    std::vector<double> lot, cage, outputs;
    RandomStream stream(41, Purpose::noise, repeat);
    const auto normal = [&] { return gsl_cdf_ugaussian_Pinv(stream.next()); };
    for (std::int64_t row = 0; row < rows; ++row) {
      if (row % in_lot == 0) lot.push_back(normal());
      cage.push_back(std::sqrt(lot_part) * lot.back() + std::sqrt(1 - lot_part) * normal());
    }
    for (const std::int64_t row : study.row)
      outputs.push_back(std::sqrt(1 - share) * cage[static_cast<std::size_t>(row)] +
                        std::sqrt(share) * normal());
    const Estimate estimate = noise_share(study, outputs, 0.95).share;
    held += (estimate.lower <= share && share <= estimate.upper) / 40.0;
  }
  return held;
}

TEST(NoiseShare, IntervalsCoverTheTruth) {
  for (const double share : {0.05, 0.3, 0.6, 0.9})
    for (const std::int64_t pairs : {8, 15, 40}) {
      const double held = noise_coverage(share, 100, pairs, 1);
      EXPECT_GE(held, 93.5) << share << " " << pairs;
      EXPECT_LE(held, 96.5) << share << " " << pairs;
      RecordProperty("held", std::to_string(held));
    }
  EXPECT_NEAR(noise_coverage(0.3, 15, 15, 1), 95, 1.5);
}

TEST(NoiseShare, IntervalsCoverTheTruthInLots) {
  for (const double share : {0.05, 0.3, 0.6})
    for (const std::int64_t in_lot : {2, 5}) {
      const double held = noise_coverage(share, 100, 15, in_lot);
      EXPECT_GE(held, 93) << share << " " << in_lot;
      EXPECT_LE(held, 97) << share << " " << in_lot;
    }
}

TEST(NoiseShare, IsAtMostOne) {
  // Runs of a cage differ more than the first runs do.
  StudyData study = plain_study(24);
  std::vector<double> outputs;
  for (std::size_t i = 0; i < 24; ++i) {
    study.row[i] = static_cast<std::int64_t>(i / 2);
    study.replicate[i] = static_cast<std::int64_t>(i % 2);
    outputs.push_back(i % 2 == 0 ? static_cast<double>(i % 4) : 9.0 - static_cast<double>(i % 3));
  }
  const NoiseShare noise = noise_share(study, outputs, 0.95);
  EXPECT_EQ(noise.share.value, 1);
  EXPECT_LE(noise.share.upper, 1);
}

}  // namespace
}  // namespace cagetol
