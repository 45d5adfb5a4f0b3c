#include "mc/host/process_limits.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <string>

#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

constexpr rlim_t kGoodStack = 8 << 20, kGoodFiles = 1024;

/// The soft limit, raised to `wanted` where the hard one allows.
rlim_t raised(__rlimit_resource resource, rlim_t wanted) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0) return RLIM_INFINITY;
  if (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= wanted) return limit.rlim_cur;
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = std::min(wanted, limit.rlim_max);
  return ::setrlimit(resource, &limit) == 0 ? limit.rlim_cur : before;
}

void require_at_least(rlim_t allowed, std::size_t minimum, rlim_t unit, const std::string& what,
                      const std::string& option) {
  if (allowed == RLIM_INFINITY || allowed >= minimum) return;
  const auto units = [&](rlim_t amount) { return std::to_string(amount / unit); };
  throw InputError({}, "ulimit " + option, units(allowed),
                   what + " is limited to this; the program needs " + units(minimum),
                   "raise the limit: ulimit " + option + " " + units(minimum) + " or more");
}

}  // namespace

void require_process_limits() {
  std::signal(SIGXFSZ, SIG_IGN);
  require_at_least(raised(RLIMIT_STACK, kGoodStack), kMinimumStack, 1024, "the stack [kB]", "-s");
  require_at_least(raised(RLIMIT_NOFILE, kGoodFiles), kMinimumFiles, 1, "the number of open files",
                   "-n");
}

void require_limits_of_mpi() {
  require_at_least(raised(RLIMIT_NOFILE, kGoodFiles), kMinimumFilesOfMpi, 1,
                   "the number of open files of an MPI process", "-n");
  require_at_least(raised(RLIMIT_AS, 0), kMinimumSpaceOfMpi, 1024,
                   "the address space of an MPI process [kB]", "-v");
}

}  // namespace cagetol
