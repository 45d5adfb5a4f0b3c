#include "mc/run/jam_shares.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

#include "mc/study/cage_fit.hpp"
#include "mc/study/sample.hpp"
#include "src/model/bearing_model.hpp"
#include "src/scene/pocket_clearances.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

/// Pockets 7.65 mm wide that scatter one by one, rollers of 7.5 mm that do not.
Study pockets_alone(const std::vector<std::string>& settings = {}, const std::string& law = "",
                    const std::string& more = "",
                    const std::string& candidates = "[0.2, 0.3, 0.6]") {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "study.toml")
      << "[scene]\nfile = \"" << shipped("scenes/nu205.toml") << "\"\n"
      << "[scene.cage]\npocket_width_mm = { nominal = 7.65, "
      << (law.empty() ? "pocket = { law = \"normal\", sigma = 0.05 }" : law) << " }\n"
      << more
      << "[[tolerance.dimension]]\nkey = \"cage.pocket_width_mm\"\ntolerance_width_mm = 0.3\n"
         "candidates = "
      << candidates << "\n";
  return read_study(scratch / "study.toml", settings);
}

double closed_form(double sigma_mm, double middle_mm = 0) {
  return -std::expm1(13 * std::log1p(-gsl_cdf_gaussian_P(-0.15 - middle_mm, sigma_mm)));
}

/// Of 13 gaps with a common normal part.
double quadrature(double gap, double lot, double pocket) {
  constexpr double step = 1e-3;
  double share = 0;
  for (double z = -9; z < 9; z += step)
    share += step * gsl_ran_ugaussian_pdf(z) *
             -std::expm1(13 * std::log1p(-gsl_cdf_gaussian_P(-gap - lot * z, pocket)));
  return share;
}

TEST(JamShares, AgreeWithTheClosedForm) {
  const JamShares jams = jam_shares(pockets_alone());
  ASSERT_EQ(jams.candidate.size(), 3u);
  ASSERT_EQ(jams.curves.size(), 1u);
  EXPECT_EQ(jams.draws, 0);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(jams.candidate[k], closed_form(std::array{0.2, 0.3, 0.6}[k] / 6), 1e-12);
  const JamCurve& curve = jams.curves[0];
  EXPECT_DOUBLE_EQ(curve.tolerance_width_mm.front(), 0.1);
  EXPECT_NEAR(curve.tolerance_width_mm.back(), kWidestJamTolerance * 0.6, 1e-12);
  for (std::size_t p = 0; p < curve.share.size(); ++p)
    EXPECT_NEAR(curve.share[p] / closed_form(curve.tolerance_width_mm[p] / 6), 1, 1e-6);
}

// Of zones above and below the nominal value; a curve takes the zones of the nearest candidate.
TEST(JamShares, FollowTheMiddleOfTheZone) {
  const JamShares jams =
      jam_shares(pockets_alone({}, "", "", "[0.3, \"+0.3/0\", \"+0.1/-0.2\", \"+0.7/-0.2\"]"));
  ASSERT_EQ(jams.candidate.size(), 4u);
  EXPECT_NEAR(jams.candidate[0], closed_form(0.05), 1e-12);
  EXPECT_NEAR(jams.candidate[1], closed_form(0.05, 0.15), 1e-12);
  EXPECT_NEAR(jams.candidate[2], closed_form(0.05, -0.05), 1e-9);
  EXPECT_NEAR(jams.candidate[3], closed_form(0.15, 0.25), 1e-9);
  EXPECT_GT(jams.candidate[2], 10 * jams.candidate[0]);
  const JamCurve& curve = jams.curves[0];
  const double narrow = curve.tolerance_width_mm.front(), wide = curve.tolerance_width_mm.back();
  EXPECT_NEAR(curve.share.front(), closed_form(narrow / 6), 1e-12);
  EXPECT_NEAR(curve.share.back() / closed_form(wide / 6, wide * 0.25 / 0.9), 1, 1e-6);
}

