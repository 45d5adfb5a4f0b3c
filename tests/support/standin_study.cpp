#include "tests/support/standin_study.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "mc/host/build_info.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

constexpr long kPockets = 5;

/// A number in [0,1) for (id, draw): the finaliser of SplitMix64.
double uniform(std::uint64_t id, std::uint64_t draw) {
  std::uint64_t z = (id + 1) * 0x9e3779b97f4a7c15u + (draw + 1) * 0xd1b54a32d192ed03u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

Study make_study(const StandinOptions& options) {
  Study study;
  study.name = "stand-in";
  study.samples = options.samples;
  study.allowed_failure_share = 0.1;
  study.scene.bearing.roller_count = kPockets;
  study.scene.operation.radial_load = options.radial_load;
  study.inputs = {{.key = "cage.pocket_width_mm",
                   .unit = "mm",
                   .nominal = {7.65},
                   .per_pocket = true,
                   .lot = Normal{},
                   .pocket = Normal{},
                   .noise = {}},
                  {.key = "start.cage_phase_deg",
                   .unit = "deg",
                   .nominal = {0},
                   .per_pocket = false,
                   .lot = {},
                   .pocket = {},
                   .noise = Uniform{}}};
  study.resolved_toml =
      fmt::format("name = \"stand-in\"\nsamples = {}\nseed = 1\n[scene.load]\nradial_N = {}\n",
                  options.samples, options.radial_load);
  study.resolved_json =
      R"({"inputs":[{"key":"cage.pocket_width_mm","lot":{"law":"normal","sigma":1}}]})";
  study.files = {{"measured.csv", options.file_hash}};
  study.hash = text_hash(study.resolved_toml + options.file_hash);
  return study;
}

Sample draw(const Study& study, std::uint64_t id) {
  Sample sample;
  sample.id = sample.row = sample.lot = id;
  sample.scene = study.scene;
  DrawnInput width, phase;
  width.lot = {0.01 * (uniform(id, 0) - 0.5)};
  for (std::size_t j = 0; j < kPockets; ++j) {
    width.pocket.push_back(0.02 * (uniform(id, j + 1) - 0.5));
    width.value.push_back(7.65 + width.lot[0] + width.pocket[j]);
  }
  phase.noise = phase.value = {360 * uniform(id, 100)};
  sample.scene.cage.pocket_width = width.value;
  sample.scene.start.cage_phase = phase.value[0];
  sample.inputs = {width, phase};
  return sample;
}

/// Waits as long as a run would take; false when stopped on the way. Sleeping lets ranks share
/// cores without slowing each other.
bool wait_for_run(double milliseconds, const StopRequested& stop) {
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(milliseconds);
  while (std::chrono::steady_clock::now() < end) {
    if (stop()) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

Outcome run(const StandinOptions& options, const Sample& sample, const StopRequested& stop) {
  const auto is = [&](const std::optional<long>& id) {
    return id && static_cast<std::uint64_t>(*id) == sample.id;
  };
  Outcome outcome;
  const double u = uniform(sample.id, 200);
  if (!wait_for_run(options.mean_ms * (0.1 - std::log(1 - 0.98 * u)), stop)) return outcome;
  if (is(options.abort_id)) std::abort();
  if (is(options.exit_id)) std::_Exit(9);
  if (is(options.kill_id)) std::raise(SIGKILL);
  if (is(options.throw_id)) throw std::runtime_error("the stand-in throws");
  if (is(options.late_id)) return outcome;

  const double kind = uniform(sample.id, 201);
  outcome.run.steps = std::floor(1000 * u);
  if (kind < options.failure_share) {
    outcome.status = Status::failed;
    outcome.reason = "static consistency error 0.7 exceeds 0.02";
  } else if (kind > 0.8) {
    outcome.status = Status::jammed;
    outcome.reason = "roller 2 is 3 um too large for its pocket";
    outcome.pocket = 2;
    outcome.interference_um = 3 * u;
    return outcome;
  } else {
    outcome.status = Status::ok;
  }
  for (std::size_t i = 0; i < quantity_table().size(); ++i)
    outcome.quantities.push_back(std::sin(static_cast<double>(i) + sample.scene.start.cage_phase) *
                                 sample.scene.operation.radial_load /
                                 sample.scene.cage.pocket_width[i % kPockets]);
  return outcome;
}

}  // namespace

SweepPlan make_standin_plan(const StandinOptions& options) {
  SweepPlan plan;
  plan.study = make_study(options);
  plan.rows = plan.samples = static_cast<std::uint64_t>(options.samples);
  plan.draw = [study = plan.study](std::uint64_t id) { return draw(study, id); };
  plan.job = [options](const Sample& sample, const StopRequested& stop) {
    return run(options, sample, stop);
  };
  return plan;
}

}  // namespace cagetol
