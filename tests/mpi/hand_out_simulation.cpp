#include "tests/mpi/hand_out_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "mc/ranks/hand_out.hpp"

namespace cagetol {
namespace {

// As in mc/sweep/sweep.cpp, mc/ranks/pulse.cpp and mc/ranks/team.cpp.
constexpr double kRebuildInterval = 180, kRebuildShare = 0.01;
constexpr double kBeatInterval = 10;
constexpr double kWorkerRest = 0.3e-3;

constexpr double kScatter = 0.3;  ///< of run times, log-normal
constexpr int kMessagesToStart = 3;

using Arrival = std::pair<double, int>;  ///< time, rank

class Simulation {
 public:
  Simulation(int ranks, double sample_s, std::uint64_t samples, const HandOutCosts& costs)
      : ranks_(ranks),
        costs_(costs),
        left_(samples),
        rest_s_(lookout_rest(sample_s, ranks - 1)),
        duration_(std::log(sample_s) - 0.5 * spread() * spread(), spread()) {}

  HandOutPrediction run();

 private:
  static double spread() { return std::sqrt(std::log(1 + kScatter * kScatter)); }
  /// Whether there was another sample for the rank, which begins at `time`.
  bool start_sample(double time, int rank);
  void answer(const Arrival& report);
  double rebuild_s() const {
    return costs_.file_sample_s * static_cast<double>(done_) + costs_.file_journal_s * ranks_;
  }

  int ranks_;
  HandOutCosts costs_;
  std::uint64_t left_, done_ = 0;
  double rest_s_;
  std::mt19937_64 random_{1};
  std::lognormal_distribution<double> duration_;
  /// Ends of samples; of rank 0 as well, whose second thread needs no message.
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> reports_;
  double server_free_ = 0, server_busy_s_ = 0;
  double busy_s_ = 0, waiting_s_ = 0, last_end_ = 0, idle_ends_ = 0;
};

bool Simulation::start_sample(double time, int rank) {
  if (left_ == 0) {
    idle_ends_ += time;
    return false;
  }
  --left_;
  const double duration = duration_(random_);
  busy_s_ += duration;
  reports_.emplace(time + duration + costs_.record_s, rank);
  return true;
}

void Simulation::answer(const Arrival& report) {
  const auto [end, rank] = report;
  ++done_;
  last_end_ = std::max(last_end_, end);
  if (rank == 0) {
    start_sample(end, rank);
    return;
  }
  // A server that has nothing to do looks every rest_s_, half of that later on average.
  const double arrival = end + costs_.latency_s;
  const double begin = std::max(arrival + 0.5 * rest_s_, server_free_);
  server_free_ = begin + costs_.message_s;
  server_busy_s_ += costs_.message_s;
  const double next = server_free_ + costs_.latency_s + 0.5 * kWorkerRest;
  waiting_s_ += next - end;
  start_sample(next, rank);
}

HandOutPrediction Simulation::run() {
  const double start = ranks_ * (costs_.journal_s + kMessagesToStart * costs_.message_s);
  const auto samples = static_cast<double>(left_);
  server_free_ = start;
  for (int rank = 0; rank < ranks_; ++rank) start_sample(start, rank);
  double next_rebuild = start + kRebuildInterval, next_beat = start + kBeatInterval;
  while (!reports_.empty()) {
    const Arrival report = reports_.top();
    reports_.pop();
    if (report.first > next_rebuild) {
      server_free_ = std::max(server_free_, report.first) + rebuild_s();
      next_rebuild = server_free_ + std::max(kRebuildInterval, rebuild_s() / kRebuildShare);
    }
    if (report.first > next_beat) {  // one to and one from each rank: as much as a report
      server_free_ = std::max(server_free_, report.first) + ranks_ * costs_.message_s;
      server_busy_s_ += ranks_ * costs_.message_s;
      next_beat = report.first + kBeatInterval;
    }
    answer(report);
  }
  const double end = std::max(last_end_, server_free_) + rebuild_s();
  const double all = ranks_ * end;
  HandOutPrediction result;
  result.efficiency = busy_s_ / all;
  result.server_busy = server_busy_s_ / end;
  result.losses[0].share = ranks_ * start / all;
  result.losses[1].share = waiting_s_ / all;
  result.losses[2].share = samples * costs_.record_s / all;
  result.losses[3].share = (ranks_ * (end - rebuild_s()) - idle_ends_) / all;
  result.losses[4].share = ranks_ * rebuild_s() / all;
  return result;
}

}  // namespace

const HandOutPrediction::Loss& HandOutPrediction::largest_loss() const {
  return *std::max_element(losses.begin(), losses.end(),
                           [](const Loss& a, const Loss& b) { return a.share < b.share; });
}

HandOutPrediction predict_hand_out(int ranks, double sample_s, std::uint64_t samples_per_rank,
                                   const HandOutCosts& costs) {
  return Simulation(ranks, sample_s, static_cast<std::uint64_t>(ranks) * samples_per_rank, costs)
      .run();
}

}  // namespace cagetol
