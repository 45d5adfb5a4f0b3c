#include "mc/ladder/rungs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/fidelity/error_budget.hpp"
#include "mc/study/sample.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/quasi_static.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

TEST(Rungs, GoFromTheCheapestModelToTheWholeOne) {
  const auto& rungs = climbing_rungs();
  const Scene bottom = on_rung(Scene{}, rungs.front()), top = on_rung(Scene{}, rungs.back());
  EXPECT_EQ(bottom.cage.model, CageKind::rigid);
  EXPECT_TRUE(is_quasi_static(bottom));
  EXPECT_EQ(bottom.discretisation.race_slices, 5);
  const Scene coarse = on_rung(Scene{}, rungs[1]);
  EXPECT_FALSE(is_quasi_static(coarse));
  EXPECT_EQ(coarse.discretisation.race_slices, 3);
  EXPECT_EQ(coarse.integration.tolerance, 0.02);
  EXPECT_FALSE(is_quasi_static(top));
  EXPECT_EQ(top.cage.model, CageKind::flexible);
  EXPECT_EQ(top.cage.modes, 10);
  EXPECT_TRUE(top.cage.bar_modes);
  EXPECT_TRUE(top.cage.centrifugal && top.cage.coriolis);
  EXPECT_EQ(top.discretisation.race_slices, 5);
  EXPECT_EQ(top.integration.tolerance, Integration{}.tolerance);
  EXPECT_EQ(top.integration.method, Integration{}.method);
  // A rung says the same whatever rung the scene was on.
  for (const Rung& rung : rungs)
    EXPECT_EQ(dump_keys(scene_keys(), on_rung(on_rung(Scene{}, rung), rungs.back())),
              dump_keys(scene_keys(), top))
        << rung.name;
}

std::vector<std::string> names_of(const std::vector<Rung>& rungs) {
  std::vector<std::string> names;
  for (const Rung& rung : rungs) names.push_back(rung.name);
  return names;
}

TEST(Rungs, EachRefinesOneThingOfTheScene) {
  Scene rigid;
  rigid.integration = {.method = IntegrationMethod::rodas3, .tolerance = 0.005};
  const auto rungs = refining_rungs(rigid);
  EXPECT_EQ(names_of(rungs),
            (std::vector<std::string>{"integrator", "modes", "slices", "window", "as-run"}));
  const Scene integrator = on_rung(rigid, rungs[0]), modes = on_rung(rigid, rungs[1]),
              slices = on_rung(rigid, rungs[2]), window = on_rung(rigid, rungs[3]);
  EXPECT_EQ(integrator.integration.method, IntegrationMethod::rodasp);
  EXPECT_DOUBLE_EQ(integrator.integration.tolerance, 0.0005);
  EXPECT_EQ(integrator.cage.model, CageKind::rigid);
  EXPECT_EQ(modes.cage.model, CageKind::flexible);
  EXPECT_EQ(modes.cage.modes, 10);
  EXPECT_EQ(modes.integration.tolerance, 0.005);
  EXPECT_EQ(slices.discretisation.race_slices, 11);
  EXPECT_EQ(window.window.measure_revolutions, 12);
  EXPECT_TRUE(rungs.back().settings.empty());
  EXPECT_EQ(rungs[0].settings.size(), 2u);

  Scene flexible = rigid;
  flexible.cage.model = CageKind::flexible;
  flexible.integration.method = IntegrationMethod::rodasp;
  flexible.window.measure_time = 0.0125;
  const auto more = refining_rungs(flexible);
  std::vector<std::string> all(kRefinedSettings.begin(), kRefinedSettings.end());
  all.emplace_back("as-run");
  EXPECT_EQ(names_of(more), all);          // the error budget asks for these
  EXPECT_EQ(more[0].settings.size(), 1u);  // its method is the finest already
  EXPECT_EQ(on_rung(flexible, more[1]).cage.modes, 36);
  EXPECT_EQ(on_rung(flexible, more[3]).cage.mesh_density, flexible.cage.mesh_density + 2);
  EXPECT_DOUBLE_EQ(on_rung(flexible, more[4]).window.measure_time, 0.025);
  EXPECT_EQ(on_rung(flexible, more[4]).window.measure_revolutions, 6);
}

TEST(Rungs, WhatCannotBeRefinedIsLeftOut) {
  Scene finest;
  finest.cage.model = CageKind::flexible;
  finest.cage.modes = 36;
  finest.cage.mesh_density = 12;
  finest.discretisation.race_slices = 100;
  EXPECT_EQ(names_of(refining_rungs(finest)),
            (std::vector<std::string>{"integrator", "window", "as-run"}));
  finest.discretisation.race_slices = 60;
  finest.cage.mesh_density = 11;
  const auto rungs = refining_rungs(finest);
  EXPECT_EQ(on_rung(finest, rungs[1]).discretisation.race_slices, 100);
  EXPECT_EQ(on_rung(finest, rungs[2]).cage.mesh_density, 12);
}

