// Heat that a bearing sheds, and the temperature at which it sheds what it loses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "src/heat_balance.hpp"
#include "src/input/input_error.hpp"
#include "src/input/toml_file.hpp"
#include "src/operation/heat_shed.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_input.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

Scene balanced_scene(double ambient = 20) {
  Scene scene = shipped_scene("nu205");
  scene.cage.model = CageKind::rigid;
  scene.window.settle_revolutions = 1;
  scene.window.measure_revolutions = 2;
  scene.temperature.balance = true;
  scene.temperature.ambient = ambient;
  return scene;
}

double value_of(const Outcome& outcome, const char* key) {
  return outcome.quantities[static_cast<std::size_t>(quantity_index(key))];
}

TEST(HeatShed, IsThatOfTheStandard) {
  const HeatShed shed = heat_shed(shipped_scene("nu205"));  // 25 x 52 x 15 mm
  EXPECT_NEAR(shed.slope, 1.161, 0.001);
  EXPECT_NEAR(shed.at(70), 58.1, 0.05);
  EXPECT_EQ(shed.at(20), 0);
  Scene large = shipped_scene("nu205");
  large.bearing.bore_diameter = 0.2, large.bearing.outside_diameter = 0.4;
  large.bearing.width = 0.1;
  const double area = std::acos(-1.0) * 0.1 * 0.6;  // 188,496 mm2
  EXPECT_NEAR(heat_shed(large).slope, 0.016e6 * std::pow(area / 0.05, -0.34) * area / 50, 1e-9);
}

TEST(HeatShed, OilTakesHeatAlong) {
  Scene scene = shipped_scene("nu205");
  scene.temperature.conductance = 2;
  scene.temperature.oil_flow = 1e-3 / 60;  // a litre a minute
  scene.temperature.oil_inlet = 40;
  const double carried = 870 * 2000 / 60e3;  // 29 W/K
  const HeatShed shed = heat_shed(scene);
  EXPECT_NEAR(shed.at(60), 2 * (60 - 20) + carried * (60 - 40), 1e-9);
}

TEST(HeatBalance, ShedsWhatItLoses) {
  double before = 0;
  for (const double ambient : {0.0, 40.0}) {
    const Scene found = with_temperature_found(balanced_scene(ambient));
    const Temperatures& t = found.temperature;
    EXPECT_EQ(found.lubrication.temperature, t.found);
    EXPECT_NEAR(heat_shed(found).at(t.found), t.found_power, 0.02 * t.found_power);
    EXPECT_GT(t.found_slope, heat_shed(found).slope);  // losses fall with temperature
    EXPECT_GT(t.found, before + 10);
    before = t.found;
    const Outcome run = simulate(found);
    ASSERT_EQ(run.status, Status::ok) << run.reason;
    EXPECT_NEAR(value_of(run, "power_loss_W"), t.found_power, 0.02 * t.found_power);
    EXPECT_NEAR(value_of(run, "operating_temperature_C"), t.found, 1);
    EXPECT_NEAR(value_of(run, "heat_shed_W"), value_of(run, "power_loss_W"), 0.02 * t.found_power);
  }
}

TEST(HeatBalance, FindsTheSameWhereverItBegins) {
  const Temperatures cold = with_temperature_found(balanced_scene(), 40).temperature;
  const Temperatures hot = with_temperature_found(balanced_scene(), 100).temperature;
  // Both agree with what is shed within 2 % of the power.
  EXPECT_NEAR(cold.found, hot.found, 2 * 0.02 * cold.found_power / cold.found_slope);
  EXPECT_NEAR(cold.found_power, hot.found_power, 2 * 0.02 * cold.found_power);
  EXPECT_NE(std::pair(cold.found, cold.found_slope), std::pair(hot.found, hot.found_slope));
}

TEST(HeatBalance, WarmsTheRingsWhereTheyGrow) {
  Scene scene = balanced_scene();
  scene.temperature.growth = true;
  scene.temperature.inner_above = 8;
  const Scene found = with_temperature_found(scene);
  EXPECT_EQ(found.temperature.outer_ring, found.temperature.found);
  EXPECT_EQ(found.temperature.inner_ring, found.temperature.found + 8);
}

TEST(HeatBalance, LeavesGivenTemperaturesAlone) {
  Scene scene = balanced_scene();
  scene.temperature.balance = false;
  EXPECT_EQ(with_temperature_found(scene).lubrication.temperature, 70);
  EXPECT_TRUE(std::isnan(value_of(simulate(scene), "operating_temperature_C")));
}

TEST(HeatBalance, APowerThatIsNotShedIsNamed) {
  Scene scene = balanced_scene();
  scene.temperature.balance = false;  // 70 degC given, 58 W shed
  EXPECT_EQ(temperature_doubt(scene, 60), "");
  EXPECT_EQ(temperature_doubt(scene, std::nan("")), "");
  EXPECT_THAT(temperature_doubt(scene, 80),
              testing::HasSubstr("at 70 degC the bearing loses 80 W and sheds 58.1 W"));
  scene.temperature.balance = true;
  EXPECT_EQ(temperature_doubt(scene, 80), "");
}

TEST(HeatBalance, RefusesABearingThatCannotShedItsPower) {
  Scene scene = balanced_scene();
  scene.temperature.conductance = 0.01;
  try {
    with_temperature_found(scene);
    FAIL();
  } catch (const InputError& refused) {
    EXPECT_THAT(refused.what(), testing::AllOf(testing::HasSubstr("would have to be at"),
                                               testing::HasSubstr("temperature.oil_flow_l_min")));
  }
  EXPECT_THROW(simulate(scene), std::logic_error);
}

TEST(HeatBalance, RefusesATemperatureThatIsGivenBesideIt) {
  const std::string path = shipped("scenes/nu205.toml");
  std::ifstream file(path);
  std::string text(std::istreambuf_iterator<char>(file), {});
  text += "\n[temperature]\nbalance = true\n";
  std::string scattered = text;
  const std::string given = "temperature_C = 70";
  scattered.replace(scattered.find(given), given.size(),
                    "temperature_C = { nominal = 70, lot = { law = 'normal', sigma = 5 } }");
  for (const std::string& each : {text, scattered}) try {
      read_scene(parse_toml(each, "scene.toml"), "scene.toml");
      FAIL();
    } catch (const InputError& refused) {
      EXPECT_THAT(refused.what(), testing::HasSubstr("lubrication.temperature_C"));
    }
}

}  // namespace
}  // namespace cagetol
