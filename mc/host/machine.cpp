#include "mc/host/machine.hpp"

#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

namespace cagetol {
namespace {

namespace fs = std::filesystem;

std::optional<double> number_in(const fs::path& file) {
  std::ifstream in(file);
  double number = 0;
  if (in >> number) return number;
  return std::nullopt;  // no such file, or "max"
}

/// The number that stands after a word in a file of the kernel, times `unit`.
std::optional<double> number_after(const fs::path& file, const std::string& word, double unit) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string name;
    double number = 0;
    if (fields >> name >> number && name == word) return unit * number;
  }
  return std::nullopt;
}

/// The room in one group of version 2, or 1.
std::optional<double> room_in(const fs::path& group, bool second) {
  const auto limit = number_in(group / (second ? "memory.max" : "memory.limit_in_bytes"));
  const auto used = number_in(group / (second ? "memory.current" : "memory.usage_in_bytes"));
  if (!limit || !used) return std::nullopt;
  // Pages of files that nobody needs at once are given back before the limit bites.
  const auto idle =
      number_after(group / "memory.stat", second ? "inactive_file" : "total_inactive_file", 1);
  return std::max(0.0, *limit - *used + idle.value_or(0));
}

void tighten(Room& room, std::optional<double> bytes, const std::string& name) {
  if (bytes && *bytes < room.bytes) room = {*bytes, name};
}

/// What a limit of the process leaves beyond what `word` of its status says that it uses.
std::optional<double> left_of(__rlimit_resource resource, const std::string& word) {
  rlimit limit{};
  if (::getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  const double used = number_after("/proc/self/status", word, 1024).value_or(0);
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

}  // namespace

Room room_of_process() {
  Room room;
  tighten(room, left_of(RLIMIT_AS, "VmSize:"), "ulimit -v");
  tighten(room, left_of(RLIMIT_DATA, "VmData:"), "ulimit -d");
  return room;
}

Room room_of_control_groups(const std::string& membership, const fs::path& root) {
  Room room;
  std::istringstream lines(membership);
  for (std::string line; std::getline(lines, line);) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool unified = controllers.empty();
    if (!unified && ("," + controllers + ",").find(",memory,") == std::string::npos) continue;
    const fs::path mount = unified ? root : root / "memory";
    // A limit of any group around this one counts. Inside a container the path may be the host's:
    // then only the mount itself is there.
    for (fs::path group = fs::path(line.substr(second + 1)).relative_path();;
         group = group.parent_path()) {
      tighten(room, room_in(mount / group, unified), "memory limit of the control group");
      if (group.empty()) break;
    }
  }
  return room;
}

Room room_of_machine() {
  std::ifstream file("/proc/self/cgroup");
  std::ostringstream membership;
  membership << file.rdbuf();
  Room room = room_of_control_groups(membership.str(), "/sys/fs/cgroup");
  tighten(room, number_after("/proc/meminfo", "MemAvailable:", 1024), "memory available");
  return room;
}

Room room_on_disk(const fs::path& path) {
  std::error_code error;
  fs::path place = fs::absolute(path, error);
  while (!fs::exists(place, error) && place != place.parent_path()) place = place.parent_path();
  struct statvfs disk {};
  if (::statvfs(place.c_str(), &disk) != 0) return {};
  return {static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize),
          "free on the disk of " + place.string()};
}

}  // namespace cagetol
