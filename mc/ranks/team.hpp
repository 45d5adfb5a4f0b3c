// The ranks of one sweep. Without mpirun a team of one that never touches MPI, so that no MPI
// daemon is needed.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mc/ranks/launch.hpp"

namespace cagetol {

class Pulse;

/// MPI while it lives. Only one thread of a rank may call it; a second one, the pulse, watches
/// that the other ranks live. Waiting sleeps instead of spinning: ranks may share cores.
///
/// A rank that hears nothing of another one for `silence_limit_s()` loses it: rank 0 then asks all
/// ranks to stop (SignalWatch), and every rank that still waits for an answer ends its process with
/// exit code 75. Journals are complete then.
class Team {
 public:
  /// Throws InputError when MPI's world is not the one that the launcher announced.
  explicit Team(const Launch& launch);
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  /// Ends MPI; where a rank is lost, which MPI does not survive, the process (code 75).
  ~Team();

  int rank() const { return rank_; }
  int size() const { return size_; }
  /// "rank 3 on HOST"; the hosts of others are known to rank 0 alone.
  std::string name_of(int rank) const;

  /// The smallest value of all ranks; every rank must call it.
  int smallest(int value) const;
  /// Waits until every rank has come here.
  void meet() const;
  /// Texts of all ranks, in their order, on rank 0; elsewhere nothing. Every rank must call it.
  std::vector<std::string> gathered(std::string_view text) const;
  /// The text that rank 0 gives, on every rank. Every rank must call it.
  std::string from_rank_0(std::string_view text) const;

  struct Message {
    int rank = 0;
    std::string bytes;
  };
  void send(int rank, std::string_view bytes) const;
  /// A message from anybody, if one is there.
  std::optional<Message> receive() const;
  /// Waits for a message from anybody.
  Message next_message() const;

  /// Ends this process with code 75 when waiting for others has become pointless.
  void check_pulse() const;
  /// Rank 0: asks every rank to give its sample back and to stop.
  void stop_all() const;

 private:
  template <class Start>
  void finish(Start start) const;
  void learn_hosts();

  bool under_mpi_;
  int rank_ = 0, size_ = 1;
  std::vector<std::string> hosts_;
  mutable std::mutex mpi_;  ///< whoever calls MPI holds it
  std::unique_ptr<Pulse> pulse_;
};

/// How long a rank sleeps between two looks at its messages: far below the run time of a sample,
/// far above the cost of a look.
void short_rest();

}  // namespace cagetol
