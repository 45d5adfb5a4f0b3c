#include "mc/ranks/launch.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <optional>

#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

constexpr const char* kRemedy =
    "start it with the mpirun of the Open MPI that it was built with; under Slurm with mpirun in a "
    "batch script (mc/slurm/study.sbatch), or with srun --mpi=pmix";

std::optional<int> environment_number(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const char* value = std::getenv(name)) return std::atoi(value);
  return std::nullopt;
}

bool is_launcher(pid_t process) {
  constexpr std::array<std::string_view, 7> kNames = {"mpirun",  "mpiexec", "orterun", "orted",
                                                      "prterun", "prte",    "prted"};
  std::string name;
  std::ifstream("/proc/" + std::to_string(process) + "/comm") >> name;
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

pid_t parent_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  for (std::string word; file >> word;)
    if (pid_t parent = 0; word == "PPid:" && file >> parent) return parent;
  return 0;
}

bool holds(pid_t process, const char* file, const char* text) {
  std::ifstream stream("/proc/" + std::to_string(process) + "/" + file);
  const std::string all{std::istreambuf_iterator<char>(stream), {}};
  return all.find(text) != std::string::npos;
}

/// A rank that starts a program hands it its own place, which MPI gives to one process only.
void refuse_place_of_parent() {
  for (pid_t above = ::getppid(); above > 1 && !is_launcher(above); above = parent_of(above))
    if (holds(above, "environ", "OMPI_COMM_WORLD_RANK=") && holds(above, "maps", "/libmpi."))
      throw InputError({}, "", "",
                       fmt::format("process {}, which started this one, is itself a rank of MPI "
                                   "(OMPI_*, PMIX_* in the environment)",
                                   above),
                       "start it from outside MPI, or without these variables: env -i "
                       "PATH=\"$PATH\" HOME=\"$HOME\" cagetol ...");
}

/// Whether the process has ended within so many milliseconds.
bool has_ended(int process, int milliseconds) {
  pollfd end{process, POLLIN, 0};
  return ::poll(&end, 1, milliseconds) > 0;
}

}  // namespace

Launch launch_from_environment() {
  const auto slurm_tasks = environment_number({"SLURM_STEP_NUM_TASKS"});
  if (const auto rank = environment_number({"OMPI_COMM_WORLD_RANK"})) {
    if (std::getenv("PMIX_NAMESPACE") == nullptr)
      throw InputError({}, "OMPI_COMM_WORLD_RANK", std::to_string(*rank),
                       "mpirun's variable PMIX_NAMESPACE is missing beside it, so that MPI cannot "
                       "find the other ranks",
                       "leave mpirun's variables (OMPI_*, PMIX_*) in the environment of its "
                       "processes, or take all of them out for a run of its own");
    refuse_place_of_parent();
    return {*rank, environment_number({"OMPI_COMM_WORLD_SIZE"}).value_or(0), true};
  }
  if (const auto rank = environment_number({"PMIX_RANK"}))
    return {*rank, slurm_tasks.value_or(0), true};
  if (slurm_tasks.value_or(1) > 1)
    throw InputError({}, "", "",
                     fmt::format("srun started {} tasks, but with no PMI that Open MPI can join "
                                 "(PMIX_RANK is not set): each would run the whole study",
                                 *slurm_tasks),
                     kRemedy);
  const auto rank = environment_number({"PMI_RANK"});
  const int size = environment_number({"PMI_SIZE"}).value_or(0);
  if (!rank || size == 1) return {};
  return {*rank, size, true};
}

void check_launch(const Launch& launch, int mpi_rank, int mpi_size) {
  const bool same_size = launch.size == 0 || launch.size == mpi_size;
  if (launch.rank == mpi_rank && same_size) return;
  const std::string announced = launch.size == 0
                                    ? fmt::format("rank {}", launch.rank)
                                    : fmt::format("rank {} of {}", launch.rank, launch.size);
  throw InputError({}, "", "",
                   fmt::format("the launcher started this process as {}, but MPI knows it as rank "
                               "{} of {}: launcher and MPI library do not belong together",
                               announced, mpi_rank, mpi_size),
                   kRemedy);
}

void end_launcher_after(double seconds) {
  constexpr int kLastWords = 5000;
  const pid_t launcher = ::getppid();
  if (!is_launcher(launcher)) return;
  // A handle, not a number: another process may have the number by then.
  const int handle = static_cast<int>(::syscall(SYS_pidfd_open, launcher, 0));
  if (handle < 0 || ::fork() != 0) return;
  // From here on only what a child of a process with threads may do. The launcher kills process
  // groups, and waits until nobody holds its pipes.
  ::setsid();
  for (int other = 0; other < 1024; ++other)
    if (other != handle) ::close(other);
  if (!has_ended(handle, static_cast<int>(1000 * seconds))) {
    ::syscall(SYS_pidfd_send_signal, handle, SIGTERM, nullptr, 0);
    if (!has_ended(handle, kLastWords))
      ::syscall(SYS_pidfd_send_signal, handle, SIGKILL, nullptr, 0);
  }
  ::_exit(0);
}

}  // namespace cagetol
