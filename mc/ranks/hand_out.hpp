// Dynamic hand-out of samples: whoever is free asks rank 0 for the next one. Rank 0 computes too,
// in a second thread, while its first thread answers; so an answer never waits for a sample.
// Samples go out in the order of their ids.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "mc/host/progress.hpp"
#include "mc/ranks/team.hpp"
#include "src/quantities/outcome.hpp"

namespace cagetol {

/// What became of the sample that a rank had.
enum class Ending : std::int32_t {
  none,          ///< the rank asks for the first time
  finished,      ///< in the journal
  no_outcome,    ///< ended by its wall-clock limit or for want of memory: not run
  interrupted,   ///< given back because of a signal; the rank stops
  cannot_write,  ///< finished, but the journal could not be written; the rank stops
};

struct RunMessage {
  Ending ending = Ending::none;
  std::uint64_t id = 0;
  bool misses = false;  ///< a limit, or has no result
  Status status = Status::not_run;
  double wall_s = 0;
  bool draining = false;  ///< the rank was asked to drain
};

/// The first samples of a sweep, as far as all of them are done. Where more of them miss a limit
/// than allowed the sweep ends with the one that did, whatever ranks have run beyond it.
class CompletedPrefix {
 public:
  CompletedPrefix(std::optional<std::uint64_t> allowed_misses = {}) : allowed_(allowed_misses) {}

  void add(std::uint64_t id, bool misses);
  bool used_up() const { return allowed_ && missing_ > *allowed_; }
  std::uint64_t size() const { return size_; }

 private:
  std::optional<std::uint64_t> allowed_;
  std::map<std::uint64_t, bool> beyond_;  ///< done, with samples before them that are not
  std::uint64_t size_ = 0, missing_ = 0;
};

/// The samples still to be run, and what came back so far. Threads may share it.
class WorkList {
 public:
  WorkList(std::vector<std::uint64_t> pending, const Tally& before, CompletedPrefix prefix = {});

  /// Takes what the last sample became and gives the next one; nothing when there is none or the
  /// sweep is to stop.
  std::optional<std::uint64_t> exchange(const RunMessage& report);
  void stop();

  struct State {
    Tally tally;
    std::uint64_t without_outcome = 0;
    bool cannot_write = false;
    double busy_s = 0;          ///< time spent in samples, all ranks together
    std::uint64_t reports = 0;  ///< of samples run
    CompletedPrefix prefix;
  };
  State state() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::uint64_t> pending_;  ///< last one first
  bool stopped_ = false;
  State state_;
};

/// Runs one sample and says what became of it.
using RunSample = std::function<RunMessage(std::uint64_t id)>;

/// How long rank 0 sleeps between two looks at its messages [s]. A look takes time from its
/// computing thread, a sleep lets the `others` wait for an answer, half of it in the mean, once in
/// `sample_s`: the sum of both losses is least at sqrt(2 look sample_s / others), within bounds.
double lookout_rest(double sample_s, int others);

/// Rank 0: computes, answers the others and calls `idle` between messages until every rank has
/// stopped. False when ranks had to be left behind because a signal gives no more time, or for want
/// of memory; then this process must end without waiting for them or its own thread.
bool lead_team(const Team& team, WorkList& list, const RunSample& run,
               const std::function<void()>& idle);

/// Other ranks: computes until rank 0 has nothing more. False when rank 0 stays silent after a
/// signal.
bool work_in_team(const Team& team, const RunSample& run);

}  // namespace cagetol
