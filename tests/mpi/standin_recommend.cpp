// `cagetol recommend` (`screen`, `map`) with a formula in place of the physics: the cage slips by how far its widest
// pocket exceeds the nominal 7.65 mm, and by 0.01 more for each slice of a contact below five. A
// share of the runs may be lost. With --value every other quantity has that value.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <thread>

#include "mc/commands/map_stages.hpp"
#include "mc/commands/rare_stages.hpp"
#include "mc/commands/recommend_stages.hpp"
#include "mc/commands/screen_stages.hpp"
#include "mc/host/log.hpp"
#include "src/input/unit.hpp"
#include "src/quantities/quantity_table.hpp"

namespace {

/// The study starts cages at 0 to 1 degrees, uniformly.
bool is_lost(const cagetol::Sample& sample, double share) {
  return sample.scene.start.cage_phase < share * std::numbers::pi / 180;
}

cagetol::Outcome run(const cagetol::Sample& sample, double milliseconds, double lost_share,
                     std::optional<double> value, const cagetol::StopRequested& stop) {
  using clock = std::chrono::steady_clock;
  const auto end = clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  cagetol::Outcome outcome;
  while (clock::now() < end) {
    if (stop()) return outcome;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  // In a map slip follows the speed, and the fastest bearing has no result.
  const double speed = sample.scene.operation.inner_speed / cagetol::kRpm;
  if (is_lost(sample, lost_share) || speed > 20000) {
    outcome.status = cagetol::Status::failed;
    outcome.reason = "lost";
    return outcome;
  }
  const auto& widths = sample.scene.cage.pocket_width;
  outcome.status = cagetol::Status::ok;
  outcome.quantities.assign(cagetol::quantity_table().size(),
                            value.value_or(sample.scene.start.cage_phase));
  outcome.quantities[static_cast<std::size_t>(cagetol::quantity_index("cage_slip_ratio"))] =
      1e3 * *std::max_element(widths.begin(), widths.end()) - 7.65 +
      0.01 * static_cast<double>(5 - sample.scene.discretisation.race_slices) +
      (cagetol::is_quasi_static(sample.scene) ? 0.01 : 0);
  outcome.quantities[static_cast<std::size_t>(cagetol::quantity_index("cage_slip_ratio"))] *=
      std::round(speed) / 6000;
  return outcome;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace cagetol;
  std::string study;
  std::vector<std::string> settings;
  RecommendOptions options;
  double milliseconds = 0.5, lost_share = 0;
  std::optional<double> value;
  bool screen = false, rare = false;
  std::vector<std::string> over;
  CLI::App app{"recommendation of a stand-in study"};
  app.add_option("study", study)->required();
  app.add_option("directory", options.directory)->required();
  app.add_option("--set", settings)->allow_extra_args(false);
  app.add_option("--ms", milliseconds);
  app.add_flag("--exit-code", options.exit_code);
  app.add_option("--lost", lost_share, "share of the runs that fail");
  app.add_option("--value", value, "of all quantities but the cage's slip");
  app.add_flag("--screen", screen, "the screen alone");
  app.add_option("--over", over, "a map over two keys")->allow_extra_args(false);
  app.add_flag("--rare", rare, "rare failures alone");
  CLI11_PARSE(app, argc, argv);
  log_to_stderr();
  const auto make_plan = [&](const Study& stage) {
    SweepPlan plan = make_sweep_plan(stage);
    plan.prepare = {};  // no cage is solved
    plan.job = [=](const Sample& sample, const StopRequested& stop) {
      return run(sample, milliseconds, lost_share, value, stop);
    };
    return plan;
  };
  if (screen)
    return run_screen([&] { return read_study(study, settings); }, make_plan, options.directory,
                      options.progress);
  if (!over.empty())
    return run_map([&] { return read_study(study, settings); }, make_plan,
                   {options.directory, over, false, options.progress});
  if (rare)
    return run_rare([&] { return read_study(study, settings); }, make_plan, options.directory,
                    options.progress);
  return run_recommend([&] { return read_study(study, settings); }, make_plan, options);
}
