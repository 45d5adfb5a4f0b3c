// `cagetol recommend` with a formula in place of the physics: the cage slips by how far its widest
// pocket exceeds the nominal 7.65 mm, and by 0.01 more for each slice of a contact below five.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

#include "mc/commands/recommend_stages.hpp"
#include "mc/log.hpp"
#include "src/quantities/quantity_table.hpp"

namespace {

cagetol::Outcome run(const cagetol::Sample& sample, double milliseconds,
                     const cagetol::StopRequested& stop) {
  using clock = std::chrono::steady_clock;
  const auto end = clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  cagetol::Outcome outcome;
  while (clock::now() < end) {
    if (stop()) return outcome;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  const auto& widths = sample.scene.cage.pocket_width;
  outcome.status = cagetol::Status::ok;
  outcome.quantities.assign(cagetol::quantity_table().size(), sample.scene.start.cage_phase);
  outcome.quantities[static_cast<std::size_t>(cagetol::quantity_index("cage_slip_ratio"))] =
      1e3 * *std::max_element(widths.begin(), widths.end()) - 7.65 +
      0.01 * static_cast<double>(5 - sample.scene.discretisation.race_slices) +
      (cagetol::is_quasi_static(sample.scene) ? 0.01 : 0);
  return outcome;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace cagetol;
  std::string study;
  std::vector<std::string> settings;
  RecommendOptions options;
  double milliseconds = 0.5;
  CLI::App app{"recommendation of a stand-in study"};
  app.add_option("study", study)->required();
  app.add_option("directory", options.directory)->required();
  app.add_option("--set", settings)->allow_extra_args(false);
  app.add_option("--ms", milliseconds);
  CLI11_PARSE(app, argc, argv);
  log_to_stderr();
  const auto make_plan = [milliseconds](const Study& stage) {
    SweepPlan plan = make_sweep_plan(stage);
    plan.job = [milliseconds](const Sample& sample, const StopRequested& stop) {
      return SampleRun{run(sample, milliseconds, stop), {}};
    };
    return plan;
  };
  return run_recommend([&] { return read_study(study, settings); }, make_plan, options);
}
