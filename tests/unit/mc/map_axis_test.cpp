// The axes of a map as they are written, and the study of one of its cells.
#include "mc/study/map_axis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mc/study/operating_points.hpp"
#include "src/input/input_error.hpp"
#include "src/input/unit.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MapAxes : public testing::Test {
 protected:
  static Study read(std::vector<std::string> settings = {}) {
    for (const char* given : {"scene.temperature.balance=false", "scene.cage.model=rigid"})
      settings.emplace_back(given);
    return read_study(shipped("studies/nu205-duty.toml"), settings);
  }
  static std::string problem(const std::string& axis, std::vector<std::string> settings = {}) {
    try {
      read_map_axis(axis, read(std::move(settings)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(MapAxes, AreSpacedEvenlyOrInEqualRatiosOrGiven) {
  const Study study = read();
  const MapAxis even = read_map_axis("speed.inner_rpm=1000..14000:6", study);
  EXPECT_EQ(even.key, "speed.inner_rpm");
  EXPECT_FALSE(even.logarithmic);
  EXPECT_THAT(even.values, ElementsAre(1000, 3600, 6200, 8800, 11400, 14000));
  const MapAxis ratio = read_map_axis("scene.load.radial_N=100..10000:6:log", study);
  EXPECT_EQ(ratio.key, "load.radial_N");
  EXPECT_TRUE(ratio.logarithmic);
  EXPECT_THAT(ratio.values, ElementsAre(100, 251.2, 631, 1585, 3981, 10000));
  EXPECT_THAT(read_map_axis("load.radial_N=123.456..234.567:2", study).values,
              ElementsAre(123.456, 234.567));
  EXPECT_TRUE(read_map_axis("load.radial_N=100,500,2000", study).logarithmic);
  EXPECT_FALSE(read_map_axis("load.radial_N=100,500,900", study).logarithmic);
  EXPECT_THAT(read_map_axis("lubrication.temperature_C=-20,40.5,90", study).values,
              ElementsAre(-20, 40.5, 90));
}

TEST_F(MapAxes, RefuseWhatIsNoneWithTheFormToWrite) {
  for (const char* form :
       {"load.radial_N", "load.radial_N=", "load.radial_N=100", "load.radial_N=1..2",
        "load.radial_N=1..2:x", "load.radial_N=1..2:1", "load.radial_N=1..2:3:lin",
        "load.radial_N=1,,2", "load.radial_N=1..2:3:log:log", "load.radial_N=1..nine:3"})
    EXPECT_THAT(problem(form), HasSubstr("--over load.radial_N=100..10000:6:log")) << form;
  EXPECT_THAT(problem("load.radial_N=2..1:3"), HasSubstr("the values do not ascend"));
  EXPECT_THAT(problem("load.radial_N=1,1"), HasSubstr("the values do not ascend"));
  EXPECT_THAT(problem("load.radial_N=0..1:3:log"), HasSubstr("logarithms are of numbers above 0"));
  EXPECT_THAT(problem("load.radial_N=1..2000:900"), HasSubstr("more than 40 values"));
}

TEST_F(MapAxes, RefuseKeysThatAnOperatingPointCannotSet) {
  EXPECT_THAT(problem("load.radial=1,2"), HasSubstr("load.radial_N"));
  EXPECT_THAT(problem("cage.pocket_width_mm=7,8"), HasSubstr("nothing that the bearing is"));
  EXPECT_THAT(problem("minimum_loads=1,2"), HasSubstr("does not hold one number"));
  EXPECT_THAT(problem("lubrication.temperature_C=-400,20"), HasSubstr("lubrication.temperature_C"));
  EXPECT_THAT(problem("start.cage_phase_deg=0,20"), HasSubstr("this key varies in the study"));
}

TEST_F(MapAxes, ACellHasItsValuesAtEveryPointAndPointsThatAreTheSameAreOne) {
  const Study study =
      read({"operating_point=[{name='rated'}, {name='idle', 'load.radial_N'=250}, "
            "{name='cold', 'load.radial_N'=250, 'lubrication.temperature_C'=20}]",
            "limit=[{quantity='driving_slip_ratio', max=0.1, source='all'}, "
            "{quantity='friction_torque_Nmm@idle', max=90, source='one'}]"});
  const std::vector<MapAxis> axes = {read_map_axis("load.radial_N=100,300", study),
                                     read_map_axis("speed.inner_rpm=2000,3000", study)};
  const Study cell = study_at(study, axes, {300, 2000});
  ASSERT_EQ(cell.points.size(), 2U);
  EXPECT_EQ(cell.points[0].name, "rated");
  EXPECT_EQ(cell.points[1].name, "cold");
  for (const OperatingPointPlan& point : cell.points) {
    const Scene scene = at_operating_point(cell.scene, point);
    EXPECT_DOUBLE_EQ(scene.operation.radial_load, 300);
    EXPECT_DOUBLE_EQ(scene.operation.inner_speed, 2000 * kRpm);
  }
  std::vector<std::string> limited;
  for (const Limit& limit : cell.limits) limited.push_back(limit.quantity);
  EXPECT_THAT(limited, ElementsAre("driving_slip_ratio@rated", "driving_slip_ratio@cold",
                                   "friction_torque_Nmm@rated"));
}

TEST_F(MapAxes, OnePointAloneIsTheScenesOwn) {
  const Study study =
      read({"operating_point=[{name='rated'}, {name='idle', 'load.radial_N'=250, "
            "'window.measure_revolutions'=9}]",
            "scene.window.measure_revolutions=9",
            "limit=[{quantity='driving_slip_ratio', max=0.1, source='all'}]"});
  const std::vector<MapAxis> axes = {read_map_axis("load.radial_N=100,300", study)};
  EXPECT_EQ(study_at(study, axes, {300}).points.size(), 2U);  // one says what the scene says
  const Study same =
      read({"operating_point=[{name='low', 'load.radial_N'=90}, {name='idle', "
            "'load.radial_N'=250}]",
            "limit=[{quantity='driving_slip_ratio', max=0.1, source='all'}]"});
  const Study cell = study_at(same, axes, {300});
  EXPECT_TRUE(cell.points.empty());
  EXPECT_DOUBLE_EQ(cell.scene.operation.radial_load, 300);
  ASSERT_EQ(cell.limits.size(), 1U);
  EXPECT_EQ(cell.limits[0].quantity, "driving_slip_ratio");
}

TEST_F(MapAxes, ACellFindsItsOwnLimitsByTheMakersMinimumLoad) {
  const Study study = read({"operating_point=[]", "scene.window.settle_revolutions=0.3",
                            "scene.window.measure_revolutions=0.3",
                            "limit=[{quantity='driving_slip_ratio', max_at_minimum_loads=1, "
                            "source='maker'}]"});
  const std::vector<MapAxis> axes = {read_map_axis("speed.inner_rpm=4000,12000", study)};
  const double slow = *study_at(study, axes, {4000}).limits[0].maximum,
               own = *study.limits[0].maximum,
               fast = *study_at(study, axes, {12000}).limits[0].maximum;
  EXPECT_LT(own, fast);
  EXPECT_NE(own, slow);
}

}  // namespace
}  // namespace cagetol
