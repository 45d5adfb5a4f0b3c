#include "mc/failure.hpp"

#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>

namespace cagetol {
namespace {

enum class Want { nothing, memory, threads, files };

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
             "start fewer ranks, or ask for fewer samples or history.points; `cagetol check` "
             "predicts what a study needs";
    case Want::threads:
      return "the system starts no further thread or process\n  remedy: raise the limits (ulimit "
             "-u, ulimit -v) or start fewer ranks";
    case Want::files:
      return "too many open files\n  remedy: raise the limit (ulimit -n)";
    case Want::nothing:
      break;
  }
  return problem.what();
}

}  // namespace cagetol
