#include "mc/study/rig_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "src/input/input_error.hpp"
#include "tests/support/process.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::vector<RigMeasurement> rig_rows(const std::string& text, bool decimal_comma = false) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "rig.csv") << text;
  return read_rig_csv(scratch / "rig.csv", decimal_comma);
}

std::string rig_problem(const std::string& text) {
  try {
    rig_rows(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RigCsv, ReadsSpeedsOrOrdersOfTheCage) {
  const auto speeds =
      rig_rows("# NU 206\nspeed_rpm;cage_rpm;radial_N\n1000;400;0\n\n500;195;330\n");
  ASSERT_EQ(speeds.size(), 2U);
  EXPECT_EQ(speeds[1].line, 5);
  EXPECT_DOUBLE_EQ(speeds[1].radial_load, 330);
  EXPECT_DOUBLE_EQ(speeds[1].speed, 500);
  EXPECT_DOUBLE_EQ(speeds[1].cage_order, 0.39);
  const auto orders = rig_rows("radial [kN];speed_rpm;cage_order\n1,5;6000;0,4\n", true);
  EXPECT_DOUBLE_EQ(orders.at(0).radial_load, 1500);
  EXPECT_DOUBLE_EQ(orders.at(0).cage_order, 0.4);
}

TEST(RigCsv, ErrorsNameFileLineAndColumn) {
  const std::string head = "radial_N,speed_rpm,cage_rpm\n";
  EXPECT_THAT(rig_problem(head + "1,2000,800\n1,2000,x\n"),
              HasSubstr("rig.csv:3: column 3 (cage_rpm) = 'x'"));
  EXPECT_THAT(rig_problem(head + "1,2000,800\n-5,2000,800\n"),
              HasSubstr("rig.csv:3: radial_N = -5: a load below 0"));
  EXPECT_THAT(rig_problem(head + "1,0,0\n"), HasSubstr("rig.csv:2: speed_rpm = 0: the inner ring"));
  EXPECT_THAT(rig_problem(head + "1,2000,-800\n"),
              HasSubstr("cage order = -0.4: the cage turns backwards"));
  EXPECT_THAT(rig_problem(head + "# a comment\n1,2000,2100\n"),
              AllOf(HasSubstr("rig.csv:3: cage order = 1.05: the cage turns backwards, or faster"),
                    HasSubstr("remedy: ")));
  EXPECT_THAT(rig_problem("radial_N,cage_rpm\n1,2\n"),
              HasSubstr("rig.csv:1: there is no column 'speed'"));
  EXPECT_THAT(rig_problem("radial_N,speed_rpm,cage_rpn\n1,2,1\n"),
              AllOf(HasSubstr("rig.csv:1: cage_rpn: a rig's file has no such column"),
                    HasSubstr("did you mean cage_rpm?")));
  EXPECT_THAT(rig_problem("radial_N,speed_rpm\n1,2\n"),
              HasSubstr("rig.csv:1: cage_rpm, cage_order: none is given"));
  EXPECT_THAT(rig_problem("radial_N,speed_rpm,cage_rpm,cage_order\n1,2,1,0.5\n"),
              HasSubstr("cage_rpm, cage_order: both are given"));
  EXPECT_THAT(rig_problem(""), HasSubstr("no header line"));
}

}  // namespace
}  // namespace cagetol
