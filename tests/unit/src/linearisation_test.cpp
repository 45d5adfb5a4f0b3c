// Derivatives of the right-hand side, and the structured solver built on them, against dense references.
#include "src/dynamics/linearisation.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

#include "src/dynamics/newton_matrix.hpp"
#include "src/integration/system.hpp"
#include "tests/support/dense_jacobian.hpp"
#include "tests/support/random_bearing.hpp"

namespace cagetol {
namespace {

struct Linearised {
  RandomBearing bearing;
  System system;
  Eigen::MatrixXd assembled;
  explicit Linearised(const RandomBearing& b) : bearing(b), system(bearing.model) {
    system.linearise_at(bearing.t, bearing.y.data());
    assembled = assembled_jacobian(bearing.model, bearing.y, system.linear);
  }
};

/// Largest entry of a matrix in error scales, so that every component counts alike.
double size_in_scales(const Eigen::MatrixXd& J, const std::vector<double>& scale, int first_row, int last_row) {
  double size = 0;
  for (int i = first_row; i < last_row; ++i)
    for (int k = 0; k < J.cols(); ++k) {
      const double row = scale[static_cast<std::size_t>(i)], column = scale[static_cast<std::size_t>(k)];
      if (row < 1e20 && column < 1e20) size = std::max(size, std::abs(J(i, k)) * column / row);
    }
  return size;
}

double relative_difference(unsigned seed, double lean) {
  const Linearised x(random_bearing(seed, {.lean = lean}));
  const auto& scale = x.system.scale;
  const Eigen::MatrixXd differenced =
      differenced_jacobian(x.bearing.model, x.bearing.t, x.bearing.y, scale, 1e-4);
  const int n = x.system.size;
  return size_in_scales(x.assembled - differenced, scale, 0, n) / size_in_scales(differenced, scale, 0, n);
}

TEST(Linearisation, RatesAreThoseOfTheRightHandSideToTheBit) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Linearised x(random_bearing(seed));
    std::vector<double> rates(x.bearing.y.size());
    evaluate_rates(x.bearing.model, x.bearing.t, x.bearing.y.data(), rates.data());
    EXPECT_EQ(rates, x.system.rate) << seed;
  }
}

TEST(Linearisation, AgreesWithDifferencesButForTermsOfTheLeanAngles) {
  double worst = 0, worst_straight = 0;
  for (unsigned seed = 0; seed < 48; ++seed) {
    worst = std::max(worst, relative_difference(seed, 1));
    worst_straight = std::max(worst_straight, relative_difference(seed, 0));
  }
  std::printf("worst %g straight %g\n", worst, worst_straight);
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(worst_straight, 1e-3);
}

TEST(NewtonMatrix, SolvesLikeDenseFactorsOfTheAssembledMatrix) {
  std::mt19937_64 engine(3);
  double worst = 0;
  for (unsigned seed = 0; seed < 48; ++seed) {
    const Linearised x(random_bearing(seed));
    const int n = x.system.size;
    for (double beta : {1e-8, 1e-6, 2e-5}) {
      NewtonMatrix newton(x.bearing.model);
      ASSERT_TRUE(newton.factor(x.system.linear, beta));
      Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n), solution(n), scale(n);
      for (int i = 0; i < n; ++i) {
        scale[i] = x.system.scale[static_cast<std::size_t>(i)];
        if (scale[i] > 1e20) scale[i] = 1;
        else rhs[i] = scale[i] * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1);
      }
      newton.solve(rhs.data(), solution.data());
      // Equilibrated with the scales, so that the dense factors lose nothing to units.
      const Eigen::MatrixXd J = scale.cwiseInverse().asDiagonal() * x.assembled * scale.asDiagonal();
      const Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n) / beta - J;
      const Eigen::VectorXd dense = Eigen::FullPivLU<Eigen::MatrixXd>(A).solve(scale.cwiseInverse().cwiseProduct(rhs));
      const Eigen::VectorXd ours = scale.cwiseInverse().cwiseProduct(solution);
      const double apart = (ours - dense).cwiseAbs().maxCoeff() / dense.cwiseAbs().maxCoeff();
      worst = std::max(worst, apart);
      EXPECT_LT(apart, 1e-9) << "seed " << seed << ", beta " << beta;
      // The right-hand side may be the solution's own storage.
      newton.solve(rhs.data(), rhs.data());
      EXPECT_EQ(rhs, solution);
    }
  }
  std::printf("newton worst %g\n", worst);
}

}  // namespace
}  // namespace cagetol
