// Prothero and Robinson's equation y' = lambda (y - phi(t)) + phi'(t), y = phi: what is left of a
// method's order where the problem is stiff (Math. Comp. 28, 1974). The tables of the linearly
// implicit methods, run here on one equation with a fixed step.
#include <gtest/gtest.h>

#include <cmath>

#include "src/integration/rosenbrock.hpp"

namespace cagetol {
namespace {

double phi(double t) {
  return std::sin(t + 0.3);
}
double phi_rate(double t) {
  return std::cos(t + 0.3);
}

/// |y - phi| at t = 1 after `steps` equal steps.
double error(const RosenbrockTable& table, double lambda, int steps) {
  const auto f = [&](double t, double y) { return lambda * (y - phi(t)) + phi_rate(t); };
  const double h = 1.0 / steps;
  double y = phi(0);
  for (int n = 0; n < steps; ++n) {
    const double t = n * h, by_time = -lambda * phi_rate(t) - phi(t);
    double stage[RosenbrockTable::kMaxStages];
    for (int s = 0; s < table.stages; ++s) {
      double argument = y, drive = table.gamma_sum[s] * h * by_time;
      for (int j = 0; j < s; ++j) {
        argument += table.a[s][j] * stage[j];
        drive += table.c[s][j] / h * stage[j];
      }
      stage[s] = (f(t + table.alpha[s] * h, argument) + drive) / (1 / (table.gamma * h) - lambda);
    }
    for (int s = 0; s < table.stages; ++s) y += table.m[s] * stage[s];
  }
  return std::abs(y - phi(1));
}

double order(const RosenbrockTable& table, double lambda, int steps) {
  return std::log2(error(table, lambda, steps) / error(table, lambda, 2 * steps));
}

TEST(ProtheroRobinson, FullOrderWhereNothingIsStiff) {
  EXPECT_NEAR(order(kRodas3, -1, 64), 3, 0.1);
  EXPECT_NEAR(order(kRodasP, -1, 32), 4, 0.1);
}

/// Rodas3 is left with order 1 and an error in proportion to 1/lambda, RodasP with order 3.
TEST(ProtheroRobinson, OrderThatStiffnessLeaves) {
  EXPECT_NEAR(order(kRodas3, -1e6, 16), 1, 0.1);
  EXPECT_NEAR(order(kRodasP, -1e6, 16), 3, 0.1);
  EXPECT_LT(error(kRodas3, -1e6, 16), 1e-7);
  EXPECT_LT(error(kRodasP, -1e6, 16), 1e-12);
  EXPECT_NEAR(error(kRodas3, -1e5, 16) / error(kRodas3, -1e6, 16), 10, 0.5);
}

}  // namespace
}  // namespace cagetol
