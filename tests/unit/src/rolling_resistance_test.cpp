// Rolling resistance: tables of the formulas by an independent script, the known answer of the
// inlet's heating, derivatives, and what the forces of a pair add up to.
#include "src/lubrication/rolling_resistance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/lubricated_contact.hpp"

namespace cagetol {
namespace {

RollingResistance rolling_law(const LubricatedContact& c, bool heating = false) {
  return make_rolling_resistance(c.viscosity, c.pressure_viscosity, c.radius, c.modulus, heating,
                                 0.035, 0.14);
}

template <class T>
T force_at(const RollingResistance& law, T q, T speed) {
  return rolling_resistance(rolling_scale(law, speed, log2(speed)), q, log2(q));
}

double rolling_force(const LubricatedContact& c, const RollingResistance& law, double load,
                     double speed) {
  const double q = load / c.length;
  return c.length * force_at(law, q, speed);
}

TEST(RollingResistance, TableOfTheReferenceBearing) {
  struct Row {
    double load, elastic, rigid, inner, outer;  // [N]
  };
  const Row rows[] = {
      {1, 0.4771, 0.0678, 0.0677, 0.0677},     {4, 0.4855, 0.1355, 0.1346, 0.1349},
      {20, 0.4955, 0.3031, 0.2830, 0.2888},    {100, 0.5057, 0.6777, 0.4504, 0.4904},
      {314.2, 0.5131, 1.2012, 0.5004, 0.5626}, {567, 0.5169, 1.6137, 0.5114, 0.5785}};
  const LubricatedContact inner, outer = LubricatedContact::outer();
  const RollingResistance in = rolling_law(inner), out = rolling_law(outer);
  for (const Row& row : rows) {
    const double q = row.load / inner.length, u = inner.speed, L = inner.length;
    const auto near = [&](double value, double expected) {
      EXPECT_NEAR(value, expected, std::max(1e-3 * expected, 5.1e-5)) << row.load << " N";
    };
    near(L * std::exp2(in.log_elastic) * std::pow(u, 0.658228) * std::pow(q, 0.012658),
         row.elastic);
    near(L * in.rigid * std::sqrt(u * q), row.rigid);
    near(rolling_force(inner, in, row.load, u), row.inner);
    near(rolling_force(outer, out, row.load, u), row.outer);
  }
}

TEST(RollingResistance, RigidForceInTermsOfTheFilm) {
  const LubricatedContact c;
  const double q = 100, u = 3, h = c.film().rigid * u / q;
  EXPECT_NEAR(rolling_law(c).rigid * std::sqrt(u * q),
              4.601 * c.viscosity * u * std::sqrt(c.radius / h),
              1e-3 * 4.601 * c.viscosity * u * std::sqrt(c.radius / h));
}

// The published law of K over D and L at one point, by way of an oil chosen to give these numbers.
TEST(RollingResistance, KnownAnswerOfTheHeatedInlet) {
  const double D = 0.322606730797286, L = 8.743070312928715e-6, K = 0.403451221364356;
  const double alpha = 2e-8, eta = 0.01, R = 5e-3, E = 2.2e11, u = 1, k = 0.14;
  const double beta = L * k / (eta * u * u);
  const double W = std::pow(11.81220746 * alpha * eta * u / R / D, 1 / 1.5), q = W * E * R;
  const auto law = make_rolling_resistance(eta, alpha, R, E, true, beta, k);
  RollingResistance elastic = law;
  elastic.rigid = 1e12;  // out of the way
  const double f = force_at(elastic, q, u);
  EXPECT_NEAR(f / (W * R / alpha), K, 1e-6 * K);
}

TEST(RollingResistance, HeatingTakesSomeOfTheElasticForce) {
  const LubricatedContact c;
  RollingResistance cold = rolling_law(c), hot = rolling_law(c, true);
  cold.rigid = hot.rigid = 1e12;
  EXPECT_NEAR(rolling_force(c, cold, 314.2, c.speed), 0.513, 5e-4);
  EXPECT_NEAR(rolling_force(c, hot, 314.2, c.speed), 0.467, 5e-4);
  EXPECT_NEAR(rolling_force(c, cold, 314.2, 20), 1.146, 1.2e-3);
  EXPECT_NEAR(rolling_force(c, hot, 314.2, 20), 0.726, 8e-4);
}

TEST(RollingResistance, DerivativesAgreeWithDifferences) {
  const LubricatedContact c;
  using D = Dual<double, 2>;
  for (const bool heating : {false, true}) {
    const auto law = rolling_law(c, heating);
    for (const double load : {0.01, 20.0, 3000.0})
      for (const double u : {0.01, 5.9, 50.0}) {
        const double q = load / c.length, dq = 1e-5 * q, du = 1e-5 * u;
        const auto at = [&](double x, double v) { return force_at(law, x, v); };
        const D f = force_at(law, variable<D>(q, 0), variable<D>(u, 1));
        EXPECT_NEAR(f.slope[0], (at(q + dq, u) - at(q - dq, u)) / (2 * dq), 1e-6 * f.value / q);
        EXPECT_NEAR(f.slope[1], (at(q, u + du) - at(q, u - du)) / (2 * du), 1e-6 * f.value / u);
      }
  }
}

TEST(RollingResistance, InverseCubeRootWithinItsBound) {
  for (double x = 1; x <= 2; x += 1e-3) EXPECT_NEAR(inverse_cube_root(x) * std::cbrt(x), 1, 1e-15);
}

TEST(RollingResistance, RefusesHeatingWithoutItsConstants) {
  EXPECT_THROW(make_rolling_resistance(0.02, 1.8e-8, 3e-3, 2e11, true, 0, 0.14), std::domain_error);
  EXPECT_THROW(make_rolling_resistance(0, 1.8e-8, 3e-3, 2e11, false, 0, 0), std::domain_error);
}

}  // namespace
}  // namespace cagetol
