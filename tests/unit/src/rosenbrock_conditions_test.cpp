// The tables of the linearly implicit methods against the conditions of order, stiff accuracy and
// L-stability (Hairer & Wanner II, IV.7 and VI.3), from the coefficients as the program uses them.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "src/integration/rosenbrock.hpp"

namespace cagetol {
namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// alpha_ij and beta_ij = alpha_ij + gamma_ij, weights b of the solution and of the embedded one.
struct Method {
  MatrixXd alpha, beta;
  VectorXd b, embedded;
};

Method method(const RosenbrockTable& table) {
  const Eigen::Index n = table.stages;
  MatrixXd a = MatrixXd::Zero(n, n), inverse = MatrixXd::Identity(n, n) / table.gamma;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      a(i, j) = table.a[i][j];
      inverse(i, j) = -table.c[i][j];
    }
  const MatrixXd gamma = inverse.inverse();
  const VectorXd m = Eigen::Map<const VectorXd>(table.m, n);
  VectorXd last = VectorXd::Zero(n);  // the embedded solution is the argument of the last stage
  last[n - 1] = 1;
  return {a * gamma, a * gamma + gamma, gamma.transpose() * m, gamma.transpose() * (m - last)};
}

/// What is left of the conditions up to an order: largest difference from 1.
double unmet(const Method& m, const VectorXd& b, int order) {
  const ArrayXd alpha = m.alpha.rowwise().sum();
  const VectorXd beta = m.beta.rowwise().sum();
  const auto weighed = [&](const VectorXd& v) { return b.dot(v); };
  std::vector<double> sums = {b.sum(), 2 * weighed(beta)};
  if (order >= 3) {
    sums.push_back(3 * weighed(alpha.square()));
    sums.push_back(6 * weighed(m.beta * beta));
  }
  if (order >= 4) {
    sums.push_back(4 * weighed(alpha.cube()));
    sums.push_back(8 * weighed(alpha * (m.alpha * beta).array()));
    sums.push_back(12 * weighed(m.beta * alpha.square().matrix()));
    sums.push_back(24 * weighed(m.beta * m.beta * beta));
  }
  double worst = 0;
  for (const double sum : sums) worst = std::max(worst, std::abs(sum - 1));
  return worst;
}

/// Growth over a step of y' = z y with h = 1: the stages as the program takes them.
std::complex<double> growth(const RosenbrockTable& table, std::complex<double> z) {
  std::complex<double> stage[RosenbrockTable::kMaxStages], y = 1;
  for (int s = 0; s < table.stages; ++s) {
    std::complex<double> argument = 1, drive = 0;
    for (int j = 0; j < s; ++j) {
      argument += table.a[s][j] * stage[j];
      drive += table.c[s][j] * stage[j];
    }
    stage[s] = (z * argument + drive) / (1 / table.gamma - z);
    y += table.m[s] * stage[s];
  }
  return y;
}

struct Claim {
  const char* name;
  const RosenbrockTable* table;
  int order, embedded, linear;
  double embedded_at_infinity;  ///< what the embedded solution leaves of the infinitely stiff
};

class RosenbrockConditions : public testing::TestWithParam<Claim> {};

TEST_P(RosenbrockConditions, OfOrder) {
  const Claim& claim = GetParam();
  const Method m = method(*claim.table);
  EXPECT_LT(unmet(m, m.b, claim.order), 2e-13);
  EXPECT_LT(unmet(m, m.embedded, claim.embedded), 2e-13);
  EXPECT_GT(unmet(m, m.embedded, claim.embedded + 1), 1e-3);
  const ArrayXd alpha = m.alpha.rowwise().sum();
  for (Eigen::Index i = 0; i < alpha.size(); ++i) {
    EXPECT_NEAR(claim.table->alpha[i], alpha[i], 1e-13);
    EXPECT_NEAR(claim.table->gamma_sum[i], (m.beta - m.alpha).row(i).sum(), 1e-13);
  }
}

TEST_P(RosenbrockConditions, OfOrderOnLinearEquations) {
  // exp(z) - R(z) = C z^(order + 1): in the ratio of two z the constant drops out.
  const auto error = [&](double z) { return std::abs(growth(*GetParam().table, z) - std::exp(z)); };
  EXPECT_NEAR(std::log2(error(-0.1) / error(-0.05)), GetParam().linear + 1, 0.15);
}

