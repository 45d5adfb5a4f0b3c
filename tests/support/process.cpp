#include "tests/support/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace cagetol {
namespace {

namespace fs = std::filesystem;

std::string new_scratch_name(const char* pattern) {
  std::string name = pattern;
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch directory");
  return name;
}

int exit_code_of(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

ScratchDirectory::ScratchDirectory()
    : path_(new_scratch_name((fs::temp_directory_path() / "cagetol-test-XXXXXX").c_str())) {}

ScratchDirectory::~ScratchDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Process::Process(const std::vector<std::string>& command, const std::function<void()>& prepare) {
  std::string name = (fs::temp_directory_path() / "cagetol-output-XXXXXX").string();
  const int output = ::mkstemp(name.data());
  if (output < 0) throw std::runtime_error("no file for output");
  output_file_ = name;
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  id_ = ::fork();
  if (id_ == 0) {
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    if (prepare) prepare();
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  ::close(output);
  if (id_ < 0) throw std::runtime_error("cannot fork");
}

Process::~Process() {
  if (running()) {
    ::kill(id_, SIGKILL);
    wait();
  }
  ::unlink(output_file_.c_str());
}

bool Process::running() {
  if (!ended_ && ::waitpid(id_, &status_, WNOHANG) == id_) ended_ = true;
  return !ended_;
}

int Process::wait() {
  while (!ended_)
    if (::waitpid(id_, &status_, 0) == id_ || errno != EINTR) ended_ = true;
  return exit_code_of(status_);
}

std::string Process::output() const {
  return text_of(output_file_);
}

void Process::signal(int number) const {
  ::kill(id_, number);
}

std::vector<std::string> with_mpirun(int ranks, std::vector<std::string> command) {
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  ::setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
  ::setenv("OMPI_MCA_hwloc_base_binding_policy", "none", 1);
  ::setenv("OMPI_MCA_btl_vader_single_copy_mechanism", "none", 1);
  std::vector<std::string> words = {"mpirun", "-np", std::to_string(ranks)};
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

std::vector<pid_t> processes_below(pid_t parent, const std::string& program) {
  std::vector<pid_t> found;
  for (const auto& task : fs::directory_iterator("/proc/" + std::to_string(parent) + "/task")) {
    std::istringstream children(text_of(task.path() / "children"));
    for (pid_t child; children >> child;) {
      std::error_code gone;
      const auto file = fs::read_symlink("/proc/" + std::to_string(child) + "/exe", gone);
      if (!gone && file.filename() == program) found.push_back(child);
    }
  }
  return found;
}

}  // namespace cagetol
