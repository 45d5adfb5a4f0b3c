#include "mc/sweep/staged_sweeps.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <filesystem>

#include "mc/host/failure.hpp"
#include "mc/host/log.hpp"
#include "mc/ranks/hand_out.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/study_file/exit_code.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "mc/sweep/stored_study.hpp"
#include "mc/sweep/sweep.hpp"
#include "mc/sweep/sweep_directory.hpp"

namespace cagetol {
namespace {

constexpr double kSecondsToEnd = 2;

/// Whether study.h5 holds this very study with every sample, by this build, with no more failures
/// than allowed. Anything doubtful is left to the sweep, which has the messages.
bool complete(const Study& study, const std::string& directory,
              std::optional<std::uint64_t> allowed_misses) {
  if (!std::filesystem::exists(study_file_path(directory))) return false;
  try {
    const StudyFile file = read_study_file(study_file_path(directory));
    CompletedPrefix prefix(allowed_misses);
    for (const auto& [id, outcome] : file.outcomes) prefix.add(id, !meets_limits(study, outcome));
    const auto samples = prefix.used_up() ? prefix.size() : sample_count(study);
    if (file.study_hash != study.hash || file.study_toml != study.resolved_toml ||
        file.build != build_id(build_info()) || file.outcomes.size() != samples)
      return false;
    std::size_t failures = 0;
    for (const auto& [id, outcome] : file.outcomes) failures += is_failure(outcome.status);
    return static_cast<double>(failures) <=
           study.allowed_failure_share * static_cast<double>(samples);
  } catch (const StudyFileError&) {
    return false;
  }
}

void tell(const Team& team, const std::string& text) {
  for (int rank = 1; rank < team.size(); ++rank) team.send(rank, text);
}

std::string next_sweep(const Team& team) {
  while (true) {
    if (const auto message = team.receive()) return message->bytes;
    if (SignalWatch::stopping_for_s() > 2 * kSecondsToEnd) ::_exit(kInterrupted);
    team.check_pulse();
    short_rest();
  }
}

/// The exit code with which all ranks part because they run different programs.
int parted(const Team& team) {
  return agreed(team,
                problem_of([&] { check_same_program(team, build_info(), "several sweeps"); }));
}

void follow(const Launch& launch, const MakePlan& make_plan) {
  const Team team(launch);
  if (parted(team) != kDone) return;
  // From rank 0: "DIRECTORY\nresolved study"; empty at the end.
  for (std::string text = next_sweep(team); !text.empty(); text = next_sweep(team)) {
    const auto line = text.find('\n');
    const std::string directory = text.substr(0, line);
    Sweep sweep(launch, {.directory = directory, .progress = ProgressStyle::off});
    sweep.prepare([&] { return make_plan(read_resolved_study(text.substr(line + 1), directory)); },
                  true);
    sweep.run(team);
  }
}

}  // namespace

int StagedSweeps::sweep(const Study& study, const std::string& directory,
                        std::optional<std::uint64_t> allowed_misses) {
  if (complete(study, directory, allowed_misses)) return kDone;
  if (SignalWatch::draining()) return kInterrupted;
  spdlog::info("{}: {} runs in {}", study.name, sample_count(study), directory);
  Sweep sweep(launch_,
              {.directory = directory, .progress = progress_, .allowed_misses = allowed_misses});
  sweep.prepare([&] { return make_plan_(study); }, launch_.under_mpi && team_);
  if (const int code = join()) return code;
  tell(*team_, directory + "\n" + study.resolved_toml);
  return sweep.run(*team_);
}

int StagedSweeps::join() {
  if (team_ || refused_ != kDone) return refused_;
  refused_ = kBadInput;  // should MPI not come up
  team_ = std::make_unique<Team>(launch_);
  return refused_ = parted(*team_);
}

int StagedSweeps::end() {
  const int code = join();  // the others wait for it
  if (code == kDone) tell(*team_, "");
  return code;
}

int run_staged(const MakePlan& make_plan, ProgressStyle progress,
               const std::function<int(StagedSweeps&)>& lead) {
  const Launch launch = launch_from_environment();
  const SignalWatch signals;
  if (launch.rank != 0) {
    follow(launch, make_plan);
    return kDone;
  }
  StagedSweeps stages(launch, make_plan, progress);
  int code = kBadInput;
  try {
    code = lead(stages);
  } catch (const WriteError& problem) {
    say("cagetol: {}\n", problem.what());
    code = problem.can_go_on() ? kInterrupted : kBadInput;
  } catch (const std::exception& problem) {
    say("cagetol: {}\n", ending_text(problem));
    code = is_want_of_resources(problem) ? kInterrupted : exit_code_for(problem);
  }
  const int refused = stages.end();
  return refused != kDone ? refused : code;
}

}  // namespace cagetol
