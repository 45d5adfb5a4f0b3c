#include "analysis/fidelity/model_ladder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mc/study_file/study_file_error.hpp"
#include "tests/support/not_a_number.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Four runs of a rung whose slip is 1, 2, 3, 4 plus `shift`; each takes `seconds`.
StudyData rung_runs(double shift, double seconds, double stress) {
  StudyData runs = plain_study(4);
  runs.quantities = {{"cage_slip_ratio", "-", "", {1 + shift, 2 + shift, 3 + shift, 4 + shift}},
                     {"cage_stress_peak_MPa", "MPa", "", {stress, 2 * stress, stress, stress}}};
  runs.timing = {{"wall_s", "s", "", {seconds, seconds, 9 * seconds, seconds}}};
  runs.plan.limits = {{.quantity = "cage_slip_ratio", .minimum = {}, .maximum = 1, .source = "t"}};
  return runs;
}

ModelLadder climbed(const std::vector<StudyData>& runs) {
  std::vector<LadderRung> rungs = {{.name = "low"}, {.name = "middle"}, {.name = "full"}};
  return make_model_ladder(rungs, runs, {.study_samples = 100});
}

TEST(ModelLadder, NamesTheMinimumRungOfEachQuantity) {
  const ModelLadder ladder =
      climbed({rung_runs(0.5, 1, kNan), rung_runs(0, 2, kNan), rung_runs(0, 8, 50)});
  const auto json = ladder_json(ladder);
  EXPECT_EQ(json["minimum_rung"]["cage_slip_ratio"], "middle");
  EXPECT_EQ(json["minimum_rung"]["cage_stress_peak_MPa"], "full");
  EXPECT_EQ(json["rungs"][0]["cost_ratio"], 0.125);
  EXPECT_EQ(json["quantities"][0]["rungs"][0]["verdict"], "biased");
  EXPECT_EQ(json["quantities"][0]["rungs"][0]["shift"], 0.5);
  EXPECT_TRUE(json["quantities"][1]["rungs"][0]["shift"].is_null());
  EXPECT_EQ(json["quantities"][1]["rungs"][0]["verdict"], "unusable");
  // Only limited quantities choose the rung of a study.
  EXPECT_EQ(chosen_rung(ladder), 1u);
  EXPECT_THAT(ladder_text(ladder), HasSubstr("minimum rung: middle"));
  EXPECT_THAT(ladder_text(ladder), HasSubstr("no run has a value"));
  EXPECT_THAT(ladder_text(ladder), Not(HasSubstr("nan")));
}

TEST(ModelLadder, RefiningSeeksNoMinimumRung) {
  ModelLadder ladder = climbed({rung_runs(0.5, 16, 50), rung_runs(0, 2, 50), rung_runs(0, 8, 50)});
  EXPECT_FALSE(ladder_json(ladder)["refining"]);
  ladder.refining = true;
  ladder.resolved_study = {{"seed", 5}};
  ladder.build = "this one";
  const auto json = ladder_json(ladder);
  EXPECT_TRUE(json["refining"]);
  EXPECT_EQ(json["resolved_study"]["seed"], 5);
  EXPECT_EQ(json["build"], "this one");
  EXPECT_FALSE(json.contains("minimum_rung"));
  EXPECT_FALSE(json["quantities"][0].contains("minimum_rung"));
  EXPECT_EQ(json["quantities"][0]["rungs"][0]["shift"], 0.5);  // refined minus as run
  EXPECT_THAT(ladder_text(ladder), testing::Not(HasSubstr("minimum rung")));
  EXPECT_THAT(ladder_text(ladder), HasSubstr("refined minus as-run"));
}

TEST(ModelLadder, CountsRunsThatGaveNoResult) {
  auto failed = rung_runs(0, 1, 50);
  failed.status[2] = RunStatus::failed;
  const ModelLadder ladder = climbed({failed, rung_runs(0, 2, 50), rung_runs(0, 8, 50)});
  EXPECT_EQ(ladder.rungs[0].ok, 3u);
  EXPECT_EQ(ladder.quantities[0].ladder.rungs[0].verdict, RungVerdict::unusable);
  EXPECT_EQ(chosen_rung(ladder), 1u);
}

TEST(ModelLadder, WithoutLimitsTakesTheReference) {
  auto runs = std::vector{rung_runs(0, 1, 50), rung_runs(0, 2, 50), rung_runs(0, 8, 50)};
  for (StudyData& rung : runs) rung.plan.limits.clear();
  EXPECT_EQ(chosen_rung(climbed(runs)), 2u);
}

TEST(ModelLadder, RefusesRungsWithOtherSamples) {
  auto other = rung_runs(0, 1, 50);
  other.id[1] = 77;
  EXPECT_THROW(climbed({other, rung_runs(0, 2, 50), rung_runs(0, 8, 50)}), StudyFileError);
}

}  // namespace
}  // namespace cagetol
