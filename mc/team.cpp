#include "mc/team.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "mc/process_limits.hpp"

namespace cagetol {
namespace {

constexpr int kTag = 1;

std::optional<int> environment_number(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const char* value = std::getenv(name)) return std::atoi(value);
  return std::nullopt;
}

void finish(MPI_Request request) {
  for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done;) short_rest();
}

}  // namespace

Launch launch_from_environment() {
  const auto rank = environment_number({"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"});
  if (!rank) return {};
  return {*rank,
          environment_number({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_NTASKS"}).value_or(1),
          true};
}

Team::Team(const Launch& launch) : under_mpi_(launch.under_mpi) {
  if (!under_mpi_) return;
  require_limits_of_mpi();
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  if (provided < MPI_THREAD_FUNNELED)
    throw std::runtime_error(
        "this MPI library allows no threads: build Open MPI with thread support");
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Team::~Team() {
  if (under_mpi_) MPI_Finalize();
}

int Team::smallest(int value) const {
  if (!under_mpi_) return value;
  int result = value;
  MPI_Request request;
  MPI_Iallreduce(&value, &result, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD, &request);
  finish(request);
  return result;
}

void Team::meet() const {
  if (!under_mpi_) return;
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  finish(request);
}

void Team::send(int rank, std::string_view bytes) const {
  MPI_Request request;
  MPI_Isend(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, kTag, MPI_COMM_WORLD,
            &request);
  finish(request);
}

std::optional<Team::Message> Team::receive() const {
  if (!under_mpi_) return std::nullopt;
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &there, &status);
  if (!there) return std::nullopt;
  int length = 0;
  MPI_Get_count(&status, MPI_BYTE, &length);
  Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
  MPI_Recv(message.bytes.data(), length, MPI_BYTE, message.rank, kTag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return message;
}

void short_rest() {
  std::this_thread::sleep_for(std::chrono::microseconds(300));
}

}  // namespace cagetol
