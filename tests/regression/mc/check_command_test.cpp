// `cagetol check` on duties over time, laws and tolerances.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What `cagetol check` prints of a file with this text; its exit code must be `code`.
std::string printed_by_check(const std::string& text, int code = 0) {
  const ScratchDirectory scratch;
  const std::string file = scratch / "file.toml";
  std::ofstream(file) << text;
  Process process({std::string(CAGETOL_BINARY_DIR) + "/cagetol", "check", file});
  EXPECT_EQ(process.wait(), code) << process.output();
  return process.output();
}

std::string study_text(const std::string& keys) {
  return "name = \"own\"\n[scene]\nfile = \"" + shipped("scenes/nu205.toml") +
         "\"\nlubrication.model = \"none\"\ncage.model = \"rigid\"\n" + keys;
}

TEST(CheckCommand, SaysWhatADutyDoesAndHowLongARunIs) {
  const std::string text = printed_by_check(study_text(R"(
[scene.duty]
time_s = [0, 0.02, 0.1]
inner_rpm = [0, 6000, 3000]
radial_N = [500, 2000, 2500]
repeat_s = 0.12
[[scene.phase]]
name = "braking"
from_s = 0.03
to_s = 0.09
)"));
  for (const char* words :
       {"again every 0.12 s", "at 0.02 s: 6000 rpm, 2000 N", "at 0.1 s: 3000 rpm, 2500 N",
        "phase braking: 0.03 to 0.09 s", "settles for 0.03 s, then measures for 0.06 s"})
    EXPECT_THAT(text, HasSubstr(words));
  EXPECT_THAT(printed_by_check(study_text("")), Not(HasSubstr("duty over time")));
}

TEST(CheckCommand, SaysHowLawsFillTheirToleranceAndHowManyCagesJam) {
  const auto with_sigma = [](const char* sigma) {
    return printed_by_check(study_text(std::string("cage.pocket_width_mm = { nominal = 7.65, law = "
                                                   "\"normal\", sigma = ") +
                                       sigma + R"( }
[[limit]]
quantity = "friction_torque_Nmm"
max = 100
source = "assumption"
cage_revolutions = 1
[[tolerance.dimension]]
key = "cage.pocket_width_mm"
tolerance_width_mm = 0.06
candidates = [0.06, 0.03, "+0.05/0"]
)"));
  };
  const std::string capable = with_sigma("0.01"), wide = with_sigma("0.06");
  EXPECT_THAT(capable, HasSubstr("a standard deviation of 0.01 mm: Pp = 1.00"));
  EXPECT_THAT(capable, Not(HasSubstr("warning: cage")));
  EXPECT_THAT(capable,
              testing::ContainsRegex("roller to both bars +150.0 +120.0 to 180.0 +120.0 to "
                                     "180.0 .*cage.pocket_width_mm"));
  // 0.15 mm of clearance is 2.5 standard deviations: 0.6 % of pockets, 8 % of cages of 13.
  EXPECT_THAT(wide, HasSubstr("Pp = 0.17"));
  EXPECT_THAT(wide, HasSubstr("warning: cage.pocket_width_mm: so many parts lie outside"));
  EXPECT_THAT(wide,
              HasSubstr("share of these that meet all limits; what does not fit jams, by integr"));
  EXPECT_THAT(wide, HasSubstr("cage.pocket_width_mm: 1 ppm from 0.0286 mm"));
  EXPECT_THAT(wide, HasSubstr("10 % from 0.0624 mm"));
  EXPECT_THAT(wide, HasSubstr("warning: 1 of 3 candidates miss the target yield of 95 % by jams"));
  EXPECT_THAT(wide, HasSubstr("at 0.05 mm with its middle at +0.025 mm: "));
}

TEST(CheckCommand, NamesTheOutlierBeforeTheProcessThatItSpoils) {
  const std::filesystem::path csv = testing::TempDir() + "outlier.csv";
  std::ofstream parts(csv);
  parts << "width\n";
  for (int i = 0; i < 40; ++i) parts << 7.648 + 0.001 * (i % 5) << '\n';
  parts << "8.65\n";
  parts.close();
  const std::string text = printed_by_check(
      study_text("cage.pocket_width_mm = { nominal = 7.65, pocket = { law = \"empirical\", file "
                 "= \"" +
                 csv.string() + R"(", column = "width" } }
[[tolerance.dimension]]
key = "cage.pocket_width_mm"
tolerance_width_mm = 0.06
candidates = [0.06]
)"));
  const auto outlier = text.find("line 42 is an outlier"), process = text.find("so many parts lie");
  EXPECT_NE(process, std::string::npos) << text;
  EXPECT_LT(outlier, process) << text;
}

TEST(CheckCommand, ShowsAnAxialLoad) {
  const std::string scene = "[scene]\nfile = \"" + shipped("scenes/nj308-axial.toml") + "\"\n";
  EXPECT_THAT(printed_by_check("name = \"own\"\n" + scene),
              HasSubstr("9300 N and axially -300 N, 4750 rpm"));
}

TEST(CheckCommand, NamesTheLawThatADistributionLacks) {
  const std::string text =
      printed_by_check(study_text("cage.pocket_width_mm = { sigma = 0.01 }\n"), 2);
  EXPECT_THAT(text, HasSubstr("cage.pocket_width_mm holds a value and has no keys of its own"));
  EXPECT_THAT(text, HasSubstr("law = \"normal\", sigma = ... }"));
}

}  // namespace
}  // namespace cagetol
