#include "mc/ranks/team.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "mc/host/process_limits.hpp"
#include "mc/ranks/pulse.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/study_file/exit_code.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

constexpr int kTag = 1;

// Small messages need no copying from the memory of another process. Containers without ptrace
// forbid that, and Open MPI then prints warnings.
constexpr const char* kSingleCopy = "OMPI_MCA_btl_vader_single_copy_mechanism";
// MPI's own waits, while it starts and ends, leave the core to ranks that compute.
constexpr const char* kYield = "OMPI_MCA_mpi_yield_when_idle";

std::string host_name() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

}  // namespace

Team::Team(const Launch& launch) : under_mpi_(launch.under_mpi), hosts_{host_name()} {
  if (!under_mpi_) return;
  require_limits_of_mpi();
  double limit_s = silence_limit_s();
  ::setenv(kSingleCopy, "none", 0);
  ::setenv(kYield, "1", 0);
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  if (provided < MPI_THREAD_SERIALIZED)
    throw InputError({}, "", "", "this MPI library allows no threads",
                     "build Open MPI with thread support");
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  try {
    check_launch(launch, rank_, size_);
  } catch (...) {
    MPI_Finalize();
    throw;
  }
  if (size_ == 1) return;
  MPI_Bcast(&limit_s, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  learn_hosts();
  pulse_ = std::make_unique<Pulse>(mpi_, limit_s, [this](int rank) { return name_of(rank); });
}

Team::~Team() {
  if (!under_mpi_) return;
  if (pulse_) pulse_->end();
  if (pulse_ && pulse_->lost()) {
    std::fflush(nullptr);
    ::_exit(kInterrupted);
  }
  MPI_Finalize();
}

/// Rank 0 learns all hosts, the others that of rank 0: whom each hears.
void Team::learn_hosts() {
  constexpr std::size_t kLength = 64;
  std::string own = hosts_[0];
  own.resize(kLength);
  std::string all(rank_ == 0 ? kLength * static_cast<std::size_t>(size_) : 0, '\0');
  MPI_Gather(own.data(), kLength, MPI_CHAR, all.data(), kLength, MPI_CHAR, 0, MPI_COMM_WORLD);
  std::string first = own;
  MPI_Bcast(first.data(), kLength, MPI_CHAR, 0, MPI_COMM_WORLD);
  hosts_.assign(static_cast<std::size_t>(size_), "");
  hosts_[0] = first.c_str();
  hosts_[static_cast<std::size_t>(rank_)] = own.c_str();
  for (std::size_t k = 1; k * kLength < all.size(); ++k)
    hosts_[k] = all.substr(k * kLength, kLength).c_str();
}

std::string Team::name_of(int rank) const {
  const std::string& host = hosts_.at(static_cast<std::size_t>(rank));
  return fmt::format("rank {}{}", rank, host.empty() ? "" : " on " + host);
}

void Team::check_pulse() const {
  if (!pulse_ || !pulse_->hopeless()) return;
  std::fflush(nullptr);
  ::_exit(kInterrupted);
}

void Team::stop_all() const {
  if (pulse_)
    pulse_->stop_all();
  else
    SignalWatch::ask_to_stop();
}

/// Starts what takes a request and waits until it is done.
template <class Start>
void Team::finish(Start start) const {
  MPI_Request request;
  int done = 0;
  {
    const std::lock_guard lock(mpi_);
    start(&request);
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  }
  while (!done) {
    check_pulse();
    short_rest();
    const std::lock_guard lock(mpi_);
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  }
}

int Team::smallest(int value) const {
  if (!under_mpi_) return value;
  int result = value;
  finish([&](MPI_Request* request) {
    MPI_Iallreduce(&value, &result, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD, request);
  });
  return result;
}

void Team::meet() const {
  if (!under_mpi_) return;
  finish([](MPI_Request* request) { MPI_Ibarrier(MPI_COMM_WORLD, request); });
}

std::vector<std::string> Team::gathered(std::string_view text) const {
  if (rank_ != 0) {
    send(0, text);
    return {};
  }
  std::vector<std::string> texts(static_cast<std::size_t>(size_));
  texts[0] = text;
  for (int left = size_ - 1; left > 0; --left) {
    Message message = next_message();
    texts[static_cast<std::size_t>(message.rank)] = std::move(message.bytes);
  }
  return texts;
}

std::string Team::from_rank_0(std::string_view text) const {
  if (rank_ != 0) return next_message().bytes;
  for (int rank = 1; rank < size_; ++rank) send(rank, text);
  return std::string(text);
}

void Team::send(int rank, std::string_view bytes) const {
  finish([&](MPI_Request* request) {
    MPI_Isend(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, kTag, MPI_COMM_WORLD,
              request);
  });
}

std::optional<Team::Message> Team::receive() const {
  if (!under_mpi_) return std::nullopt;
  int there = 0, length = 0;
  MPI_Status status;
  {
    const std::lock_guard lock(mpi_);
    MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &there, &status);
    if (!there) return std::nullopt;
    MPI_Get_count(&status, MPI_BYTE, &length);
  }
  Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
  finish([&](MPI_Request* request) {
    MPI_Irecv(message.bytes.data(), length, MPI_BYTE, message.rank, kTag, MPI_COMM_WORLD, request);
  });
  return message;
}

Team::Message Team::next_message() const {
  while (true) {
    if (auto message = receive()) return *std::move(message);
    check_pulse();
    short_rest();
  }
}

void short_rest() {
  std::this_thread::sleep_for(std::chrono::microseconds(300));
}

}  // namespace cagetol
