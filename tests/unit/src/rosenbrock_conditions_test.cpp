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
  EXPECT_LT((m.embedded - m.beta.row(last - 1).transpose()).norm(), 1e-13);
  EXPECT_NEAR(m.alpha.row(last).sum(), 1, 1e-13);
  for (double y = 0.01; y < 1e4; y *= 1.01)
    EXPECT_LE(std::abs(growth(table, {0, y})), 1 + 1e-12) << y;
  EXPECT_LT(std::abs(growth(table, -1e8)), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Tables, RosenbrockConditions,
                         testing::Values(Claim{"rodas3", &kRodas3, 3, 2, 3},
                                         Claim{"rodasp", &kRodasP, 4, 3, 4}),
                         [](const auto& test) { return test.param.name; });

/// Share by which an oscillation comes out too slow, at 1 and at 1.4 rad a step.
TEST(RosenbrockConditions, FrequencyOfAnOscillation) {
  const auto slow = [](const RosenbrockTable& table, double y) {
    return 1 - std::arg(growth(table, {0, y})) / y;
  };
  EXPECT_NEAR(slow(kRodasP, 1.4), 3.0e-3, 0.1e-3);
  EXPECT_NEAR(slow(kRodasP, 1.0), 8.2e-4, 0.1e-4);
}

}  // namespace
}  // namespace cagetol
