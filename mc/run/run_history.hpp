// Time histories of one run as an HDF5 file: every channel of history_channels.hpp at accepted
// states, at most one per window.history_interval_us. mc/RUN_FORMAT.md lists the datasets.
#pragma once

#include <string>
#include <vector>

#include "mc/run/history_channels.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

class RunHistory {
 public:
  explicit RunHistory(const Scene& scene);

  /// Keeps the state if the interval has passed. To be called at every accepted state.
  void record(const Instant& at);

  /// Throws WriteError.
  void write(const std::string& path) const;

 private:
  std::string scene_name_;
  double interval_, next_time_ = 0;
  int rollers_;
  std::vector<double> time_;
  std::vector<std::vector<double>> of_bearing_, of_rollers_;  ///< in the order of the channels
};

}  // namespace cagetol
