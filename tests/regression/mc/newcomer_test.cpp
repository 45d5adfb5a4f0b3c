// Mistakes of somebody who begins: each ends at once, with the word that matters in its message.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

struct Mistake {
  std::string setting;  ///< of the shipped study, or of its scene where `of_scene`
  std::string message;
  int code = 2;  ///< 0: a warning
  bool of_scene = false;
};

const std::string kWidth = "scene.cage.pocket_width_mm=";
const std::string kDimension =
    "tolerance.dimension=[{key='cage.pocket_width_mm',tolerance_width_mm=0.1,candidates=";

const std::vector<Mistake>& mistakes() {
  // clang-format off
  static const std::vector<Mistake> all = {
      // Names and units.
      {kWidth + "'7,65'", "this is a text, expected a number in mm"},
      {"scene.cage.pocket_width=7.65", "write cage.pocket_width_mm, in mm"},
      {"scene.cage.pocket_width_um=7650", "write cage.pocket_width_mm = 7.65  (1 um = 0.001 mm)"},
      {"scene.cage.pocket_widht_mm=7.65", "did you mean cage.pocket_width_mm?"},
      {"operating_point=[{name='a',radial_N=200}]", "did you mean load.radial_N?"},
      {"cage.pocket_width_in=0.3", "the unit in is not known"},
      {"load.radial_kN=1", "write load.radial_N = 1000  (1 kN = 1000 N)", 2, true},
      {"speed.inner=6000", "write speed.inner_rpm, in rpm", 2, true},
      {"lubrication.temperature_C=343", "give a value from -60 to 250 degC", 2, true},
      {"roller.diameter_mm=7500", "the rollers do not fit between the raceways", 2, true},
      {"bearing.roller_count=13.5", "a whole number, from 3 to 64", 2, true},
      {"samples=1e6", "write 1000000"},
      {"samples=0", "give a value from 1 to 1e+09"},
      {"seed=-1", "give a value from 0 to"},
      // Choices.
      {"design='latin'", "nearest: lhs"},
      {"lubrication.lubricant='VG68'", "nearest: iso-vg-68", 2, true},
      {"cage.material='PA66'", "nearest: pa66-gf25", 2, true},
      // Distributions and correlations.
      {kWidth + "{nominal=7.65,lot={law='gauss',sigma=0.009}}", "laws are: normal"},
      {kWidth + "{nominal=7.65,lot={law='normal',sigma_um=9}}", "did you mean sigma?"},
      {kWidth + "{nominal=7.65,lot={law='normal',sigma=-0.009}}", "give a value at least 0"},
      {kWidth + "{nominal=7.65,lot={law='normal',sigma=9}}", "narrow the laws"},
      {kWidth + "{nominal=7.65,sigma=0.009}", "add law = \"normal\""},
      {kWidth + "{nominal=7.65,lot={law='uniform',lower=0.1,upper=-0.1}}", "exchange them"},
      {kWidth + "{nominal=7.65,cage={law='normal',sigma=0.009}}", "parts are nominal, lot, pocket, noise, or a law"},
      {kWidth + "{nominal=7.4}", "give a pocket width above the roller diameter"},
      {kWidth + "7650", "pockets this wide leave no bar between them"},
      {"correlation=[{between=['cage.pocket_width_mm','cage.pocket_length_mm'],rho=0.5}]", "did you mean cage.pocket_width_mm:lot?"},
      {"correlation=[{between=['cage.pocket_width_mm:lot','cage.pocket_length_mm:pocket'],rho=0.5}]", "both with :lot or both with :pocket"},
      {"correlation=[{between=['cage.pocket_width_mm:lot','cage.pocket_length_mm:lot'],rho=1}]", "give 0.999 at most: inputs that move as one are one input"},
      {"correlation=[{between=['cage.pocket_width_mm:lot','cage.pocket_length_mm:lot'],rho=0.5},"
       "{between=['cage.pocket_length_mm:lot','cage.pocket_width_mm:lot'],rho=0.4}]", "have a correlation already"},
      {"seed=5", "from cage to cage normal, mean 0, standard deviation 0.009 mm", 0},
      {"cage.pocket_pitch_mrad={pocket={law='empirical',values=[1,2,3,5,8,13],centred=true}}", "empirical, mean 0, standard", 0},
      // Tolerances and targets.
      {kDimension + "[90,150]}]", "widths are in mm: 90 um are 0.09"},
      {kDimension + "'IT9'}]", "write candidates = ['IT9']"},
      {kDimension + "['it 9']}]", "did you mean \"IT9\"?"},
      {kDimension + "['9']}]", "did you mean \"IT9\"?"},
      {kWidth + "7.65", "--set cage.pocket_width_mm.nominal=... keeps a law"},
      {kDimension + "['0,01']}]", "give a grade like \"IT9\" or a full width in mm"},
      {kDimension + "['IT19']}]", "choose from IT5 to IT14"},
      {kDimension + "['IT9','IT9']}]", "this candidate is named twice"},
      {kDimension + "[]}]", "there are no candidate tolerances"},
      {kDimension + "[5]}]", "candidates miss the target yield of 99 % by jams alone", 0},
      {"tolerance.dimension=[{key='cage.pocket_width_mm',tolerance_width_mm=100,candidates=['IT9']}]", "widths are in mm: 100 um are 0.1"},
      {"tolerance.dimension=[{key='cage.pocket_widht_mm',tolerance_width_mm=0.1,candidates=['IT9']}]", "did you mean cage.pocket_width_mm?"},
      {"tolerance.target_yield=99", "give a value above 0, up to 1"},
      {"tolerance.target_yield=1", "a yield of 1 cannot be confirmed by any number of runs", 0},
      {"tolerance.confidence=95", "give a value above 0, up to 0.999999"},
      {"recommend.budget_samples=10", "so few runs cannot confirm any tolerance", 0},
      // Limits.
      {"limit=[{quantity='cage_stress_peak',max=100,source='a'}]", "did you mean cage_stress_peak_MPa?"},
      {"limit=[{quantity='life_L10_h',min=1000,source='a'}]", "this belongs to the operating point"},
      {"limit=[{quantity='cage_stress_peak_MPa',max=100}]", "the limit does not say where it comes from"},
      {"limit=[{quantity='cage_stress_peak_MPa',source='a'}]", "add min = ..., max = ..., or both"},
      {"limit=[{quantity='cage_stress_peak_MPa',max=-1,source='a'}]", "is never negative: no run meets this limit\n  remedy: give 0 or more", 0},
      {"limit=[{quantity='cage_stress_peak_MPa',max=100,source='a'},{quantity='cage_stress_peak_MPa',max=90,source='b'}]", "keep one of the two"},
      {"scene.cage.model='rigid'", "runs of this scene give it no value: it needs cage.model = \"flexible\"", 0},
      // Bearings that nobody would run.
      {"cage.guide_clearance_mm=200", "warning: cage.guide_clearance_mm = 200: the diameters leave 0.2 mm", 0, true},
      {"cage.guidance='inner'", "warning: the ring that does not guide the cage stops it first, at 0.2 mm", 0, true},
      {"cage.width_mm=30", "warning: the cage is wider than the bearing, 15 mm", 0, true},
      {"bearing.internal_clearance_um=700", "warning: an internal clearance of 700 um", 0, true},
      {"lubrication.race_roughness_um=500", "warning: lubrication.race_roughness_um or pocket_roughness_um is above 20 um", 0, true},
      {"assumption=[{key='bearing.internal_clearance_um',note='x',low=50,high=60}]", "warning: bearing.internal_clearance_um = 30 lies outside the range of its assumption, 50 to 60", 0, true},
      {"load.radial_N=1000000", "races and rollers yield (ISO 76)", 0, true},
      {"load.radial_N=0", "rollers and cage may skid", 0, true},
      {"load.axial_N=900", "an NJ has both outside and one inside", 2, true},
      {"bearing.misalignment_z_mrad=30", "makers allow 4 minutes of arc", 0, true},
      {"speed.inner_rpm=100000", "is above bearing.limiting_speed_rpm", 0, true},
      {"lubrication.temperature_C=-40", "hardly flows", 0, true},
      {"cage={material='pa66-gf25',temperature_C=180}", "nothing is known above 150 degC", 0, true},
      {"discretisation.race_slices=1", "nothing holds the rollers against tilting", 0, true},
  };
  // clang-format on
  return all;
}

