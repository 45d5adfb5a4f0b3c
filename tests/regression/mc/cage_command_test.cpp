// `cagetol cage`: the drawing of a pocket, and what it says of rigid and flexible cages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What `cagetol cage` prints; it must succeed.
std::string printed_by_cage(const std::string& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {std::string(CAGETOL_BINARY_DIR) + "/cagetol", "cage",
                                       shipped("scenes/nu205.toml")});
  Process process(arguments, [&] { ::setenv("CAGETOL_CACHE", (folder + "/cache").c_str(), 1); });
  EXPECT_EQ(process.wait(), 0) << process.output();
  return process.output();
}

std::string whole_file(const std::string& name) {
  std::ifstream file(name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Letters are drawn as curves; their text stands beside them in comments.
TEST(CageCommand, DrawsAPocketWithItsClearances) {
  const ScratchDirectory scratch;
  const std::string text = printed_by_cage(scratch.path(), {"-o", scratch / "flat"});
  EXPECT_THAT(text, HasSubstr("no modes: the cage of this scene is rigid"));
  const std::string file = scratch / "flat/figures/pocket.svg", drawing = whole_file(file);
  Process parser({"/usr/bin/python3", "-c",
                  "import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])", file});
  EXPECT_EQ(parser.wait(), 0) << parser.output();
  for (const char* words : {"Pocket 0 of nu205", "0.1500 mm", "0.2500 mm", "0.0800 mm",
                            "radial, cage to outer ring, which guides it", "0.2000 mm"})
    EXPECT_THAT(drawing, HasSubstr(std::string("<!-- ") + words));
  EXPECT_THAT(drawing, Not(HasSubstr("<!-- radial play")));

  printed_by_cage(scratch.path(),
                  {"-o", scratch / "lips", "--set", "cage.retention_width_outer_mm=7.1", "--set",
                   "cage.pocket_width_mm=7.7"});
  const std::string other = whole_file(scratch / "lips/figures/pocket.svg");
  EXPECT_THAT(other, HasSubstr("<!-- 0.2000 mm"));
  EXPECT_THAT(other, Not(HasSubstr("<!-- 0.1500 mm")));
  EXPECT_THAT(other, HasSubstr("<!-- radial play of the roller towards the outside"));
}

TEST(CageCommand, ShowsClearancesInOperation) {
  const ScratchDirectory scratch;
  const std::string cold = printed_by_cage(scratch.path(), {}),
                    warm = printed_by_cage(scratch.path(), {"--set", "temperature.growth=true",
                                                            "--set", "cage.temperature_C=220"});
  EXPECT_THAT(cold, Not(HasSubstr("in operation")));
  EXPECT_THAT(warm, HasSubstr("scene nu205 in operation (fits, heat, moisture, rotation)"));
  // 7.65 mm * 12e-6/K * 200 K less 7.5 mm * 12e-6/K * 50 K
  EXPECT_THAT(warm, HasSubstr(" 0.1639"));
}

TEST(CageCommand, SaysWhatAForceOnABarOfAFlexibleCageDoes) {
  const ScratchDirectory scratch;
  const std::string printed = printed_by_cage(
      scratch.path(), {"--json", "--set", "cage.model=flexible", "--set", "cage.mesh_density=1",
                       "--set", "cage.corner_radius_mm=0", "--pocket", "3"});
  const auto json = nlohmann::json::parse(printed.substr(printed.find('{')));
  EXPECT_EQ(json["drawing"]["pocket"], 3);
  ASSERT_EQ(json["bar_loads"].size(), 3U);
  for (const auto& load : json["bar_loads"])
    for (const char* number : {"kept_compliance_um_N", "other_compliance_um_N", "stress_MPa_N"})
      EXPECT_GT(load[number].get<double>(), 0) << number;
  EXPECT_GT(json["seconds_table"].get<double>(), 0);
}

}  // namespace
}  // namespace cagetol
