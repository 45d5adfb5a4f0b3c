#include "tests/mpi/standin.hpp"

#include <chrono>
#include <filesystem>
#include <thread>

#include "mc/sweep/journal.hpp"
#include "mc/sweep/sweep_directory.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;

void rest() {
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

}  // namespace

std::vector<std::string> standin(const std::string& directory,
                                 const std::vector<std::string>& options) {
  std::vector<std::string> command = {CAGETOL_BINARY_DIR "/standin_sweep", directory};
  command.insert(command.end(), options.begin(), options.end());
  return command;
}

Ended run(const std::vector<std::string>& command, const std::function<void()>& prepare) {
  Process process(command, prepare);
  const int code = process.wait();
  return {code, process.output()};
}

std::size_t finished_in(const std::string& directory) {
  const std::string journals = journal_directory(directory);
  return fs::exists(journals) ? read_journals(journals).finished.size() : 0;
}

void wait_for(Process& process, const std::string& directory, std::size_t count) {
  while (process.running() && finished_in(directory) < count) rest();
}

std::vector<pid_t> ranks_of(Process& mpirun, std::size_t count) {
  while (mpirun.running()) {
    const auto ranks = processes_below(mpirun.id(), "standin_sweep");
    if (ranks.size() >= count) return ranks;
    rest();
  }
  return {};
}

std::string study_file_of(const std::string& directory) {
  return study_file_path(directory);
}

std::string longest_journal(const std::string& directory) {
  std::string longest;
  if (!fs::exists(journal_directory(directory))) return longest;
  for (const auto& entry : fs::directory_iterator(journal_directory(directory)))
    if (longest.empty() || entry.file_size() > fs::file_size(longest))
      longest = entry.path().string();
  return longest;
}

}  // namespace cagetol
