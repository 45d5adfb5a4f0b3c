#include "mc/study/assumption_ranges.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "src/input/input_error.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A study on a scene of the NU 205 whose only assumptions are these.
class AssumptionRanges : public testing::Test {
 protected:
  Study read(const std::string& of_scene, const std::string& of_study = "",
             const std::vector<std::string>& settings = {}) const {
    std::ofstream(scratch_ / "scene.toml") << kScene << of_scene;
    std::ofstream(scratch_ / "study.toml") << "samples = 4\n" << kStudy << of_study;
    return read_study(scratch_ / "study.toml", settings);
  }
  std::string problem(const std::string& of_scene, const std::string& of_study = "") const {
    try {
      read(of_scene, of_study);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  /// An entry on three lines; the first one of the scene begins on line 27.
  static std::string entry(const std::string& key, const std::string& range) {
    return "[[assumption]]\nkey = \"" + key + "\"\nnote = \"why\"\n" + range + "\n";
  }

  static constexpr const char* kStudy = R"([scene]
file = "scene.toml"
[scene.cage]
pocket_width_mm = { nominal = 7.65, lot = { law = "normal", sigma = 0.009 } }
)";
  static constexpr const char* kTolerance = R"([[tolerance.dimension]]
key = "cage.pocket_width_mm"
tolerance_width_mm = 0.1
candidates = ["IT11"]
)";
  static constexpr const char* kScene = R"([bearing]
roller_count = 13
bore_diameter_mm = 25
outside_diameter_mm = 52
width_mm = 15
inner_raceway_diameter_mm = 31.5
outer_raceway_diameter_mm = 46.5
shoulder_diameter_mm = 43.8
internal_clearance_um = 30
flange_clearance_mm = 0.08
[roller]
diameter_mm = 7.5
length_mm = 9
[cage]
inner_diameter_mm = 37.0
outer_diameter_mm = 43.4
width_mm = 14
pocket_width_mm = 7.65
pocket_length_mm = 9.25
[lubrication]
model = "film"
race_layer_um = 20
[load]
radial_N = 1000
[speed]
inner_rpm = 6000
)";
  ScratchDirectory scratch_;
};

TEST_F(AssumptionRanges, AreReadResolvedAndReadAgain) {
  const Study study =
      read(entry("lubrication.race_layer_um", "low = 5\nhigh = 50") + entry("cage.width_mm", ""));
  const auto& assumptions = study.scene.assumptions;
  ASSERT_EQ(assumptions.size(), 2u);
  EXPECT_EQ(assumptions[0].low, 5);
  EXPECT_EQ(assumptions[0].high, 50);
  EXPECT_FALSE(assumptions[1].has_range());
  const Study again = read_resolved_study(study.resolved_toml, "again");
  EXPECT_EQ(again.hash, study.hash);
  EXPECT_EQ(again.scene.assumptions[0].high, 50);
  const auto ends = alternatives_of(study);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].value, 5);
  EXPECT_EQ(ends[1].value, 50);
  EXPECT_EQ(ends[0].unit, "um");
}

TEST_F(AssumptionRanges, EntriesOfAStudyReplaceThoseOfItsSceneForTheSameKeys) {
  const std::string of_scene = entry("lubrication.race_layer_um", "low = 5\nhigh = 50") +
                               entry("cage.width_mm", "low = 13.9\nhigh = 14.1");
  for (const std::string list : {"[[assumption]]", "[[scene.assumption]]"}) {
    const Study study =
        read(of_scene, list + "\nkey = \"cage.width_mm\"\nnote = \"n\"\nlow = 13.8\nhigh = 14.2\n");
    ASSERT_EQ(study.scene.assumptions.size(), 2u);
    EXPECT_EQ(study.scene.assumptions[0].key, "lubrication.race_layer_um");
    EXPECT_EQ(study.scene.assumptions[1].low, 13.8);
  }
  // At their place: only what differs differs.
  const Study first = read(of_scene, entry("lubrication.race_layer_um", "low = 6\nhigh = 50") +
                                         entry("cage.pocket_width_mm", ""));
  ASSERT_EQ(first.scene.assumptions.size(), 3u);
  EXPECT_EQ(first.scene.assumptions[0].low, 6);
  EXPECT_EQ(first.scene.assumptions[1].key, "cage.width_mm");
  const std::string setting =
      "assumption=[{key=\"cage.width_mm\", note=\"n\", low=13.5, high=14.5}]";
  for (const std::string prefix : {"", "scene."}) {
    const Study study = read(of_scene, entry("cage.width_mm", ""), {prefix + setting});
    ASSERT_EQ(study.scene.assumptions.size(), 2u);
    EXPECT_EQ(study.scene.assumptions[0].high, 50);
    EXPECT_EQ(study.scene.assumptions[1].low, 13.5);
  }
}

