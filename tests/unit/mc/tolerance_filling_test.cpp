// Pp of the laws of a dimension, parts outside their tolerance, and candidates that take no roller.
#include "mc/study/tolerance_filling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Of the NU 205 (rollers of 7.5 mm in pockets of 7.65 mm), with these laws of the pocket width.
Study study_with(const std::string& laws, const std::string& candidates) {
  const ScratchDirectory scratch;
  const std::string path = scratch / "study.toml";
  std::ofstream(path) << "samples = 4\n[scene]\nfile = '" << shipped("scenes/nu205.toml")
                      << "'\n[scene.cage]\npocket_width_mm = { nominal = 7.65, " << laws
                      << " }\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\n"
                      << "tolerance_width_mm = 0.1\ncandidates = [" << candidates << "]\n";
  return read_study(path, {});
}

std::string normal(const std::string& sigma) {
  return "{ law = 'normal', sigma = " + sigma + " }";
}

TEST(ToleranceFilling, AddsTheVariancesOfLotAndPocket) {
  const auto filling = tolerance_fillings(
      study_with("lot = " + normal("0.009") + ", pocket = " + normal("0.012"), "0.1"));
  ASSERT_EQ(filling.size(), 1u);
  EXPECT_NEAR(filling[0].deviation_mm, 0.015, 1e-12);
  EXPECT_NEAR(filling[0].capability, 0.1 / 0.09, 1e-12);
  EXPECT_DOUBLE_EQ(filling[0].nominal_mm, 7.65);
  EXPECT_DOUBLE_EQ(filling[0].counterpart_mm, 7.5);
  EXPECT_FALSE(filling[0].within);
}

TEST(ToleranceFilling, AUniformLawThatFillsItsToleranceHasNoPartsOutside) {
  const auto uniform = [](const std::string& half) {
    return "pocket = { law = 'uniform', lower = -" + half + ", upper = " + half + " }";
  };
  const auto inside = study_with(uniform("0.05"), "0.1"),
             outside = study_with(uniform("0.08"), "0.1");
  EXPECT_TRUE(tolerance_fillings(inside)[0].within);
  EXPECT_THAT(tolerance_warnings(inside), Not(Contains(HasSubstr("lie outside"))));
  EXPECT_FALSE(tolerance_fillings(outside)[0].within);
  EXPECT_THAT(tolerance_warnings(outside), Contains(HasSubstr("lie outside")));
}

TEST(ToleranceFilling, WarnsOfPartsWhoseMeanLiesOutside) {
  const auto off = [](const std::string& mean) {
    return study_with(
        "lot = { law = 'normal', mean = " + mean + ", sigma = 0.01 }, pocket = " + normal("0.006"),
        "0.1");
  };
  EXPECT_DOUBLE_EQ(tolerance_fillings(off("-0.04"))[0].mean_mm, -0.04);
  EXPECT_THAT(tolerance_warnings(off("-0.04")), testing::IsEmpty());
  EXPECT_THAT(tolerance_warnings(off("-0.06")),
              Contains(HasSubstr("mean of its laws lies -0.06 mm from the nominal value")));
}

TEST(ToleranceFilling, NamesTheToleranceFromWhichAPartMayBeSmallerThanItsRoller) {
  const std::string laws = "pocket = " + normal("0.0125");
  EXPECT_THAT(tolerance_notes(study_with(laws, "0.2, 0.3")), testing::IsEmpty());
  EXPECT_THAT(tolerance_notes(study_with(laws, "0.2, 0.32, 0.4")),
              Contains(HasSubstr(
                  "from a tolerance of 0.32 mm on, a part inside its tolerance may be as small "
                  "as 7.49 mm, less than the roller's diameter of 7.5 mm")));
}

}  // namespace
}  // namespace cagetol
