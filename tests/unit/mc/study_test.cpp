// One file on purpose, though long: a single table names every mistake a study file can hold.
#include "mc/study/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "mc/study/document.hpp"
#include "mc/study/sample.hpp"
#include "mc/study/study_inputs.hpp"
#include "src/input/input_error.hpp"
#include "tests/support/reference_scene.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// A folder for the files of one test.
class StudyFile : public testing::Test {
 protected:
  StudyFile()
      : folder_(testing::TempDir() + "study_" +
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    write("reference.toml", reference_scene_text());
  }
  ~StudyFile() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + "/" + name, std::ios::binary) << text;
    return folder_ + "/" + name;
  }

  /// A text that names no scene file gets the reference bearing.
  Study study_of(const std::string& text, std::vector<std::string> settings = {}) const {
    const bool names_scene = text.find("[scene]\nfile") != std::string::npos ||
                             text.find("scene = ") != std::string::npos;
    if (!names_scene) settings.push_back("scene.file=" + folder_ + "/reference.toml");
    return read_study(write("study.toml", text), settings);
  }

  std::string problem_of(const std::string& text,
                         const std::vector<std::string>& settings = {}) const {
    try {
      study_of(text, settings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  std::string folder_;
};

TEST_F(StudyFile, TheDefaultStudyIsComplete) {
  const Study study = read_study(shipped("studies/nu205-rated.toml"));
  EXPECT_EQ(study.name, "nu205-rated");
  EXPECT_EQ(study.scene.bearing.roller_count, 13);
  EXPECT_GE(study.samples, 256);
  EXPECT_FALSE(study.limits.empty());
  EXPECT_EQ(study.tolerance.dimensions.size(), 2u);
  EXPECT_EQ(study.candidates.size(), study.tolerance.dimensions[0].candidates.size() *
                                         study.tolerance.dimensions[1].candidates.size());
  EXPECT_EQ(study.hash.size(), 16u);
  const auto json = nlohmann::json::parse(study.resolved_json);
  EXPECT_EQ(json["scene"]["cage"]["pocket_width_mm"], 7.65);
  EXPECT_EQ(json["tolerance"]["dimension"][0]["key"], "cage.pocket_width_mm");
  EXPECT_EQ(json["inputs"][1]["key"], "cage.pocket_width_mm");
  EXPECT_EQ(json["inputs"][1]["lot"]["law"], "normal");
}

TEST_F(StudyFile, ASceneIsAStudyOfOneRow) {
  const Study study = read_study(shipped("scenes/speed-z16-skew.toml"));
  EXPECT_EQ(study.name, "speed-z16-skew");
  EXPECT_EQ(study.samples, 1);
  EXPECT_EQ(sample_count(study), 1u);
  ASSERT_EQ(study.inputs.size(), 3u);
  EXPECT_EQ(study.inputs[0].key, "cage.pocket_squareness_mrad");
  const Sample sample = draw_sample(study, 0);
  EXPECT_EQ(sample.scene.cage.pocket_squareness.size(), 16u);
  EXPECT_NE(sample.scene.cage.pocket_squareness[0], sample.scene.cage.pocket_squareness[1]);
  EXPECT_NE(sample.scene.start.cage_offset_y, 0);
}

TEST_F(StudyFile, ResolvedTextReadsBackToTheSameStudy) {
  for (const char* path : {"studies/nu205-rated.toml", "studies/nu205-measured.toml",
                           "studies/nu205-stress.toml", "scenes/speed-z16-skew.toml"}) {
    const Study study = read_study(shipped(path));
    const Study again = read_resolved_study(study.resolved_toml, "stored");
    EXPECT_EQ(again.resolved_toml, study.resolved_toml);
    EXPECT_EQ(again.resolved_json, study.resolved_json);
    const auto a = draw_sample(study, 0), b = draw_sample(again, 0);
    ASSERT_EQ(a.inputs.size(), b.inputs.size());
    for (std::size_t i = 0; i < a.inputs.size(); ++i)
      EXPECT_EQ(a.inputs[i].value, b.inputs[i].value);
  }
}

// A report of an earlier program's study keeps its operating point.
TEST_F(StudyFile, AStoredStudyLosesKeysThatAreGoneAndNothingElse) {
  const Study study = read_study(shipped("studies/nu205-rated.toml"));
  std::string text = study.resolved_toml;
  for (const auto& [now, then] : {std::pair{"design = 'random'", "design = 'sobol'\nscrambles = 8"},
                                  {"[scene.speed]", "[scene.speed]\noscillation_Hz = 3"}}) {
    ASSERT_NE(text.find(now), std::string::npos) << now;
    text.replace(text.find(now), std::string(now).size(), then);
  }
  text += "[scene.film]\nmodel = 'series'\n";
  EXPECT_EQ(read_resolved_study(text, "stored").resolved_toml, study.resolved_toml);
  // What is called otherwise today is not lost silently.
  EXPECT_THROW(read_resolved_study(text + "[scene.lobes]\ninner_1_um = 3\n", "stored"), InputError);
}

TEST_F(StudyFile, OverridesAndSettingsComeInOrder) {
  write("scene.toml",
        reference_scene_text("name = 'base'\n[cage]\npocket_width_mm = 7.7\n[load]\nradial_N = "
                             "500\n"));
  const std::string text =
      "[scene]\nfile = 'scene.toml'\n[scene.cage]\npocket_width_mm = { lot = { law = 'normal', "
      "sigma = 0.01 } }\n";
  const Study study = study_of(text);
  EXPECT_EQ(study.scene.name, "base");
  EXPECT_DOUBLE_EQ(study.scene.operation.radial_load, 500);
  EXPECT_THAT(study.inputs.at(0).nominal, ElementsAre(7.7));
  EXPECT_EQ(study_of(text, {"load.radial_N=300"}).scene.operation.radial_load, 300);
  EXPECT_EQ(study_of(text, {"scene.load.radial_N=300"}).scene.operation.radial_load, 300);
  EXPECT_EQ(study_of(text, {"samples=7", "design=lhs"}).samples, 7);
  EXPECT_TRUE(study_of(text, {"cage.pocket_width_mm=7.8"}).inputs.empty());
  const auto wider = study_of(text, {"cage.pocket_width_mm.lot.sigma=0.02"}).inputs.at(0);
  EXPECT_EQ(std::get<Normal>(*wider.lot).sigma, 0.02);
  EXPECT_THAT(wider.nominal, ElementsAre(7.7));
  write("other.toml", reference_scene_text("[load]\nradial_N = 7\n"));
  const auto other = study_of(text, {"scene.file=" + folder_ + "/other.toml"});
  EXPECT_DOUBLE_EQ(other.scene.operation.radial_load, 7);
}

TEST_F(StudyFile, AStudyWithoutItsBearingIsRefused) {
  const std::string path =
      write("study.toml", "samples = 3\n[scene.cage]\npocket_width_mm = 7.65\n");
  try {
    read_study(path);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("study.toml: the scene leaves out 18 keys"),
                                    HasSubstr("bearing.roller_count: "),
                                    HasSubstr("load.radial_N [N]: "), HasSubstr("scene.file")));
  }
}

