#include "mc/run/forecast.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "mc/sweep/journal.hpp"
#include "mc/sweep/stored_study.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/input_error.hpp"
#include "tests/support/process.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/support/shipped_input.hpp"
#include "tests/support/standin_study.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A line of /proc/self/status in bytes.
double memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::istringstream fields(line);
    std::string word;
    double kilobytes = 0;
    if (fields >> word >> kilobytes && word == name + ":") return 1024 * kilobytes;
  }
  return 0;
}

template <class Action>
std::string problem_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Forecast, IsMetByAStandInSweepWithinAFactorOfTwo) {
  if (kSanitized) GTEST_SKIP() << kNotItsOwnCost;
  constexpr long samples = 20000;
  const SweepPlan plan = make_standin_plan({.samples = samples, .mean_ms = 0});
  const SweepForecast forecast = forecast_sweep(plan.study);
  EXPECT_EQ(forecast.samples, 20000u);
  const ScratchDirectory scratch;
  {
    Journal journal(scratch.path(), {plan.study.hash, "build", 0});
    for (std::uint64_t id = 0; id < plan.samples; ++id) {
      journal.started(id);
      journal.finished(
          make_stored_outcome(id, plan.job(plan.draw(id), [] { return false; }), 0.1, 0));
    }
  }
  const auto close = [](double predicted, double measured, const char* what) {
    EXPECT_LT(predicted, 2 * measured) << what;
    EXPECT_GT(predicted, measured / 2) << what;
  };
  double journals = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path()))
    journals += static_cast<double>(entry.file_size());
  close(forecast.journal_bytes, journals, "journals");

  // What rank 0 does when an interrupted sweep goes on and study.h5 is built again.
  const SweepForecast nothing = forecast_sweep(make_standin_plan({.samples = 1}).study);
  std::ofstream("/proc/self/clear_refs") << 5;  // the high-water mark is what is there now
  const double before = memory("VmRSS");
  const JournalSet found = read_journals(scratch.path());
  {
    const JournalSet stored = read_journals(scratch.path());
    write_study_file(scratch / "study.h5", plan, stored.finished, {});
  }
  EXPECT_EQ(found.finished.size(), 20000u);
  close(forecast.rank_0_memory - nothing.rank_0_memory, memory("VmHWM") - before, "memory");
  close(forecast.study_file_bytes,
        static_cast<double>(std::filesystem::file_size(scratch / "study.h5")), "study.h5");
}

TEST(Forecast, CountsTheLargestStudyWithoutOverflow) {
  const auto forecast = [](const std::vector<std::string>& settings) {
    return forecast_sweep(read_study(shipped("studies/nu205-rated.toml"), settings));
  };
  const SweepForecast largest = forecast({"samples=1000000000", "extra_replicates=1000"});
  EXPECT_EQ(largest.rows, 1000000000u);
  EXPECT_EQ(largest.samples, 1001000000000u);
  EXPECT_GT(largest.journal_bytes, 8.0 * 100 * 1001e9);  // a hundred quantities and more
  EXPECT_GT(largest.rank_0_memory, largest.journal_bytes);
  // Linear in the samples.
  const SweepForecast one = forecast({"samples=1000", "extra_replicates=0"}),
                      ten = forecast({"samples=10000", "extra_replicates=0"});
  EXPECT_NEAR(ten.journal_bytes / one.journal_bytes, 10, 1e-9);
}

TEST(Forecast, BeyondTheMachineIsRefusedWithCountsAndRemedy) {
  SweepForecast forecast = forecast_sweep(make_standin_plan({.samples = 40}).study);
  EXPECT_EQ(problem_of([&] { require_memory(forecast, 2); }), "no error");
  EXPECT_EQ(problem_of([&] { require_disk(forecast, "/"); }), "no error");
  forecast.rank_0_memory = 1e18;
  EXPECT_THAT(problem_of([&] { require_memory(forecast, 1); }),
              AllOf(HasSubstr("samples = 40: 40 rows, 40 samples with "),
                    HasSubstr("need about 1000 PB of memory; there are "),
                    HasSubstr("remedy: ask for fewer samples")));
  forecast.study_file_bytes = 1e17;
  EXPECT_THAT(problem_of([&] { require_disk(forecast, "/no/such/folder"); }),
              AllOf(HasSubstr("need about 200 PB of disk"), HasSubstr("free on the disk of /"),
                    HasSubstr("choose another output directory with -o")));
  // The need of a sweep below the least that is refused is met as it comes.
  forecast.study_file_bytes = 0;
  forecast.journal_bytes = kMinimumRefused;
  EXPECT_EQ(problem_of([&] { require_disk(forecast, "/proc"); }), "no error");
  forecast.journal_bytes = 1.01 * kMinimumRefused;
  EXPECT_THAT(problem_of([&] { require_disk(forecast, "/proc"); }), HasSubstr("there are 0.0 kB"));
}

TEST(Forecast, AThinOrFineCageTakesMemory) {
  const auto bytes = [](const std::vector<std::string>& settings) {
    return forecast_cage_table(read_study(shipped("scenes/nu205.toml"), settings).scene);
  };
  EXPECT_EQ(bytes({"cage.model=rigid"}), 0);
  // Nodes of the mesh, by `cagetol cage`: 3705 and 17225, 24 kB each.
  EXPECT_NEAR(bytes({"cage.model=flexible", "cage.mesh_density=2"}), 24e3 * 3705, 1);
  EXPECT_NEAR(bytes({"cage.model=flexible", "cage.mesh_density=4"}), 24e3 * 17225, 1);
  Scene scene = read_study(shipped("scenes/nu205.toml"), {"cage.model=flexible"}).scene;
  scene.cage.mesh_density = 400;
  EXPECT_THAT(problem_of([&] { require_cage_memory(scene); }),
              AllOf(HasSubstr("cage.mesh_density = 400: making the table of this cage takes about"),
                    HasSubstr("remedy: use a coarser mesh")));
}

}  // namespace
}  // namespace cagetol
