#include "mc/run/jam_shares.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

/// Pockets 7.65 mm wide that scatter one by one, rollers of 7.5 mm that do not.
Study pockets_alone(const std::vector<std::string>& settings = {}) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "study.toml")
      << "[scene]\nfile = \"" << shipped("scenes/nu205.toml") << "\"\n"
      << "[scene.cage]\npocket_width_mm = { nominal = 7.65, pocket = { law = \"normal\", sigma = "
         "0.05 } }\n"
         "[[tolerance.dimension]]\nkey = \"cage.pocket_width_mm\"\ntolerance_width_mm = 0.3\n"
         "candidates = [0.2, 0.3, 0.6]\n";
  return read_study(scratch / "study.toml", settings);
}

double closed_form(double sigma_mm) {
  return 1 - std::pow(1 - gsl_cdf_gaussian_P(-0.15, sigma_mm), 13);
}

TEST(JamShares, AgreeWithTheClosedForm) {
  const JamShares jams = jam_shares(pockets_alone());
  ASSERT_EQ(jams.candidate.size(), 3u);
  ASSERT_EQ(jams.curves.size(), 1u);
  const auto near = [](double share, double exact) {
    return std::abs(share - exact) <= 4 * std::sqrt(exact * (1 - exact) / kJamCages) + 1e-12;
  };
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_TRUE(near(jams.candidate[k], closed_form(std::array{0.2, 0.3, 0.6}[k] / 6)))
        << k << ": " << jams.candidate[k];
  const JamCurve& curve = jams.curves[0];
  EXPECT_DOUBLE_EQ(curve.tolerance_width_mm.front(), 0.2);
  EXPECT_NEAR(curve.tolerance_width_mm.back(), kWidestJamTolerance * 0.6, 1e-12);
  for (std::size_t p = 0; p < curve.share.size(); ++p)
    EXPECT_TRUE(near(curve.share[p], closed_form(curve.tolerance_width_mm[p] / 6)))
        << curve.tolerance_width_mm[p];
  EXPECT_DOUBLE_EQ(curve.share.front(), jams.candidate[0]);
}

// Rollers 60 K warmer than the cage, of a material that expands by 60e-6/K.
TEST(JamShares, AreThoseInOperation) {
  const JamShares jams = jam_shares(
      pockets_alone({"scene.temperature.growth=true", "scene.temperature.inner_ring_C=80",
                     "scene.temperature.outer_ring_C=80", "scene.cage.temperature_C=20",
                     "scene.roller.expansion_um_m_K=60"}));
  const double sigma = 0.3 / 6, lost = 7.5 * 60e-6 * 60;
  const double exact = 1 - std::pow(1 - gsl_cdf_gaussian_P(lost - 0.15, sigma), 13);
  EXPECT_NEAR(jams.candidate[1], exact, 4 * std::sqrt(exact * (1 - exact) / kJamCages));
  EXPECT_GT(exact, 4 * closed_form(sigma));
}

TEST(JamShares, SimulatedPinchesAreNoJams) {
  EXPECT_TRUE(jam_shares(pockets_alone({"cage.allow_interference=true"})).candidate.empty());
}

}  // namespace
}  // namespace cagetol
