// A study with several operating points: what it reads and refuses, and what its samples are.
#include "mc/study/operating_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "mc/run/sample_run.hpp"
#include "mc/sweep/stored_study.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"
#include "tests/support/not_a_number.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const char* const kScene = R"(name = "points"
samples = 3
[scene.discretisation]
race_slices = 3
[scene.window]
settle_time_s = 2e-4
measure_time_s = 4e-4
[scene.cage]
pocket_width_mm = { nominal = 7.65, lot = { law = "normal", sigma = 0.009 } }
[scene.start]
cage_phase_deg = { noise = { law = "uniform", lower = 0, upper = 360 } }
)";

const char* const kPoints = R"([[operating_point]]
name = "rated"
weight = 3
[[operating_point]]
name = "idle"
"load.radial_N" = 200
speed.inner_rpm = 3000
)";

class OperatingPoints : public testing::Test {
 protected:
  Study study_of(const std::string& text) const {
    const std::string path = scratch_ / "study.toml";
    std::ofstream(path) << text << "[scene]\nfile = '" << shipped("scenes/nu205.toml") << "'\n";
    return read_study(path);
  }
  std::string problem_of(const std::string& text) const {
    try {
      study_of(kScene + text);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "no problem";
  }
  const ScratchDirectory scratch_;
};

std::vector<std::string> limited(const Study& study) {
  std::vector<std::string> names;
  for (const Limit& limit : study.limits) names.push_back(limit.quantity);
  return names;
}

const char* const kWarm = R"(samples = 2
[scene.window]
settle_time_s = 2e-3
measure_time_s = 1e-2
[scene.cage]
model = "rigid"
[scene.temperature]
balance = true
found_C = "auto"
[[operating_point]]
name = "rated"
[[operating_point]]
name = "fast"
speed.inner_rpm = 12000
[[operating_point]]
name = "cold-start"
temperature.balance = false
lubrication.temperature_C = 20
)";

TEST_F(OperatingPoints, EachIsAsWarmAsItsHeatMakesIt) {
  const Study study = study_of(kWarm);
  const auto at = [&](std::size_t k) { return at_operating_point(study.scene, study.points[k]); };
  EXPECT_EQ(at(0).lubrication.temperature, study.scene.lubrication.temperature);
  EXPECT_GT(at(1).lubrication.temperature, at(0).lubrication.temperature + 20);
  EXPECT_EQ(at(1).temperature.found, at(1).lubrication.temperature);
  EXPECT_EQ(at(2).lubrication.temperature, 20);
  EXPECT_FALSE(at(2).temperature.balance);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(simulate(at(k)).status, Status::ok) << study.points[k].name;
  // What was found is part of the study: reading it again finds nothing anew.
  EXPECT_EQ(read_resolved_study(study.resolved_toml, "again").hash, study.hash);
  Study forgotten = study;
  forgotten.scene.temperature.ambient = 50;
  forget_temperatures(forgotten);
  find_temperatures(forgotten);
  EXPECT_GT(at_operating_point(forgotten.scene, forgotten.points[1]).temperature.found,
            at(1).temperature.found + 5);
  EXPECT_EQ(at_operating_point(forgotten.scene, forgotten.points[2]).lubrication.temperature, 20);
}

TEST_F(OperatingPoints, ALimitWithoutLabelIsOneAtEachPoint) {
  const Study study =
      study_of(std::string(kScene) + kPoints +
               "[[limit]]\nquantity = 'cage_slip_ratio'\nmax = 1\nsource = 's'\n"
               "[[limit]]\nquantity = 'power_loss_W@idle'\nmax = 1\nsource = 's'\n");
  EXPECT_THAT(limited(study),
              ElementsAre("cage_slip_ratio@rated", "cage_slip_ratio@idle", "power_loss_W@idle"));
  EXPECT_THAT(quantity_labels(study), ElementsAre("rated", "idle"));
  // The resolved study is the same study.
  const Study again = read_resolved_study(study.resolved_toml, "again");
  EXPECT_EQ(again.hash, study.hash);
  EXPECT_EQ(limited(again), limited(study));
  EXPECT_DOUBLE_EQ(again.points[0].weight, 3);
  EXPECT_DOUBLE_EQ(at_operating_point(again.scene, again.points[1]).operation.radial_load, 200);
  EXPECT_DOUBLE_EQ(at_operating_point(again.scene, again.points[0]).operation.radial_load, 1000);
}