TEST_F(AssumptionRanges, AnAlternativeMovesTheNominalValueAndKeepsTheLaw) {
  const Study study = read(entry("cage.pocket_width_mm", "low = 7.6\nhigh = 7.65"));
  const auto ends = alternatives_of(study);
  ASSERT_EQ(ends.size(), 1u);  // the other end is the study's own
  const Study changed =
      changed_study(study, [&](Study& other) { apply_alternative(ends[0], other); });
  ASSERT_EQ(changed.inputs.size(), 1u);
  EXPECT_EQ(changed.inputs[0].nominal, std::vector{7.6});
  EXPECT_TRUE(changed.inputs[0].lot);
  EXPECT_NEAR(changed.scene.cage.pocket_width[0], 7.6e-3, 1e-12);
  const Study automatic = read(entry("cage.guide_clearance_mm", "low = 0.1\nhigh = 0.3"));
  ASSERT_EQ(alternatives_of(automatic).size(), 2u);
  EXPECT_NEAR(
      changed_study(automatic,
                    [&](Study& other) { apply_alternative(alternatives_of(automatic)[1], other); })
          .scene.cage.guide_clearance,
      0.3e-3, 1e-12);
}

TEST_F(AssumptionRanges, KeysThatDoNothingAreNotJudged) {
  const Study dry = read(entry("lubrication.race_layer_um", "low = 5\nhigh = 50"),
                         std::string("[scene.lubrication]\nmodel = \"none\"\n") + kTolerance);
  EXPECT_TRUE(alternatives_of(dry).empty());
  EXPECT_THAT(study_notes(dry),
              testing::Contains(HasSubstr("do nothing (lubrication.model = \"none\"): "
                                          "lubrication.race_layer_um")));
}

TEST_F(AssumptionRanges, ATemperatureThatABalanceFindsIsNotJudged) {
  const std::string range = entry("lubrication.temperature_C", "low = 40\nhigh = 100");
  EXPECT_EQ(alternatives_of(read(range)).size(), 2u);
  const Study balanced =
      read(range, std::string("[scene.temperature]\nbalance = true\n") + kTolerance);
  // As the program writes it once it is found: read again, and without another word.
  const Study found = changed_study(balanced, [](Study& study) {
    study.scene.temperature.found = study.scene.lubrication.temperature = 61.25;
  });
  for (const Study& study : {balanced, read_resolved_study(found.resolved_toml, "again")}) {
    EXPECT_TRUE(alternatives_of(study).empty());
    EXPECT_THAT(study_notes(study),
                testing::Contains(HasSubstr("do nothing (temperature.balance = true finds it): "
                                            "lubrication.temperature_C")));
    EXPECT_THAT(study_notes(study),
                testing::Not(testing::Contains(HasSubstr("without effect (temperature.balance"))));
  }
  EXPECT_EQ(found.scene.lubrication.temperature, 61.25);
}

TEST_F(AssumptionRanges, BadRangesAreRefusedWithPlaceReasonAndRemedy) {
  const std::string key = "lubrication.race_layer_um";
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
      {entry(key, "low = \"5\"\nhigh = 50"),
       {"scene.toml:30: assumption.low = '5'", "this is a text"}},
      {entry(key, "low = 5\nhigh = nan"),
       {"scene.toml:31: assumption.high", "not a finite number"}},
      {entry(key, "low = 50\nhigh = 5"),
       {"scene.toml:30: assumption.low = 50", "begins above its end"}},
      {entry(key, "low = 0\nhigh = 5"), {"scene.toml:30", key, "outside the range", "above 0 um"}},
      {entry(key, "low = 5"), {"scene.toml:30", "one end only", "give low and high"}},
      {entry(key, "high = 5"), {"scene.toml:30: assumption.high = 5", "one end only"}},
      {entry("cage.guide_clearance_mm", "low = \"auto\"\nhigh = 5"), {"scene.toml:30"}},
      {entry("cage.material", "low = 5\nhigh = 6"), {"scene.toml:30", "not a number with a unit"}},
      {entry("bearing.roller_count", "low = 12\nhigh = 13"), {"not a number with a unit"}},
      {entry(key, "lwo = 5"), {"scene.toml:30: assumption.lwo = 5", "did you mean low?"}},
      {entry(key, "low = 5\nhigh = 6") + entry(key, ""), {"scene.toml:32", "a second entry"}},
      {entry("cage.outer_diameter_mm", "low = 43\nhigh = 44"),
       {"scene.toml:31: assumption.high = 44", "does not fit inside the outer ring's shoulders",
        "narrow the range of cage.outer_diameter_mm"}},
  };
  for (const auto& [text, parts] : cases) {
    const std::string message = problem(text);
    EXPECT_THAT(message, HasSubstr("remedy: "));
    for (const std::string& part : parts) EXPECT_THAT(message, HasSubstr(part)) << text;
  }
  EXPECT_THAT(problem("", entry(key, "low = 9\nhigh = 8")),
              AllOf(HasSubstr("study.toml:9: assumption.low = 9"), HasSubstr("remedy")));
  EXPECT_THAT(problem("", "[assumption]\nkey = \"x\"\n"), HasSubstr("write [[assumption]]"));
  // The draws of a law must stay within the key's range at both ends.
  EXPECT_THAT(problem(entry("cage.guide_clearance_mm", "low = 0.01\nhigh = 0.3"),
                      "guide_clearance_mm = { nominal = 0.2, lot = { law = \"normal\", sigma = "
                      "0.02 } }\n"),
              AllOf(HasSubstr("assumption.low = 0.01"), HasSubstr("the laws draw values like")));
}

}  // namespace
}  // namespace cagetol