// Rollers 60 K warmer than the cage, of a material that expands by 60e-6/K.
TEST(JamShares, AreThoseInOperation) {
  const JamShares jams = jam_shares(
      pockets_alone({"scene.temperature.growth=true", "scene.temperature.inner_ring_C=80",
                     "scene.temperature.outer_ring_C=80", "scene.cage.temperature_C=20",
                     "scene.roller.expansion_um_m_K=60"}));
  const double sigma = 0.3 / 6, lost = 7.5 * 60e-6 * 60;
  const double exact = 1 - std::pow(1 - gsl_cdf_gaussian_P(lost - 0.15, sigma), 13);
  EXPECT_NEAR(jams.candidate[1], exact, 1e-6);
  EXPECT_GT(exact, 4 * closed_form(sigma));
}

TEST(JamShares, SimulatedPinchesAreNoJams) {
  EXPECT_TRUE(jam_shares(pockets_alone({"cage.allow_interference=true"})).candidate.empty());
}

// IT14 .0057228, IT13 5.5e-7, IT12 2.6e-14 of the width, 3e-7 of the length.
TEST(JamShares, OfThePublishedStudyAreThoseOfQuadrature) {
  const Study study = read_study(shipped("studies/nu205-jams.toml"));
  const JamShares jams = jam_shares(study);
  EXPECT_EQ(jams.draws, 0);
  ASSERT_EQ(jams.candidate.size(), 49u);
  for (std::size_t k = 0; k < 49; ++k) {
    const auto& scale = study.candidates[k].scales;
    const double width = quadrature(0.15, 0.009 * scale[0], std::hypot(0.009 * scale[0], 0.0004));
    const double length = quadrature(0.25, 0.009 * scale[1], 0.009 * scale[1]);
    EXPECT_NEAR(jams.candidate[k], width + length - width * length, 1e-9 * width + 1e-15) << k;
    EXPECT_LE(jams.error[k], 1e-9);
  }
  EXPECT_NEAR(jams.candidate.back(), 0.0057228 + 3e-7, 3e-7);
  // 18 um off centre, all variance among pockets, all from cage to cage.
  const double sigma = 0.0324 * std::sqrt(2);
  EXPECT_NEAR(jams.off_centre[96], quadrature(0.132, 0.0324, std::hypot(0.0324, 0.0004)), 1e-6);
  EXPECT_NEAR(jams.pockets_alone[96],
              1 - std::pow(1 - gsl_cdf_gaussian_P(-0.15, std::hypot(sigma, 0.0004)), 13), 1e-6);
  EXPECT_NEAR(jams.lots_alone[96], quadrature(0.15, sigma, 0.0004), 1e-6);
}

double standard_error(double share, double cages) {
  return std::sqrt(share * (1 - share) / cages);
}

TEST(JamShares, DrawsAgreeWithIntegrals) {
  const Study study = read_study(shipped("studies/nu205-jams.toml"));
  const JamShares jams = jam_shares(study);
  const auto drawn = drawn_jam_shares(study, 100000);
  for (std::size_t k = 0; k < 49; ++k)
    EXPECT_NEAR(drawn[k], jams.candidate[k], 3 * standard_error(jams.candidate[k], 1e5) + 3e-5)
        << k;
}

constexpr const char* kLots =
    "lot = { law = \"normal\", sigma = 0.03 }, pocket = { law = \"normal\", sigma = 0.04 }";

// Widths and rollers of one pocket with a correlation of .5: their difference has the variance
// 40^2 + 20^2 - 2 .5 40 20 um^2.
TEST(JamShares, NightlyOfACopulaAreDrawn) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  const Study study = pockets_alone({}, kLots,
                                    "[scene.roller]\ndiameter_mm = { nominal = 7.5, pocket = { law "
                                    "= \"normal\", sigma = 0.02 } }\n[[correlation]]\nbetween = "
                                    "[\"cage.pocket_width_mm:pocket\", "
                                    "\"roller.diameter_mm:pocket\"]\nrho = 0.5\n");
  const JamShares jams = jam_shares(study);
  EXPECT_EQ(jams.draws, kJamCages);
  for (std::size_t k = 0; k < 3; ++k) {
    const double s = study.candidates[k].scales[0], pocket = 0.04 * s;
    const double exact =
        quadrature(0.15, 0.03 * s, std::sqrt(pocket * pocket + 0.0004 - 0.02 * pocket));
    EXPECT_NEAR(jams.candidate[k], exact, 3 * std::sqrt(exact / 1e6)) << k;
    EXPECT_NEAR(jams.error[k], std::sqrt(exact * (1 - exact) / 1e6), 2e-5);
  }
}