const char* const kAtMinimum = R"([[operating_point]]
name = "minimum"
minimum_loads = 1.5
limiting_speeds = 0.75
[[limit]]
quantity = "driving_slip_ratio"
operating_point = "minimum"
max_at_minimum_loads = 1
source = "s"
)";

TEST_F(OperatingPoints, LoadsAndSpeedsMayBeMultiplesOfTheMakers) {
  const Study study = study_of(std::string(kScene) + kAtMinimum);
  const Operation at = at_operating_point(study.scene, study.points[0]).operation;
  EXPECT_DOUBLE_EQ(at.inner_speed, 0.75 * study.scene.bearing.limiting_speed);
  // SKF: k_r (6 + 4 n/n_r) (d_m/100)^2 kN, d_m in mm; up to the next tenth of a newton.
  const double least = 1e3 * 0.15 * (6 + 4 * 12000.0 / 14000) * std::pow(0.385, 2);
  EXPECT_NEAR(at.radial_load, 1.5 * least, 0.1);
  EXPECT_GE(at.radial_load, 1.5 * least);
  EXPECT_THAT(problem_of(std::string(kPoints) + "minimum_loads = 2\n"),
              AllOf(HasSubstr("load.radial_N is given as well"), HasSubstr("study.toml:1")));
  EXPECT_THAT(problem_of("[[operating_point]]\nname = 'a'\nlimiting_speeds = 0.5\n"
                         "[scene.bearing]\nlimiting_speed_rpm = 'auto'\n"),
              AllOf(HasSubstr("does not give bearing.limiting_speed_rpm"), HasSubstr("remedy")));
}

TEST_F(OperatingPoints, ALimitMayBeWhatTheNominalBearingHasAtTheMinimumLoad) {
  const Study study = study_of(std::string(kScene) + kAtMinimum);
  ASSERT_THAT(limited(study), ElementsAre("driving_slip_ratio@minimum"));
  Scene scene = at_operating_point(study.scene, study.points[0]);
  scene.operation.radial_load /= 1.5;
  double sum = 0;
  for (int start = 0; start < 8; ++start) {
    scene.start.cage_phase = start * 0.25 * M_PI;
    sum +=
        simulate(scene).quantities[static_cast<std::size_t>(quantity_index("driving_slip_ratio"))];
  }
  // The load there is a tenth of a newton too large at most.
  EXPECT_NEAR(*study.limits[0].maximum, sum / 8, 0.01 * sum / 8);
  // It is found once: the resolved study carries it.
  EXPECT_EQ(read_resolved_study(study.resolved_toml, "again").hash, study.hash);
  EXPECT_THAT(
      problem_of(std::string(kAtMinimum) + "[scene.bearing]\nminimum_load_factor = 'auto'\n"),
      HasSubstr("does not give"));
}

TEST_F(OperatingPoints, AStudyThatMeasuresWhirlIsTheSameFromItsOwnText) {
  const Study study = study_of(std::string(kScene) +
                               "[[operating_point]]\nname = 'whirl'\n"
                               "\"window.measure_time_s\" = 'auto'\n"
                               "\"window.measure_revolutions\" = 20\n");
  EXPECT_NEAR(study.scene.window.whirl_clearance, 75e-6, 1e-9);  // half the pocket's clearance
  EXPECT_EQ(read_resolved_study(study.resolved_toml, "again").resolved_toml, study.resolved_toml);
}

TEST_F(OperatingPoints, ABalanceInAStudyTakesTheTemperaturesOfTheSceneFileAway) {
  const std::string balance = "[scene.temperature]\nbalance = true\n";
  const Study study = study_of(kScene + balance);
  EXPECT_EQ(study.scene.lubrication.temperature, study.scene.temperature.found);
  EXPECT_THAT(problem_of(balance + "[scene.lubrication]\ntemperature_C = 50\n"),
              HasSubstr("temperature.balance = true finds"));
}

