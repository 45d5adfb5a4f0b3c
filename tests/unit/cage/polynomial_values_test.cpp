#include "src/cage/mesh/polynomial_values.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

namespace cagetol {
namespace {

/// Terms of `sectors`, of which every third is of a deviation that no pocket has.
Eigen::MatrixXd some_terms(Eigen::Index sectors) {
  Eigen::MatrixXd terms = Eigen::MatrixXd::Random(19, sectors);
  for (Eigen::Index t = 0; t < terms.rows(); t += 3) terms.row(t).setZero();
  return terms;
}

TEST(PolynomialValues, AreTheProductForAnyNumberOfPolynomialsAndSectors) {
  for (const Eigen::Index rows : {1, 7, 8, 9, 15, 16, 37})
    for (const Eigen::Index sectors : {1, 7, 8, 13, 17}) {
      const Eigen::MatrixXd coefficients = Eigen::MatrixXd::Random(rows, 19);
      const Eigen::MatrixXd terms = some_terms(sectors);
      const Eigen::MatrixXd error = polynomial_values(coefficients, terms) - coefficients * terms;
      EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-14) << rows << " x " << sectors;
    }
}

TEST(PolynomialValues, ThoseOfSomePolynomialsLeaveTheOthersAlone) {
  const Eigen::MatrixXd coefficients = Eigen::MatrixXd::Random(60, 19);
  const Eigen::MatrixXd terms = some_terms(13);
  const Eigen::MatrixXd product = coefficients * terms;
  for (const Eigen::Index rows : {5, 21}) {
    Eigen::MatrixXd values = Eigen::MatrixXd::Constant(40, 13, 3.0);
    put_values(coefficients, terms, acting_terms(terms), 30, rows, 10, values);
    EXPECT_LT((values.middleRows(10, rows) - product.middleRows(30, rows)).cwiseAbs().maxCoeff(),
              1e-14);
    EXPECT_TRUE((values.topRows(10).array() == 3).all());
    EXPECT_TRUE((values.bottomRows(30 - rows).array() == 3).all());
  }
}

TEST(PolynomialValues, CoefficientsOfDeviationsThatNoPocketHasStayUnread) {
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Random(24, 19);
  for (Eigen::Index t = 0; t < 19; t += 3)
    coefficients.col(t).setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(polynomial_values(coefficients, some_terms(13)).allFinite());
}

}  // namespace
}  // namespace cagetol
