// A duty over time in scene files and CSV: what is read, and what is refused with place and remedy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>

#include "src/reading/scene_keys.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class DutyKeys : public testing::Test {
 protected:
  DutyKeys() { std::filesystem::create_directories(folder_); }
  ~DutyKeys() override { std::filesystem::remove_all(folder_); }

  /// The NU 205 with `text` on top, as if it stood in a file of the folder.
  Scene scene_of(const std::string& text) const {
    toml::table root = read_toml(shipped("scenes/nu205.toml"));
    merge_tables(root, parse_toml(text, folder_ + "/scene.toml"), is_distribution);
    return read_scene(root, folder_ + "/scene.toml");
  }
  std::string problem_of(const std::string& text) const {
    try {
      scene_of(text);
    } catch (const InputError& problem) {
      return problem.what();
    }
    return "no problem";
  }
  std::string with_csv(const std::string& csv) const {
    std::ofstream(folder_ + "/cycle.csv") << csv;
    return "[duty]\nfile = 'cycle.csv'\n";
  }

  const std::string folder_ = testing::TempDir() + "duty_keys_" +
                              testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(DutyKeys, ReadColumnsOfTheSceneAndPhasesOfBothForms) {
  const Scene scene = scene_of(
      "[duty]\ntime_s = [0, 0.1]\ninner_rpm = [0, 3000]\nrepeat_s = 0.2\n"
      "[[phase]]\nname = 'start'\nfrom_s = 0\nto_s = 0.1\n");
  EXPECT_NEAR(scene.operation.table.inner_speed[1], 314.159265, 1e-5);
  EXPECT_DOUBLE_EQ(scene.operation.table.repeat, 0.2);
  EXPECT_THAT(scene.phase.name, ElementsAre("start"));
  EXPECT_DOUBLE_EQ(scene.phase.to[0], 0.1);
  const Scene other = scene_of(
      "[duty]\ntime_s = [0, 0.1]\nradial_N = [0, 3000]\n"
      "[phase]\nname = ['a', 'b']\nfrom_s = [0, 0.05]\nto_s = [0.05, 0.1]\n");
  EXPECT_THAT(other.phase.name, ElementsAre("a", "b"));
  EXPECT_THAT(other.phase.from.values, ElementsAre(0, 0.05));
}

TEST_F(DutyKeys, ReadACsvInItsUnitsAndForgetItsName) {
  const Scene scene =
      scene_of(with_csv("# measured\ntime_ms,radial_kN,inner_rpm\n0,1.5,0\n100,2,3000\n"));
  const DutyTable& table = scene.operation.table;
  EXPECT_TRUE(table.file.empty());
  EXPECT_DOUBLE_EQ(table.time[1], 0.1);
  EXPECT_DOUBLE_EQ(table.radial_load[0], 1500);
  EXPECT_NEAR(table.inner_speed[1], 314.159265, 1e-5);
  EXPECT_TRUE(table.axial_load.empty());
}

TEST_F(DutyKeys, RefuseBadFilesWithTheirLineAndARemedy) {
  const std::string csv = folder_ + "/cycle.csv";
  EXPECT_THAT(problem_of("[duty]\nfile = 'none.csv'\n"),
              AllOf(HasSubstr("scene.toml:2: duty.file"), HasSubstr("no such file")));
  EXPECT_THAT(problem_of(with_csv("")), HasSubstr("the file is empty"));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n")), HasSubstr("holds no measurements"));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n0,1\n2,2\n1,3\n")),
              AllOf(HasSubstr(csv + ":4: duty.time_s = 1"), HasSubstr("increase")));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n0,nan\n")),
              AllOf(HasSubstr(csv + ":2: column 2 (inner_rpm) = 'nan'"), HasSubstr("finite")));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n0,fast\n")), HasSubstr("fast"));
  EXPECT_THAT(problem_of(with_csv("time_s,radial_N\n0,-1\n")), HasSubstr("at least 0 N"));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n0,1e-320\n")), HasSubstr("outside the range"));
  EXPECT_THAT(problem_of(with_csv("time_s,iner_rpm\n0,1\n")),
              AllOf(HasSubstr(":1: "), HasSubstr("did you mean inner_rpm")));
  EXPECT_THAT(problem_of(with_csv("time_s,inner\n0,1\n")), HasSubstr("write inner_rpm"));
  for (const char* heading : {"radial_lbf", "radial [lbf]", "radial_rpm"})
    EXPECT_THAT(problem_of(with_csv("time_s," + std::string(heading) + "\n0,1\n")),
                AllOf(HasSubstr("ends in no unit of a force"), HasSubstr("write radial_N")));
  EXPECT_THAT(problem_of(with_csv("time_min,inner_rpm\n0,1\n")), HasSubstr("write time_s"));
  EXPECT_THAT(problem_of(with_csv("0,1\n1,2\n")),
              HasSubstr("duty.file = 0: the first line must name the columns"));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n0,1\n0,2\n")),
              HasSubstr("a step needs two different times"));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n0,1\n1,\n")),
              HasSubstr("cycle.csv:3: column 2 (inner_rpm): the field is empty"));
  EXPECT_THAT(problem_of(with_csv("inner_rpm\n1\n")), HasSubstr("no column tells the time"));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n0\n")), HasSubstr("1 fields"));
  EXPECT_THAT(problem_of(with_csv("time_s,inner_rpm\n0,1\n") + "time_s = [0]\n"),
              HasSubstr("duty.time_s beside a file"));
}

