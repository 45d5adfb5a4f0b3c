// What the tests of this directory share: commands of the stand-in sweep and what its directory
// holds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/process.hpp"

namespace cagetol {

/// `standin_sweep DIR options...`
std::vector<std::string> standin(const std::string& directory,
                                 const std::vector<std::string>& options = {});

/// Exit code and everything printed.
struct Ended {
  int code = 0;
  std::string output;
};
Ended run(const std::vector<std::string>& command, const std::function<void()>& prepare = {});

/// Finished samples in all journals below DIR.
std::size_t finished_in(const std::string& directory);

/// Waits until `count` samples are finished, or the program ends.
void wait_for(Process& process, const std::string& directory, std::size_t count);

/// Ids of the ranks, all of them, once `count` have started; fewer when the program ends before.
std::vector<pid_t> ranks_of(Process& mpirun, std::size_t count);

std::string study_file_of(const std::string& directory);

/// Path of the journal with the most bytes.
std::string longest_journal(const std::string& directory);

}  // namespace cagetol