TEST(Rungs, AFreeRingStays) {
  Scene scene;
  scene.model.ring_tilt = TiltModel::free;
  scene.operation.tilting_moment_z = 2;
  for (const Rung& rung : climbing_rungs()) {
    EXPECT_EQ(on_rung(scene, rung).model.ring_tilt, TiltModel::free);
    EXPECT_NO_THROW(check_scene(on_rung(scene, rung), "rung"));
  }
}

TEST(Rungs, TheLowestGivesItsQuantitiesAndNoOthers) {
  const Scene scene = on_rung(Scene{}, climbing_rungs().front());
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  for (std::size_t k = 0; k < quantity_table().size(); ++k)
    EXPECT_EQ(std::isfinite(outcome.quantities[k]), quantity_table()[k].need.met(scene))
        << quantity_table()[k].key;
}

TEST(Rungs, AreThoseThatTellModelsOfTheSceneApart) {
  // Equilibria carry no axial load.
  const Scene axial = read_study(shipped("scenes/nj308-axial.toml")).scene;
  EXPECT_EQ(rungs_for(axial, climbing_rungs()).front().name, "coarse-3");
  const Scene radial = read_study(shipped("scenes/nu208-brass.toml")).scene;
  EXPECT_EQ(names_of(rungs_for(radial, climbing_rungs())), names_of(climbing_rungs()));
}

// A rung that a bearing's scene cannot take ends its ladder.
TEST(Rungs, FitEveryBearingThatShips) {
  for (const auto& file : std::filesystem::directory_iterator(shipped("scenes"))) {
    const Scene scene = read_study(file.path().string()).scene;
    for (const auto& rungs : {climbing_rungs(), refining_rungs(scene)})
      for (const Rung& rung : rungs_for(scene, rungs))
        EXPECT_NO_THROW(check_scene(on_rung(scene, rung), "rung"))
            << file.path() << ", " << rung.name;
  }
}

TEST(Rungs, AllSeeTheSameSamples) {
  const Study study = read_study(shipped("studies/nu205-rated.toml"));
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
    EXPECT_EQ(a.scene.cage.model, CageKind::rigid);
    EXPECT_EQ(b.scene.cage.model, CageKind::flexible);
  }
  for (const Rung& rung : refining_rungs(study.scene)) {
    const Sample own = draw_sample(study, 7), refined = draw_sample(rung_study(study, rung, 24), 7);
    EXPECT_EQ(own.scene.cage.pocket_width, refined.scene.cage.pocket_width) << rung.name;
    EXPECT_EQ(own.scene.start.cage_phase, refined.scene.start.cage_phase) << rung.name;
  }
  EXPECT_EQ(ladder_study_samples(study), 480);
}

TEST(Rungs, AnyDesignBecomesRandom) {
  const Study spread = read_study(shipped("studies/nu205-rated.toml"), {"design='lhs'"});
  ASSERT_EQ(spread.design, DesignKind::lhs);
  const Study rung = rung_study(spread, climbing_rungs().front(), 5);
  EXPECT_EQ(rung.design, DesignKind::random);
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
  const Study study = read_study(shipped("studies/nu205-rated.toml"), {"fidelity=auto"});
  EXPECT_EQ(study.fidelity, "auto");
  EXPECT_TRUE(study.fidelity_decision.rung.empty());
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const Study decided = changed_study(study, [&](Study& changed) {
    changed.scene = on_rung(changed.scene, climbing_rungs().front());
    changed.fidelity_decision = {"quasi-static",
                                 "because",
                                 "that it is so",
                                 {{"cage_slip_ratio", "coarse-3", 0.5, 0.25, 0.75, 0.125, "settled",
                                   "limit at most 1", 1e-5, 1e-3},
                                  {"cage_slip_ratio", "quasi-static", 0, unknown, unknown, 0.125,
                                   "unresolved", "", unknown, unknown}}};
  });
  EXPECT_NE(decided.hash, study.hash);
  const Study again = read_resolved_study(decided.resolved_toml, "again");
  EXPECT_EQ(again.hash, decided.hash);
  EXPECT_TRUE(is_quasi_static(again.scene));
  EXPECT_EQ(again.fidelity_decision.rung, "quasi-static");
  ASSERT_EQ(again.fidelity_decision.shifts.size(), 2u);
  EXPECT_EQ(again.fidelity_decision.shifts[0].upper, 0.75);
  EXPECT_TRUE(std::isnan(again.fidelity_decision.shifts[1].upper));
  const auto json = nlohmann::json::parse(decided.resolved_json);
  EXPECT_EQ(again.fidelity_decision.assumption, "that it is so");
  EXPECT_EQ(again.fidelity_decision.shifts[0].wrong_share, 1e-5);
  EXPECT_EQ(again.fidelity_decision.shifts[0].limit, "limit at most 1");
  EXPECT_TRUE(std::isnan(again.fidelity_decision.shifts[1].wrong_share));
  EXPECT_EQ(json["fidelity_decision"]["shift"][0]["verdict"], "settled");
  EXPECT_FALSE(json["fidelity_decision"]["shift"][1].contains("upper"));
  // Only a resolved study may hold it.
  EXPECT_THROW(read_study(shipped("studies/nu205-rated.toml"), {"fidelity_decision.rung=full"}),
               InputError);
}

}  // namespace
}  // namespace cagetol
