// Press fits against their closed forms for one material, causes and their order.
#include "src/operation/press_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cagetol {
namespace {

constexpr Material kRingSteel{208e9, 0.3, 7810};

/// A ring of 25 to 31.5 mm on a shaft.
PressFit on_shaft(double shaft_bore, double interference) {
  return {{{shaft_bore / 2, 12.5e-3, kRingSteel}},
          {{12.5e-3, 15.75e-3, kRingSteel}},
          interference,
          12.5e-3};
}

TEST(PressFit, WidensTheRacewayByTheClosedFormOfOneMaterial) {
  for (const double bore : {0.0, 10e-3, 18e-3}) {
    const double share = (1 - std::pow(bore / 25e-3, 2)) / (1 - std::pow(bore / 31.5e-3, 2));
    const Growth raceway = fit_growth(on_shaft(bore, 20e-6), true, 15.75e-3);
    EXPECT_NEAR(raceway.fit, 20e-6 * 25 / 31.5 * share, 1e-15);
    EXPECT_EQ(raceway.heat, 0);
    EXPECT_EQ(raceway.spin, 0);
  }
  // p = E s/(4 R) (1 - R^2/b^2), s of diameters.
  EXPECT_NEAR(fit_state(on_shaft(0, 20e-6)).pressure,
              208e9 * 20e-6 / (4 * 12.5e-3) * (1 - std::pow(25 / 31.5, 2)), 1);
}

TEST(PressFit, SharesTheInterferenceBetweenBothBodies) {
  PressFit fit = on_shaft(10e-3, 20e-6);
  fit.inside.ring.material = {70e9, 0.33, 2700};
  const double ring = fit_growth(fit, true, fit.radius).fit,
               shaft = fit_growth(fit, false, fit.radius).fit;
  EXPECT_GT(ring, 0);
  EXPECT_LT(shaft, 0);
  EXPECT_NEAR(ring - shaft, 20e-6, 1e-18);
  fit.inside.heat = 1e-4;
  fit.outside.heat = 3e-4;
  fit.inside.speed = fit.outside.speed = 2000;
  // Bodies that touch have one radius.
  const Growth outer = fit_growth(fit, true, fit.radius),
               inner = fit_growth(fit, false, fit.radius);
  EXPECT_NEAR(outer.total() - inner.total(), 20e-6, 1e-17);
  EXPECT_NE(outer.heat, 0);
  EXPECT_NE(outer.spin, 0);
}

/// Both bodies equally warm: the fit keeps its interference. A colder shaft opens it.
TEST(PressFit, LosesWhatTheShaftIsColder) {
  PressFit fit = on_shaft(0, 20e-6);
  fit.inside.heat = fit.outside.heat = 6e-4;
  EXPECT_NEAR(fit_state(fit).interference, 20e-6, 1e-18);
  EXPECT_NEAR(fit_growth(fit, true, 15.75e-3).heat, 6e-4 * 31.5e-3, 1e-15);
  fit.inside.heat = 2e-4;
  EXPECT_NEAR(fit_state(fit).interference, 20e-6 - 4e-4 * 25e-3, 1e-18);
  fit.inside.heat = -3e-4;  // 9e-4 * 25 mm = 22.5 um
  EXPECT_NEAR(fit_state(fit).interference, -2.5e-6, 1e-18);
  EXPECT_EQ(fit_state(fit).pressure, 0);
  const Growth open = fit_growth(fit, true, 15.75e-3);  // as if there were no shaft
  EXPECT_NEAR(open.total(), 6e-4 * 31.5e-3, 1e-15);
  EXPECT_NEAR(open.fit, 20e-6 * 25 / 31.5, 1e-15);
}

/// A solid disc of ring and shaft in one piece grows as the pressed pair does.
TEST(PressFit, TurnsAsOnePieceWhileItIsClosed) {
  PressFit fit = on_shaft(0, 20e-6);
  fit.inside.speed = fit.outside.speed = 1700;
  const Growth raceway = fit_growth(fit, true, 15.75e-3);
  EXPECT_NEAR(raceway.spin, 2 * spinning_growth({0, 15.75e-3, kRingSteel}, 1700, 15.75e-3), 1e-16);
  EXPECT_LT(fit_state(fit).interference, 20e-6);
  fit.interference = 0;  // the ring leaves its shaft and grows alone
  EXPECT_NEAR(fit_growth(fit, true, 15.75e-3).spin,
              2 * spinning_growth(fit.outside.ring, 1700, 15.75e-3), 1e-18);
  EXPECT_LT(fit_state(fit).interference, 0);
}

}  // namespace
}  // namespace cagetol
