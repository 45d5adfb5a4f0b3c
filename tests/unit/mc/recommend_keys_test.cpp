// What a study says about costs and about the stages of a recommendation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "mc/study/sample.hpp"
#include "mc/study/study.hpp"
#include "mc/study_file/tolerance.hpp"
#include "src/input/input_error.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

const std::string kCosts = "cost_table = [[0.05, 12], [0.1, 4]]";

/// A study with two dimensions; the lines given stand in each of them.
std::string study_text(const std::string& first, const std::string& second) {
  const auto dimension = [](const std::string& key, const std::string& more) {
    return "[[tolerance.dimension]]\nkey = \"cage." + key +
           "\"\ntolerance_width_mm = 0.1\ncandidates = [0.05, 0.1]\n" + more + "\n";
  };
  return "[scene]\nfile = \"" + shipped("scenes/nu205.toml") +
         "\"\n[scene.cage]\n"
         "pocket_width_mm = { nominal = 7.65, pocket = { law = \"normal\", sigma = 0.009 } }\n"
         "pocket_length_mm = { nominal = 9.25, pocket = { law = \"normal\", sigma = 0.009 } }\n" +
         dimension("pocket_width_mm", first) + dimension("pocket_length_mm", second);
}

Study study_of(const std::string& first, const std::string& second) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "study.toml") << study_text(first, second);
  return read_study(scratch / "study.toml");
}

std::string problem_of(const std::string& first, const std::string& second) {
  try {
    study_of(first, second);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RecommendKeys, ReadAndResolved) {
  const Study study = read_study(shipped("studies/nu205-rated.toml"),
                                 {"recommend.attempts=3", "recommend.budget_h=0.5"});
  EXPECT_EQ(study.recommend.attempts, 3);
  EXPECT_DOUBLE_EQ(study.recommend.budget_time, 1800);
  const auto json = nlohmann::json::parse(study.resolved_json);
  EXPECT_EQ(json["recommend"]["attempts"], 3);
  EXPECT_DOUBLE_EQ(json["recommend"]["budget_h"], 0.5);
  EXPECT_THROW(read_study(shipped("studies/nu205-rated.toml"), {"recommend.attempts=0"}),
               InputError);
  EXPECT_THROW(read_study(shipped("studies/nu205-rated.toml"), {"recommend.budget_h=-1"}),
               InputError);
  // Without candidates nobody knows a share.
  EXPECT_THROW(read_study(shipped("studies/nu205-rated.toml"),
                          {"redraw_jams=true", "tolerance.dimension=[]"}),
               InputError);
  EXPECT_TRUE(read_study(shipped("studies/nu205-rated.toml"), {"redraw_jams=true"}).redraw_jams);
}

TEST(RecommendKeys, CostsAreReadAndResolved) {
  const Study study = study_of(kCosts, "cost_table = [[0.05, 8], [0.1, 5.5]]");
  EXPECT_EQ(study.tolerance.dimensions[1].cost.at(1).second, 5.5);
  const Study again = read_resolved_study(study.resolved_toml, "again");
  EXPECT_EQ(again.hash, study.hash);
}

TEST(RecommendKeys, CentresMultiplyTheCandidates) {
  const Study study = study_of("centres = [7.6, 7.65, 7.75]", "");
  ASSERT_EQ(study.candidates.size(), 3u * 2 * 2);
  EXPECT_NEAR(study.candidates[0].shifts[0], -0.05, 1e-12);
  EXPECT_EQ(study.candidates[2].shifts[0], 0);  // the second length at the first centre is between
  EXPECT_NEAR(study.candidates[4].shifts[0], 0.1, 1e-12);
  EXPECT_EQ(study.candidates[4].shifts[1], 0);
  const Study again = read_resolved_study(study.resolved_toml, "again");
  EXPECT_EQ(again.hash, study.hash);
  EXPECT_EQ(again.candidates[4].shifts, study.candidates[4].shifts);
  for (const char* bad : {"centres = []", "centres = 7.6", "centres = [7.7, 7.6]",
                          "centres = [7.6, 7.6]", "centres = [\"7.6\"]"})
    EXPECT_THAT(problem_of(bad, ""), HasSubstr("tolerance.dimension.centres")) << bad;
  EXPECT_THAT(problem_of("centres = [-1, 7.6]", ""), HasSubstr("outside the range of this key"));
}

TEST(RecommendKeys, BadCostsAreRefused) {
  EXPECT_THAT(problem_of(kCosts, ""), HasSubstr("one dimension has a cost and another has none"));
  for (const char* bad : {"[]", "3", "[[0.05, 8]]", "[[0.1, 8], [0.05, 5]]", "[[0.05], [0.1, 5]]",
                          "[[0.05, -8], [0.1, 5]]", "[[0.05, \"x\"], [0.1, 5]]"})
    EXPECT_THAT(problem_of(kCosts, std::string("cost_table = ") + bad),
                HasSubstr("this is no table of costs"))
        << bad;
  EXPECT_THAT(problem_of(kCosts, "cost_table = [[0.06, 8], [0.1, 5]]"),
              HasSubstr("of 0.05 mm lies outside the table of costs, 0.06 to 0.1 mm"));
}

TEST(RecommendKeys, GradesAreForSizes) {
  for (const char* size : {"cage.pocket_width_mm", "roller.diameter_mm", "roller.length_mm",
                           "bearing.width_mm", "cage.retention_width_inner_mm"})
    EXPECT_TRUE(is_size(size)) << size;
  for (const char* other : {"bearing.internal_clearance_um", "cage.guide_clearance_mm",
                            "cage.corner_radius_mm", "lubrication.land_film_width_mm"})
    EXPECT_FALSE(is_size(other)) << other;
  const auto text = [](const char* candidate) {
    return "[scene]\nfile = \"" + shipped("scenes/nu205.toml") +
           "\"\n[scene.bearing]\ninternal_clearance_um = { nominal = 30, lot = { law = \"normal\", "
           "sigma = 2 } }\n[[tolerance.dimension]]\nkey = \"bearing.internal_clearance_um\"\n"
           "tolerance_width_mm = 0.015\ncandidates = [" +
           candidate + "]\n";
  };
  const ScratchDirectory scratch;
  std::ofstream(scratch / "tolerance.toml") << text("0.02");
  EXPECT_DOUBLE_EQ(read_study(scratch / "tolerance.toml").candidates[0].tolerance_widths_mm[0],
                   0.02);
  std::ofstream(scratch / "grade.toml") << text("\"IT6\"");
  try {
    read_study(scratch / "grade.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is no diameter, width or length in mm"));
  }
}

