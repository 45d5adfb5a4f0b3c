// What many ranks cost: `mpirun -n 2 build/mpi_scaling > tests/SCALING.md` measures what a message,
// a journal record and study.h5 cost here, and simulates a sweep on up to 10,000 ranks with these
// costs.
#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>

#include "mc/ranks/hand_out.hpp"
#include "mc/sweep/journal.hpp"
#include "mc/sweep/stored_study.hpp"
#include "tests/mpi/hand_out_simulation.hpp"
#include "tests/support/process.hpp"
#include "tests/support/standin_study.hpp"

namespace cagetol {
namespace {

double clock_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What `work` takes, in seconds: on the clock of the wall where it waits for the disk, else of the
/// processor, which other programs on this machine do not lengthen.
template <class Work>
double time_of(clockid_t clock, Work work) {
  const double begin = clock_s(clock);
  work();
  return clock_s(clock) - begin;
}

/// Processor time of rank 0 for one report taken and answered: reports wait in heaps, so that it
/// never waits itself.
double message_s(const Team& team) {
  constexpr int kHeaps = 20, kHeap = 500;
  const std::string report(21, 'r'), answer(8, 'a');
  WorkList list(std::vector<std::uint64_t>(kHeaps * kHeap), {});
  double busy_s = 0;
  for (int heap = 0; heap < kHeaps; ++heap) {
    team.meet();
    for (int k = 0; team.rank() == 1 && k < kHeap; ++k) team.send(0, report);
    team.meet();
    const double begin = clock_s(CLOCK_THREAD_CPUTIME_ID);
    for (int k = 0; team.rank() == 0 && k < kHeap; ++k) {
      const int rank = team.next_message().rank;
      list.exchange({Ending::finished, Status::ok, 0.1, false});
      team.send(rank, answer);
    }
    busy_s += clock_s(CLOCK_THREAD_CPUTIME_ID) - begin;
    for (int k = 0; team.rank() == 1 && k < kHeap; ++k) team.next_message();
  }
  return busy_s / (kHeaps * kHeap);
}

struct FileCosts {
  double record_s = 0, record_bytes = 0;  ///< of a sample in the journal
  double journal_s = 0;                   ///< a journal made, with its syncs
  double sample_s = 0, file_s = 0;        ///< study.h5 from journals, by sample and journal
};

/// Samples of the study with every quantity.
FileCosts file_costs() {
  constexpr std::uint64_t kFew = 2000, kMany = 10000, kFiles = 200;
  const ScratchDirectory scratch;
  const SweepPlan plan = make_standin_plan({.samples = static_cast<long>(kMany), .mean_ms = 0});
  const JournalHeader header{plan.study.hash, build_id(build_info()), 0};
  std::vector<StoredOutcome> outcomes;
  for (std::uint64_t id = 0; id < kMany; ++id)
    outcomes.push_back(
        make_stored_outcome(id, plan.job(plan.draw(id), [] { return false; }), 0.1, 0));
  FileCosts costs;
  const auto file_of = [&](std::uint64_t samples, std::uint64_t files) {
    const std::string folder = scratch / fmt::format("{}-{}", samples, files);
    std::filesystem::create_directory(folder);
    for (std::uint64_t file = 0, id = 0; file < files; ++file) {
      std::unique_ptr<Journal> journal;
      const double made =
          time_of(CLOCK_MONOTONIC, [&] { journal = std::make_unique<Journal>(folder, header); });
      const double written = time_of(CLOCK_PROCESS_CPUTIME_ID, [&] {
        for (; id < samples * (file + 1) / files; ++id) {
          journal->started(id);
          journal->finished(outcomes[id]);
        }
      });
      if (files > 1) costs.journal_s += made / kFiles;
      if (samples == kMany) costs.record_s = written / kMany;
      if (samples == kMany)
        costs.record_bytes = static_cast<double>(std::filesystem::file_size(journal->path())) /
                             static_cast<double>(kMany);
    }
    return time_of(CLOCK_PROCESS_CPUTIME_ID, [&] {
      write_study_file(scratch / "study.h5", plan, read_journals(folder).finished, build_info());
    });
  };
  const double few = file_of(kFew, 1), spread = file_of(kFew, kFiles), many = file_of(kMany, 1);
  costs.sample_s = (many - few) / (kMany - kFew);
  costs.file_s = std::max(0.0, spread - few) / (kFiles - 1);
  return costs;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "an unknown processor";
}

std::string page(const HandOutCosts& costs, const FileCosts& files) {
  std::string text = fmt::format(
      "# Many ranks\n\n"
      "Predicted, not measured: a simulation of the hand-out (tests/mpi/hand_out_simulation.hpp) "
      "with costs measured on two ranks.\n"
      "Made by `mpirun -n 2 build/mpi_scaling > tests/SCALING.md` at commit {} on {}.\n\n"
      "| measured | |\n|---|---|\n"
      "| report taken and answered by rank 0 | {:.1f} us of its processor |\n"
      "| sample in a journal (start and outcome, {:.0f} bytes) | {:.0f} us of its processor |\n"
      "| journal made, with its syncs, once for each rank | {:.2f} ms |\n"
      "| study.h5 from journals | {:.0f} us of the processor a sample, {:.2f} ms a journal |\n\n"
      "Assumed: {:.0f} us on the way for a message; run times that scatter by 30 % (log-normal); "
      "100 samples for each rank;\njournals made one after another, as in one folder of a shared "
      "file system; beats every 10 s. MPI's own start is left out.\n\n"
      "| ranks | sample takes | efficiency | largest loss | messages keep rank 0 busy |\n"
      "|---|---|---|---|---|\n",
      build_info().commit, processor(), 1e6 * costs.message_s, files.record_bytes,
      1e6 * files.record_s, 1e3 * files.journal_s, 1e6 * files.sample_s, 1e3 * files.file_s,
      1e6 * costs.latency_s);
  for (const int ranks : {2, 100, 1000, 10000})
    for (const double sample_s : {0.1, 1.0, 10.0, 100.0}) {
      const HandOutPrediction predicted = predict_hand_out(ranks, sample_s, 100, costs);
      text += fmt::format("| {} | {} s | {:.3f} | {}, {:.1f} % | {:.2g} % |\n", ranks, sample_s,
                          predicted.efficiency, predicted.largest_loss().name,
                          100 * predicted.largest_loss().share, 100 * predicted.server_busy);
    }
  text += fmt::format(
      "\nRank 0 can answer {:.0f} reports a second: {:.0f} ranks with samples of 0.1 s, ten times "
      "as many with 1 s. \"last samples\" is the wait for\nthe slowest rank at the end: more "
      "samples for each rank shrink it. \"study.h5\" is rank 0 building the file while the others "
      "wait; it\ngrows with all samples, and every other rank is idle then.\n",
      1 / costs.message_s, 0.1 / costs.message_s);
  return text;
}

}  // namespace
}  // namespace cagetol

int main() {
  using namespace cagetol;
  const Team team(launch_from_environment());
  if (team.size() != 2) {
    fmt::print(stderr, "start it as: mpirun -n 2 build/mpi_scaling > tests/SCALING.md\n");
    return 2;
  }
  const double message = message_s(team);
  if (team.rank() == 0) {
    const FileCosts files = file_costs();
    const HandOutCosts costs{.message_s = message,
                             .record_s = files.record_s,
                             .journal_s = files.journal_s,
                             .file_sample_s = files.sample_s,
                             .file_journal_s = files.file_s};
    fmt::print("{}", page(costs, files));
  }
  team.meet();
  return 0;
}
