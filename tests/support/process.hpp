// Starting programs from tests, watching them, ending them in every way.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace cagetol {

/// A directory of its own for a test, removed with all that is in it.
class ScratchDirectory {
 public:
  ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  ~ScratchDirectory();
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A running program; its output and errors go to one text. Killed when it goes out of scope still
/// running.
class Process {
 public:
  /// `prepare` runs in the child before the program starts (limits and the like).
  explicit Process(const std::vector<std::string>& command,
                   const std::function<void()>& prepare = {});
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  pid_t id() const { return id_; }
  bool running();
  /// Waits for the end: the exit code, or 128 + signal.
  int wait();
  /// What was printed so far.
  std::string output() const;
  void signal(int number) const;

 private:
  pid_t id_ = -1;
  int status_ = 0;
  bool ended_ = false;
  std::string output_file_;
};

/// `mpirun -np RANKS command`, as root and with more ranks than cores.
std::vector<std::string> with_mpirun(int ranks, std::vector<std::string> command);

/// Processes below `parent`, and theirs, that run `program` (its file name).
std::vector<pid_t> processes_below(pid_t parent, const std::string& program);

}  // namespace cagetol