TEST_F(StudyFile, TheHashNamesContents) {
  const std::string text =
      "samples = 3\n[scene.cage]\npocket_width_mm = { nominal = 7.65, pocket = { law = "
      "'empirical', "
      "file = 'parts.csv', column = 'd' } }\n";
  write("parts.csv", "d\n0.01\n-0.01\n");
  const Study study = study_of(text);
  EXPECT_EQ(study_of(text + "# a comment\n").hash, study.hash);
  EXPECT_NE(study_of(text, {"samples=4"}).hash, study.hash);
  ASSERT_EQ(study.files.size(), 1u);
  EXPECT_EQ(study.files[0].first, "parts.csv");
  write("parts.csv", "d\n0.01\n-0.011\n");
  EXPECT_NE(study_of(text).hash, study.hash);
}

TEST_F(StudyFile, BareLawsTakeTheScopeOfTheirKey) {
  const Study study = study_of(
      "samples = 2\n[scene.cage]\npocket_pitch_mrad = { law = 'normal', sigma = 0.3 }\n"
      "[scene.load]\nradial_N = { nominal = 1000, law = 'uniform', lower = -10, upper = 10 }\n");
  ASSERT_EQ(study.inputs.size(), 2u);
  EXPECT_TRUE(study.inputs[0].pocket);
  EXPECT_FALSE(study.inputs[0].lot);
  EXPECT_TRUE(study.inputs[1].lot);
}

TEST_F(StudyFile, WhatAFlexibleCageIsNotTabulatedForMayVary) {
  const Study study = study_of(
      "samples = 2\n[scene.cage]\nmodel = 'flexible'\n"
      "pocket_pitch_mrad = { law = 'normal', sigma = 0.3 }\n"
      "mode_damping = { nominal = 0.01, lot = { law = 'uniform', lower = -0.005, upper = 0.005 } }"
      "\n");
  EXPECT_EQ(study.inputs.size(), 2u);
}

TEST_F(StudyFile, DiametersOfAFlexibleCageMayScatterAsFarAsItsTableCovers) {
  const auto scattered = [](const std::string& half_tolerance) {
    const auto law = [](const std::string& half) {
      return "{ law = 'uniform', lower = -" + half + ", upper = " + half + " } }\n";
    };
    return "samples = 2\n[scene.cage]\nmodel = 'flexible'\n"
           "outer_diameter_mm = { nominal = 43.4, lot = " +
           law(half_tolerance) + "inner_diameter_mm = { nominal = 37.0, noise = " + law("0.01");
  };
  const Study study = study_of(scattered("0.03"));  // 0.04 of 6.4 mm
  EXPECT_NEAR(thickness_scatter(study), 0.04 / 6.4, 1e-6);
  EXPECT_THAT(study_notes(study),
              testing::Contains(AllOf(HasSubstr("by up to 0.62 % of its thickness"),
                                      HasSubstr("1.81 % of the bars' compliance"))));
  EXPECT_THAT(problem_of(scattered("0.06")),
              AllOf(HasSubstr("cage.outer_diameter_mm"), HasSubstr("by up to 1.09 %"),
                    HasSubstr("right for up to 1 %")));
}

