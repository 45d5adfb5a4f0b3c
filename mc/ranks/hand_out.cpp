#include "mc/ranks/hand_out.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <memory>
#include <thread>

#include "mc/host/byte_stream.hpp"
#include "mc/host/failure.hpp"
#include "mc/ranks/signals.hpp"

namespace cagetol {
namespace {

// mpirun kills one second after SIGTERM: by then the study file has to be written as well.
constexpr double kLastWordsSeconds = 0.5;

constexpr std::int64_t kNothing = -1;

// What a look at the messages takes from the thread that computes on the same core: two changes of
// context and what they leave in its caches. Measured; sweeps of 0.1 s a sample took 13 % longer
// when rank 0 looked every 0.3 ms.
constexpr double kLookSeconds = 40e-6;
constexpr double kShortestRest = 0.3e-3, kLongestRest = 5e-3;

void rest_for(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

std::string encoded(const RunMessage& report) {
  ByteWriter out;
  out.put(static_cast<std::int32_t>(report.ending));
  out.put(report.id);
  out.put(report.misses);
  out.put(static_cast<std::int32_t>(report.status));
  out.put(report.wall_s);
  out.put(report.draining);
  return out.bytes();
}

RunMessage decoded_message(const std::string& bytes) {
  ByteReader in(bytes);
  RunMessage report;
  report.ending = static_cast<Ending>(in.get<std::int32_t>());
  report.id = in.get<std::uint64_t>();
  report.misses = in.get<bool>();
  report.status = static_cast<Status>(in.get<std::int32_t>());
  report.wall_s = in.get<double>();
  report.draining = in.get<bool>();
  return report;
}

std::string encoded(const std::optional<std::uint64_t>& id) {
  ByteWriter out;
  out.put(id ? static_cast<std::int64_t>(*id) : kNothing);
  return out.bytes();
}

std::optional<std::uint64_t> decoded_id(const std::string& bytes) {
  const auto id = ByteReader(bytes).get<std::int64_t>();
  if (id == kNothing) return std::nullopt;
  return static_cast<std::uint64_t>(id);
}

/// The computing thread of rank 0 and what it leaves. Shared, since it may outlive the thread that
/// waits for it.
struct OwnWork {
  std::atomic<bool> done{false};
  std::exception_ptr problem;
};

}  // namespace

void CompletedPrefix::add(std::uint64_t id, bool misses) {
  if (!allowed_) return;
  beyond_[id] = misses;
  for (auto next = beyond_.find(size_); next != beyond_.end() && !used_up();
       next = beyond_.find(size_)) {
    missing_ += next->second;
    beyond_.erase(next);
    ++size_;
  }
}

WorkList::WorkList(std::vector<std::uint64_t> pending, const Tally& before, CompletedPrefix prefix)
    : pending_(pending.rbegin(), pending.rend()) {
  state_.tally = before;
  state_.prefix = std::move(prefix);
}

std::optional<std::uint64_t> WorkList::exchange(const RunMessage& report) {
  const std::lock_guard lock(mutex_);
  state_.busy_s += report.wall_s;
  if (report.ending != Ending::none) ++state_.reports;
  if (report.ending == Ending::finished) {
    state_.tally.count(report.status);
    state_.prefix.add(report.id, report.misses);
  }
  if (report.ending == Ending::no_outcome) ++state_.without_outcome;
  if (report.ending == Ending::cannot_write) state_.cannot_write = true;
  stopped_ = stopped_ || report.draining || report.ending == Ending::cannot_write ||
             report.ending == Ending::interrupted;
  if (stopped_ || pending_.empty() || state_.prefix.used_up()) return std::nullopt;
  const std::uint64_t id = pending_.back();
  pending_.pop_back();
  return id;
}

void WorkList::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
}

WorkList::State WorkList::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

double lookout_rest(double sample_s, int others) {
  if (others == 0) return kLongestRest;
  return std::clamp(std::sqrt(2 * kLookSeconds * sample_s / others), kShortestRest, kLongestRest);
}

bool lead_team(const Team& team, WorkList& list, const RunSample& run,
               const std::function<void()>& idle) {
  const auto own = std::make_shared<OwnWork>();
  std::thread computing([own, &list, &run] {
    try {
      for (auto id = list.exchange({}); id;) id = list.exchange(run(*id));
    } catch (...) {
      own->problem = std::current_exception();
      list.stop();
    }
    own->done = true;
  });

  int others = team.size() - 1;
  while (others > 0 || !own->done) try {
      if (SignalWatch::draining()) list.stop();
      if (SignalWatch::stopping_for_s() > kLastWordsSeconds) {
        computing.detach();
        return false;
      }
      if (const auto message = team.receive()) {
        const auto next = list.exchange(decoded_message(message->bytes));
        team.send(message->rank, encoded(next));
        if (!next) --others;
        continue;
      }
      idle();
      const WorkList::State state = list.state();
      const double sample_s =
          state.busy_s / std::max<double>(1, static_cast<double>(state.reports));
      rest_for(lookout_rest(sample_s, others));
    } catch (
        const std::exception& problem) {  // want of memory: the computing thread has no end yet
      spdlog::error("{}", failure_text(problem));
      computing.detach();
      return false;
    }
  computing.join();
  if (own->problem) std::rethrow_exception(own->problem);
  return true;
}

bool work_in_team(const Team& team, const RunSample& run) {
  RunMessage report;
  while (true) {
    report.draining = SignalWatch::draining();
    team.send(0, encoded(report));
    auto answer = team.receive();
    for (; !answer; answer = team.receive()) {
      if (SignalWatch::stopping_for_s() > 2 * kLastWordsSeconds) return false;
      short_rest();
    }
    const auto id = decoded_id(answer->bytes);
    if (!id) return true;
    report = run(*id);
  }
}

}  // namespace cagetol