TEST(ChangedStudy, IsResolvedAnew) {
  const Study study = read_study(shipped("studies/nu205-rated.toml"));
  EXPECT_EQ(changed_study(study, [](Study&) {}).hash, study.hash);
  const Study changed = changed_study(study, [](Study& other) {
    other.samples = 33;
    other.tolerance.dimensions[0].candidates = {"0.123"};
    other.tolerance.dimensions[1].candidates = {"IT12"};
  });
  EXPECT_NE(changed.hash, study.hash);
  ASSERT_EQ(changed.candidates.size(), 1u);
  EXPECT_DOUBLE_EQ(changed.candidates[0].tolerance_widths_mm[0], 0.123);
  EXPECT_EQ(changed.candidates[0].grades[1], "IT12");
  EXPECT_THAT(changed.resolved_toml, HasSubstr("samples = 33"));
}

TEST(Identity, HoldsWhatMovesARunAlone) {
  const std::string file = shipped("studies/nu205-rated.toml");
  const Study study = read_study(file);
  for (const char* judging :
       {"name='other'", "limit=[{quantity='cage_slip_ratio', max=0.5, source='test'}]",
        "tolerance.target_yield=0.5", "tolerance.confidence=0.6", "recommend.budget_samples=9999",
        "recommend.attempts=7", "recommend.pilot_samples=77", "allowed_failure_share=0.5",
        "fidelity=auto", "fidelity_samples=7", "fidelity_budget=0.2"}) {
    const Study other = read_study(file, {judging});
    EXPECT_EQ(other.hash, study.hash) << judging;
    EXPECT_NE(other.resolved_toml, study.resolved_toml) << judging;
    for (const std::uint64_t id : {0, 5}) {
      EXPECT_EQ(draw_sample(other, id).scene.cage.pocket_width,
                draw_sample(study, id).scene.cage.pocket_width);
      EXPECT_EQ(draw_sample(other, id).scene.start.cage_phase,
                draw_sample(study, id).scene.start.cage_phase);
    }
  }
  for (const char* moving :
       {"seed=99", "samples=64", "design=lhs", "cages_per_lot=2", "redraw_jams=true",
        "extra_replicates=0.5", "cage_check_share=0.5", "scene.load.radial_N.nominal=900",
        "scene.window.measure_revolutions=3", "scene.integration.tolerance=0.002",
        "scene.cage.pocket_width_mm.nominal=7.66"})
    EXPECT_NE(read_study(file, {moving}).hash, study.hash) << moving;
  EXPECT_EQ(study_of(kCosts, kCosts).hash,
            study_of(kCosts, "cost_table = [[0.05, 8], [0.1, 5.5]]").hash);
  // Which candidate a sample has is drawn from all of them.
  const std::string name = "tolerance.dimension=[{key='cage.pocket_width_mm', tolerance_width_mm=";
  EXPECT_NE(read_study(file, {name + "0.1, candidates=['IT11']}]"}).hash,
            read_study(file, {name + "0.1, candidates=['IT11', 'IT12']}]"}).hash);
}

}  // namespace
}  // namespace cagetol
