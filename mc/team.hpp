// The ranks of one sweep. Without mpirun a team of one that never touches MPI, so that no MPI
// daemon is needed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cagetol {

/// Place in the team, from the environment that mpirun (or srun) sets: known before MPI starts.
struct Launch {
  int rank = 0;
  int size = 1;
  bool under_mpi = false;
};
Launch launch_from_environment();

/// MPI while it lives. Only one thread of a rank may call it. Waiting sleeps instead of spinning:
/// ranks may share cores.
class Team {
 public:
  explicit Team(const Launch& launch);
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team();

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// The smallest value of all ranks; every rank must call it.
  int smallest(int value) const;
  /// Waits until every rank has come here.
  void meet() const;

  struct Message {
    int rank = 0;
    std::string bytes;
  };
  void send(int rank, std::string_view bytes) const;
  /// A message from anybody, if one is there.
  std::optional<Message> receive() const;

 private:
  bool under_mpi_;
  int rank_ = 0, size_ = 1;
};

/// How long a rank sleeps between two looks at its messages: far below the run time of a sample,
/// far above the cost of a look.
void short_rest();

}  // namespace cagetol
