#include "tests/support/instruction_count.hpp"

#include <sched.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace cagetol {
namespace {

/// The next stop of the traced process; its signal, or 0 when it ended.
int stopped_by(pid_t traced) {
  int status = 0;
  if (waitpid(traced, &status, 0) != traced) throw std::runtime_error("cannot wait for the work");
  return WIFSTOPPED(status) ? WSTOPSIG(status) : 0;
}

/// Keeps this process, and those it starts, on the core it is on: to wake another at every
/// instruction would cost more than to execute it.
class OneCore {
 public:
  OneCore() {
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;
  ~OneCore() { sched_setaffinity(0, sizeof before_, &before_); }

 private:
  cpu_set_t before_;
};

}  // namespace

std::optional<long> instructions_of(const std::function<void()>& work) {
  constexpr int kUntraceable = 3;
  const OneCore here;
  const pid_t traced = fork();
  if (traced < 0) throw std::runtime_error("cannot start the work");
  if (traced == 0) {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) _exit(kUntraceable);
    raise(SIGSTOP);
    work();
    raise(SIGSTOP);
    _exit(0);
  }
  if (stopped_by(traced) != SIGSTOP) return {};
  long count = 0;
  int signal = SIGTRAP;
  while (signal == SIGTRAP) {
    if (ptrace(PTRACE_SINGLESTEP, traced, nullptr, nullptr) != 0) break;
    signal = stopped_by(traced);
    ++count;
  }
  const bool done = signal == SIGSTOP;
  kill(traced, SIGKILL);
  waitpid(traced, nullptr, 0);
  if (!done) throw std::runtime_error("the work did not come to its end");
  return count;
}

}  // namespace cagetol