TEST(Newcomer, EveryMistakeIsNamed) {
  for (const Mistake& made : mistakes()) {
    const std::string file =
        shipped(made.of_scene ? "scenes/nu205.toml" : "studies/nu205-rated.toml");
    Process check({CAGETOL_BINARY_DIR "/cagetol", "check", file, "--set", made.setting});
    const int code = check.wait();
    EXPECT_EQ(code, made.code) << made.setting << '\n' << check.output();
    EXPECT_THAT(check.output(), testing::HasSubstr(made.message)) << made.setting;
    if (code != 0) {
      EXPECT_THAT(check.output(), testing::HasSubstr("remedy: ")) << made.setting;
    }
  }
}

TEST(Newcomer, EveryCommandSaysWhatItTakes) {
  const ScratchDirectory scratch;
  const std::string study = shipped("studies/nu205-rated.toml"),
                    scene = shipped("scenes/nu205.toml"), out = scratch / "out";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"recommend", scene, "-o", out}, "where this is a scene, name it in a study"},
      {{"replay", scratch.path(), "--sample", "1"}, scratch / "mixture"},
      {{"judge", scratch.path()}, "this is a recommendation"},
      {{"judge", out}, "there is no such file"},
      {{"limits", out},
       "`cagetol judge DIR` reads the runs of a directory, `cagetol screen STUDY`"},
      {{"simulate", study, "--sample", "-1"}, "-1 not in range 0 to 9999999999"},
      {{"ladder", scene, "-o", out, "--budget", "0"}, "not in range 0.000001 to 1000000"},
      {{"sweep", study, "-o", out, "--progress", "on"}, "on not in {auto,line,off,plain}"},
      {{"scene", "NU208", "--temperature", "343"}, "--temperature: Value 343 not in range -60"},
  };
  std::filesystem::create_directory(scratch / "mixture");
  for (auto [words, message] : cases) {
    words.insert(words.begin(), CAGETOL_BINARY_DIR "/cagetol");
    Process process(words);
    EXPECT_EQ(process.wait(), 2) << process.output();
    EXPECT_THAT(process.output(), testing::HasSubstr(message));
  }
  EXPECT_EQ(Process({CAGETOL_BINARY_DIR "/cagetol", "scene", "NU208", "--clearance", "c3"}).wait(),
            0);
}

}  // namespace
}  // namespace cagetol