TEST_F(DutyKeys, RefuseBadTables) {
  const auto duty = [&](const std::string& rest) { return problem_of("[duty]\n" + rest); };
  EXPECT_THAT(duty("time_s = [0, 1, 1]\nradial_N = [1, 2, 3]\n"),
              AllOf(HasSubstr("scene.toml:2: duty.time_s"), HasSubstr("instant 3")));
  EXPECT_THAT(duty("time_s = [0, 1]\nradial_N = [1, 2, 3]\n"),
              HasSubstr("3 values for 2 instants"));
  EXPECT_THAT(duty("radial_N = [1]\n"), HasSubstr("1 values for 0 instants"));
  EXPECT_THAT(duty("time_s = [0, 1]\n"), HasSubstr("nothing is given at these instants"));
  EXPECT_THAT(duty("time_s = [0, nan]\nradial_N = [1, 2]\n"), HasSubstr("not a finite number"));
  EXPECT_THAT(duty("time_s = 0\n"), HasSubstr("an array of numbers in s"));
  EXPECT_THAT(duty("time_s = [0, 1]\nradial_N = [1, 2]\nrepeat_s = 0.5\n"),
              HasSubstr("shorter than the duty"));
  EXPECT_THAT(duty("time_s = [0, 1]\nradial_N = [1, 2]\nrepeat_s = 1\n"),
              AllOf(HasSubstr("duty.radial_N"), HasSubstr("jump")));
  const std::string turning = "time_s = [0, 1, 2, 3]\ndirection_deg = [0, 120, 240, 360]\n";
  EXPECT_EQ(duty(turning + "repeat_s = 3\n"), "no problem");  // a whole turn is no jump
  EXPECT_THAT(duty("repeat_s = 1\n"), HasSubstr("no duty to repeat"));
  EXPECT_THAT(duty("time_s = [0, 1]\nmoment_y_N_m = [1, 2]\n"), HasSubstr("model.ring_tilt"));
  EXPECT_THAT(duty("time_s = [0, 1]\naxial_N = [0, 200]\n"),
              AllOf(HasSubstr("duty.axial_N"), HasSubstr("flange of the inner ring")));
  EXPECT_THAT(problem_of("[speed]\nramp_from_rpm = 0\nramp_ms = 5\n[duty]\ntime_s = [0, 1]\n"
                         "inner_rpm = [0, 1]\n"),
              HasSubstr("speed.ramp_from_rpm"));
  EXPECT_THAT(problem_of("[window]\npeak_revolutions = 2\n[duty]\ntime_s = [0, 1]\n"
                         "inner_rpm = [0, 1]\n"),
              HasSubstr("no cage revolution stands for another"));
}

TEST_F(DutyKeys, NoteDirectionsThatGoTheLongWayRound) {
  const auto doubts = [&](const std::string& directions) {
    return scene_doubts(
        scene_of("[duty]\ntime_s = [0, 1, 2]\ndirection_deg = " + directions + "\nrepeat_s = 3\n"));
  };
  EXPECT_THAT(doubts("[0, 120, 180]"), testing::IsEmpty());
  EXPECT_THAT(doubts("[0, 120, 240]"),
              testing::ElementsAre(HasSubstr("from 240 to 0, more than half a turn: for the short "
                                             "way write 360")));
  EXPECT_THAT(doubts("[350, 10, 200]"), testing::SizeIs(2));
}

TEST_F(DutyKeys, RefuseBadPhases) {
  const std::string duty = "[duty]\ntime_s = [0, 1]\nradial_N = [1, 2]\n";
  const auto phase = [&](const std::string& rest) { return problem_of(duty + rest); };
  EXPECT_THAT(problem_of("[[phase]]\nname = 'a'\nfrom_s = 0\nto_s = 1\n"),
              HasSubstr("do not change over time"));
  EXPECT_THAT(phase("[[phase]]\nname = 'a'\nto_s = 1\n"), HasSubstr("a beginning and an end"));
  EXPECT_THAT(phase("[[phase]]\nname = 'a'\nfrom_s = 0\nto_s = 1\nend = 3\n"),
              HasSubstr("phase.end"));
  EXPECT_THAT(phase("[[phase]]\nname = 'a b'\nfrom_s = 0\nto_s = 1\n"),
              HasSubstr("letters, digits"));
  EXPECT_THAT(phase("[[phase]]\nname = 'a'\nfrom_s = 1\nto_s = 1\n"),
              HasSubstr("ends before it begins"));
  EXPECT_THAT(phase("[phase]\nname = ['a', 'a']\nfrom_s = [0, 0]\nto_s = [1, 1]\n"),
              HasSubstr("two phases are called a"));
  EXPECT_THAT(phase("[phase]\nname = ['a', 'b']\nfrom_s = [0]\nto_s = [1, 1]\n"),
              HasSubstr("1 values for 2 phases"));
  EXPECT_THAT(phase("[[phase]]\nname = 'a'\nfrom_s = 0\nto_s = 1\n[window]\nsettle_time_s = 0\n"
                    "measure_time_s = 0.5\n"),
              HasSubstr("ends after the run, 0.5 s"));
  // Left out, the settling ends where the first phase begins.
  EXPECT_THAT(
      phase("[[phase]]\nname = 'a'\nfrom_s = 0.2\nto_s = 1\n[window]\nmeasure_time_s = 0.5\n"),
      HasSubstr("ends after the run, 0.7 s"));
}

}  // namespace
}  // namespace cagetol