TEST_F(StudyFile, CandidatesAreTheProductOfTheDimensions) {
  const Study study = study_of(
      "samples = 6\n[scene.cage]\npocket_width_mm = { nominal = 7.65, lot = { law = 'normal', "
      "sigma = 0.01 } }\n"
      "pocket_length_mm = { nominal = 10.5, pocket = { law = 'normal', sigma = 0.01 } }\n"
      "[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = 0.1\ncandidates "
      "= ['IT9', "
      "'IT10']\n"
      "[[tolerance.dimension]]\nkey = 'cage.pocket_length_mm'\ntolerance_width_mm = "
      "0.1\ncandidates = ['IT9', "
      "0.2, 'IT11']\n");
  ASSERT_EQ(study.candidates.size(), 6u);
  EXPECT_THAT(study.candidates[0].tolerance_widths_mm, ElementsAre(0.036, 0.043));
  EXPECT_THAT(study.candidates[1].tolerance_widths_mm, ElementsAre(0.036, 0.2));
  EXPECT_THAT(study.candidates[5].tolerance_widths_mm, ElementsAre(0.058, 0.110));
  EXPECT_THAT(study.candidates[1].grades, ElementsAre("IT9", ""));
  // Rows that a recommendation does not draw are no matter of the study alone.
  EXPECT_THAT(sweep_notes(study), testing::Contains(HasSubstr("rows for 6 candidate tolerances")));
  EXPECT_THAT(study_notes(study),
              testing::Not(testing::Contains(HasSubstr("candidate tolerances"))));
  EXPECT_DOUBLE_EQ(study.candidates[1].scales[1], 2);
  EXPECT_EQ(draw_sample(study, 4).candidate, 4);
  EXPECT_EQ(draw_sample(study, 7).candidate, 1);
}

TEST_F(StudyFile, CandidatesMayBeAsADrawingHasThem) {
  const std::string keys =
      "samples = 6\n[scene.cage]\npocket_width_mm = { nominal = 7.65, lot = { law = 'normal', "
      "sigma = 0.01 } }\n[scene.bearing]\ninternal_clearance_um = { nominal = 30, lot = { law = "
      "'normal', sigma = 1 } }\n"
      "[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = 0.1\ncandidates "
      "= ['H11', 'js11', '+0.10/0']\ncentres = [7.6, 7.65]\n"
      "[[tolerance.dimension]]\nkey = 'bearing.internal_clearance_um'\ntolerance_width_mm = "
      "0.01\ncandidates = ['+0.005/-0.002']\n";
  const Study study = study_of(keys);
  ASSERT_EQ(study.candidates.size(), 6u);
  const auto& h = study.candidates[0];
  EXPECT_THAT(h.grades, ElementsAre("H11", "+0.005/-0.002"));
  EXPECT_DOUBLE_EQ(h.tolerance_widths_mm[0], 0.09);
  EXPECT_DOUBLE_EQ(h.tolerance_widths_mm[1], 0.007);
  EXPECT_DOUBLE_EQ(h.scales[1], 0.7);
  EXPECT_DOUBLE_EQ(h.middles[0], 0.045);
  EXPECT_DOUBLE_EQ(h.middles[1], 1.5);  // um, as the key
  EXPECT_NEAR(h.shift(0), 7.6 + 0.045 - 7.65, 1e-15);
  EXPECT_EQ(study.candidates[2].tolerance_widths_mm[0], h.tolerance_widths_mm[0]);
  EXPECT_EQ(study.candidates[2].shift(0), h.centre_shift(0));
  EXPECT_DOUBLE_EQ(study.candidates[5].shift(0), 0.05);
  const Study again = read_resolved_study(study.resolved_toml, "again");
  ASSERT_EQ(again.candidates.size(), 6u);
  EXPECT_EQ(again.candidates[0].middles, h.middles);
  EXPECT_EQ(again.candidates[0].grades, h.grades);
  EXPECT_EQ(again.resolved_toml, study.resolved_toml);
}

TEST_F(StudyFile, RowsBeyondTheRangeAreRefusedWithTheirCount) {
  const std::string lot =
      " = { nominal = 7.65, lot = { law = 'uniform', lower = -0.1, upper = 0.1 } }\n";
  const std::string inputs = "[scene.cage]\npocket_width_mm" + lot;
  EXPECT_THAT(problem_of("samples = 1000000000\ndesign = 'lhs'\n" + inputs),
              AllOf(HasSubstr("1000000000 rows"), HasSubstr("at most 2^28 = 268435456"),
                    HasSubstr("remedy: use random, or fewer rows")));
  // In range, and resolved to a study that can be read again.
  const Study study = study_of("samples = 999999990\n" + inputs);
  EXPECT_EQ(read_resolved_study(study.resolved_toml, "again").samples, study.samples);
}

