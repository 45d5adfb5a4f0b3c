#include "mc/sweep/sweep.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "mc/host/failure.hpp"
#include "mc/ranks/hand_out.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/run/forecast.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/study_file/exit_code.hpp"
#include "mc/sweep/alone.hpp"
#include "mc/sweep/stored_study.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

// A sample in flight when everything was killed twice may well be innocent; from then on it runs in
// a process of its own.
constexpr int kLossesBeforeAlone = 2;

// Bringing study.h5 up to date must stay a small share of the sweep, however long its reading and
// writing takes.
constexpr double kRebuildShare = 0.01;

// How often rank 0 looks whether the directory is still there, s.
constexpr double kSecondsBetweenChecks = 1;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Draws and runs one sample. An exception is the sample's failure; `not_run` means that it was
/// given back.
StoredOutcome stored_run(const SweepPlan& plan, std::uint64_t id, int rank) {
  const auto begin = std::chrono::steady_clock::now();
  Outcome outcome;
  try {
    outcome = plan.job(plan.draw(id), SignalWatch::stopping);
  } catch (const std::exception& problem) {
    if (is_want_of_resources(problem)) {
      spdlog::error("sample {} is not run: {}", id, failure_text(problem));
    } else {
      outcome.status = Status::failed;
      outcome.reason = problem.what();
    }
  }
  return make_stored_outcome(id, outcome, seconds_since(begin), rank);
}

/// Runs one sample and keeps the journal: what a rank does for each id that it is given.
RunMessage run_with_journal(const SweepPlan& plan, Journal& journal, std::uint64_t id, int rank) {
  RunMessage report;
  try {
    journal.started(id);
    const StoredOutcome stored = stored_run(plan, id, rank);
    report = {Ending::finished, id, !meets_limits(plan.study, stored), stored.status,
              stored.wall_s};
    if (stored.status != Status::not_run) {
      journal.finished(stored);
    } else {
      journal.dropped(id);
      report.ending = SignalWatch::stopping() ? Ending::interrupted : Ending::no_outcome;
    }
  } catch (const WriteError& problem) {
    spdlog::error("{}", problem.what());
    report.ending = Ending::cannot_write;
  }
  return report;
}

/// Samples that were lost again and again run alone, before the others start.
void run_suspects(const SweepPlan& plan, const JournalSet& stored, Journal& journal) {
  for (const auto& [id, losses] : stored.losses) {
    if (losses < kLossesBeforeAlone || SignalWatch::draining()) continue;
    spdlog::warn("sample {} was being run {} times when its process died: running it alone", id,
                 losses);
    journal.started(id);
    const AloneResult result = run_alone(id, [&, id = id]() -> std::optional<StoredOutcome> {
      const StoredOutcome outcome = stored_run(plan, id, 0);
      if (outcome.status == Status::not_run) return std::nullopt;
      return outcome;
    });
    if (!result.outcome) {
      journal.dropped(id);
      spdlog::warn("sample {} has no outcome yet: {}", id, result.why_not);
    } else {
      journal.finished(*result.outcome);
      if (result.outcome->status == Status::poisoned)
        spdlog::warn("sample {} is poisoned: {}", id, result.outcome->reason);
    }
  }
}

/// What is left for this session, and what is there already.
struct Pending {
  std::vector<std::uint64_t> ids;
  Tally before;
  CompletedPrefix prefix;
};

Pending pending_samples(const SweepPlan& plan, const JournalSet& stored,
                        const SweepOptions& options) {
  Pending pending;
  pending.prefix = CompletedPrefix(options.allowed_misses);
  for (std::uint64_t id = 0; id < plan.samples; ++id) {
    const auto found = stored.finished.find(id);
    if (found != stored.finished.end()) {
      pending.before.count(found->second.status);
      pending.prefix.add(id, !meets_limits(plan.study, found->second));
      continue;
    }
    const auto losses = stored.losses.find(id);
    if (losses == stored.losses.end() || losses->second < kLossesBeforeAlone)
      pending.ids.push_back(id);
  }
  return pending;
}

/// Rank 0 while the sweep runs.
class Leader {
 public:
  Leader(const SweepPlan& plan, const SweepOptions& options, const BuildInfo& build)
      : plan_(plan), options_(options), build_(build) {}

  int lead(const Team& team, Journal& journal, const RunSample& run);