TEST(JamShares, OfMeasuredValuesAreDrawn) {
  const Study study = pockets_alone(
      {},
      "lot = { law = \"normal\", sigma = 0.03 }, pocket = { law = \"empirical\", values = "
      "[-0.08, -0.05, -0.02, 0.0, 0.0, 0.02, 0.05, 0.08] }");
  const JamShares jams = jam_shares(study);
  EXPECT_EQ(jams.draws, kJamCages);
  for (std::size_t k = 0; k < 3; ++k) {
    const double s = study.candidates[k].scales[0];
    double exact = 0;
    // The smallest of 13 pockets decides: below the i-th value with the probability (i/8)^13.
    const std::array values = {-0.08, -0.05, -0.02, 0.0};
    for (std::size_t i = 0; i < 4; ++i) {
      const double above = std::pow(1 - static_cast<double>(i) / 8, 13);
      const double beyond = std::pow(1 - static_cast<double>(i + 1) / 8, 13);
      exact += (above - beyond) * gsl_cdf_gaussian_P(-0.15 - s * values[i], 0.03 * s);
    }
    EXPECT_NEAR(jams.candidate[k], exact, 3 * std::sqrt(exact / 1e6) + 1e-5) << k;
  }
}

// One law that is not normal is integrated, and so are several operating points.
TEST(JamShares, OfOneOtherLawAreIntegrated) {
  const Study study = pockets_alone(
      {},
      "lot = { law = \"uniform\", lower = -0.06, upper = 0.06 }, pocket = { law = "
      "\"triangular\", lower = -0.12, mode = 0, upper = 0.12 }",
      "[scene.roller]\ndiameter_mm = { nominal = 7.5, pocket = { law = \"normal\", sigma = 0.01 } "
      "}\n");
  const JamShares jams = jam_shares(study);
  EXPECT_EQ(jams.draws, 0);
  const auto drawn = drawn_jam_shares(study, 200000);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(jams.candidate[k], drawn[k], 4 * standard_error(drawn[k], 2e5) + 2e-5) << k;
}

// Lips: no affine gap.
TEST(JamShares, OfLipsAreThoseOfEveryCageByItself) {
  const Study study = read_study(shipped("studies/own-bearing-lips.toml"));
  constexpr long kCages = 4000;
  const auto drawn = drawn_jam_shares(study, kCages);
  Study probes = study;
  probes.design = DesignKind::random;
  probes.samples = kCages * static_cast<long>(study.candidates.size());
  const Sampler sampler(probes);
  for (std::size_t k = 0; k < study.candidates.size(); ++k) {
    long jams = 0;
    for (long i = 0; i < kCages; ++i)
      jams += !cage_fits(
          study, sampler.draw(k + static_cast<std::size_t>(i) * study.candidates.size()).scene);
    const double share = static_cast<double>(jams) / kCages;
    EXPECT_NEAR(drawn[k], share, 4 * std::sqrt(2 * (share + 2e-4) / kCages)) << k;
  }
}

// What is drawn again is what a run would call a jam.
TEST(CageFits, SaysWhatRunsSay) {
  const Study study = pockets_alone();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  int fitting = 0, jammed = 0, seized = 0;
  for (int i = 0; i < 400; ++i) {
    Scene scene = study.scene;
    scene.cage.pocket_width = {7.6e-3 + 120e-6 * any(random)};
    scene.cage.retention_outer = {7.35e-3 + 0.2e-3 * any(random)};
    scene.cage.guide_clearance = 100e-6 + 150e-6 * any(random);
    const bool jams = find_jam(scene).pocket >= 0,
               seizes = !(pocket_clearances(OperatingScene(scene), 0).ring[1] > 0);
    EXPECT_EQ(cage_fits(study, scene), !jams && !seizes) << i;
    fitting += !jams && !seizes;
    jammed += jams;
    seized += seizes;
  }
  EXPECT_GT(std::min({fitting, jammed, seized}), 30);
}

}  // namespace
}  // namespace cagetol