TEST_F(OperatingPoints, ALoadOfMoreDigitsThanAnIntegerHasIsReadAgain) {
  const Study study =
      study_of(std::string(kScene) +
               "[[operating_point]]\nname = 'a'\n\"load.radial_N\" = 9223372036854775807\n");
  EXPECT_EQ(at_operating_point(study.scene, study.points[0]).operation.radial_load, 0x1p63);
}

TEST_F(OperatingPoints, ASampleIsTheDrawnBearingAtEachPoint) {
  const Study study = study_of(std::string(kScene) + kPoints);
  const Sample sample = draw_sample(study, 1);
  const Outcome joined = run_sample(study, sample);
  ASSERT_EQ(joined.status, Status::ok) << joined.reason;
  Scene idle = sample.scene;
  idle.operation.radial_load = 200;
  idle.operation.inner_speed /= 2;
  const Outcome rated = simulate(sample.scene, {}), light = simulate(idle, {});
  const auto& table = quantity_table();
  ASSERT_EQ(joined.quantities.size(), 3 * table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    EXPECT_TRUE(same(joined.quantities[table.size() + i], rated.quantities[i])) << table[i].key;
    EXPECT_TRUE(same(joined.quantities[2 * table.size() + i], light.quantities[i])) << table[i].key;
  }
  const auto value = [&](const Outcome& of, const std::string& name) {
    return of.quantities[static_cast<std::size_t>(labelled_index(name, of.labels))];
  };
  const double torque = value(rated, "friction_torque_Nmm"),
               less = value(light, "friction_torque_Nmm");
  EXPECT_NE(torque, less);
  EXPECT_NEAR(value(joined, "friction_torque_Nmm"), (3 * torque + less) / 4, 1e-9 * torque);
  EXPECT_EQ(value(joined, "roller_load_peak_N"), value(rated, "roller_load_peak_N"));
  EXPECT_EQ(value(joined, "film_min_um"),
            std::min(value(rated, "film_min_um"), value(light, "film_min_um")));
  EXPECT_TRUE(std::isnan(value(joined, "cage_slip_ratio")));
  EXPECT_EQ(joined.run.steps, rated.run.steps + light.run.steps);
}

// By its kind, whatever its key: a new smallest value is the smallest of its points.
TEST_F(OperatingPoints, AQuantityIsJoinedByItsKind) {
  Study study;
  study.points = {{"a", 1, {}}, {"b", 3, {}}, {"c", 4, {}}};
  std::vector<Outcome> outcomes(3);
  outcomes[0].quantities = {3};
  outcomes[1].quantities = {1};
  outcomes[2].quantities = {2};
  const Quantity& any = quantity_table()[0];
  const auto joined = [&](Kind kind) {
    return over_points({"gap_min_um", "um", kind, any.need, any.bound, "", ""}, 0, study, outcomes);
  };
  EXPECT_EQ(joined(Kind::minimum), 1);
  EXPECT_EQ(joined(Kind::peak), 3);
  EXPECT_DOUBLE_EQ(joined(Kind::power), (3 + 3 * 1 + 4 * 2) / 8.0);
  EXPECT_TRUE(std::isnan(joined(Kind::mean)));
  outcomes[1].quantities = {kNan};
  EXPECT_EQ(joined(Kind::minimum), 2);
}

TEST_F(OperatingPoints, APointThatFailsFailsItsSampleAndIsNamed) {
  const Study study = study_of(std::string(kScene) + kPoints +
                               "[[operating_point]]\nname = 'cut'\nwindow.measure_time_s = 9\n"
                               "[scene.integration]\nstep_budget = 5000\n");
  const Outcome joined = run_sample(study, draw_sample(study, 0));
  EXPECT_EQ(joined.status, Status::censored);
  EXPECT_THAT(joined.reason, HasSubstr("operating point cut: "));
  EXPECT_EQ(joined.quantities.size(), 4 * quantity_table().size());
  EXPECT_TRUE(std::isnan(joined.quantities[0]));
}