 private:
  /// Brings study.h5 up to date from the journals of this study and build; false with a message
  /// when that is not possible, or when they lack a sample that this sweep has `done`.
  bool rebuild(std::uint64_t done, const CompletedPrefix& prefix);
  void idle(const WorkList& list, Progress& progress);
  /// Whether the directory is where it was; otherwise every rank is asked to stop.
  bool in_place(const Team& team, const Journal& journal);
  int conclude(const WorkList::State& state, bool written) const;

  const SweepPlan& plan_;
  const SweepOptions& options_;
  const BuildInfo& build_;
  std::chrono::steady_clock::time_point last_rebuild_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_check_ = last_rebuild_;
  double rebuild_s_ = 0;
  bool gone_ = false;  ///< the directory was removed or renamed
};

JournalHeader owner_of(const SweepPlan& plan, const BuildInfo& build) {
  return {plan.study.hash, build_id(build), 0};
}

bool Leader::rebuild(std::uint64_t done, const CompletedPrefix& prefix) {
  const auto begin = std::chrono::steady_clock::now();
  bool written = true;
  try {
    const JournalHeader owner = owner_of(plan_, build_);
    JournalSet stored = read_journals(journal_directory(options_.directory), &owner);
    for (const auto& [file, header] : stored.refused)
      spdlog::error(
          "{}: belongs to another study or build, and is left out:\n  stored {} {}\n  now    {} "
          "{}\n"
          "  remedy: move it out of this directory, which it has entered during the sweep",
          file, header.study_hash, header.build, owner.study_hash, owner.build);
    std::erase_if(stored.finished, [&](const auto& item) { return item.first >= plan_.samples; });
    const std::size_t found = stored.finished.size();
    if (prefix.used_up())
      std::erase_if(stored.finished, [&](const auto& item) { return item.first >= prefix.size(); });
    write_study_file(study_file_path(options_.directory), plan_, stored.finished, build_);
    if (found < done) {
      for (const std::string& note : stored.notes) spdlog::error("{}", note);
      spdlog::error(
          "{}: the journals hold {} of the {} samples done: some were removed, damaged or refused "
          "meanwhile",
          journal_directory(options_.directory), found, done);
      written = false;
    }
  } catch (const std::exception& problem) {
    spdlog::error("{}", failure_text(problem));
    written = false;
  }
  rebuild_s_ = seconds_since(begin);
  last_rebuild_ = std::chrono::steady_clock::now();
  return written;
}

bool Leader::in_place(const Team& team, const Journal& journal) {
  if (gone_ || seconds_since(last_check_) < kSecondsBetweenChecks) return !gone_;
  last_check_ = std::chrono::steady_clock::now();
  try {
    journal.check_in_place();
  } catch (const WriteError& problem) {
    gone_ = true;
    spdlog::error("{}", problem.what());
    team.stop_all();
  }
  return !gone_;
}

void Leader::idle(const WorkList& list, Progress& progress) {
  progress.update(list.state().tally);
  const double interval = std::max(options_.rebuild_interval_s, rebuild_s_ / kRebuildShare);
  if (seconds_since(last_rebuild_) > interval) rebuild(0, list.state().prefix);
}

int Leader::lead(const Team& team, Journal& journal, const RunSample& run) {
  const JournalHeader owner = owner_of(plan_, build_);
  const Pending pending = pending_samples(
      plan_, read_journals(journal_directory(options_.directory), &owner), options_);
  if (pending.before.done > 0)
    spdlog::info("{} of {} samples are already done", pending.before.done, plan_.samples);
  WorkList list(pending.ids, pending.before, pending.prefix);
  Progress progress(options_.progress, pending.before.done, plan_.samples);
  const bool orderly = lead_team(team, list, run, [&] {
    if (in_place(team, journal)) idle(list, progress);
  });
  const WorkList::State state = list.state();
  const double elapsed = progress.elapsed_s();
  progress.finish(state.tally);
  if (orderly && state.tally.done > pending.before.done)
    spdlog::info("{:.1f} s on {} ranks, {:.1f} % of it inside samples", elapsed, team.size(),
                 100 * state.busy_s / (elapsed * team.size()));
  if (orderly) journal.sync();
  const bool written = !gone_ && rebuild(state.tally.done, state.prefix);
  const int code = conclude(state, written);
  // The computing thread, or another rank, is still busy and a signal leaves no time to wait for
  // it. Journals are complete.
  if (!orderly) ::_exit(kInterrupted);
  return code;
}

