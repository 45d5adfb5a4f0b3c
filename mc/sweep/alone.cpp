#include "mc/sweep/alone.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "mc/host/failure.hpp"
#include "mc/host/file_write.hpp"
#include "mc/ranks/signals.hpp"

namespace cagetol {
namespace {

// Signals that come from people, batch systems and the kernel's memory guard, never from what a
// sample computes.
bool comes_from_outside(int number) {
  return number == SIGKILL || number == SIGTERM || number == SIGINT || number == SIGHUP ||
         number == SIGUSR1 || number == SIGXCPU;
}

std::string name_of(int number) {
  const char* name = ::sigabbrev_np(number);
  return name == nullptr ? fmt::format("signal {}", number) : fmt::format("SIG{}", name);
}

[[noreturn]] void be_child(int pipe_end, const std::function<std::optional<StoredOutcome>()>& run) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::string bytes;
  try {
    if (const auto outcome = run()) bytes = to_bytes(*outcome);
  } catch (const std::exception& problem) {
    if (!is_want_of_resources(problem)) throw;
    bytes.clear();  // no fault of the sample's
  }
  ::_exit(write_all(pipe_end, bytes) == 0 ? 0 : 1);
}

/// All that comes through the pipe until the other end is closed. Kills the child when a signal
/// asks this process to stop.
std::string read_from(int pipe_end, pid_t child) {
  std::string bytes;
  std::array<char, 4096> part;
  while (true) {
    pollfd ready{pipe_end, POLLIN, 0};
    if (SignalWatch::stopping()) ::kill(child, SIGKILL);
    if (::poll(&ready, 1, 100) <= 0) continue;
    const ssize_t count = ::read(pipe_end, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(count));
  }
}

StoredOutcome poisoned(std::uint64_t id, const std::string& how) {
  Outcome outcome;
  outcome.status = Status::poisoned;
  outcome.reason = "the process running this sample alone " + how;
  return make_stored_outcome(id, outcome, 0, 0);
}

}  // namespace

AloneResult run_alone(std::uint64_t id, const std::function<std::optional<StoredOutcome>()>& run) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {{}, std::strerror(errno)};
  const FileDescriptor reading(ends[0]);
  FileDescriptor writing(ends[1]);
  const pid_t child = ::fork();
  if (child < 0) return {{}, std::strerror(errno)};
  if (child == 0) be_child(writing.get(), run);
  ::close(writing.release());
  const std::string bytes = read_from(reading.get(), child);

  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    if (comes_from_outside(number))
      return {{}, "its process was ended from outside by " + name_of(number)};
    return {poisoned(id, "died of " + name_of(number)), ""};
  }
  if (WEXITSTATUS(status) != 0)
    return {poisoned(id, fmt::format("ended itself with exit code {}", WEXITSTATUS(status))), ""};
  if (bytes.empty()) return {{}, "it was interrupted, or memory ran out"};
  ByteReader in(bytes);
  return {outcome_from_bytes(in), ""};
}

}  // namespace cagetol
