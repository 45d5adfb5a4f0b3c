#include "analysis/report/python_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string_view>

extern char** environ;

namespace cagetol {
namespace {

// Figures and pages take some seconds. Under a tight limit on memory (ulimit -v) matplotlib's
// linear algebra asks for it again and again and never ends.
constexpr rlim_t kLongestDrawing = 120;

/// The exit code of the child; -1 and `problem` where it took too much time.
int wait_for(pid_t child, std::string& problem) {
  const rlimit processor_time{kLongestDrawing, kLongestDrawing};
  prlimit(child, RLIMIT_CPU, &processor_time, nullptr);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  if (WTERMSIG(status) != SIGXCPU && WTERMSIG(status) != SIGKILL) return 128;
  problem =
      fmt::format("it was stopped: it took more than {} s, or memory ran out", kLongestDrawing);
  return -1;
}

/// This program's environment, with one thread for matplotlib's linear algebra: more cost memory
/// and gain nothing.
std::vector<char*> environment_of_one_thread() {
  static char one_thread[] = "OPENBLAS_NUM_THREADS=1";
  std::vector<char*> environment{one_thread};
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (!std::string_view(*entry).starts_with("OPENBLAS_NUM_THREADS="))
      environment.push_back(*entry);
  environment.push_back(nullptr);
  return environment;
}

/// Runs the program with its output in `log`; the exit code, or -1 and `problem`.
int run_logged(const std::vector<std::string>& command, const std::filesystem::path& log,
               std::string& problem) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = -1;
  const int error = posix_spawn(&child, command[0].c_str(), &actions, nullptr, arguments.data(),
                                environment_of_one_thread().data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    problem = fmt::format("{} cannot be started ({})", command[0], std::strerror(error));
    return -1;
  }
  return wait_for(child, problem);
}

/// The last line that says something: Python prints the error itself there.
std::string last_line(const std::string& text) {
  const auto end = text.find_last_not_of(" \n\r\t");
  if (end == std::string::npos) return "no message";
  const auto begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

}  // namespace

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

PythonRun run_python(const std::string& python, const std::filesystem::path& script,
                     const std::vector<std::string>& arguments, const std::filesystem::path& log) {
  PythonRun run;
  std::vector<std::string> command = {python, "-I", "-B", script.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  run.code = run_logged(command, log, run.problem);
  const std::string said = file_text(log);
  if (run.code != 0 && run.problem.empty())
    run.problem = fmt::format("{} {} ended with code {}: {}", python, script.filename().string(),
                              run.code, last_line(said));
  std::error_code ignored;
  if (said.empty()) std::filesystem::remove(log, ignored);
  return run;
}

}  // namespace cagetol
