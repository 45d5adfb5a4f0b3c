// `cagetol sweep` with a formula in place of the physics. The tests of this directory start it,
// alone and under mpirun.
#include <CLI/CLI.hpp>

#include <cstdio>

#include "mc/host/log.hpp"
#include "mc/host/process_limits.hpp"
#include "mc/sweep/sweep.hpp"
#include "src/input/input_error.hpp"
#include "tests/support/standin_study.hpp"

int main(int argc, char** argv) {
  cagetol::StandinOptions standin;
  cagetol::SweepOptions sweep;
  bool bad_study = false, fault = false;
  CLI::App app{"sweep of a stand-in study"};
  app.add_option("directory", sweep.directory)->required();
  app.add_option("--samples", standin.samples);
  app.add_option("--load", standin.radial_load);
  app.add_option("--file-hash", standin.file_hash);
  app.add_option("--mean-ms", standin.mean_ms);
  app.add_option("--failure-share", standin.failure_share);
  app.add_option("--abort-id", standin.abort_id);
  app.add_option("--exit-id", standin.exit_id);
  app.add_option("--kill-id", standin.kill_id);
  app.add_option("--throw-id", standin.throw_id);
  app.add_option("--late-id", standin.late_id);
  app.add_option("--rebuild", sweep.rebuild_interval_s);
  app.add_flag("--bad-study", bad_study);
  app.add_flag("--fault", fault);
  CLI11_PARSE(app, argc, argv);
  cagetol::log_to_stderr();
  cagetol::require_process_limits();
  try {
    return cagetol::run_sweep(
        [&] {
          if (bad_study)
            throw cagetol::InputError({"study.toml", 3}, "sigma", "-1", "must not be negative",
                                      "give another");
          if (fault) throw std::logic_error("no such row");
          return cagetol::make_standin_plan(standin);
        },
        sweep);
  } catch (const cagetol::InputError& error) {
    std::fprintf(stderr, "cagetol: %s\n", error.what());
    return 2;
  }
}
