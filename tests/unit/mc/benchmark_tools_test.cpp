// What the charts of methods rest on: replicas by address, trajectories, and the judgement of the
// stability suite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mc/benchmark/chart.hpp"
#include "mc/benchmark/replicas.hpp"
#include "mc/benchmark/stability.hpp"
#include "mc/benchmark/trajectory.hpp"
#include "src/input/input_error.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

std::string scene_file() {
  return shipped("scenes/speed-z16.toml");
}

TEST(Replicas, AreAddressedAndDoNotDependOnThreads) {
  const Study study =
      read_study(scene_file(), {"window.settle_time_s = 0.0002", "window.measure_time_s = 0.0002"});
  const auto few = replica_scenes(study, 2), more = replica_scenes(study, 4);
  EXPECT_EQ(few[1].start.cage_offset_y, more[1].start.cage_offset_y);
  EXPECT_NE(more[1].start.cage_offset_y, more[2].start.cage_offset_y);
  EXPECT_LT(std::abs(more[1].start.cage_offset_y), 100e-6);
  const auto one = simulate_all(more, 1), three = simulate_all(more, 3);
  for (std::size_t k = 0; k < more.size(); ++k)
    EXPECT_EQ(std::memcmp(one[k].quantities.data(), three[k].quantities.data(),
                          one[k].quantities.size() * sizeof(double)),
              0);
}

TEST(Trajectory, MethodsOfDifferentKindsAgreeAndTighterIsNearer) {
  const Scene scene = shipped_scene("speed-z16");
  const Trajectory reference =
      follow(with_setting(scene, reference_setting(IntegrationMethod::rodasp)), 0.4e-3);
  double last = 10;
  for (double tolerance : {1e-2, 5e-4, 2e-5}) {
    const auto error = trajectory_error(
        follow(with_setting(scene, {IntegrationMethod::rodasp, tolerance}), 0.4e-3), reference);
    EXPECT_LT(error, last);
    last = error;
  }
  EXPECT_LT(last, 0.005);
  EXPECT_TRUE(std::isnan(trajectory_error(Trajectory{}, reference)));
}

TEST(Chart, MarksTheFrontAndSaysWhatIsUnresolved) {
  const Study study =
      read_study(scene_file(), {"window.settle_time_s = 0.003", "window.measure_time_s = 0.001"});
  const Chart chart = make_chart(study,
                                 {.methods = {IntegrationMethod::rodas3},
                                  .horizon = 0.4e-3,
                                  .replicas = 1,
                                  .starts = 2,
                                  .threads = 1},
                                 [](const std::string&) {});
  ASSERT_EQ(chart.points.size(), 6u);  // the scene's own tolerance and five
  EXPECT_EQ(chart.points[0].setting.tolerance, 0.001);
  EXPECT_LT(chart.reference_gap, 1e-2);
  for (const ChartPoint& p : chart.points)
    for (const ChartPoint& q : chart.points)
      if (q.brief.rtf < p.brief.rtf && q.trajectory_error < p.trajectory_error) {
        EXPECT_FALSE(p.brief.on_front);
      }
  EXPECT_THAT(chart_text(chart), HasSubstr("unresolved"));
  const auto json = chart_json(chart);
  EXPECT_TRUE(json["points"][0]["default"].get<bool>());
  EXPECT_FALSE(json["points"][1]["default"].get<bool>());
  EXPECT_EQ(json["points"][1]["trajectory"]["error"], chart.points[1].trajectory_error);
}

TEST(Chart, RungsStandBesideTheSettings) {
  const Study study =
      read_study(shipped("scenes/nu205.toml"),
                 {"window.settle_revolutions=0.1", "window.measure_revolutions=0.1",
                  "cage.mesh_density=1", "cage.corner_radius_mm=0",
                  "watch.energy_residual_max=1000", "watch.static_consistency_max=1000"});
  const Chart chart = make_chart(study,
                                 {.methods = {IntegrationMethod::rodas3},
                                  .horizon = 0.1e-3,
                                  .replicas = 2,
                                  .starts = 1,
                                  .threads = 1,
                                  .rungs = true},
                                 [](const std::string&) {});
  ASSERT_EQ(chart.rungs.size(), climbing_rungs().size());
  const RungPoint &equilibria = chart.rungs.front(), &highest = chart.rungs.back();
  EXPECT_EQ(highest.rung.name, "full");
  // Equilibria define few quantities; where a rung has none, it has no bias either.
  EXPECT_GT(equilibria.quantities, 0);
  EXPECT_LT(equilibria.quantities, highest.quantities);
  EXPECT_LT(equilibria.window.rtf, highest.window.rtf);
  const auto slip = static_cast<std::size_t>(quantity_index("cage_slip_ratio"));
  EXPECT_TRUE(std::isnan(equilibria.biases[slip].bias));
  EXPECT_GT(highest.biases[slip].deviation, 0);
  const auto json = chart_json(chart);
  EXPECT_EQ(json["rungs"][7]["rung"], "full");
  EXPECT_EQ(json["rungs"][7]["window"]["bias_rms"].get<double>(), highest.bias_rms);
  EXPECT_EQ(json["rungs"][7]["window"]["biases"][slip]["quantity"], "cage_slip_ratio");
  EXPECT_THAT(chart_text(chart), HasSubstr("rungs of the model ladder against full"));
}

