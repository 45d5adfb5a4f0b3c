// Heartbeats: rank 0 and every other rank tell each other that they live, whatever else they do.
// TCP alone may take a quarter of an hour to give a cut link up, and MPI then waits for ever.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace cagetol {

/// How long a rank may stay silent before it counts as lost, s: CAGETOL_SILENCE_S of rank 0's
/// environment, else 60. Throws InputError when that is no number from 1 to 86400.
double silence_limit_s();

/// A thread of its own while it lives. Silence is counted in ticks of this thread, not by the
/// clock: a job that was suspended as a whole loses nobody.
class Pulse {
 public:
  /// `mpi` is held by whoever calls MPI. `name_of` names a rank for messages.
  Pulse(std::mutex& mpi, double limit_s, std::function<std::string(int rank)> name_of);
  Pulse(const Pulse&) = delete;
  Pulse& operator=(const Pulse&) = delete;
  /// Ends the beats, which must be done before MPI ends. The rest must live until MPI has ended: a
  /// beat may still be on its way, and an end of MPI that takes too long ends the process.
  void end();
  ~Pulse();

  /// Whether a rank is lost, here or elsewhere: MPI cannot end in an orderly way any more.
  bool lost() const { return lost_; }
  /// Whether this rank waits in vain. Ranks that still hear rank 0 leave it time to write, since
  /// mpirun ends all ranks with the first one that ends.
  bool hopeless() const;
  /// Rank 0: every rank is to stop soon, as after SIGTERM, and in an orderly way.
  void stop_all();

 private:
  void beat();
  void tick();
  void hear();
  void count_silence();
  void send(char what);

  std::mutex& mpi_;
  double limit_s_, tick_s_;
  std::function<std::string(int)> name_of_;
  struct Wire;
  std::unique_ptr<Wire> wire_;  ///< what MPI needs
  int rank_ = 0;
  std::vector<int> peers_;  ///< whom this rank tells, and listens to
  std::vector<int> silent_ticks_;
  int ticks_ = 0, ticks_lost_ = 0;
  std::atomic<bool> lost_{false}, lost_rank_0_{false}, stop_all_{false};
  enum class Phase { beating, ending, silent, over };
  Phase phase_ = Phase::beating;
  std::mutex phases_;
  std::condition_variable next_phase_;
  std::thread thread_;
};

}  // namespace cagetol