TEST_F(OperatingPoints, AreKeptInTheStudyFile) {
  const SweepPlan plan = make_sweep_plan(study_of(std::string(kScene) + kPoints));
  OutcomesById outcomes;
  for (std::uint64_t id = 0; id < plan.samples; ++id)
    outcomes[id] = make_stored_outcome(id, plan.job(plan.draw(id), [] { return false; }), 0.1, 0);
  const std::string path = scratch_ / "study.h5";
  write_study_file(path, plan, outcomes, build_info());
  const StudyFile file = read_study_file(path);
  ASSERT_EQ(file.outcomes.size(), outcomes.size());
  for (const auto& [id, outcome] : outcomes)
    EXPECT_THAT(outcome_differences(file.outcomes.at(id), outcome), testing::IsEmpty());
}

TEST_F(OperatingPoints, RefuseWhatIsNoOperationOfTheBearing) {
  const std::string point = "[[operating_point]]\nname = 'a'\n";
  EXPECT_THAT(problem_of(point + "cage.width_mm = 13\n"),
              AllOf(HasSubstr("cage.width_mm = 13"), HasSubstr("nothing that the bearing is")));
  EXPECT_THAT(problem_of(point + "load.radial_M = 13\n"), HasSubstr("load.radial_N"));
  EXPECT_THAT(problem_of(point + "start.cage_phase_deg = 13\n"), HasSubstr("varies in the study"));
  EXPECT_THAT(problem_of(point + "load.radial_N = -1\n"), HasSubstr("at least 0 N"));
  EXPECT_THAT(
      problem_of(point + "load.axial_N = 10\n"),
      AllOf(HasSubstr("study.toml:12: operating_point = a"), HasSubstr("load.axial_N = 10")));
  EXPECT_THAT(problem_of(point + "weight = 0\n"), HasSubstr("operating_point.weight"));
  EXPECT_THAT(problem_of("[[operating_point]]\nweight = 1\n"), HasSubstr("has no name"));
  EXPECT_THAT(problem_of("[[operating_point]]\nname = 'a@b'\n"), HasSubstr("letters, digits"));
  EXPECT_THAT(problem_of(point + point), HasSubstr("two points are called a"));
  EXPECT_THAT(problem_of("[operating_point]\nname = 'a'\n"), HasSubstr("[[operating_point]]"));
  EXPECT_THAT(problem_of(point + "[[limit]]\nquantity = 'power_loss_W@b'\nmax = 1\nsource = 's'\n"),
              AllOf(HasSubstr("called 'b'"), HasSubstr("choose from a")));
  EXPECT_THAT(problem_of("[[limit]]\nquantity = 'power_loss_W@b'\nmax = 1\nsource = 's'\n"),
              HasSubstr("leave out @b"));
}

// Whirl of all samples is over the clearance of the nominal bearing.
TEST_F(OperatingPoints, WhereOneMeasuresWhirlTheStudySaysOverWhat) {
  const std::string base = "samples = 2\n[scene.cage]\npocket_width_mm = { nominal = ",
                    scatter = ", lot = { law = 'normal', sigma = 0.009 } }\n",
                    long_window =
                        "[[operating_point]]\nname = 'a'\nwindow.measure_revolutions = 20\n",
                    brief = "[[operating_point]]\nname = 'a'\nwindow.measure_revolutions = 19\n";
  const auto over = [&](const std::string& width, const std::string& point) {
    return study_of(base + width + scatter + point).scene.window.whirl_clearance;
  };
  EXPECT_NEAR(over("7.65", long_window), 75e-6, 1e-12);
  EXPECT_NEAR(over("8.0", long_window), 200e-6, 1e-12);  // the guide's
  EXPECT_TRUE(std::isnan(over("7.65", brief)));
  EXPECT_TRUE(std::isnan(over("7.5", "allow_interference = true\n" + long_window)));
}

TEST_F(OperatingPoints, SayHowMuchMotionTheyMake) {
  const Study study = study_of(std::string(kScene) + kPoints);
  EXPECT_THAT(
      operating_points_text(study),
      AllOf(HasSubstr("2 operating points"), HasSubstr("6 runs"), HasSubstr("weight 0.75"),
            HasSubstr("idle, weight 0.25, load.radial_N = 200"), HasSubstr("0.0012 s of motion")));
  Study plain = study;
  plain.points.clear();
  EXPECT_EQ(operating_points_text(plain), "");
}

}  // namespace
}  // namespace cagetol