TEST_P(RosenbrockConditions, OfStiffAccuracyAndLStability) {
  const RosenbrockTable& table = *GetParam().table;
  const Method m = method(table);
  const Eigen::Index last = table.stages - 1;
  EXPECT_LT((m.b - m.beta.row(last).transpose()).norm(), 1e-13);
  const VectorXd fields = m.beta.inverse() * VectorXd::Ones(table.stages);
  const double left = GetParam().embedded_at_infinity;
  EXPECT_NEAR(1 - m.embedded.dot(fields), left, 1e-3);
  if (left == 0) {
    EXPECT_LT((m.embedded - m.beta.row(last - 1).transpose()).norm(), 1e-13);
  }
  EXPECT_NEAR(m.alpha.row(last).sum(), 1, 1e-13);
  for (double y = 0.01; y < 1e4; y *= 1.01)
    EXPECT_LE(std::abs(growth(table, {0, y})), 1 + 1e-12) << y;
  EXPECT_LT(std::abs(growth(table, -1e8)), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Tables, RosenbrockConditions,
                         testing::Values(Claim{"rodas3", &kRodas3, 3, 2, 3, 0},
                                         Claim{"rodasp", &kRodasP, 4, 3, 4, 0},
                                         Claim{"rodas4f", &kRodas4F, 4, 3, 4, 0},
                                         Claim{"rodas4s", &kRodas4S, 4, 3, 4, -0.301}),
                         [](const auto& test) { return test.param.name; });

/// An oscillation, at 1.4 and at 1 rad a step.
TEST(RosenbrockConditions, FrequencyOfAnOscillation) {
  const auto slow = [](const RosenbrockTable& table, double y) {
    return 1 - std::arg(growth(table, {0, y})) / y;
  };
  EXPECT_NEAR(slow(kRodasP, 1.4), 3.0e-3, 0.1e-3);
  EXPECT_NEAR(slow(kRodas4F, 1.4), 4.8e-4, 0.1e-4);
  EXPECT_NEAR(slow(kRodas4S, 1.4), 2.4e-3, 0.1e-3);
  EXPECT_NEAR(slow(kRodasP, 1.0), 8.2e-4, 0.1e-4);
  EXPECT_NEAR(slow(kRodas4F, 1.0), 1.2e-4, 0.1e-4);
}

/// A contact that sets in, or ends, at a share of the step, with the 10/9th power of the
/// penetration and no other force by which the step could feel it: error of the impulse, in the
/// force it would have a step later or had a step before, times the step.
TEST(RosenbrockConditions, ImpulseOfAForceThatSetsInOrDiesAway) {
  const auto wrong = [](const RosenbrockTable& table, double at, bool dies) {
    const Method m = method(table);
    const double n = 10.0 / 9.0;
    // What a step does not take from the rate and slope at its start; its integral over the step.
    const double first = dies ? std::pow(at, n) : 0, slope = dies ? -n * std::pow(at, n - 1) : 0;
    const auto force = [&](double t) {
      return std::pow(std::max(0.0, dies ? at - t : t - at), n) - first - slope * t;
    };
    double error = first + slope / 2 - std::pow(dies ? at : 1 - at, n + 1) / (n + 1);
    for (Eigen::Index i = 0; i < m.b.size(); ++i) error += m.b[i] * force(m.alpha.row(i).sum());
    return error;
  };
  for (const RosenbrockTable* table : {&kRodasP, &kRodas4F, &kRodas4S}) {
    EXPECT_LT(std::abs(wrong(*table, table->touch_place, false)), 5e-4) << table->gamma;
    // Where a step happens to end it is not.
    EXPECT_GT(std::abs(wrong(*table, 0.03, false)), 1e-2) << table->gamma;
    EXPECT_GT(std::abs(wrong(*table, 0.64, false)), 1e-2) << table->gamma;
  }
  constexpr double kPartingPlace = 0.556;
  EXPECT_LT(std::abs(wrong(kRodas4F, kPartingPlace, true)), 5e-4);
  EXPECT_GT(std::abs(wrong(kRodas4F, 0.9, true)), 5e-3);
  // Less exactly so by the others.
  EXPECT_LT(std::abs(wrong(kRodasP, kPartingPlace, true)), 1e-2);
  EXPECT_LT(std::abs(wrong(kRodas3, kPartingPlace, true)), 6e-2);
}

}  // namespace
}  // namespace cagetol