TEST_F(StudyFile, ReplicatesGoThroughTheRowsAgain) {
  const Study study = study_of(
      "samples = 10\nextra_replicates = 1.5\n[scene.start]\n"
      "cage_phase_deg = { noise = { law = 'uniform', lower = 0, upper = 360 } }\n");
  EXPECT_EQ(sample_count(study), 25u);
  const auto sample = draw_sample(study, 23);
  EXPECT_EQ(sample.row, 3u);
  EXPECT_EQ(sample.replicate, 2u);
}

TEST_F(StudyFile, EveryMistakeIsNamedWithPlaceReasonAndRemedy) {
  write("parts.csv", "# synthetic\npart,width_mm,length_mm\n1,0.01,0.02\n2,wide,0.03\n");
  write("other.toml", "[cage]\npocket_widht_mm = 7.7\n");
  write("parts.toml", "seed = 4\n[scene.cage]\nwidth_mm = 13\n");
  const std::string width = "[scene.cage]\npocket_width_mm = ";
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
      {"smaples = 10\nseed = 1\n",
       {"study.toml:1: smaples = 10: no such key", "did you mean samples?"}},
      {"samples = -3\n", {"study.toml:1: samples = -3: outside the range", "from 1 to 1e+09"}},
      {"samples = 10.5\n", {"samples = 10.5", "expected a whole number"}},
      {"samples = 99999999999999999999999\n", {"study.toml:1: not valid TOML", "remedy"}},
      {"seed = 1\ndesign = 'radnom'\n", {"study.toml:2: design = 'radnom'", "nearest: random"}},
      {"samples = 4\n[scene]\nfile = 'absent.toml'\n",
       {"study.toml:3: scene.file = 'absent.toml'", "no such file"}},
      {"samples = 4\n[scene]\nfile = 7\n",
       {"study.toml:3: scene.file = 7", "not the name of a file"}},
      {"samples = 4\nscene = 7\n", {"study.toml:2: scene = 7", "section"}},
      {"samples = 4\n[cage]\nwidth_mm = 13\n",
       {"study.toml:3: cage.width_mm: this is a key of a scene", "write scene.cage.width_mm"}},
      {"[scene]\nsamples = 4\n", {"study.toml:2: samples: this is a key of a study"}},
      {"[scene]\nfile = 'parts.toml'\n", {"parts.toml:", "this is a key of a study"}},
      {"samples = 4\n[scene]\nfile = 'other.toml'\n",
       {"other.toml:2: cage.pocket_widht_mm = 7.7", "did you mean cage.pocket_width_mm"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = -0.01 } }\n",
       {"study.toml:2: cage.pocket_width_mm.lot.sigma = -0.01", "outside the range", "at least 0"}},
      {width + "{ nominal = 7.65, lot = { law = 'truncated_normal', sigma = 0.01, lower = 1, upper "
               "= 0.5 } }",
       {"study.toml:2: cage.pocket_width_mm.lot", "remedy"}},
      {width + "{ nominal = 7.65, lot = { law = 'truncated_normal', sigma = 0.01, lower = 5, upper "
               "= 6 } }",
       {"study.toml:2: cage.pocket_width_mm.lot", "remedy"}},
      {width + "{ nominal = 7.65, lot = { law = 'normall', sigma = 0.01 } }",
       {"study.toml:2: cage.pocket_width_mm.lot.law = 'normall'", "did you mean normal?",
        "weibull"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma_mm = 0.01 } }",
       {"cage.pocket_width_mm.lot.sigma_mm = 0.01", "did you mean sigma?"}},
      {width + "{ nominal = 7.65, lot = { law = 'uniform', lower = 0.01 } }",
       {"needs upper", "add upper = ..."}},
      {width + "{ nominal = 7.65, lot = { sigma = 0.01 } }", {"needs a law", "add law ="}},
      {width + "{ nominal = 7.65, lott = { law = 'normal', sigma = 0.01 }, lot = { law = 'normal', "
               "sigma = 0.01 } }",
       {"cage.pocket_width_mm.lott", "did you mean lot?"}},
      {width + "{ nominal = 7.65, lot = 5 }", {"cage.pocket_width_mm.lot = 5", "expected a law"}},
      {"[scene.friction]\nstatic_coefficient = { law = 'normal', sigma = 0.001 }",
       {"study.toml:2: friction.static_coefficient", "nominal value is not given",
        "add nominal = 0.07"}},
      {width + "{ nominal = 7.65, lot = { law = 'uniform', lower = 7.6, upper = 7.7 } }",
       {"near the nominal value 7.65", "subtract the nominal value"}},
      {width + "{ nominal = 7.4, lot = { law = 'normal', sigma = 0.01 } }",
       {"study.toml:2: cage.pocket_width_mm = 7.4", "not wider than its roller"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 3 } }",
       {"outside the range of this key: above 0 mm", "truncated_normal"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = nan } }",
       {"sigma = nan", "not a finite number"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = inf } }",
       {"sigma = inf", "not a finite number"}},
      {width + "{ nominal = 7.65, lot = { law = 'histogram', edges = [0, 1], weights = [1, 2] } }",
       {"cage.pocket_width_mm.lot", "remedy"}},
      {"samples = 1\n[scene.load]\nradial_N = { nominal = 5, pocket = { law = 'normal', sigma = 1 "
       "} }",
       {"load.radial_N.pocket", "it has no pockets", "use lot"}},
      {"samples = 1\n[scene.bearing]\nroller_count = { nominal = 13, lot = { law = 'normal', sigma "
       "= 1 } }",
       {"bearing.roller_count", "cannot be a distribution"}},
      {"samples = 1\n[scene.cage]\nmass_kg = { lot = { law = 'normal', sigma = 0.001 } }",
       {"cage.mass_kg", "\"auto\""}},
      {"samples = 1\n[scene.cage]\nmodel = 'flexible'\nwidth_mm = { nominal = 14, lot = { law = "
       "'normal', sigma = 0.01 } }",
       {"study.toml:4: cage.width_mm", "tabulated once", "set cage.model = \"rigid\""}},
      {"samples = 1\n[scene.cage]\nmodel = 'flexible'\nmaterial = 'pa66-gf25'\nswelling_percent = "
       "{ nominal = 0.1, lot = { law = 'normal', sigma = 0.02 } }",
       {"study.toml:5: cage.swelling_percent", "tabulated once"}},
      {"samples = 1\n[scene.temperature]\ngrowth = true\nreference_C = { nominal = 20, noise = { "
       "law "
       "= 'normal', sigma = 1 } }\n[scene.cage]\nmodel = 'flexible'",
       {"study.toml:4: temperature.reference_C", "tabulated once"}},
      {"samples = 1\n[scene.temperature]\ngrowth = true\n[scene.lubrication]\ntemperature_C = { "
       "nominal = 70, lot = { law = 'normal', sigma = 1 } }\n[scene.cage]\nmodel = 'flexible'",
       {"study.toml:5: lubrication.temperature_C", "tabulated once"}},
      {width + "{ nominal = 7.65, lot = { law = 'empirical', file = 'absent.csv', column = "
               "'width_mm' } }",
       {"study.toml:2: cage.pocket_width_mm.lot.file = 'absent.csv'", "no such file"}},
      {width + "{ nominal = 7.65, lot = { law = 'empirical', file = 'parts.csv', column = "
               "'depth_mm' } }",
       {"parts.csv:2: there is no column 'depth_mm'",
        "the columns are: part, width_mm, length_mm"}},
      {width + "{ nominal = 7.65, lot = { law = 'empirical', file = 'parts.csv', column = "
               "'width_mm' } }",
       {"parts.csv:4: column 2 (width_mm) = 'wide': this is not a number", "remedy"}},
      {width + "{ nominal = 7.65, lot = { law = 'empirical', column = 'width_mm' } }",
       {"no measurements are given"}},
      {"samples = 1\n[[limit]]\nquantity = 'whirl_radius'\nmax = 1\nsource = 's'\n",
       {"study.toml:3: limit.quantity", "did you mean whirl_radius_ratio"}},
      {"samples = 1\n[[limit]]\nquantity = 'cage_slip_ratio'\nsource = 's'\n",
       {"study.toml:2: limit", "neither min nor max"}},
      {"samples = 1\n[[limit]]\nquantity = 'cage_slip_ratio'\nmax = 1\nmin = 2\nsource = 's'\n",
       {"min is larger than max"}},
      {"samples = 1\n[[limit]]\nquantity = 'cage_slip_ratio'\nmaximum = 1\nsource = 's'\n",
       {"study.toml:4: limit.maximum = 1", "did you mean limit.max?"}},
      {"samples = 1\n[[limit]]\nquantity = 'cage_slip_ratio'\nmax = 1\n", {"where it comes from"}},
      {"samples = 1\n[limit]\nquantity = 'cage_slip_ratio'\n", {"list of tables", "[[limit]]"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_widt_mm'\ntolerance_width_mm = "
               "0.1\ncandidates "
               "= ['IT9']\n",
       {"study.toml:4: tolerance.dimension.key", "did you mean cage.pocket_width_mm?"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = "
               "0.1\ncandidates = ['IT99']\n",
       {"tolerance.dimension.candidates = IT99", "IT5 to IT14"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } }\n"
               "pocket_length_mm = { nominal = 9.25, lot = { law = 'normal', sigma = 0.01 } }\n"
               "[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\n"
               "tolerance_width_mm = 0.1\ncandidates = ['IT9']\n"
               "[[tolerance.dimension]]\nkey = 'cage.pocket_length_mm'\n"
               "tolerance_width_mm = 0.1\ncandidates = ['IT99']\n",
       {"study.toml:8: tolerance.dimension.candidates = IT99"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = "
               "0.1\ncandidates = [-0.1]\n",
       {"study.toml:6: tolerance.dimension.candidates = -0.1",
        "neither an ISO 286 grade nor a tolerance"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = "
               "0.1\ncandidates = ['e8']\n",
       {"study.toml:6: tolerance.dimension.candidates = 'e8'",
        "fundamental deviation e is not known", "known are H"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = "
               "0.1\ncandidates = ['0/+0.1']\n",
       {"study.toml:6: tolerance.dimension.candidates = '0/+0.1'", "no deviations in mm",
        "write \"+0.10/0\""}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = "
               "0.1\ncandidates = ['H15']\n",
       {"tolerance.dimension.candidates = H15", "IT5 to IT14"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = "
               "0.1\ncandidates = ['+100/0']\n",
       {"wider than the size itself", "100 um are 0.1"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_mm = "
               "0.1\ncandidates = [5e-324]\n",
       {"study.toml:6: tolerance.dimension.candidates",
        "neither an ISO 286 grade nor a tolerance"}},
      {width + "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } "
               "}\n[[tolerance.dimension]]\nkey = 'cage.pocket_width_mm'\ntolerance_width_um = "
               "100\ncandidates = ['IT9']\n",
       {"study.toml:5: tolerance.dimension.tolerance_width_um = 100: wrong unit",
        "write tolerance.dimension.tolerance_width_mm = 0.1"}},
      {width +
           "{ nominal = 7.65, lot = { law = 'normal', sigma = 0.01 } }\n[[correlation]]\nbetween = "
           "['cage.pocket_width_mm:lot', 'cage.pocket_length_mm:lot']\nrho = 0.5\n",
       {"study.toml:4: correlation.between", "no uncertain input \"cage.pocket_length_mm:lot\""}},
      {"samples = 1\n[[correlation]]\nrho = 0.5\n", {"a correlation needs two inputs and rho"}},
      {"samples = 8\ncages_per_lot = 4\ndesign = 'lhs'\n[scene.cage]\npocket_pitch_mrad = { lot = "
       "{ law = 'normal', sigma = 0.3 } }\n",
       {"design = \"lhs\"", "cages_per_lot = 4"}},
      {"tolerance = 5\nsamples = 1\n", {"study.toml:1: tolerance = 5", "section"}},
      {"inputs = 5\n", {"study.toml:1: inputs = 5"}},
  };
  for (const auto& [text, parts] : cases) {
    const auto message = problem_of(text);
    for (const auto& part : parts) EXPECT_THAT(message, HasSubstr(part)) << text;
    EXPECT_THAT(message, HasSubstr("remedy: ")) << text;
  }
}

TEST_F(StudyFile, SettingsHaveMessagesToo) {
  const std::string text = "samples = 4\n";
  EXPECT_THAT(problem_of(text, {"samples"}), HasSubstr("not of the form key=value"));
  EXPECT_THAT(problem_of(text, {"=5"}), HasSubstr("not of the form key=value"));
  EXPECT_THAT(problem_of(text, {"smaples=5"}), HasSubstr("--set: smaples = 5: no such key"));
  EXPECT_THAT(problem_of(text, {"load.radial_kN=5"}), HasSubstr("write load.radial_N = 5000"));
  EXPECT_THAT(problem_of(text, {"samples=[1,"}), HasSubstr("cannot read the value"));
  EXPECT_THAT(problem_of(text, {"samples=1\nseed=2"}), HasSubstr("cannot read the value"));
  EXPECT_THAT(problem_of(text, {"laod.radial_N=5"}), HasSubstr("did you mean load.radial_N?"));
  EXPECT_THAT(problem_of(text, {"load=5"}), HasSubstr("--set: load = 5"));
}

TEST_F(StudyFile, CorrelationsThatContradictEachOther) {
  std::string text =
      "samples = 4\n[scene.cage]\npocket_width_mm = { nominal = 7.65, lot = { law = 'normal', "
      "sigma = 0.01 } }\n"
      "pocket_length_mm = { nominal = 9.25, lot = { law = 'normal', sigma = 0.01 } }\n"
      "pocket_pitch_mrad = { lot = { law = 'normal', sigma = 0.01 } }\n";
  const char* width = "'cage.pocket_width_mm:lot'";
  const char* length = "'cage.pocket_length_mm:lot'";
  const char* pitch = "'cage.pocket_pitch_mrad:lot'";
  const auto pair = [](const char* a, const char* b, const char* rho) {
    return std::string("[[correlation]]\nbetween = [") + a + ", " + b + "]\nrho = " + rho + "\n";
  };
  EXPECT_EQ(problem_of(text + pair(width, length, "0.6") + pair(length, pitch, "0.6")), "no error");
  EXPECT_THAT(problem_of(text + pair(width, length, "0.9") + pair(length, pitch, "0.9") +
                         pair(width, pitch, "-0.9")),
              HasSubstr("correlation: the correlations contradict each other"));
  EXPECT_THAT(problem_of(text + pair(width, width, "0.9")), HasSubstr("two different inputs"));
}

TEST_F(StudyFile, AResolvedFileIsTheSameStudy) {
  for (const char* path : {"studies/nu205-rated.toml", "studies/nu205-measured.toml"}) {
    const Study study = read_study(shipped(path), {"samples=20"});
    EXPECT_EQ(study_of(study.resolved_toml).resolved_json, study.resolved_json) << path;
  }
}

TEST_F(StudyFile, ADocumentIsNoPartOfWhatMovesARun) {
  const std::string document = "[document]\ncustomer = 'W\u00e4lz & S\u00f6hne'\n";
  const Study plain = study_of("samples = 1\n"), filed = study_of("samples = 1\n" + document);
  EXPECT_EQ(filed.hash, plain.hash);
  EXPECT_EQ(study_of(filed.resolved_toml).document.customer, "W\u00e4lz & S\u00f6hne");
  EXPECT_EQ(problem_of("[document]\ndrawing = '" + std::string(120, 'x') + "'\n"), "no error");
  EXPECT_THAT(problem_of("[document]\ndrawing = '" + std::string(121, 'x') + "'\n"),
              AllOf(HasSubstr("document.drawing"), HasSubstr("a line of at most 120 characters")));
  EXPECT_THAT(problem_of("[document]\nauthor = \"a\\nb\"\n"), HasSubstr("a line of at most"));
  EXPECT_THAT(problem_of("[document]\nsigned = 'x'\n"), HasSubstr("no such key"));
}

TEST_F(StudyFile, ADocumentMayStandInAFileOfItsOwn) {
  const auto written = [&](const std::string& text) { return write("order.toml", text); };
  const auto texts = read_document(written("name = 'a'\n[document]\nproject = 'spindle'\n"));
  EXPECT_EQ(texts, (std::map<std::string, std::string>{{"project", "spindle"}}));
  EXPECT_THROW(read_document(written("name = 'a'\n")), InputError);
  EXPECT_THROW(read_document(written("[document]\nprojekt = 'a'\n")), InputError);
}

TEST_F(StudyFile, NotesSayWhatASimplerModelLeavesOut) {
  const std::string squareness = "cage.pocket_squareness_mrad = { law = 'normal', sigma = 1 }\n";
  const auto notes = model_notes(study_of(
      "samples = 5\n[scene]\nmodel.motion = 'quasi-static'\nload.ramp_ms = 2\n" + squareness));
  EXPECT_THAT(notes, ElementsAre("without effect (model.motion = \"quasi-static\"): "
                                 "cage.pocket_squareness_mrad, load.ramp_ms",
                                 HasSubstr("quasi-static: the ring's displacement")));
  EXPECT_TRUE(model_notes(study_of("samples = 5\n[scene]\n" + squareness)).empty());
  const std::string free = "samples = 5\n[scene]\nmodel.ring_tilt = 'free'\n";
  EXPECT_TRUE(model_notes(study_of(free)).empty());
}

TEST_F(StudyFile, ADynamicStudyMustSayWhetherThereIsOil) {
  write("silent.toml", reference_scene_without_oil());
  const std::string text = "samples = 5\n[scene]\nfile = 'silent.toml'\n";
  EXPECT_THAT(problem_of(text),
              AllOf(HasSubstr("study.toml: lubrication.model: a dynamic scene must say"),
                    HasSubstr("remedy: give lubrication.model = \"film\"")));
  EXPECT_FALSE(is_lubricated(study_of(text + "lubrication.model = 'none'\n").scene));
  EXPECT_FALSE(is_lubricated(study_of(text, {"lubrication.model=none"}).scene));
  EXPECT_TRUE(is_lubricated(study_of(text, {"scene.lubrication.model=film"}).scene));
  const std::string still = text + "model.motion = 'quasi-static'\n";
  EXPECT_FALSE(is_lubricated(study_of(still).scene));
  EXPECT_THAT(problem_of(still, {"model.motion=dynamic"}), HasSubstr("a dynamic scene must say"));
  // A ladder sets it in motion.
  EXPECT_THAT(
      problem_of("fidelity = 'auto'\n" + still),
      HasSubstr("lubrication.model: the model ladder sets this scene in motion, and a dynamic "
                "scene must say"));
  EXPECT_EQ(problem_of("fidelity = 'auto'\n" + still + "lubrication.model = 'none'\n"), "no error");
  EXPECT_THROW(require_word_of_oil(study_of(still), "s"), InputError);
  EXPECT_NO_THROW(require_word_of_oil(study_of(still + "lubrication.model = 'none'\n"), "s"));
}

TEST_F(StudyFile, ALubricatedStudyResolves) {
  const std::string text = "samples = 5\n[scene]\nlubrication.model = 'film'\n";
  const Study study = study_of(text);
  const Study again = read_resolved_study(study.resolved_toml, "again");
  EXPECT_EQ(again.hash, study.hash);
  EXPECT_TRUE(is_lubricated(again.scene));
  EXPECT_THAT(study.resolved_toml, HasSubstr("eyring_stress_MPa"));
  const Study dry =
      changed_study(study, [](Study& s) { s.scene.lubrication.model = LubricationModel::none; });
  EXPECT_FALSE(is_lubricated(dry.scene));
  EXPECT_THAT(problem_of(text + "film.viscosity_Pa_s = 0.03\n"),
              AllOf(HasSubstr("study.toml:4: film.viscosity_Pa_s = 0.03"),
                    HasSubstr("with the keys of lubrication")));
  EXPECT_THAT(problem_of("samples = 5\n", {"lubrication.model=film", "film.model=series"}),
              HasSubstr("--set: film.model = "));
}

TEST_F(StudyFile, AResolvedStudyOlderThanLubricationIsDry) {
  toml::table root = parse_toml(study_of("samples = 5\n").resolved_toml, "stored");
  root["scene"].as_table()->erase("lubrication");
  std::ostringstream text;
  text << toml::toml_formatter(root) << '\n';
  EXPECT_FALSE(is_lubricated(read_resolved_study(text.str(), "stored").scene));
  root["scene"].as_table()->insert("lubrication", 5);
  text.str("");
  text << toml::toml_formatter(root) << '\n';
  EXPECT_THROW(read_resolved_study(text.str(), "stored"), InputError);
}

TEST_F(StudyFile, AnInputOfASectionThatIsNoneIsRefused) {
  const std::string input = "[[inputs]]\nkey = 'contact.race.restitution'\nnominal = 0.9\n";
  EXPECT_THAT(problem_of("samples = 1\nscene.contact = 5\n" + input),
              HasSubstr("contact = 5: this is a section, not a key"));
  EXPECT_THAT(problem_of("samples = 1\nscene.contact.race = 5\n" + input),
              HasSubstr("contact.race = 5: this is a section, not a key"));
}

TEST_F(StudyFile, NotesNameRollersBesideTheBars) {
  const std::string cage = "samples = 5\n[scene.cage]\ninner_diameter_mm = 34.4\n";
  EXPECT_TRUE(model_notes(study_of(cage)).empty());
  EXPECT_THAT(model_notes(study_of(cage + "outer_diameter_mm = 37.6\n")),
              ElementsAre(HasSubstr("a radius of 19.5 mm, lie beside the flat faces of the bars")));
}

TEST_F(StudyFile, NotesNameTheOilThatADryBearingLeavesOut) {
  const std::string text = "samples = 5\n[scene.lubrication]\ntemperature_C = 90\n";
  EXPECT_THAT(model_notes(study_of(text)),
              ElementsAre(HasSubstr("(lubrication.model = \"none\"): lubrication.temperature_C")));
  EXPECT_TRUE(model_notes(study_of(text, {"lubrication.model=film"})).empty());
}

TEST_F(StudyFile, NotesSayWhatToKnow) {
  const Study study = study_of(
      "samples = 5\n[[limit]]\nquantity = 'cage_slip_ratio'\nmax = 1\nsource = "
      "'s'\ncage_revolutions = 60\n");
  EXPECT_THAT(study_notes(study),
              testing::Contains(HasSubstr("60 cage revolutions, the window measures 6")));
  EXPECT_THAT(study_notes(study), testing::Contains(HasSubstr("nothing varies")));
}

TEST_F(StudyFile, LimitsOnPeaksAreForTheRevolutionsThatPeaksAreTakenOver) {
  const auto notes_of = [&](const std::string& quantity, int revolutions) {
    const auto notes =
        study_notes(study_of("samples = 5\n[scene.window]\npeak_revolutions = 3\n[[limit]]\n"
                             "quantity = '" +
                             quantity + "'\nmax = 1\nsource = 's'\ncage_revolutions = " +
                             std::to_string(revolutions) + "\n"));
    std::string all;
    for (const std::string& note : notes) all += note + "\n";
    return all;
  };
  EXPECT_THAT(notes_of("pocket_force_peak_N", 6),
              HasSubstr("is for 6 cage revolutions, the window measures 3 "
                        "(scene.window.peak_revolutions)"));
  EXPECT_THAT(notes_of("pocket_force_peak_N", 3), testing::Not(HasSubstr("cage revolutions")));
  EXPECT_THAT(notes_of("pocket_force_rms_N", 6), testing::Not(HasSubstr("cage revolutions")));
}

}  // namespace
}  // namespace cagetol
