#include "mc/ladder/rungs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "mc/sample.hpp"
#include "src/input/input_error.hpp"
#include "src/scene/scene_keys.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

std::string shipped(const std::string& path) {
  return std::string(CAGETOL_SOURCE_DIR) + "/inputs/" + path;
}

TEST(Rungs, GoFromTheCheapestModelToTheWholeOne) {
  const auto& rungs = climbing_rungs();
  const Scene bottom = on_rung(Scene{}, rungs.front()), top = on_rung(Scene{}, rungs.back());
  EXPECT_EQ(bottom.cage.model, "rigid");
  EXPECT_EQ(bottom.discretisation.race_slices, 1);
  EXPECT_EQ(bottom.integration.tolerance, 0.02);
  EXPECT_EQ(top.cage.model, "flexible");
  EXPECT_EQ(top.cage.modes, 20);
  EXPECT_TRUE(top.cage.centrifugal && top.cage.coriolis);
  EXPECT_EQ(top.discretisation.race_slices, 5);
  EXPECT_EQ(top.integration.tolerance, Integration{}.tolerance);
  EXPECT_EQ(top.integration.method, Integration{}.method);
  // A rung says the same whatever rung the scene was on.
  EXPECT_EQ(on_rung(on_rung(Scene{}, rungs[4]), rungs.back()).cage.modes, 20);
}

TEST(Rungs, OneThingIsTakenAwayAtATime) {
  const Scene top = on_rung(Scene{}, climbing_rungs().back());
  for (const Rung& rung : separate_rungs()) {
    const Scene less = on_rung(Scene{}, rung);
    int changes = (less.cage.model != top.cage.model) + (less.cage.modes != top.cage.modes) +
                  (less.cage.centrifugal != top.cage.centrifugal) +
                  (less.discretisation.race_slices != top.discretisation.race_slices) +
                  (less.integration.tolerance != top.integration.tolerance);
    EXPECT_EQ(changes, rung.name == "full" ? 0 : 1) << rung.name;
  }
}

TEST(Rungs, AllSeeTheSameSamples) {
  const Study study = read_study(shipped("studies/nu205.toml"));
  const Study low = rung_study(study, climbing_rungs().front(), 24),
              high = rung_study(study, climbing_rungs().back(), 24);
  EXPECT_EQ(sample_count(low), 24u);
  EXPECT_NE(low.hash, high.hash);
  for (std::uint64_t id : {0u, 7u, 23u}) {
    const Sample a = draw_sample(low, id), b = draw_sample(high, id), own = draw_sample(study, id);
    EXPECT_EQ(a.scene.cage.pocket_width, b.scene.cage.pocket_width);
    EXPECT_EQ(a.scene.cage.pocket_width, own.scene.cage.pocket_width);
    EXPECT_EQ(a.scene.start.cage_offset_y, b.scene.start.cage_offset_y);
    EXPECT_EQ(a.scene.start.cage_phase, own.scene.start.cage_phase);
    EXPECT_EQ(a.scene.cage.model, "rigid");
    EXPECT_EQ(b.scene.cage.model, "flexible");
  }
  EXPECT_EQ(ladder_study_samples(study), 480);
}

TEST(Rungs, AGridBecomesRandomAndLosesItsClaims) {
  const Study grid = read_study(shipped("studies/paper-length.toml"));
  ASSERT_EQ(grid.design, "grid");
  const Study rung = rung_study(grid, climbing_rungs().front(), 5);
  EXPECT_EQ(rung.design, "random");
  EXPECT_EQ(sample_count(rung), 5u);
}

TEST(Rungs, AMereSceneGetsScatterOfItsStart) {
  const Study scene = read_study(shipped("scenes/nu205.toml"));
  const Study rung = rung_study(scene, climbing_rungs().front(), 4);
  ASSERT_EQ(rung.inputs.size(), 3u);
  EXPECT_NE(draw_sample(rung, 0).scene.start.cage_offset_y,
            draw_sample(rung, 1).scene.start.cage_offset_y);
  EXPECT_DOUBLE_EQ(std::get<Normal>(*rung.inputs[0].noise).sigma, 15);  // um, of 0.15 mm
  EXPECT_EQ(ladder_study_samples(scene), 1000);
}

TEST(Rungs, AKeyOfTheLadderMustNotScatter) {
  const Study study = read_study(shipped("scenes/nu205.toml"),
                                 {"integration.tolerance={ law = 'uniform', lower = 0, upper = "
                                  "0.0001, nominal = 0.001 }"});
  try {
    rung_study(study, climbing_rungs().front(), 4);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("scene.integration.tolerance"));
    EXPECT_THAT(error.what(), HasSubstr("remedy"));
  }
}

TEST(Rungs, TheDecisionIsPartOfTheResolvedStudy) {
  const Study study = read_study(shipped("studies/nu205.toml"), {"fidelity=auto"});
  EXPECT_EQ(study.fidelity, "auto");
  EXPECT_TRUE(study.fidelity_decision.rung.empty());
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const Study decided = changed_study(study, [&](Study& changed) {
    changed.scene = on_rung(changed.scene, climbing_rungs().front());
    changed.fidelity_decision = {
        "coarse-1",
        "because",
        {{"cage_slip_ratio", "coarse-3", 0.5, 0.25, 0.75, 0.125, "biased"},
         {"cage_slip_ratio", "coarse-1", 0, unknown, unknown, 0.125, "unresolved"}}};
  });
  EXPECT_NE(decided.hash, study.hash);
  const Study again = read_resolved_study(decided.resolved_toml, "again");
  EXPECT_EQ(again.hash, decided.hash);
  EXPECT_EQ(again.scene.discretisation.race_slices, 1);
  EXPECT_EQ(again.fidelity_decision.rung, "coarse-1");
  ASSERT_EQ(again.fidelity_decision.shifts.size(), 2u);
  EXPECT_EQ(again.fidelity_decision.shifts[0].upper, 0.75);
  EXPECT_TRUE(std::isnan(again.fidelity_decision.shifts[1].upper));
  const auto json = nlohmann::json::parse(decided.resolved_json);
  EXPECT_EQ(json["fidelity_decision"]["shift"][0]["verdict"], "biased");
  EXPECT_FALSE(json["fidelity_decision"]["shift"][1].contains("upper"));
  // Only a resolved study may hold it.
  EXPECT_THROW(read_study(shipped("studies/nu205.toml"), {"fidelity_decision.rung=full"}),
               InputError);
}

}  // namespace
}  // namespace cagetol
