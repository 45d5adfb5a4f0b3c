#include "mc/host/failure.hpp"

#include <new>
#include <stdexcept>
#include <system_error>

#include "mc/host/file_write.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

enum class Want { nothing, memory, threads, files, output };

Want want_of(const std::exception& problem) {
  if (dynamic_cast<const std::bad_alloc*>(&problem) != nullptr ||
      dynamic_cast<const std::length_error*>(&problem) != nullptr)
    return Want::memory;
  const auto* refused = dynamic_cast<const std::system_error*>(&problem);
  if (refused == nullptr) return Want::nothing;
  switch (refused->code().value()) {
    case ENOMEM:
      return Want::memory;
    case EAGAIN:
      return Want::threads;
    case EMFILE:
    case ENFILE:
      return Want::files;
    case ENOSPC:
    case EDQUOT:
    case EPIPE:
    case EIO:
      return Want::output;
    default:
      return Want::nothing;
  }
}

}  // namespace

bool is_want_of_resources(const std::exception& problem) {
  return want_of(problem) != Want::nothing;
}

std::string failure_text(const std::exception& problem) {
  switch (want_of(problem)) {
    case Want::memory:
      return "out of memory\n  remedy: free some, raise the limit (ulimit -v, the job's memory), "
             "start fewer ranks, or ask for fewer samples; `cagetol check` "
             "predicts what a study needs";
    case Want::threads:
      return "the system starts no further thread or process\n  remedy: raise the limits (ulimit "
             "-u, ulimit -v) or start fewer ranks";
    case Want::files:
      return "too many open files\n  remedy: raise the limit (ulimit -n)";
    case Want::output:
      return std::string("cannot write the output: ") + problem.what() +
             "\n  remedy: free space on the disk or choose another place";
    case Want::nothing:
      break;
  }
  return problem.what();
}

ExitCode exit_code_for(const std::exception& problem) {
  if (dynamic_cast<const UnfinishedWrite*>(&problem) != nullptr) return kInterrupted;
  const bool known = dynamic_cast<const InputError*>(&problem) != nullptr ||
                     dynamic_cast<const StudyFileError*>(&problem) != nullptr ||
                     dynamic_cast<const WriteError*>(&problem) != nullptr ||
                     is_want_of_resources(problem);
  return known ? kBadInput : kUnexpected;
}

std::string ending_text(const std::exception& problem) {
  return (exit_code_for(problem) == kUnexpected ? "unexpected: " : "") + failure_text(problem);
}

}  // namespace cagetol
