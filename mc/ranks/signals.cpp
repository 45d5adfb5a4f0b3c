#include "mc/ranks/signals.hpp"

#include <algorithm>
#include <atomic>
#include <ctime>

namespace cagetol {
namespace {

// Samples take seconds; whoever sends SIGUSR1 ahead of a time limit commonly leaves a minute.
constexpr double kDrainSeconds = 30;

// A signal handler can reach nothing but statics. 0 means "not asked yet"; otherwise seconds of the
// monotonic clock.
std::atomic<double> drain_asked{0}, stop_asked{0};
static_assert(std::atomic<double>::is_always_lock_free);

int watches = 0;  ///< alive; only the outermost one has anything to put back

double now_s() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void ask(std::atomic<double>& asked) {
  double never = 0;
  asked.compare_exchange_strong(never, now_s());
}

extern "C" void on_signal(int number) noexcept {
  ask(number == SIGUSR1 ? drain_asked : stop_asked);
}

/// When stopping() became or becomes true; 0 while nobody asked.
double stop_time() {
  const double drain = drain_asked, stop = stop_asked;
  if (drain == 0) return stop;
  return stop == 0 ? drain + kDrainSeconds : std::min(stop, drain + kDrainSeconds);
}

}  // namespace

SignalWatch::SignalWatch() {
  if (watches++ > 0) return;
  drain_asked = stop_asked = 0;
  for (const int number : {SIGUSR1, SIGTERM, SIGINT}) {
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    Replaced old{number, {}};
    sigaction(number, &action, &old.action);
    replaced_.push_back(old);
  }
}

SignalWatch::~SignalWatch() {
  --watches;
  for (const Replaced& old : replaced_) sigaction(old.number, &old.action, nullptr);
}

void SignalWatch::ask_to_stop() {
  ask(stop_asked);
}
bool SignalWatch::draining() {
  return drain_asked != 0 || stop_asked != 0;
}
bool SignalWatch::stopping() {
  return stopping_for_s() > 0;
}

double SignalWatch::stopping_for_s() {
  const double since = stop_time();
  return since == 0 ? 0 : std::max(0.0, now_s() - since);
}

}  // namespace cagetol
