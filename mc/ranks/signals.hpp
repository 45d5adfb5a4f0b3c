// Signals that end a sweep early. SIGUSR1 drains: samples in flight may finish for a while. SIGTERM
// and SIGINT stop at once, since mpirun and batch systems leave about two seconds before they kill.
#pragma once

#include <signal.h>

#include <vector>

namespace cagetol {

/// Watches for signals while it lives. Where another one lives already, that one goes on watching.
class SignalWatch {
 public:
  SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  ~SignalWatch();

  /// No new sample may start.
  static bool draining();
  /// Samples in flight shall be given back: asked to stop, or draining for longer than samples are
  /// waited for.
  static bool stopping();
  /// The program itself asks to stop, as SIGTERM does.
  static void ask_to_stop();
  /// Seconds since stopping() became true; 0 before.
  static double stopping_for_s();

 private:
  struct Replaced {
    int number;
    struct sigaction action;
  };
  std::vector<Replaced> replaced_;
};

}  // namespace cagetol
