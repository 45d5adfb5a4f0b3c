// What the machine, the shell and the batch system leave to this process: memory and disk.
#pragma once

#include <filesystem>
#include <limits>
#include <string>

namespace cagetol {

/// So many bytes, and what says so ("ulimit -v").
struct Room {
  double bytes = std::numeric_limits<double>::infinity();
  std::string name = "no limit";
};

/// Memory that this process may still take by its own limits (ulimit -v, ulimit -d).
Room room_of_process();

/// Memory that all processes here together may still take: what the system calls available, or the
/// tightest memory limit of the control groups around this process, less what they use and cannot
/// give back.
Room room_of_machine();

/// The latter for the groups of `membership` (the text of /proc/self/cgroup), versions 1 and 2,
/// mounted at `root`.
Room room_of_control_groups(const std::string& membership, const std::filesystem::path& root);

/// Free space of the file system on which `path` is or will be.
Room room_on_disk(const std::filesystem::path& path);

}  // namespace cagetol