TEST(Stability, Judgement) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(judge_soundness(Status::ok, 0.05, 0.01), Soundness::right);
  EXPECT_EQ(judge_soundness(Status::ok, 0.5, 0.01), Soundness::degraded);
  EXPECT_EQ(judge_soundness(Status::ok, 5, 0.01), Soundness::wrong);
  EXPECT_EQ(judge_soundness(Status::ok, none, 0.01), Soundness::wrong);
  EXPECT_EQ(judge_soundness(Status::ok, 5, 0.5), Soundness::unresolved);
  EXPECT_EQ(judge_soundness(Status::ok, 0.05, none), Soundness::unresolved);
  EXPECT_EQ(judge_soundness(Status::failed, 0.05, 0.01), Soundness::failed);
  EXPECT_EQ(judge_soundness(Status::jammed, none, none), Soundness::right);
}

TEST(Stability, IsSoundWithTheDefaultRightAndNothingSilentlyWrong) {
  const auto map = [](Soundness default_method, Soundness other) {
    SuiteRow row{"scene", 0, {}};
    row.cells[IntegrationMethod::rodas3].soundness = default_method;
    row.cells[IntegrationMethod::rodasp].soundness = other;
    return StabilityMap{
        IntegrationMethod::rodas3, {IntegrationMethod::rodas3, IntegrationMethod::rodasp}, {row}};
  };
  EXPECT_TRUE(is_sound(map(Soundness::right, Soundness::failed)));
  EXPECT_TRUE(is_sound(map(Soundness::right, Soundness::unresolved)));
  EXPECT_FALSE(is_sound(map(Soundness::right, Soundness::wrong)));
  EXPECT_FALSE(is_sound(map(Soundness::degraded, Soundness::right)));
  EXPECT_FALSE(is_sound(map(Soundness::failed, Soundness::right)));
  StabilityMap without_default = map(Soundness::right, Soundness::degraded);
  without_default.rows[0].cells.erase(IntegrationMethod::rodas3);
  EXPECT_TRUE(is_sound(without_default));
}

TEST(Stability, ABadSuiteSaysWhatIsWrong) {
  const ScratchDirectory scratch;
  const std::string file = scratch / "suite.toml";
  const auto problem = [&](const std::string& text) -> std::string {
    std::ofstream(file) << text;
    try {
      read_suite(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(problem("x = 1\n"), HasSubstr("suite.toml:1: x = 1: no such key"));
  EXPECT_THAT(problem("\n"), HasSubstr("the suite holds no scene"));
  EXPECT_THAT(problem("scene = [1]\n"), HasSubstr("expected a table"));
  EXPECT_THAT(problem("[[scene]]\nfile = 'a.toml'\n"), HasSubstr("no such file"));
  EXPECT_THAT(problem("[[scene]]\nname = 'a'\n"), HasSubstr("scene.file: missing"));
  EXPECT_THAT(problem("[[scene]]\nset = 'a'\n"), HasSubstr("expected an array of texts"));
}

TEST(StabilityText, ColumnsAreAsWideAsTheirText) {
  StabilityMap map{
      IntegrationMethod::rodasp, {IntegrationMethod::rodasp, IntegrationMethod::arkode_erk}, {}};
  const std::string longest = "a scene whose name is longer than that of any other scene";
  for (const std::string& scene : {std::string("short"), longest}) {
    SuiteRow row{scene, 0, {}};
    for (const IntegrationMethod method : map.methods)
      row.cells[method].soundness = Soundness::right;
    map.rows.push_back(row);
  }
  std::istringstream text(stability_text(map));
  std::string heading, line;
  std::getline(text, heading);
  const std::size_t first = heading.find("rodasp"), second = heading.find("arkode-erk");
  EXPECT_EQ(first, longest.size() + 2);
  for (const std::string& scene : {std::string("short"), longest}) {
    std::getline(text, line);
    EXPECT_EQ(line.find(scene), 0u);
    EXPECT_EQ(line.find("right"), first);
    EXPECT_EQ(line.find("right", first + 1), second);
  }
}

}  // namespace
}  // namespace cagetol