int Leader::conclude(const WorkList::State& state, bool written) const {
  const Tally& tally = state.tally;
  if (state.without_outcome > 0)
    spdlog::warn(
        "{} samples have no outcome: integration.wall_budget_s or the memory ran out; start again "
        "with more",
        state.without_outcome);
  if (state.prefix.used_up())
    spdlog::info("ended after {} of {} samples: no more than {} may miss a limit",
                 state.prefix.size(), plan_.samples, *options_.allowed_misses);
  if ((tally.done < plan_.samples && !state.prefix.used_up()) || !written || state.cannot_write) {
    spdlog::warn("interrupted with {} of {} samples done: start the same command again to go on",
                 tally.done, plan_.samples);
    return kInterrupted;
  }
  const double share = static_cast<double>(tally.failures()) / static_cast<double>(plan_.samples);
  if (tally.failures() > 0 && share > plan_.study.allowed_failure_share) {
    spdlog::error(
        "{} of {} samples failed, were censored or poisoned ({:.3g} %); the study allows {:.3g} %\n"
        "  remedy: look at one with `cagetol replay {} --sample ID`; samples/reason in study.h5 "
        "says what happened",
        tally.failures(), plan_.samples, 100 * share, 100 * plan_.study.allowed_failure_share,
        options_.directory);
    return kSamplesFailed;
  }
  return kDone;
}

}  // namespace

void Sweep::open_journal() {
  journal_ =
      std::make_unique<Journal>(journal_directory(options_.directory),
                                JournalHeader{plan_.study.hash, build_id(build_), launch_.rank});
}

void Sweep::prepare(const std::function<SweepPlan()>& make_plan, bool mpi_runs) {
  problem_ = problem_of([&] {
    plan_ = make_plan();
    if (launch_.rank != 0) return;
    const SweepForecast forecast = forecast_sweep(plan_.study);
    spdlog::info("{}", forecast_text(forecast));
    if (const std::string points = operating_points_text(plan_.study); !points.empty())
      spdlog::info("{}", points);
    require_memory(forecast, ranks_on_this_machine());
    require_disk(forecast, options_.directory);
    directory_ = std::make_unique<SweepDirectory>(options_.directory, plan_.study, build_);
    for (const std::string& note : directory_->stored().notes) spdlog::warn("{}", note);
    open_journal();
    for (const StoredOutcome& outcome : directory_->only_in_study_file())
      journal_->finished(outcome);
    if (!mpi_runs) run_suspects(plan_, directory_->stored(), *journal_);
    directory_->forget_outcomes();
  });
}

int Sweep::run(const Team& team) {
  const bool leads = launch_.rank == 0;
  if (const int code = agreed(team, problem_)) return leads ? code : 0;
  problem_ = problem_of([&] { check_same_study(team, plan_.study); });
  if (const int code = agreed(team, problem_)) return leads ? code : 0;
  problem_ = problem_of([&] {
    check_same_directory(team, options_.directory, leads ? journal_->path() : "");
    if (!leads) open_journal();
    if (plan_.prepare) plan_.prepare(team.rank(), team.size());
  });
  if (const int code = agreed(team, problem_)) return leads ? code : 0;

  const RunSample run = [&](std::uint64_t id) {
    return run_with_journal(plan_, *journal_, id, launch_.rank);
  };
  int code = 0;
  try {
    if (leads) {
      code = Leader(plan_, options_, build_).lead(team, *journal_, run);
    } else if (!work_in_team(team, run)) {
      ::_exit(kInterrupted);
    }
  } catch (const std::exception& problem) {
    // The other ranks wait for answers that nobody gives: an orderly end of MPI would wait for
    // them. Journals are complete.
    const bool fault = exit_code_for(problem) == kUnexpected;
    spdlog::error("{}; rank {} ends{}", ending_text(problem), launch_.rank,
                  fault ? "" : ": start the same command again to go on");
    ::_exit(fault ? kUnexpected : kInterrupted);
  }
  team.meet();
  return code;
}

int run_sweep(const std::function<SweepPlan()>& make_plan, const SweepOptions& options) {
  const Launch launch = launch_from_environment();
  const SignalWatch signals;
  Sweep sweep(launch, options);
  sweep.prepare(make_plan, false);
  const Team team(launch);
  const Problem problem = problem_of([&] { check_same_program(team, build_info(), "one sweep"); });
  if (const int code = agreed(team, problem)) return team.rank() == 0 ? code : 0;
  return sweep.run(team);
}

}  // namespace cagetol
