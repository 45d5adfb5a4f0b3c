#include "mc/study_file/unsealed_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

#include "mc/study_file/hdf5_reader.hpp"
#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

constexpr char kContents = 'C', kProblem = 'P';  // what the first byte of an answer says
constexpr std::size_t kLongestAttribute = 32000;
constexpr int kDeepest = 8;

std::string text_or_empty(const Hdf5Reader& from, const std::string& object, const char* name) {
  return from.has_attribute(object, name) ? from.text_attribute(object, name) : "";
}

/// Texts too long for an attribute become a dataset of the group, as in schema 2.
void copy_attributes(const Hdf5Reader& from, const std::string& object, hid_t to) {
  for (const std::string& name : from.attributes(object)) {
    const H5Kind kind = from.attribute_kind(object, name);
    if (kind == H5Kind::real) write_h5_attribute(to, name, from.real_attribute(object, name));
    if (kind == H5Kind::integer) write_h5_attribute(to, name, from.integer_attribute(object, name));
    if (kind != H5Kind::text) continue;
    const std::string text = from.text_attribute(object, name);
    if (text.size() <= kLongestAttribute)
      write_h5_attribute(to, name, text);
    else
      write_h5(to, name, text, {"-", ""});
  }
}

void copy_dataset(const Hdf5Reader& from, const std::string& path, H5Kind kind, hid_t to,
                  const std::string& name) {
  const H5Meaning meaning{text_or_empty(from, path, "unit"),
                          text_or_empty(from, path, "description")};
  if (kind == H5Kind::integer) write_h5(to, name, from.integers(path), meaning);
  if (kind == H5Kind::text) write_h5(to, name, from.strings(path), meaning);
  if (kind == H5Kind::real) {
    const RealArray array = from.reals(path);
    write_h5(to, name, array.values, meaning, array.shape.size() == 2 ? array.shape[1] : 0);
  }
}

void copy_group(const Hdf5Reader& from, const std::string& group, hid_t to, int depth) {
  if (depth > kDeepest) throw std::runtime_error("its groups are nested too deeply");
  copy_attributes(from, group, to);
  for (const std::string& name : from.children(group)) {
    const std::string path = (group == "/" ? "" : group) + "/" + name;
    const H5Kind kind = from.kind(path);
    if (kind == H5Kind::group)
      copy_group(from, path, make_h5_group(to, name), depth + 1);
    else
      copy_dataset(from, path, kind, to, name);
  }
}

std::string rewritten(const std::string& bytes, const std::string& file_name) {
  const Hdf5Reader from(bytes, file_name);
  const H5Handle file = make_h5_memory_file();
  copy_group(from, "/", H5Handle(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "open the root"), 0);
  return sealed_h5_image(file);
}

/// Bytes of address space that this process has now.
std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, rlim_t amount) {
  const rlimit both{amount, amount};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

/// A crash must leave no message, no core and nobody's handler running.
void restrict_this_process(const UnsealedLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds) + 1);
  limit(RLIMIT_AS, address_space() + limits.memory);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}

bool write_all(int descriptor, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return true;
}

[[noreturn]] void be_child(int pipe_end, const std::string& bytes, const std::string& file_name,
                           const UnsealedLimits& limits) {
  restrict_this_process(limits);
  std::string answer;
  try {
    answer = rewritten(bytes, file_name);
    answer.insert(answer.begin(), kContents);
  } catch (const StudyFileError& problem) {
    answer = kProblem + problem.reason();
  } catch (const std::bad_alloc&) {
    answer = std::string(1, kProblem) + "HDF5 wants far more memory for it than it can hold";
  } catch (const std::exception& problem) {
    answer = std::string(1, kProblem) + problem.what();
  }
  ::_exit(write_all(pipe_end, answer) ? 0 : 1);
}

/// All that comes through the pipe until its other end is closed; false when that takes too long.
bool read_all(int pipe_end, double seconds, std::string& bytes) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  std::vector<char> part(1 << 16);
  while (std::chrono::steady_clock::now() < end) {
    pollfd ready{pipe_end, POLLIN, 0};
    if (::poll(&ready, 1, 100) <= 0) continue;
    const ssize_t count = ::read(pipe_end, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return true;
    bytes.append(part.data(), static_cast<std::size_t>(count));
  }
  return false;
}

[[noreturn]] void refuse(const std::string& file_name, const std::string& why) {
  throw StudyFileError(file_name, "has no checksum, and is damaged: " + why, kRebuildRemedy);
}

}  // namespace

std::string read_unsealed(const std::string& bytes, const std::string& file_name,
                          const UnsealedLimits& limits) {
  UnsealedLimits own = limits;
  own.seconds += static_cast<double>(bytes.size()) / (4 << 20);
  own.memory += 6 * bytes.size();
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw StudyFileError(file_name, std::string("cannot be read: ") + std::strerror(errno),
                         "raise the limit on open files (ulimit -n)");
  const pid_t child = ::fork();
  if (child == 0) be_child(ends[1], bytes, file_name, own);
  const int fork_error = errno;
  ::close(ends[1]);
  std::string answer;
  const bool ended = child < 0 || read_all(ends[0], own.seconds, answer);
  ::close(ends[0]);
  if (child < 0)
    throw StudyFileError(file_name, std::string("cannot be read: ") + std::strerror(fork_error),
                         "raise the limit on processes (ulimit -u), or free some memory");
  if (!ended) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!ended) refuse(file_name, fmt::format("HDF5 did not end within {:.0f} s", own.seconds));
  if (WIFSIGNALED(status))
    refuse(file_name, fmt::format("HDF5 crashed on it ({})", ::strsignal(WTERMSIG(status))));
  if (answer.empty() || WEXITSTATUS(status) != 0)
    refuse(file_name, "nothing could be read from it");
  if (answer.front() != kContents) refuse(file_name, answer.substr(1));
  return answer.erase(0, 1);
}

}  // namespace cagetol
