#include "mc/ranks/pulse.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "mc/ranks/launch.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/study_file/exit_code.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

constexpr int kBeatTag = 2;
constexpr int kTicksPerLimit = 30;
constexpr int kTicksPerBeat = 5;
constexpr char kAlive = 'a', kStop = 's', kLost = 'l';

/// A process that cannot end by itself is ended after so many ticks.
constexpr int kGraceTicks = kTicksPerLimit / 2;

/// mpirun may need some seconds to end all ranks that it reaches.
constexpr double kMinimumLauncherGrace = 15;

}  // namespace

double silence_limit_s() {
  constexpr double kUsual = 60, kLeast = 1, kMost = 86400;
  const char* text = std::getenv("CAGETOL_SILENCE_S");
  if (text == nullptr) return kUsual;
  char* end = nullptr;
  const double limit = std::strtod(text, &end);
  if (end == text || *end != '\0' || !(limit >= kLeast && limit <= kMost))
    throw InputError({}, "CAGETOL_SILENCE_S", text,
                     "the time that a rank may stay silent must be a number of seconds from 1 to "
                     "86400",
                     "give a number such as 60, or unset the variable");
  return limit;
}

struct Pulse::Wire {
  MPI_Comm beats = MPI_COMM_NULL;
  std::vector<MPI_Request> sending;
  std::vector<char> sent;  ///< what a pending send reads
};

Pulse::Pulse(std::mutex& mpi, double limit_s, std::function<std::string(int)> name_of)
    : mpi_(mpi),
      limit_s_(limit_s),
      tick_s_(limit_s / kTicksPerLimit),
      name_of_(std::move(name_of)) {
  wire_ = std::make_unique<Wire>();
  MPI_Comm_dup(MPI_COMM_WORLD, &wire_->beats);
  MPI_Comm_rank(wire_->beats, &rank_);
  int size = 1;
  MPI_Comm_size(wire_->beats, &size);
  if (rank_ != 0) peers_ = {0};
  if (rank_ == 0)
    for (int peer = 1; peer < size; ++peer) peers_.push_back(peer);
  wire_->sending.assign(peers_.size(), MPI_REQUEST_NULL);
  wire_->sent.assign(peers_.size(), kAlive);
  silent_ticks_.assign(peers_.size(), 0);
  thread_ = std::thread([this] { beat(); });
}

Pulse::~Pulse() {
  end();
  {
    const std::lock_guard lock(phases_);
    phase_ = Phase::over;
  }
  next_phase_.notify_all();
  thread_.join();
}

void Pulse::end() {
  std::unique_lock lock(phases_);
  if (phase_ != Phase::beating) return;
  phase_ = Phase::ending;
  next_phase_.notify_all();
  next_phase_.wait(lock, [this] { return phase_ == Phase::silent; });
}

bool Pulse::hopeless() const {
  return lost_ && (rank_ == 0 || lost_rank_0_);
}

void Pulse::stop_all() {
  stop_all_ = true;
  SignalWatch::ask_to_stop();
}

void Pulse::beat() {
  std::unique_lock lock(phases_);
  while (!next_phase_.wait_for(lock, std::chrono::duration<double>(tick_s_),
                               [this] { return phase_ != Phase::beating; })) {
    lock.unlock();
    tick();
    lock.lock();
  }
  phase_ = Phase::silent;
  next_phase_.notify_all();
  if (next_phase_.wait_for(lock, std::chrono::duration<double>(limit_s_),
                           [this] { return phase_ == Phase::over; }))
    return;
  spdlog::error(
      "MPI does not end within {:.0f} s: a link is cut or a machine is down; all samples of this "
      "start are stored\n  remedy: start the same command again",
      limit_s_);
  end_launcher_after(kMinimumLauncherGrace);
  ::_exit(kInterrupted);
}

void Pulse::tick() {
  const char what = rank_ == 0 && lost_ ? kLost : stop_all_ ? kStop : kAlive;
  if (what != kAlive || ticks_ % kTicksPerBeat == 0) send(what);
  ++ticks_;
  hear();
  if (!lost_) count_silence();
  if (lost_ && ++ticks_lost_ > kGraceTicks) ::_exit(kInterrupted);
}

void Pulse::send(char what) {
  for (std::size_t k = 0; k < peers_.size(); ++k) {
    const std::lock_guard lock(mpi_);
    int done = 0;
    MPI_Test(&wire_->sending[k], &done, MPI_STATUS_IGNORE);
    if (!done) continue;  // the last one is still on its way: the link is cut, or slow
    wire_->sent[k] = what;
    MPI_Isend(&wire_->sent[k], 1, MPI_CHAR, peers_[k], kBeatTag, wire_->beats, &wire_->sending[k]);
  }
}

void Pulse::hear() {
  for (auto& ticks : silent_ticks_) ++ticks;
  while (true) {
    const std::lock_guard lock(mpi_);
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, kBeatTag, wire_->beats, &there, &status);
    if (!there) return;
    char beat = kAlive;
    MPI_Recv(&beat, 1, MPI_CHAR, status.MPI_SOURCE, kBeatTag, wire_->beats, MPI_STATUS_IGNORE);
    silent_ticks_[rank_ == 0 ? static_cast<std::size_t>(status.MPI_SOURCE) - 1 : 0] = 0;
    if (beat == kAlive) continue;
    if (beat == kLost) lost_ = true;
    SignalWatch::ask_to_stop();
  }
}

void Pulse::count_silence() {
  std::size_t lost = 0, first = peers_.size();
  for (std::size_t k = peers_.size(); k-- > 0;)
    if (silent_ticks_[k] > kTicksPerLimit) {
      ++lost;
      first = k;
    }
  if (lost == 0) return;
  spdlog::error(
      "{}{} for {:.0f} s: the link is cut, the machine is down or stood still, or the process "
      "hangs; the run ends. Finished samples are kept\n"
      "  remedy: start the same command again, on machines that reach each other; where a machine "
      "may stand still for longer, with a larger CAGETOL_SILENCE_S (seconds)",
      name_of_(peers_[first]),
      lost == 1 ? " has been silent" : fmt::format(" and {} more have been silent", lost - 1),
      limit_s_);
  lost_rank_0_ = rank_ != 0;
  end_launcher_after(std::max(kMinimumLauncherGrace, kGraceTicks * tick_s_));
  lost_ = true;
  if (rank_ == 0) send(kLost);
  SignalWatch::ask_to_stop();
}

}  // namespace cagetol
